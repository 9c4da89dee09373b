// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/web_archive.h"

#include <QEventLoop>
#include <QFile>
#include <QHostAddress>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QSslCertificate>
#include <QSslConfiguration>
#include <QSslKey>
#include <QSslSocket>
#include <QTimer>
#include <QUrl>
#include <QUrlQuery>
#include <algorithm>
#include <functional>

#include "app/fetch/arrivals.h"
#include "app/fetch/multipart.h"
#include "app/fetch/pace.h"
#include "app/fetch/qido.h"

namespace app::fetch {
namespace {

using haptics::Expected;

constexpr qint64 kBuffer = qint64{1} << 20;  // bytes that wait to be read, at most
constexpr qint64 kMostRefusal = 65536;       // bytes of words behind an error's status
constexpr int kLook_ms = 100;
constexpr int kRedirects = 3;
constexpr int kNoContent = 204;      // HTTP status
constexpr const char* kWild = "*?";  // some servers do not decode these
constexpr const char* kJson = "application/dicom+json";
constexpr const char* kImages = "multipart/related; type=\"application/dicom\"; transfer-syntax=*";

/// Where the body of an answer goes, as it comes.
struct Body {
  std::function<Expected<void>(const QString& content_type)> begins;
  std::function<Expected<void>(std::span<const char>)> bytes;
};

class WebArchive final : public Archive {
 public:
  WebArchive(const Server& server, QUrl base, QByteArray authorization,
             std::optional<QSslConfiguration> tls)
      : server_{server},
        base_{std::move(base)},
        authorization_{std::move(authorization)},
        tls_{std::move(tls)} {}

  Expected<void> echo() override {
    QUrlQuery query;
    query.addQueryItem("limit", "1");
    const auto text = json("/studies", query);
    if (!text) return tl::unexpected(text.error());
    const auto findings = findingsFrom(*text, Level::Study);
    if (!findings) return tl::unexpected(findings.error());
    return {};
  }

  Expected<Findings> find(const Query& query) override;
  Expected<void> get(const FoundSeries& series, Arrivals& arrivals) override;

 private:
  Server server_;
  QUrl base_;
  QByteArray authorization_;
  std::optional<QSslConfiguration> tls_;  ///< of https alone: making one starts a TLS library
  QNetworkAccessManager network_;
  std::vector<char> piece_ = std::vector<char>(kBuffer);  ///< of an answer, on its way

