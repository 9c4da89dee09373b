// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/incoming.h"

#include <dcmtk/dcmnet/assoc.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <system_error>

#include "app/fetch/association.h"

namespace app::fetch {

using haptics::Expected;

namespace {

constexpr int kLook_ms = 20;
constexpr int kBacklog = 4;

std::string numeric(const sockaddr* address, socklen_t size) {
  char host[NI_MAXHOST];
  if (getnameinfo(address, size, host, sizeof host, nullptr, 0, NI_NUMERICHOST) != 0) return {};
  return host;
}

/// A title without the blanks that pad it.
std::string trimmed(const char* title) {
  std::string text{title};
  text.erase(text.find_last_not_of(' ') + 1);
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// Accepts what is fetched, each context in the first of its transfer syntaxes that is known.
bool acceptContexts(T_ASC_Parameters* parameters) {
  bool any = false;
  const auto known = [](std::span<const char* const> list, std::string_view uid) {
    return std::ranges::any_of(list, [&](const char* one) { return uid == one; });
  };
  for (int i = 0; i < ASC_countPresentationContexts(parameters); ++i) {
    T_ASC_PresentationContext context{};
    if (ASC_getPresentationContext(parameters, i, &context).bad()) continue;
    const char* chosen = nullptr;
    if (known(imageClasses(), context.abstractSyntax))
      for (int t = 0; t < context.transferSyntaxCount && chosen == nullptr; ++t)
        if (known(transferSyntaxes(), context.proposedTransferSyntaxes[t]))
          chosen = context.proposedTransferSyntaxes[t];
    if (chosen != nullptr)
      any =
          ASC_acceptPresentationContext(parameters, context.presentationContextID, chosen).good() ||
          any;
    else
      ASC_refusePresentationContext(parameters, context.presentationContextID,
                                    ASC_P_ABSTRACTSYNTAXNOTSUPPORTED);
  }
  return any;
}

/// DCMTK's network and association of one connection.
struct Accepted {
  T_ASC_Network* network = nullptr;
  T_ASC_Association* association = nullptr;
  bool released = false;
  ~Accepted() {
    if (association != nullptr) {
      // after a release the other end closes
      if (released) ASC_dropSCPAssociation(association);
      ASC_destroyAssociation(&association);
    }
    if (network != nullptr) ASC_dropNetwork(&network);
  }
};

}  // namespace

Expected<std::unique_ptr<Incoming>> Incoming::open(ConnectionWatch& watch, Arrivals& arrivals,
                                                   const std::string& key_passphrase) {
  const Server& server = watch.server();
  if (server.tls && server.certificate.empty())
    return refused("usage", {"fetch-move-needs-certificate", {}});
  auto layer = watch.layer(key_passphrase, true);
  if (!layer) return tl::unexpected(layer.error());
  std::unique_ptr<Incoming> made{new Incoming(watch, arrivals, std::move(*layer))};
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_socktype = SOCK_STREAM;
  if (getaddrinfo(server.host.c_str(), nullptr, &wanted, &found) != 0)
    return failed("host", {"fetch-host-unknown", {server.name()}});
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next)
    made->peers_.push_back(numeric(one->ai_addr, one->ai_addrlen));
  freeaddrinfo(found);

