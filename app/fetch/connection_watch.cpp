// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/connection_watch.h"

#include <arpa/inet.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmtls/tlslayer.h>
#include <dcmtk/dcmtls/tlstrans.h>
#include <fcntl.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <sys/socket.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <utility>

namespace app::fetch {
namespace {

constexpr std::chrono::milliseconds kLook{50};
constexpr std::chrono::milliseconds kToCancel{300};

std::atomic<bool> stop_asked{false};
// what the last handshake said; OpenSSL's callbacks have no place of their own
std::atomic<int> certificate_fault{X509_V_OK};
std::atomic<int> alert_read{-1};

// what this thread may still receive
constexpr std::size_t kUnbounded = std::numeric_limits<std::size_t>::max();
thread_local std::size_t may_come = kUnbounded;
thread_local bool too_much = false;

/// A connection that tells the watch what it is and what came.
template <class Base>
class Watched final : public Base {
 public:
  template <class... Rest>
  Watched(ConnectionWatch& watch, int socket, Rest... rest)
      : Base(socket, rest...), watch_{watch}, socket_{socket} {
    watch_.took(socket);
  }
  ~Watched() override { watch_.lost(socket_); }
  ssize_t read(void* to, size_t most) override {
    const ssize_t size = Base::read(to, most);
    if (size <= 0) return size;
    const auto came = static_cast<std::size_t>(size);
    watch_.came(came);
    if (may_come == kUnbounded) return size;
    if (came > may_come) {
      too_much = true;
      ::shutdown(socket_, SHUT_RDWR);
      return 0;
    }
    may_come -= came;
    return size;
  }
  void close() override {
    watch_.lost(socket_);
    Base::close();
  }
  void closeTransportConnection() override {
    watch_.lost(socket_);
    Base::closeTransportConnection();
  }

 private:
  ConnectionWatch& watch_;
  int socket_;
};

class PlainLayer final : public DcmTransportLayer {
 public:
  explicit PlainLayer(ConnectionWatch& watch) : watch_{watch} {}
  DcmTransportConnection* createConnection(DcmNativeSocketType socket, OFBool secure) override {
    return secure ? nullptr : new Watched<DcmTCPConnection>(watch_, socket);
  }

 private:
  ConnectionWatch& watch_;
};

class TlsLayer final : public DcmTLSTransportLayer {
 public:
  TlsLayer(ConnectionWatch& watch, bool acceptor)
      : DcmTLSTransportLayer(acceptor ? NET_ACCEPTOR : NET_REQUESTOR, nullptr, OFTrue),
        watch_{watch},
        acceptor_{acceptor} {}

  DcmTransportConnection* createConnection(DcmNativeSocketType socket, OFBool secure) override {
    if (!secure) return nullptr;
    SSL* connection = SSL_new(getNativeHandle());
    if (connection == nullptr) return nullptr;
    SSL_set_fd(connection, socket);
    if (!acceptor_ && !checkHost(connection)) {
      SSL_free(connection);
      return nullptr;
    }
    return new Watched<DcmTLSConnection>(watch_, socket, connection);
  }

 private:
  ConnectionWatch& watch_;
  bool acceptor_;

