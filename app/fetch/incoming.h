// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/fetch/arrivals.h"
#include "app/fetch/connection_watch.h"

namespace app::fetch {

/// Takes the images of one C-MOVE. While it lives, a socket listens on the address that the user
/// named. Only connections from the server's own addresses are taken, one after another, and only
/// associations from its AE title to ours; others are closed at once. Images come on a thread of
/// its own, which alone uses `arrivals` meanwhile.
class Incoming {
 public:
  static haptics::Expected<std::unique_ptr<Incoming>> open(ConnectionWatch& watch,
                                                           Arrivals& arrivals,
                                                           const std::string& key_passphrase);
  /// Stops listening and waits for the thread.
  ~Incoming();
  Incoming(const Incoming&) = delete;
  Incoming& operator=(const Incoming&) = delete;

  /// The error that ended the taking, if there is one. Any thread.
  haptics::Expected<void> health();
  /// Waits until so many images were taken and no association is open: the last image may come
  /// after the server said that it is done.
  void settle(std::optional<std::size_t> sent);

 private:
  Incoming(ConnectionWatch& watch, Arrivals& arrivals, std::unique_ptr<DcmTransportLayer> layer)
      : watch_{watch}, arrivals_{arrivals}, layer_{std::move(layer)} {}

  ConnectionWatch& watch_;
  Arrivals& arrivals_;
  std::unique_ptr<DcmTransportLayer> layer_;
  std::vector<std::string> peers_;  ///< numeric addresses of the server
  int listening_ = -1;
  std::atomic<bool> over_{false}, busy_{false};
  std::atomic<std::size_t> taken_{0};
  std::mutex mutex_;
  haptics::Expected<void> health_ = {};
  std::thread thread_;

  void listen();
  haptics::Expected<void> take(int socket);
};

}  // namespace app::fetch