  haptics::Message name() const { return server_.name(); }
  Expected<void> request(const std::string& path, const QUrlQuery& query, const char* accept,
                         const Body& body);
  Expected<std::string> json(const std::string& path, const QUrlQuery& query);
  Expected<void> images(const std::string& path, Arrivals& arrivals);
  Expected<void> list(const std::string& path, Arrivals& arrivals);
  /// The server's alert, from a connection without a request. A request that the server leaves
  /// unread makes its host reset the connection, and the alert is lost.
  QString lastWordOfTls() const;
  tl::unexpected<haptics::Error> troubleOf(const QNetworkReply& reply,
                                           const QList<QSslError>& errors, bool arrived) const;
  tl::unexpected<haptics::Error> statusTrouble(int status) const;
};

/// A certificate's fault, the one that names it best.
std::optional<haptics::Error> faultOf(const QList<QSslError>& errors,
                                      const haptics::Message& server) {
  const auto any = [&](std::initializer_list<QSslError::SslError> kinds) {
    return std::ranges::any_of(errors, [&](const QSslError& error) {
      return std::ranges::find(kinds, error.error()) != kinds.end();
    });
  };
  if (errors.isEmpty()) return {};
  if (any({QSslError::CertificateExpired, QSslError::CertificateNotYetValid}))
    return refused("certificate-expired", {"fetch-certificate-expired", {server}}).value();
  if (any({QSslError::SelfSignedCertificate, QSslError::SelfSignedCertificateInChain,
           QSslError::UnableToGetLocalIssuerCertificate, QSslError::UnableToGetIssuerCertificate,
           QSslError::UnableToVerifyFirstCertificate, QSslError::CertificateUntrusted}))
    return refused("certificate-authority", {"fetch-certificate-authority", {server}}).value();
  if (any({QSslError::HostNameMismatch}))
    return refused("certificate-host", {"fetch-certificate-host", {server}}).value();
  return refused("certificate", {"fetch-certificate-refused", {server}}).value();
}

/// Whether a server's alert is about the certificate of who asks. Qt passes on what a TLS library
/// says of it as words alone.
bool isOfOwnCertificate(const QString& words) {
  return words.contains("certificate required") || words.contains("alert bad certificate") ||
         words.contains("alert unknown ca") || words.contains("alert certificate") ||
         words.contains("alert handshake failure");
}

QString WebArchive::lastWordOfTls() const {
  constexpr int kLongest_ms = 2000;
  QSslSocket socket;
  QString words;  // of all, since the last is that the connection is closed
  QObject::connect(&socket, &QAbstractSocket::errorOccurred, &socket,
                   [&] { words += socket.errorString() + "\n"; });
  socket.setSslConfiguration(*tls_);
  socket.connectToHostEncrypted(base_.host(), static_cast<quint16>(base_.port(443)));
  if (socket.waitForEncrypted(kLongest_ms)) socket.waitForReadyRead(kLongest_ms);
  return words;
}

tl::unexpected<haptics::Error> WebArchive::troubleOf(const QNetworkReply& reply,
                                                     const QList<QSslError>& errors,
                                                     bool arrived) const {
  if (auto fault = faultOf(errors, name())) return tl::unexpected(std::move(*fault));
  const bool closed_at_once = reply.error() == QNetworkReply::RemoteHostClosedError &&
                              !reply.attribute(QNetworkRequest::HttpStatusCodeAttribute).isValid();
  if (isOfOwnCertificate(reply.errorString()) ||
      (closed_at_once && tls_ && isOfOwnCertificate(lastWordOfTls()))) {
    if (server_.certificate.empty())
      return refused("certificate-own", {"fetch-certificate-wanted", {name()}});
    return refused("certificate-own", {"fetch-certificate-own-refused", {name()}});
  }
  switch (reply.error()) {
    case QNetworkReply::HostNotFoundError:
      return failed("host", {"fetch-host-unknown", {name()}});
    case QNetworkReply::ConnectionRefusedError:
      return failed("port", {"fetch-port-closed", {name()}});
    case QNetworkReply::SslHandshakeFailedError:
      return refused("tls", {"fetch-no-tls", {name()}});
    case QNetworkReply::InsecureRedirectError:
    case QNetworkReply::TooManyRedirectsError:
      return refused("redirect", {"fetch-redirect", {name()}});
    case QNetworkReply::RemoteHostClosedError:
      if (closed_at_once) return failed("lost", {"fetch-closed-at-once", {name()}});
      return failed("lost", {"fetch-lost", {name()}});
    case QNetworkReply::TimeoutError:
    case QNetworkReply::UnknownNetworkError:
    case QNetworkReply::TemporaryNetworkFailureError:
    case QNetworkReply::NetworkSessionFailedError:
      if (!arrived) return failed("host", {"fetch-host-unreachable", {name()}});
      return failed("lost", {"fetch-lost", {name()}});
    default:
      return refused("answer", {"fetch-no-http", {name()}});
  }
}

tl::unexpected<haptics::Error> WebArchive::statusTrouble(int status) const {
  switch (status) {
    case 401:
      if (authorization_.isEmpty()) return refused("login", {"fetch-login-wanted", {name()}});
      return refused("login", {"fetch-login-refused", {name()}});
    case 403:
      return refused("permission", {"fetch-permission", {name()}});
    case 404:
    case 405:
      return refused("path", {"fetch-no-dicomweb", {name()}});
    case 413:
      return refused("too-many", {"fetch-answer-too-large", {}});
    default:
      return refused("answer", {"fetch-status", {name(), "HTTP " + std::to_string(status)}});
  }
}

Expected<void> WebArchive::request(const std::string& path, const QUrlQuery& query,
                                   const char* accept, const Body& body) {
  QUrl url = base_;
  url.setPath(base_.path() + QString::fromStdString(path));
  if (!query.isEmpty()) url.setQuery(query);
  QNetworkRequest asked{url};
  if (tls_) asked.setSslConfiguration(*tls_);
  asked.setRawHeader("Accept", accept);
  // whoever packs a body may pack a small one that becomes large
  asked.setRawHeader("Accept-Encoding", "identity");
  asked.setRawHeader("User-Agent", "palpate-fetch");
  if (!authorization_.isEmpty()) asked.setRawHeader("Authorization", authorization_);
  asked.setAttribute(QNetworkRequest::Http2AllowedAttribute, false);
  asked.setAttribute(QNetworkRequest::RedirectPolicyAttribute,
                     QNetworkRequest::SameOriginRedirectPolicy);
  asked.setAttribute(QNetworkRequest::CacheLoadControlAttribute, QNetworkRequest::AlwaysNetwork);
  asked.setAttribute(QNetworkRequest::CookieLoadControlAttribute, QNetworkRequest::Manual);
  asked.setAttribute(QNetworkRequest::CookieSaveControlAttribute, QNetworkRequest::Manual);
  asked.setAttribute(QNetworkRequest::AuthenticationReuseAttribute, QNetworkRequest::Manual);
  asked.setMaximumRedirectsAllowed(kRedirects);

  const std::unique_ptr<QNetworkReply> reply{network_.get(asked)};
  reply->setReadBufferSize(kBuffer);
  QEventLoop loop;
  QList<QSslError> errors;
  std::optional<haptics::Error> trouble;
  bool begun = false, sent = false;
  bool refused_at_length = false;  // what more is said of it, nobody reads
  qint64 read = 0;
  Pace pace{server_.patience_s};
  const auto begun_at = Pace::Clock::now();

  const auto give = [&] {
    while (!trouble && !refused_at_length && reply->bytesAvailable() > 0) {
      const int status = reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
      const qint64 size = reply->read(piece_.data(), kBuffer);
      if (size <= 0) break;
      const std::span<const char> bytes{piece_.data(), static_cast<std::size_t>(size)};
      read += size;
      pace.came(bytes.size());
      if (status < 200 || status > 299) {  // words for people, in an error
        refused_at_length = read > kMostRefusal;
        if (refused_at_length) break;
        continue;
      }
      if (!std::exchange(begun, true)) {
        const QByteArray packed = reply->rawHeader("Content-Encoding").toLower();
        if (!packed.isEmpty() && packed != "identity") {
          trouble = refused("answer", {"fetch-answer-senseless", {name()}}).value();
          break;
        }
        if (auto begins = body.begins(reply->header(QNetworkRequest::ContentTypeHeader).toString());
            !begins) {
          trouble = begins.error();
          break;
        }
      }
      if (auto taken = body.bytes(bytes); !taken) trouble = taken.error();
    }
    if (trouble || refused_at_length) loop.quit();
  };
  QObject::connect(reply.get(), &QNetworkReply::sslErrors, &loop,
                   [&](const QList<QSslError>& all) { errors = all; });
  QObject::connect(reply.get(), &QNetworkReply::requestSent, &loop, [&] { sent = true; });
  QObject::connect(reply.get(), &QNetworkReply::encrypted, &loop, [&] { sent = true; });
  QObject::connect(reply.get(), &QNetworkReply::metaDataChanged, &loop, [&] { pace.came(1); });
  QObject::connect(reply.get(), &QNetworkReply::readyRead, &loop, give);
  QObject::connect(reply.get(), &QNetworkReply::finished, &loop, &QEventLoop::quit);
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
    const std::chrono::duration<double> since = Pace::Clock::now() - begun_at;
    if (!sent && pace.bytes() == 0 &&
        since.count() > std::min(kConnectTime_s, server_.patience_s)) {
      trouble = failed("host", {"fetch-host-unreachable", {name()}}).value();
    } else if (const auto verdict = pace.look(); verdict == Pace::Verdict::Silent) {
      trouble =
          failed("silent", {"fetch-silent", {name(), std::to_string(int(server_.patience_s))}})
              .value();
    } else if (verdict == Pace::Verdict::Slow) {
      trouble = failed("slow", {"fetch-slow", {name(), std::to_string(kLeastRate_B_s)}}).value();
    }
    if (trouble) loop.quit();
  });
  timer.start(kLook_ms);
  if (!reply->isFinished()) loop.exec();
  if (!trouble) give();
  timer.stop();
  const int status = reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
  if (trouble || refused_at_length) {
    reply->disconnect(&loop);
    reply->abort();
  }
  if (trouble) return tl::unexpected(std::move(*trouble));
  if (status >= 300 && status < 400) return refused("redirect", {"fetch-redirect", {name()}});
  if (status >= 400) return statusTrouble(status);
  if (reply->error() != QNetworkReply::NoError) return troubleOf(*reply, errors, begun || sent);
  // Qt may take a connection that broke off for the end of an answer
  const QVariant length = reply->header(QNetworkRequest::ContentLengthHeader);
  if (length.isValid() ? length.toLongLong() != read : !begun && status != kNoContent)
    return failed("lost", {"fetch-lost", {name()}});
  if (!begun)
    if (auto begins = body.begins({}); !begins) return tl::unexpected(begins.error());
  return {};
}

