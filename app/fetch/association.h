// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/dimse.h>
#include "app/fetch/connection_watch.h"

namespace app::fetch {

class Arrivals;

/// The classes of images that are fetched, and the transfer syntaxes in which a server may have
/// them.
std::span<const char* const> imageClasses();
std::span<const char* const> transferSyntaxes();

/// Bytes of a command, of a match and of the answer to a request for an association. A command may
/// come in one PDU with the begin of an image.
inline constexpr std::size_t kLongestMessage = ASC_MAXIMUMPDUSIZE + (std::size_t{64} << 10);

/// What a server says of a retrieval: images that it sent, and that it did not send. Nothing where
/// it does not say it.
struct Retrieved {
  std::optional<std::size_t> sent, failed;
};

/// One association that this program asked for. Calls return an error when the connection is lost,
/// and then the association is of no more use.
class Association {
 public:
  enum class Purpose { Echo, Find, Get, Move };
  static haptics::Expected<std::unique_ptr<Association>> open(ConnectionWatch& watch,
                                                              Purpose purpose,
                                                              const std::string& key_passphrase);
  ~Association();
  Association(const Association&) = delete;
  Association& operator=(const Association&) = delete;

  haptics::Expected<void> echo();
  /// C-FIND: calls `found` for each match. More than `most` are an error.
  haptics::Expected<void> find(DcmDataset& keys, std::size_t most,
                               const std::function<void(DcmDataset&)>& found);
  /// C-GET: the images come on this association.
  haptics::Expected<Retrieved> get(DcmDataset& keys, Arrivals& arrivals);
  /// C-MOVE to this program's AE title. `healthy` is asked between messages.
  haptics::Expected<Retrieved> move(DcmDataset& keys, Arrivals& arrivals,
                                    const std::function<haptics::Expected<void>()>& healthy);
  void release();

 private:
  Association(ConnectionWatch& watch, std::unique_ptr<DcmTransportLayer> layer)
      : watch_{watch}, layer_{std::move(layer)} {}

  ConnectionWatch& watch_;
  std::unique_ptr<DcmTransportLayer> layer_;
  T_ASC_Network* network_ = nullptr;
  T_ASC_Association* association_ = nullptr;
  int socket_ = -1;
  bool released_ = false, cancel_sent_ = false, heard_ = false;

  haptics::Expected<T_ASC_PresentationContextID> contextOf(const char* abstract_syntax,
                                                           haptics::Message missing) const;
  haptics::Expected<void> send(T_ASC_PresentationContextID context, T_DIMSE_Message& message,
                               DcmDataset* keys);
  /// The next message; where one asks to stop, C-CANCEL is sent first.
  haptics::Expected<T_DIMSE_Message> next(T_ASC_PresentationContextID request, DIC_US id,
                                          T_ASC_PresentationContextID& context,
                                          const std::function<haptics::Expected<void>()>& healthy);
  haptics::Expected<std::unique_ptr<DcmDataset>> dataset(T_ASC_PresentationContextID context);
  haptics::Expected<void> finalOf(DIC_US status) const;
  template <class Response>
  haptics::Expected<std::optional<Retrieved>> endOf(const Response& response,
                                                    T_ASC_PresentationContextID context,
                                                    Arrivals& arrivals, unsigned int sent_given,
                                                    unsigned int failed_given);
  tl::unexpected<haptics::Error> lossOf(const OFCondition& why);
};

/// Receives the image of a C-STORE request into `arrivals` and answers the request. An error ends
/// the transfer.
haptics::Expected<void> receiveImage(ConnectionWatch& watch, T_ASC_Association* association,
                                     T_ASC_PresentationContextID context,
                                     const T_DIMSE_C_StoreRQ& request, Arrivals& arrivals);

/// Waits for some time at most until data come, on the socket of the association; whether they do.
bool awaitData(T_ASC_Association* association, int socket, int milliseconds);

/// Why no connection could be made, or what else is wrong.
haptics::Error reachError(ConnectionWatch& watch, DcmTransportLayer& layer);

}  // namespace app::fetch