  // an address, not a name: which one is listened on is not for a name server to say
  wanted.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  const haptics::Message place = server.listen_address + ":" + std::to_string(server.listen_port);
  if (getaddrinfo(server.listen_address.c_str(), std::to_string(server.listen_port).c_str(),
                  &wanted, &found) != 0)
    return refused("usage", {"fetch-listen-address", {server.listen_address}});
  made->listening_ = socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int yes = 1;
  setsockopt(made->listening_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool bound = bind(made->listening_, found->ai_addr, found->ai_addrlen) == 0 &&
                     ::listen(made->listening_, kBacklog) == 0;
  const int why = errno;
  freeaddrinfo(found);
  if (!bound)
    return failed("listen", {"fetch-not-listening", {place, std::generic_category().message(why)}});
  made->thread_ = std::thread{[in = made.get()] { in->listen(); }};
  return made;
}

Incoming::~Incoming() {
  over_ = true;
  if (listening_ >= 0) ::shutdown(listening_, SHUT_RDWR);  // wakes the thread
  if (thread_.joinable()) thread_.join();
  if (listening_ >= 0) close(listening_);
}

Expected<void> Incoming::health() {
  const std::scoped_lock lock(mutex_);
  return health_;
}

void Incoming::settle(std::optional<std::size_t> sent) {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  // what is in the backlog is taken within a look or two; an association that stays open is not
  // waited for longer than the server is
  const auto least = begun + std::chrono::milliseconds(3 * kLook_ms);
  const auto most = begun + std::chrono::duration<double>(watch_.server().patience_s);
  while (Clock::now() < most && !ConnectionWatch::stopping()) {
    const bool all = sent && taken_ >= *sent, late = Clock::now() > least;
    if ((all && late) || (!busy_ && (all || late))) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void Incoming::listen() {
  while (!over_) {
    pollfd waited{listening_, POLLIN, 0};
    if (poll(&waited, 1, kLook_ms) <= 0) continue;
    sockaddr_storage from{};
    socklen_t size = sizeof from;
    busy_ = true;
    const int socket = accept4(listening_, reinterpret_cast<sockaddr*>(&from), &size, SOCK_CLOEXEC);
    if (socket >= 0) {
      const std::string peer = numeric(reinterpret_cast<sockaddr*>(&from), size);
      if (std::ranges::find(peers_, peer) == peers_.end()) {
        close(socket);
      } else if (auto taken = take(socket); !taken) {
        const std::scoped_lock lock(mutex_);
        health_ = taken;
      }
    }
    busy_ = false;
  }
}

/// One connection of the server's, to its end. What it does wrong ends it alone, what is wrong here
/// ends the transfer.
Expected<void> Incoming::take(int socket) {
  const Server& server = watch_.server();
  const int patience = static_cast<int>(server.patience_s) + 2;
  dcmExternalSocketHandle.set(socket);
  Accepted accepted;
  if (ASC_initializeNetwork(NET_ACCEPTOR, 0, patience, &accepted.network).bad() ||
      ASC_setTransportLayer(accepted.network, layer_.get(), 0).bad()) {
    close(socket);
    return failed("memory", {"fetch-memory", {}});
  }
  {
    const ConnectionWatch::Bound bound{kLongestMessage};
    if (ASC_receiveAssociation(accepted.network, &accepted.association, ASC_MAXIMUMPDUSIZE, nullptr,
                               nullptr, server.tls, DUL_NOBLOCK, patience)
            .bad())
      return {};
  }
  T_ASC_Association* association = accepted.association;
  std::array<char, 17> calling{}, called{}, unused{};
  ASC_getAPTitles(association->params, calling.data(), calling.size(), called.data(), called.size(),
                  unused.data(), unused.size());
  const bool from_server = trimmed(calling.data()) == server.called;
  if (!from_server || trimmed(called.data()) != server.calling ||
      !acceptContexts(association->params)) {
    const T_ASC_RejectParameters why{ASC_RESULT_REJECTEDPERMANENT, ASC_SOURCE_SERVICEUSER,
                                     from_server ? ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED
                                                 : ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED};
    ASC_rejectAssociation(association, &why);
    return {};
  }
  if (ASC_acknowledgeAssociation(association).bad()) return {};
  const int connection = watch_.newest();
  for (;;) {
    while (!awaitData(association, connection, kLook_ms))
      if (over_ || ConnectionWatch::stopping()) return {};
    T_DIMSE_Message message{};
    T_ASC_PresentationContextID context = 0;
    const OFCondition received = [&] {
      const ConnectionWatch::Bound bound{kLongestMessage};
      return DIMSE_receiveCommand(association, DIMSE_NONBLOCKING, patience, &context, &message,
                                  nullptr);
    }();
    if (received == DUL_PEERREQUESTEDRELEASE)
      accepted.released = ASC_acknowledgeRelease(association).good();
    if (received.bad() || message.CommandField != DIMSE_C_STORE_RQ) return {};
    if (auto stored = receiveImage(watch_, association, context, message.msg.CStoreRQ, arrivals_);
        !stored) {
      // the server's own connection tells of a loss; here it may be another one's
      if (isLoss(stored.error())) return {};
      return stored;
    }
    ++taken_;
  }
}

}  // namespace app::fetch