Expected<std::string> WebArchive::json(const std::string& path, const QUrlQuery& query) {
  std::string text;
  const Body body{.begins = [&](const QString& type) -> Expected<void> {
                    if (type.isEmpty() || type.startsWith("application/dicom+json") ||
                        type.startsWith("application/json"))
                      return {};
                    return refused("path", {"fetch-no-dicomweb", {name()}});
                  },
                  .bytes = [&](std::span<const char> bytes) -> Expected<void> {
                    text.append(bytes.data(), bytes.size());
                    if (text.size() > kMostJson)
                      return refused("too-many", {"fetch-answer-too-large", {}});
                    return {};
                  }};
  if (auto answered = request(path, query, kJson, body); !answered)
    return tl::unexpected(answered.error());
  return text;
}

Expected<Findings> WebArchive::find(const Query& query) {
  QUrlQuery asked;
  const auto add = [&](const char* key, const std::string& value) {
    if (!value.empty())
      asked.addQueryItem(
          key, QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(value), kWild)));
  };
  add("PatientID", query.patient_id);
  add("PatientName", query.patient_name);
  add("AccessionNumber", query.accession_number);
  add("StudyDate", query.study_date);
  add("StudyDescription", query.study_description);
  add("ModalitiesInStudy", query.modality);
  add("includefield", "00081030");
  add("limit", std::to_string(kMostStudies + 1));
  const auto text = json("/studies", asked);
  if (!text) return tl::unexpected(text.error());
  const auto studies = findingsFrom(*text, Level::Study);
  if (!studies) return tl::unexpected(studies.error());
  if (studies->series.size() > kMostStudies)
    return refused("too-many", {"fetch-too-many-matches", {std::to_string(kMostStudies)}});

  Findings all;
  all.refused = studies->refused;
  for (const FoundSeries& study : studies->series) {
    QUrlQuery narrowed;
    if (!query.modality.empty())
      narrowed.addQueryItem(
          "Modality",
          QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(query.modality))));
    narrowed.addQueryItem("includefield", "00201209");
    narrowed.addQueryItem("includefield", "0008103E");
    const auto series_text = json("/studies/" + study.study_uid + "/series", narrowed);
    if (!series_text) return tl::unexpected(series_text.error());
    auto found = findingsFrom(*series_text, Level::Series);
    if (!found) return tl::unexpected(found.error());
    all.refused += found->refused;
    for (FoundSeries& series : found->series) {
      // another study's series in the answer is none of this one
      if (!series.study_uid.empty() && series.study_uid != study.study_uid) {
        ++all.refused;
        continue;
      }
      series.study_uid = study.study_uid;
      series.study_date = study.study_date;
      series.patient_name = study.patient_name;
      series.patient_id = study.patient_id;
      series.study_description = study.study_description;
      all.series.push_back(std::move(series));
    }
    if (all.series.size() > kMostSeries)
      return refused("too-many", {"fetch-too-many-matches", {std::to_string(kMostSeries)}});
  }
  return all;
}

