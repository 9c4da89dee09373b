// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/dcmlayer.h>

#include "app/fetch/archive.h"
#include "app/fetch/pace.h"

namespace app::fetch {

/// The connections of DIMSE, watched by a thread: DCMTK's calls may wait as long as a server likes,
/// so this shuts the sockets down when the server is silent or too slow, and 0.3 s after one asked
/// to stop. One in a process.
class ConnectionWatch {
 public:
  explicit ConnectionWatch(const Server& server);
  ~ConnectionWatch();
  ConnectionWatch(const ConnectionWatch&) = delete;
  ConnectionWatch& operator=(const ConnectionWatch&) = delete;

  /// What makes DCMTK's connections, by plain TCP or TLS as the server has it.
  haptics::Expected<std::unique_ptr<DcmTransportLayer>> layer(const std::string& key_passphrase,
                                                              bool acceptor);
  /// While it lives, the server is waited for, and timed.
  class Waiting {
   public:
    explicit Waiting(ConnectionWatch& watch) : watch_{watch} { watch_.wait(true); }
    ~Waiting() { watch_.wait(false); }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

   private:
    ConnectionWatch& watch_;
  };

  /// While it lives, its thread receives so many bytes at most; with more its connection ends.
  /// DCMTK takes commands and matches of any length.
  class Bound {
   public:
    explicit Bound(std::size_t most);
    ~Bound();
    Bound(const Bound&) = delete;
    Bound& operator=(const Bound&) = delete;
  };

  /// Whether SIGTERM came.
  static bool stopping();
  /// Shuts all connections down.
  void end();
  /// Why a call of DCMTK failed on this thread, if that is known here: stopped, silent, slow, more
  /// than the bound, or TLS. Clears it.
  std::optional<haptics::Error> trouble();

  /// Why a server ends TLS, on a new socket and without a request: behind one, what the server says
  /// of this program's certificate may be lost. Waits two seconds at most.
  std::optional<haptics::Error> refusalOn(DcmTransportLayer& tls_layer, int socket);

  // for the connections
  void took(int socket);
  void lost(int socket);
  void came(std::size_t bytes) { pace_.came(bytes); }
  /// The socket of the connection that was made last.
  int newest();
  const Server& server() const { return server_; }

 private:
  Server server_;
  Pace pace_;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::set<int> sockets_;
  int newest_ = -1;
  bool waiting_ = false, over_ = false;
  Pace::Verdict verdict_ = Pace::Verdict::Fine;
  std::thread thread_;

  void wait(bool begins);
  void watch();
  void shutDown();
};

}  // namespace app::fetch