  /// The certificate must name the host: DCMTK does not look.
  bool checkHost(SSL* connection) const {
    const std::string& host = watch_.server().host;
    X509_VERIFY_PARAM* wanted = SSL_get0_param(connection);
    unsigned char ignored[sizeof(in6_addr)];
    if (inet_pton(AF_INET, host.c_str(), ignored) == 1 ||
        inet_pton(AF_INET6, host.c_str(), ignored) == 1)
      return X509_VERIFY_PARAM_set1_ip_asc(wanted, host.c_str()) == 1;
    X509_VERIFY_PARAM_set_hostflags(wanted, X509_CHECK_FLAG_NO_PARTIAL_WILDCARDS);
    return SSL_set_tlsext_host_name(connection, host.c_str()) == 1 &&
           X509_VERIFY_PARAM_set1_host(wanted, host.c_str(), host.size()) == 1;
  }
};

int seeCertificate(int sound, X509_STORE_CTX* context) {
  if (sound == 0) certificate_fault = X509_STORE_CTX_get_error(context);
  return sound;
}

void seeAlert(const SSL*, int where, int what) {
  if ((where & SSL_CB_READ_ALERT) == SSL_CB_READ_ALERT && (what >> 8) == SSL3_AL_FATAL)
    alert_read = what & 0xff;
}

std::optional<haptics::Error> tlsTrouble(const Server& server) {
  const int fault = certificate_fault.exchange(X509_V_OK), alert = alert_read.exchange(-1);
  const haptics::Message name = server.name();
  switch (fault) {
    case X509_V_OK:
      break;
    case X509_V_ERR_CERT_HAS_EXPIRED:
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return refused("certificate-expired", {"fetch-certificate-expired", {name}}).value();
    case X509_V_ERR_HOSTNAME_MISMATCH:
    case X509_V_ERR_IP_ADDRESS_MISMATCH:
      return refused("certificate-host", {"fetch-certificate-host", {name}}).value();
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
    case X509_V_ERR_CERT_UNTRUSTED:
      return refused("certificate-authority", {"fetch-certificate-authority", {name}}).value();
    default:
      return refused("certificate", {"fetch-certificate-refused", {name}}).value();
  }
  switch (alert) {
    case SSL_AD_HANDSHAKE_FAILURE:
    case SSL_AD_NO_CERTIFICATE:
    case SSL_AD_BAD_CERTIFICATE:
    case SSL_AD_UNSUPPORTED_CERTIFICATE:
    case SSL_AD_CERTIFICATE_REVOKED:
    case SSL_AD_CERTIFICATE_EXPIRED:
    case SSL_AD_CERTIFICATE_UNKNOWN:
    case SSL_AD_UNKNOWN_CA:
    case SSL_AD_ACCESS_DENIED:
    case SSL_AD_CERTIFICATE_REQUIRED:
      if (server.certificate.empty())
        return refused("certificate-own", {"fetch-certificate-wanted", {name}}).value();
      return refused("certificate-own", {"fetch-certificate-own-refused", {name}}).value();
    default:
      return {};
  }
}

}  // namespace

ConnectionWatch::ConnectionWatch(const Server& server) : server_{server}, pace_{server.patience_s} {
  struct sigaction how {};
  how.sa_handler = [](int) { stop_asked = true; };
  sigaction(SIGTERM, &how, nullptr);
  thread_ = std::thread{[this] { watch(); }};
}

ConnectionWatch::~ConnectionWatch() {
  {
    const std::scoped_lock lock(mutex_);
    over_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

bool ConnectionWatch::stopping() { return stop_asked; }

void ConnectionWatch::watch() {
  Pace::Clock::time_point asked{};
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kLook, [this] { return over_; })) {
    const auto now = Pace::Clock::now();
    if (stop_asked && asked == Pace::Clock::time_point{}) asked = now;
    if (stop_asked && now - asked > kToCancel) shutDown();
    if (!waiting_ || verdict_ != Pace::Verdict::Fine) continue;
    verdict_ = pace_.look();
    if (verdict_ != Pace::Verdict::Fine) shutDown();
  }
}

void ConnectionWatch::wait(bool begins) {
  const std::scoped_lock lock(mutex_);
  waiting_ = begins;
  if (!begins) return;
  pace_.restart();
  verdict_ = Pace::Verdict::Fine;
}

ConnectionWatch::Bound::Bound(std::size_t most) {
  may_come = most;
  too_much = false;
}

ConnectionWatch::Bound::~Bound() { may_come = kUnbounded; }

void ConnectionWatch::shutDown() {
  for (const int socket : sockets_) ::shutdown(socket, SHUT_RDWR);
}

void ConnectionWatch::end() {
  const std::scoped_lock lock(mutex_);
  shutDown();
}

void ConnectionWatch::took(int socket) {
  const std::scoped_lock lock(mutex_);
  sockets_.insert(socket);
  newest_ = socket;
}

int ConnectionWatch::newest() {
  const std::scoped_lock lock(mutex_);
  return newest_;
}

void ConnectionWatch::lost(int socket) {
  const std::scoped_lock lock(mutex_);
  sockets_.erase(socket);
}

std::optional<haptics::Error> ConnectionWatch::trouble() {
  const haptics::Message name = server_.name();
  Pace::Verdict verdict{};
  {
    const std::scoped_lock lock(mutex_);
    verdict = std::exchange(verdict_, Pace::Verdict::Fine);
  }
  if (stop_asked) return cancelled().value();
  if (std::exchange(too_much, false))
    return refused("answer", {"fetch-answer-senseless", {name}}).value();
  if (verdict == Pace::Verdict::Silent)
    return failed("silent",
                  {"fetch-silent", {name, std::to_string(static_cast<int>(server_.patience_s))}})
        .value();
  if (verdict == Pace::Verdict::Slow)
    return failed("slow", {"fetch-slow", {name, std::to_string(kLeastRate_B_s)}}).value();
  return tlsTrouble(server_);
}

std::optional<haptics::Error> ConnectionWatch::refusalOn(DcmTransportLayer& tls_layer, int socket) {
  const std::unique_ptr<SSL, decltype(&SSL_free)> quiet{
      SSL_new(static_cast<TlsLayer&>(tls_layer).getNativeHandle()), &SSL_free};
  const timeval most{2, 0};
  setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &most, sizeof most);
  setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &most, sizeof most);
  fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) & ~O_NONBLOCK);
  char unused = 0;
  if (quiet && SSL_set_fd(quiet.get(), socket) == 1 && SSL_connect(quiet.get()) == 1)
    SSL_read(quiet.get(), &unused, 1);
  return trouble();
}

haptics::Expected<std::unique_ptr<DcmTransportLayer>> ConnectionWatch::layer(
    const std::string& passphrase, bool acceptor) {
  if (!server_.tls) return std::make_unique<PlainLayer>(*this);
  auto tls = std::make_unique<TlsLayer>(*this, acceptor);
  if (!*tls || tls->setTLSProfile(TSP_Profile_BCP195).bad() || tls->activateCipherSuites().bad())
    return failed("tls", {"fetch-no-tls-here", {}});
  SSL_CTX* native = tls->getNativeHandle();
  SSL_CTX_set_default_verify_paths(native);
  if (!server_.authority.empty() &&
      SSL_CTX_load_verify_locations(native, server_.authority.c_str(), nullptr) != 1)
    return refused("certificate-file", {"fetch-certificate-file", {server_.authority}});
  if (!server_.certificate.empty()) {
    tls->setPrivateKeyPasswd(passphrase.c_str());
    if (SSL_CTX_use_certificate_chain_file(native, server_.certificate.c_str()) != 1)
      return refused("certificate-file", {"fetch-certificate-file", {server_.certificate}});
    if (tls->setPrivateKeyFile(server_.key.c_str(), DCF_Filetype_PEM).bad() ||
        !tls->checkPrivateKeyMatchesCertificate())
      return refused("certificate-file", {"fetch-key-file", {server_.key}});
  }
  SSL_CTX_set_verify(native, SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT, seeCertificate);
  SSL_CTX_set_info_callback(native, seeAlert);
  return std::unique_ptr<DcmTransportLayer>(std::move(tls));
}

}  // namespace app::fetch