Expected<void> WebArchive::images(const std::string& path, Arrivals& arrivals) {
  QFile file{QString::fromStdString(arrivals.part().string())};
  const auto unwritable = [&] {
    return failed("unwritable",
                  {"output-unwritable",
                   {arrivals.part().parent_path().string(), file.errorString().toStdString()}});
  };
  const Multipart::Sink sink{.began = [&]() -> Expected<void> {
                               file.close();
                               if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate,
                                              QFileDevice::ReadOwner | QFileDevice::WriteOwner))
                                 return unwritable();
                               return {};
                             },
                             .bytes = [&](std::span<const char> bytes) -> Expected<void> {
                               const auto size = static_cast<qint64>(bytes.size());
                               if (file.write(bytes.data(), size) != size) return unwritable();
                               return arrivals.came(bytes.size());
                             },
                             .ended = [&]() -> Expected<void> {
                               file.close();
                               if (file.error() != QFileDevice::NoError) return unwritable();
                               return arrivals.keep();
                             }};
  std::optional<Multipart> parts;
  bool single = false;
  const Body body{
      .begins = [&](const QString& type) -> Expected<void> {
        if (type.isEmpty()) return {};  // nothing to send
        const auto boundary = boundaryOf(type.toStdString());
        if (!boundary) return refused("answer", {"fetch-no-images", {name()}});
        single = boundary->empty();
        if (single) return sink.began();
        parts.emplace(*boundary, sink);
        return {};
      },
      .bytes = [&](std::span<const char> bytes) -> Expected<void> {
        return single ? sink.bytes(bytes) : parts ? parts->feed(bytes) : Expected<void>{};
      }};
  auto answered = request(path, {}, kImages, body);
  if (answered && single) {
    file.close();
    answered = arrivals.isWhole() ? sink.ended() : failed("lost", {"fetch-cut-off", {}});
  }
  if (answered && parts) answered = parts->finish();
  file.close();
  arrivals.drop();
  return answered;
}

