// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/association.h"

#include <dcmtk/dcmdata/dcostrmf.h>
#include <dcmtk/dcmnet/diutil.h>
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "app/fetch/arrivals.h"

namespace app::fetch {

using haptics::Expected;

namespace {

constexpr int kLook_ms = 20;

constexpr std::array<const char*, 8> kImageClasses{UID_CTImageStorage,
                                                   UID_EnhancedCTImageStorage,
                                                   UID_LegacyConvertedEnhancedCTImageStorage,
                                                   UID_MRImageStorage,
                                                   UID_EnhancedMRImageStorage,
                                                   UID_LegacyConvertedEnhancedMRImageStorage,
                                                   UID_PositronEmissionTomographyImageStorage,
                                                   UID_XRay3DAngiographicImageStorage};

constexpr std::array<const char*, 13> kTransferSyntaxes{
    UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax,
    UID_BigEndianExplicitTransferSyntax,    UID_DeflatedExplicitVRLittleEndianTransferSyntax,
    UID_JPEGProcess1TransferSyntax,         UID_JPEGProcess2_4TransferSyntax,
    UID_JPEGProcess14TransferSyntax,        UID_JPEGProcess14SV1TransferSyntax,
    UID_JPEGLSLosslessTransferSyntax,       UID_JPEGLSLossyTransferSyntax,
    UID_JPEG2000LosslessOnlyTransferSyntax, UID_JPEG2000TransferSyntax,
    UID_RLELosslessTransferSyntax};

constexpr std::array<const char*, 2> kPlain{UID_LittleEndianExplicitTransferSyntax,
                                            UID_LittleEndianImplicitTransferSyntax};

/// What DCMTK is told to wait: longer than the watch waits, which knows why.
int seconds(const ConnectionWatch& watch) {
  return static_cast<int>(watch.server().patience_s) + 2;
}

/// What a call of DCMTK that failed means where the connection stood.
tl::unexpected<haptics::Error> lossOf(ConnectionWatch& watch) {
  if (auto known = watch.trouble()) return tl::unexpected(std::move(*known));
  return failed("lost", {"fetch-lost", {watch.server().name()}});
}

Expected<void> addContexts(T_ASC_Parameters* parameters, Association::Purpose purpose) {
  using Purpose = Association::Purpose;
  T_ASC_PresentationContextID id = 1;
  bool sound = true;
  const auto add = [&](const char* abstract, std::span<const char* const> transfer,
                       T_ASC_SC_ROLE role) {
    std::vector<const char*> list(transfer.begin(), transfer.end());
    sound = sound && ASC_addPresentationContext(parameters, id, abstract, list.data(),
                                                static_cast<int>(list.size()), role)
                         .good();
    id = static_cast<T_ASC_PresentationContextID>(id + 2);
  };
  if (purpose == Purpose::Echo) add(UID_VerificationSOPClass, kPlain, ASC_SC_ROLE_DEFAULT);
  add(UID_FINDStudyRootQueryRetrieveInformationModel, kPlain, ASC_SC_ROLE_DEFAULT);
  if (purpose == Purpose::Move)
    add(UID_MOVEStudyRootQueryRetrieveInformationModel, kPlain, ASC_SC_ROLE_DEFAULT);
  if (purpose == Purpose::Get) {
    add(UID_GETStudyRootQueryRetrieveInformationModel, kPlain, ASC_SC_ROLE_DEFAULT);
    // a context for each: of several in one the server would choose, and convert
    for (const char* image : kImageClasses)
      for (const char* transfer : kTransferSyntaxes)
        add(image, std::span(&transfer, 1), ASC_SC_ROLE_SCP);
  }
  if (!sound) return failed("memory", {"fetch-memory", {}});
  return {};
}

haptics::Error rejection(const ConnectionWatch& watch, T_ASC_Parameters* parameters) {
  const Server& server = watch.server();
  const haptics::Message name = server.name();
  T_ASC_RejectParameters why{};
  ASC_getRejectParameters(parameters, &why);
  switch (why.reason) {
    case ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED:
      return refused("called-ae", {"fetch-called-ae", {name, server.called}}).value();
    case ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED:
      return refused("calling-ae", {"fetch-calling-ae", {name, server.calling}}).value();
    case ASC_REASON_SP_PRES_TEMPORARYCONGESTION:
    case ASC_REASON_SP_PRES_LOCALLIMITEXCEEDED:
      return failed("busy", {"fetch-busy", {name}}).value();
    default:
      return refused("rejected", {"fetch-rejected", {name, server.called, server.calling}}).value();
  }
}

}  // namespace

std::span<const char* const> imageClasses() { return kImageClasses; }
std::span<const char* const> transferSyntaxes() { return kTransferSyntaxes; }

haptics::Error reachError(ConnectionWatch& watch, DcmTransportLayer& layer) {
  const Server& server = watch.server();
  const haptics::Message name = server.name();
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(server.host.c_str(), std::to_string(server.port).c_str(), &wanted, &found) != 0)
    return failed("host", {"fetch-host-unknown", {name}}).value();
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> all{found, &freeaddrinfo};
  const int probe = socket(found->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  int why = 0;
  if (connect(probe, found->ai_addr, found->ai_addrlen) != 0) {
    why = errno;
    pollfd waited{probe, POLLOUT, 0};
    if (why == EINPROGRESS && poll(&waited, 1, static_cast<int>(kConnectTime_s * 1000)) > 0) {
      socklen_t size = sizeof why;
      getsockopt(probe, SOL_SOCKET, SO_ERROR, &why, &size);
    }
  }
  std::optional<haptics::Error> known;
  if (why == 0 && server.tls) known = watch.refusalOn(layer, probe);
  if (probe >= 0) close(probe);
  if (known) return std::move(*known);
  if (why == ECONNREFUSED) return failed("port", {"fetch-port-closed", {name}}).value();
  if (why != 0) return failed("host", {"fetch-host-unreachable", {name}}).value();
  if (server.tls) return refused("tls", {"fetch-no-tls", {name}}).value();
  return refused("closed", {"fetch-closed-at-once", {name}}).value();
}

bool awaitData(T_ASC_Association* association, int socket, int milliseconds) {
  // TLS may have read more than was asked for
  if (ASC_dataWaiting(association, 0)) return true;
  pollfd waited{socket, POLLIN, 0};
  poll(&waited, 1, milliseconds);
  return ASC_dataWaiting(association, 0);
}

Expected<std::unique_ptr<Association>> Association::open(ConnectionWatch& watch, Purpose purpose,
                                                         const std::string& key_passphrase) {
  const Server& server = watch.server();
  auto layer = watch.layer(key_passphrase, false);
  if (!layer) return tl::unexpected(layer.error());
  std::unique_ptr<Association> made{new Association(watch, std::move(*layer))};
  if (ASC_initializeNetwork(NET_REQUESTOR, 0, seconds(watch), &made->network_).bad() ||
      ASC_setTransportLayer(made->network_, made->layer_.get(), 0).bad())
    return failed("memory", {"fetch-memory", {}});
  T_ASC_Parameters* parameters = nullptr;
  if (ASC_createAssociationParameters(&parameters, ASC_MAXIMUMPDUSIZE).bad())
    return failed("memory", {"fetch-memory", {}});
  ASC_setAPTitles(parameters, server.calling.c_str(), server.called.c_str(), nullptr);
  ASC_setTransportLayerType(parameters, server.tls);
  ASC_setPresentationAddresses(parameters, "localhost",
                               (server.host + ":" + std::to_string(server.port)).c_str());
  if (auto added = addContexts(parameters, purpose); !added) {
    ASC_destroyAssociationParameters(&parameters);
    return tl::unexpected(added.error());
  }
  const ConnectionWatch::Waiting waiting{watch};
  const ConnectionWatch::Bound bound{kLongestMessage};
  const OFCondition asked = ASC_requestAssociation(made->network_, parameters, &made->association_,
                                                   nullptr, nullptr, DUL_NOBLOCK, seconds(watch));
  if (asked.bad()) {
    made->released_ = true;  // there is nothing to abort
    if (asked == DUL_ASSOCIATIONREJECTED) return tl::unexpected(rejection(watch, parameters));
    // without an association the parameters are this function's
    if (made->association_ == nullptr) ASC_destroyAssociationParameters(&parameters);
    if (auto known = watch.trouble()) return tl::unexpected(std::move(*known));
    return tl::unexpected(reachError(watch, *made->layer_));
  }
  made->socket_ = watch.newest();
  return made;
}

Association::~Association() {
  if (association_ != nullptr) {
    if (!released_) {
      // DCMTK waits until the server closes; what it still sends is of no worth
      ::shutdown(socket_, SHUT_RD);
      ASC_abortAssociation(association_);
    }
    ASC_destroyAssociation(&association_);
  }
  if (network_ != nullptr) ASC_dropNetwork(&network_);
}

void Association::release() {
  const ConnectionWatch::Waiting waiting{watch_};
  released_ = ASC_releaseAssociation(association_).good();
}

/// An abort is how some servers answer the first request of a program that they do not permit.
tl::unexpected<haptics::Error> Association::lossOf(const OFCondition& why) {
  auto lost = fetch::lossOf(watch_);
  if (lost.value().reason == "lost" && why == DUL_PEERABORTEDASSOCIATION && !heard_)
    return refused("permission",
                   {"fetch-aborted", {watch_.server().name(), watch_.server().calling}});
  return lost;
}

Expected<T_ASC_PresentationContextID> Association::contextOf(const char* abstract_syntax,
                                                             haptics::Message missing) const {
  const auto id = ASC_findAcceptedPresentationContextID(association_, abstract_syntax);
  if (id == 0) return refused("permission", std::move(missing));
  return id;
}

Expected<void> Association::send(T_ASC_PresentationContextID context, T_DIMSE_Message& message,
                                 DcmDataset* keys) {
  heard_ = false;
  if (DIMSE_sendMessageUsingMemoryData(association_, context, &message, nullptr, keys, nullptr,
                                       nullptr)
          .bad())
    return fetch::lossOf(watch_);
  return {};
}

Expected<T_DIMSE_Message> Association::next(T_ASC_PresentationContextID request, DIC_US id,
                                            T_ASC_PresentationContextID& context,
                                            const std::function<Expected<void>()>& healthy) {
  while (!awaitData(association_, socket_, kLook_ms)) {
    if (ConnectionWatch::stopping() && !std::exchange(cancel_sent_, true))
      DIMSE_sendCancelRequest(association_, request, id);
    if (healthy)
      if (auto sound = healthy(); !sound) return tl::unexpected(sound.error());
  }
  T_DIMSE_Message message{};
  DcmDataset* detail = nullptr;
  const ConnectionWatch::Bound bound{kLongestMessage};
  const OFCondition received = DIMSE_receiveCommand(association_, DIMSE_NONBLOCKING,
                                                    seconds(watch_), &context, &message, &detail);
  const std::unique_ptr<DcmDataset> unused{detail};
  if (received.bad()) return lossOf(received);
  heard_ = true;
  return message;
}

Expected<std::unique_ptr<DcmDataset>> Association::dataset(T_ASC_PresentationContextID context) {
  DcmDataset* received = nullptr;
  const ConnectionWatch::Bound bound{kLongestMessage};
  const OFCondition done = DIMSE_receiveDataSetInMemory(
      association_, DIMSE_NONBLOCKING, seconds(watch_), &context, &received, nullptr, nullptr);
  std::unique_ptr<DcmDataset> owned{received};
  if (done.bad() || !owned) return fetch::lossOf(watch_);
  return owned;
}

/// What the last response of a request means.
Expected<void> Association::finalOf(DIC_US status) const {
  const haptics::Message name = watch_.server().name();
  if (ConnectionWatch::stopping() ||
      status == STATUS_FIND_Cancel_MatchingTerminatedDueToCancelRequest)
    return cancelled();
  if (status == STATUS_Success || (status & 0xf000) == 0xb000) return {};
  if (status == STATUS_MOVE_Refused_MoveDestinationUnknown)
    return refused("destination", {"fetch-move-destination", {name, watch_.server().calling}});
  if (status == 0x0124) return refused("permission", {"fetch-permission", {name}});
  char word[8];
  std::snprintf(word, sizeof word, "%04X", status);
  return refused("answer", {"fetch-status", {name, std::string{"DIMSE "} + word}});
}

Expected<void> Association::echo() {
  const auto context =
      contextOf(UID_VerificationSOPClass,
                {"fetch-no-find", {watch_.server().name(), watch_.server().calling}});
  if (!context) return tl::unexpected(context.error());
  const ConnectionWatch::Waiting waiting{watch_};
  const ConnectionWatch::Bound bound{kLongestMessage};
  DIC_US status = 0;
  DcmDataset* detail = nullptr;
  const OFCondition answered = DIMSE_echoUser(association_, association_->nextMsgID++,
                                              DIMSE_NONBLOCKING, seconds(watch_), &status, &detail);
  const std::unique_ptr<DcmDataset> unused{detail};
  if (answered.bad()) return lossOf(answered);
  heard_ = true;
  return finalOf(status);
}

Expected<void> Association::find(DcmDataset& keys, std::size_t most,
                                 const std::function<void(DcmDataset&)>& found) {
  const auto context =
      contextOf(UID_FINDStudyRootQueryRetrieveInformationModel,
                {"fetch-no-find", {watch_.server().name(), watch_.server().calling}});
  if (!context) return tl::unexpected(context.error());
  const ConnectionWatch::Waiting waiting{watch_};
  T_DIMSE_Message message{};
  message.CommandField = DIMSE_C_FIND_RQ;
  T_DIMSE_C_FindRQ& request = message.msg.CFindRQ;
  request.MessageID = association_->nextMsgID++;
  std::strcpy(request.AffectedSOPClassUID, UID_FINDStudyRootQueryRetrieveInformationModel);
  request.Priority = DIMSE_PRIORITY_MEDIUM;
  request.DataSetType = DIMSE_DATASET_PRESENT;
  if (auto sent = send(*context, message, &keys); !sent) return sent;
  for (std::size_t count = 0;;) {
    T_ASC_PresentationContextID came = 0;
    auto answer = next(*context, request.MessageID, came, {});
    if (!answer) return tl::unexpected(answer.error());
    if (answer->CommandField != DIMSE_C_FIND_RSP)
      return refused("answer", {"fetch-answer-senseless", {watch_.server().name()}});
    const T_DIMSE_C_FindRSP& response = answer->msg.CFindRSP;
    std::unique_ptr<DcmDataset> match;
    if (response.DataSetType != DIMSE_DATASET_NULL) {
      auto received = dataset(came);
      if (!received) return tl::unexpected(received.error());
      match = std::move(*received);
    }
    if (!DICOM_PENDING_STATUS(response.DimseStatus)) return finalOf(response.DimseStatus);
    if (++count > most) {
      DIMSE_sendCancelRequest(association_, *context, request.MessageID);
      return refused("too-many", {"fetch-too-many-matches", {std::to_string(most)}});
    }
    if (match) found(*match);
  }
}

/// What a response to C-GET or C-MOVE says: nothing yet, while images are still to come.
template <class Response>
Expected<std::optional<Retrieved>> Association::endOf(const Response& response,
                                                      T_ASC_PresentationContextID context,
                                                      Arrivals& arrivals, unsigned int sent_given,
                                                      unsigned int failed_given) {
  if (response.DataSetType != DIMSE_DATASET_NULL)
    if (auto unused = dataset(context); !unused) return tl::unexpected(unused.error());
  // an image with a warning was sent too
  const std::size_t done =
      std::size_t{response.NumberOfCompletedSubOperations} + response.NumberOfWarningSubOperations;
  if (DICOM_PENDING_STATUS(response.DimseStatus)) {
    arrivals.announce(done + response.NumberOfRemainingSubOperations +
                      response.NumberOfFailedSubOperations);
    return std::nullopt;
  }
  if (auto ended = finalOf(response.DimseStatus); !ended) return tl::unexpected(ended.error());
  Retrieved all;
  if ((response.opts & sent_given) != 0) all.sent = done;
  if ((response.opts & failed_given) != 0) all.failed = response.NumberOfFailedSubOperations;
  return all;
}

Expected<Retrieved> Association::get(DcmDataset& keys, Arrivals& arrivals) {
  const auto context = contextOf(UID_GETStudyRootQueryRetrieveInformationModel,
                                 {"fetch-no-get", {watch_.server().name()}});
  if (!context) return tl::unexpected(context.error());
  const ConnectionWatch::Waiting waiting{watch_};
  T_DIMSE_Message message{};
  message.CommandField = DIMSE_C_GET_RQ;
  T_DIMSE_C_GetRQ& request = message.msg.CGetRQ;
  request.MessageID = association_->nextMsgID++;
  std::strcpy(request.AffectedSOPClassUID, UID_GETStudyRootQueryRetrieveInformationModel);
  request.Priority = DIMSE_PRIORITY_MEDIUM;
  request.DataSetType = DIMSE_DATASET_PRESENT;
  if (auto sent = send(*context, message, &keys); !sent) return tl::unexpected(sent.error());
  for (;;) {
    T_ASC_PresentationContextID came = 0;
    auto answer = next(*context, request.MessageID, came, {});
    if (!answer) return tl::unexpected(answer.error());
    if (answer->CommandField == DIMSE_C_STORE_RQ) {
      if (auto stored = receiveImage(watch_, association_, came, answer->msg.CStoreRQ, arrivals);
          !stored)
        return tl::unexpected(stored.error());
      if (ConnectionWatch::stopping() && !std::exchange(cancel_sent_, true))
        DIMSE_sendCancelRequest(association_, *context, request.MessageID);
      continue;
    }
    if (answer->CommandField != DIMSE_C_GET_RSP)
      return refused("answer", {"fetch-answer-senseless", {watch_.server().name()}});
    auto ended = endOf(answer->msg.CGetRSP, came, arrivals, O_GET_NUMBEROFCOMPLETEDSUBOPERATIONS,
                       O_GET_NUMBEROFFAILEDSUBOPERATIONS);
    if (!ended) return tl::unexpected(ended.error());
    if (*ended) return **ended;
  }
}

Expected<Retrieved> Association::move(DcmDataset& keys, Arrivals& arrivals,
                                      const std::function<Expected<void>()>& healthy) {
  const auto context = contextOf(UID_MOVEStudyRootQueryRetrieveInformationModel,
                                 {"fetch-no-move", {watch_.server().name()}});
  if (!context) return tl::unexpected(context.error());
  const ConnectionWatch::Waiting waiting{watch_};
  T_DIMSE_Message message{};
  message.CommandField = DIMSE_C_MOVE_RQ;
  T_DIMSE_C_MoveRQ& request = message.msg.CMoveRQ;
  request.MessageID = association_->nextMsgID++;
  std::strcpy(request.AffectedSOPClassUID, UID_MOVEStudyRootQueryRetrieveInformationModel);
  std::strcpy(request.MoveDestination, watch_.server().calling.c_str());
  request.Priority = DIMSE_PRIORITY_MEDIUM;
  request.DataSetType = DIMSE_DATASET_PRESENT;
  if (auto sent = send(*context, message, &keys); !sent) return tl::unexpected(sent.error());
  for (;;) {
    T_ASC_PresentationContextID came = 0;
    auto answer = next(*context, request.MessageID, came, healthy);
    if (!answer) return tl::unexpected(answer.error());
    if (answer->CommandField != DIMSE_C_MOVE_RSP)
      return refused("answer", {"fetch-answer-senseless", {watch_.server().name()}});
    auto ended = endOf(answer->msg.CMoveRSP, came, arrivals, O_MOVE_NUMBEROFCOMPLETEDSUBOPERATIONS,
                       O_MOVE_NUMBEROFFAILEDSUBOPERATIONS);
    if (!ended) return tl::unexpected(ended.error());
    if (*ended) return **ended;
  }
}

Expected<void> receiveImage(ConnectionWatch& watch, T_ASC_Association* association,
                            T_ASC_PresentationContextID context, const T_DIMSE_C_StoreRQ& request,
                            Arrivals& arrivals) {
  struct Counter {
    ConnectionWatch& watch;
    Arrivals& arrivals;
    unsigned long seen = 0;
    Expected<void> fine = {};
  } counter{watch, arrivals};
  DcmOutputFileStream* opened = nullptr;
  const OFCondition created = DIMSE_createFilestream(OFFilename(arrivals.part().c_str()), &request,
                                                     association, context, 1, &opened);
  std::unique_ptr<DcmOutputFileStream> file{opened};
  if (created.bad() || !file)
    return failed("unwritable", {"fetch-disk", {arrivals.part().parent_path().string()}});
  const OFCondition received = DIMSE_receiveDataSetInFile(
      association, DIMSE_NONBLOCKING, seconds(watch), &context, file.get(),
      [](void* to, unsigned long bytes) {
        auto& c = *static_cast<Counter*>(to);
        if (c.fine) c.fine = c.arrivals.came(bytes - std::exchange(c.seen, bytes));
        if (!c.fine) c.watch.end();
      },
      &counter);
  const bool written = file->good();
  file.reset();
  if (!counter.fine) return counter.fine;
  if (received.bad() || !written) {
    arrivals.drop();
    if (!written)
      return failed("unwritable", {"fetch-disk", {arrivals.part().parent_path().string()}});
    return lossOf(watch);
  }
  const auto kept = arrivals.keep();
  T_DIMSE_C_StoreRSP response{};
  response.MessageIDBeingRespondedTo = request.MessageID;
  response.DimseStatus = kept ? STATUS_Success : STATUS_STORE_Refused_OutOfResources;
  response.DataSetType = DIMSE_DATASET_NULL;
  std::strcpy(response.AffectedSOPClassUID, request.AffectedSOPClassUID);
  std::strcpy(response.AffectedSOPInstanceUID, request.AffectedSOPInstanceUID);
  response.opts = O_STORE_AFFECTEDSOPCLASSUID | O_STORE_AFFECTEDSOPINSTANCEUID;
  if (DIMSE_sendStoreResponse(association, context, &request, &response, nullptr).bad())
    return lossOf(watch);
  return kept;
}

}  // namespace app::fetch