/// Asks which images there are. A server that cannot say is no error.
Expected<void> WebArchive::list(const std::string& path, Arrivals& arrivals) {
  const auto text = json(path + "/instances", {});
  if (!text) {
    if (text.error().reason == "path" || text.error().reason == "too-many") return {};
    return tl::unexpected(text.error());
  }
  auto listed = imagesFrom(*text);
  if (!listed) return tl::unexpected(listed.error());
  arrivals.expect(std::move(*listed));
  return {};
}

Expected<void> WebArchive::get(const FoundSeries& series, Arrivals& arrivals) {
  const std::string path = "/studies/" + series.study_uid + "/series/" + series.series_uid;
  const auto whole = [&] {
    return series.images && arrivals.images() == static_cast<std::size_t>(*series.images);
  };
  for (int attempt = 1;; ++attempt) {
    Expected<void> brought;
    if (attempt > 1 && !arrivals.listed()) brought = list(path, arrivals);
    if (brought && (attempt == 1 || !arrivals.listed())) {
      brought = images(path, arrivals);
    } else if (brought) {
      for (const std::string& image : arrivals.missing())
        if (brought = images(path + "/instances/" + image, arrivals); !brought) break;
    }
    // which images there are is asked where the server's count does not say that all have come
    if (brought && !whole() && !arrivals.listed()) brought = list(path, arrivals);
    if (brought && (!arrivals.listed() || arrivals.missing().empty() || attempt > 1)) return {};
    if (!brought && (attempt == kAttempts || !isLoss(brought.error()))) return brought;
    if (brought) continue;
    QEventLoop pause;
    QTimer::singleShot(static_cast<int>(server_.pauseAfter(attempt) * 1000), &pause,
                       &QEventLoop::quit);
    pause.exec();
  }
}

}  // namespace

Expected<std::unique_ptr<Archive>> openWeb(const Server& server, const Login& login) {
  const QUrl url{QString::fromStdString(server.url), QUrl::StrictMode};
  const bool https = url.scheme() == "https";
  if (!url.isValid() || url.host().isEmpty() || (!https && url.scheme() != "http") ||
      !url.userInfo().isEmpty() || url.hasQuery() || url.hasFragment())
    return refused("usage", {"fetch-url", {}});
  QHostAddress address;
  const bool here =
      url.host() == "localhost" || (address.setAddress(url.host()) && address.isLoopback());
  if (!https && !here && login.kind != Login::Kind::None)
    return refused("login", {"fetch-login-readable", {server.url}});

  QUrl base = url.adjusted(QUrl::StripTrailingSlash);
  if (base.path() == "/") base.setPath({});
  QByteArray authorization;
  if (login.kind == Login::Kind::Basic)
    authorization =
        "Basic " + QByteArray::fromStdString(login.user + ":" + login.password).toBase64();
  if (login.kind == Login::Kind::Bearer)
    authorization = "Bearer " + QByteArray::fromStdString(login.password);

  std::optional<QSslConfiguration> tls;
  if (https) {
    tls = QSslConfiguration::defaultConfiguration();
    tls->setProtocol(QSsl::TlsV1_2OrLater);
    tls->setPeerVerifyMode(QSslSocket::VerifyPeer);
    if (!server.authority.empty() &&
        !tls->addCaCertificates(QString::fromStdString(server.authority)))
      return refused("certificate-file", {"fetch-certificate-file", {server.authority}});
    if (!server.certificate.empty()) {
      const auto chain = QSslCertificate::fromPath(QString::fromStdString(server.certificate));
      if (chain.isEmpty())
        return refused("certificate-file", {"fetch-certificate-file", {server.certificate}});
      QFile file{QString::fromStdString(server.key)};
      if (!file.open(QIODevice::ReadOnly))
        return refused("certificate-file", {"fetch-key-file", {server.key}});
      const QByteArray pem = file.readAll();
      QSslKey key;
      for (const auto algorithm : {QSsl::Rsa, QSsl::Ec})
        if (key.isNull())
          key = QSslKey(pem, algorithm, QSsl::Pem, QSsl::PrivateKey,
                        QByteArray::fromStdString(login.key_passphrase));
      if (key.isNull()) return refused("certificate-file", {"fetch-key-file", {server.key}});
      tls->setLocalCertificateChain(chain);
      tls->setPrivateKey(key);
    }
  }
  return std::make_unique<WebArchive>(server, base, authorization, tls);
}

}  // namespace app::fetch
