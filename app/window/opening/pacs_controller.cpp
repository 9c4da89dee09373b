// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/opening/pacs_controller.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "app/log/log.h"
#include "app/window/program/stored_values.h"
#include "app/window/scan/sentence.h"
#include "haptics/process/helper_program.h"

namespace app {
namespace {

constexpr qsizetype kLongestLine = 64 << 20;  // bytes; the program has a limit of its own
constexpr int kEnd_ms = 1'000;

struct LoginName {
  ui::PacsServer::Login login;
  const char* name;
};
constexpr LoginName kLogins[] = {{ui::PacsServer::Login::None, "none"},
                                 {ui::PacsServer::Login::Basic, "basic"},
                                 {ui::PacsServer::Login::Bearer, "bearer"},
                                 {ui::PacsServer::Login::Keyring, "keyring"}};

QString nameOf(ui::PacsServer::Login login) {
  for (const auto& [known, name] : kLogins)
    if (known == login) return QString::fromLatin1(name);
  return {};
}

QStringList optionsOf(const ui::PacsServer& server) {
  QStringList options;
  const auto add = [&](const char* name, const QString& value) {
    if (!value.isEmpty()) options << QString::fromLatin1(name) << value;
  };
  if (server.web) {
    options << "--dicomweb" << server.url;
    if (server.login != ui::PacsServer::Login::None) options << "--login" << nameOf(server.login);
    if (server.login == ui::PacsServer::Login::Keyring) add("--user", server.user);
  } else {
    options << "--dimse" << QStringLiteral("%1:%2").arg(server.host).arg(server.port);
    add("--called", server.called);
    add("--calling", server.calling);
    if (server.tls) options << "--tls";
  }
  add("--authority", server.authority);
  add("--certificate", server.certificate);
  add("--key", server.key);
  return options;
}

haptics::Message messageIn(const QJsonValue& words) {
  if (!words.isObject()) return words.toString().toStdString();
  haptics::Message message;
  message.id = words["id"].toString().toStdString();
  for (const QJsonValue& argument : words["arguments"].toArray())
    message.arguments.push_back(messageIn(argument));
  return message;
}

/// Of an error or a warning. An earlier palpate-fetch tells the English sentence alone.
QString sentenceIn(const QJsonObject& told) {
  return sentenceOf(messageIn(told.contains("words") ? told["words"] : told["message"]));
}

QJsonObject objectOf(const ui::PacsQuery& query) {
  QJsonObject object;
  const auto add = [&](const char* name, const QString& value) {
    if (!value.isEmpty()) object[QLatin1String(name)] = value;
  };
  add("patient_id", query.patient_id);
  add("patient_name", query.patient_name);
  add("accession_number", query.accession_number);
  add("study_date", query.study_date);
  add("modality", query.modality);
  return object;
}

std::optional<qint64> countIn(const QJsonObject& object, const char* name) {
  const QJsonValue value = object[QLatin1String(name)];
  if (!value.isDouble()) return {};
  return value.toInteger();
}

}  // namespace

// a settings file may state any number
constexpr int kMostServers = 1000;

QList<ui::PacsServer> loadPacsServers() {
  QSettings settings;
  QList<ui::PacsServer> servers;
  const int count = std::min(settings.beginReadArray("pacs/servers"), kMostServers);
  StoredValues stored(settings);
  for (int n = 0; n < count; ++n) {
    settings.setArrayIndex(n);
    const auto text = [&](const char* name) { return settings.value(name).toString(); };
    ui::PacsServer server;
    server.name = text("name");
    server.web = stored.flag("web").value_or(true);
    server.url = text("url");
    server.host = text("host");
    server.port = stored.whole("port", 1, 65'535).value_or(server.port);
    server.called = text("called");
    server.calling = text("calling");
    server.tls = stored.flag("tls").value_or(false);
    server.authority = text("authority");
    server.certificate = text("certificate");
    server.key = text("key");
    for (const auto& [login, name] : kLogins)
      if (text("login") == QLatin1String(name)) server.login = login;
    server.user = text("user");
    server.move = text("move");
    servers << server;
  }
  settings.endArray();
  return servers;
}

void savePacsServers(const QList<ui::PacsServer>& servers) {
  QSettings settings;
  settings.remove("pacs/servers");
  settings.beginWriteArray("pacs/servers", static_cast<int>(servers.size()));
  for (int n = 0; n < servers.size(); ++n) {
    settings.setArrayIndex(n);
    const ui::PacsServer& server = servers[n];
    settings.setValue("name", server.name);
    settings.setValue("web", server.web);
    settings.setValue("url", server.url);
    settings.setValue("host", server.host);
    settings.setValue("port", server.port);
    settings.setValue("called", server.called);
    settings.setValue("calling", server.calling);
    settings.setValue("tls", server.tls);
    settings.setValue("authority", server.authority);
    settings.setValue("certificate", server.certificate);
    settings.setValue("key", server.key);
    settings.setValue("login", nameOf(server.login));
    settings.setValue("user", server.user);
    settings.setValue("move", server.move);
  }
  settings.endArray();
}

PacsController::PacsController(ui::Messages& messages, ui::Menus& menus, QString program)
    : messages_(messages), program_(std::move(program)) {
  connect(&menus, &ui::Menus::pacsWanted, this, &PacsController::open);
}

PacsController::~PacsController() {
  if (process_) process_->disconnect(this);
  release(std::move(process_));
  release(std::move(holds_folder_));
}

void PacsController::open() {
  if (program_.isEmpty())
    program_ = QString::fromStdString(haptics::helperProgram("palpate-fetch").string());
  if (program_.isEmpty())
    return messages_.showMessage(
        tr("Scans from a PACS need the program palpate-fetch, which is not installed; fetch the "
           "scan with another program and open its folder."));
  if (shown_ == nullptr) {
    shown_ = new ui::PacsWindow(messages_.window());
    servers_ = loadPacsServers();
    shown_->showServers(servers_, 0);
    connect(shown_, &ui::PacsWindow::serversChanged, this,
            [this](const QList<ui::PacsServer>& servers, int) {
              if (servers != servers_) savePacsServers(servers);
              servers_ = servers;
              // what was found is another server's
              shown_->showSeries({}, false);
              checks_.clear();
            });
    connect(shown_, &ui::PacsWindow::testWanted, this, [this] {
      ask("echo", {}, {}, tr("Asking the server"), [this](const QJsonObject&) {
        shown_->showAnswer(tr("The server answers, and lets Palpate search."), true);
      });
    });
    connect(shown_, &ui::PacsWindow::rememberWanted, this, [this] {
      const bool token = servers_.value(shown_->chosenServer()).user.isEmpty();
      ask("remember", {{"login", QJsonObject{{token ? "token" : "password", shown_->secret()}}}},
          {}, tr("Storing"), [this](const QJsonObject&) {
            shown_->clearSecret();
            shown_->showAnswer(tr("The keyring has it now."), true);
          });
    });
    connect(shown_, &ui::PacsWindow::forgetWanted, this, [this] {
      ask("forget", {}, {}, tr("Removing"), [this](const QJsonObject&) {
        shown_->showAnswer(tr("The keyring has it no more."), true);
      });
    });
    connect(shown_, &ui::PacsWindow::searchWanted, this, &PacsController::search);
    connect(shown_, &ui::PacsWindow::fetchWanted, this, &PacsController::fetch);
    connect(shown_, &ui::PacsWindow::cancelWanted, this, [this] {
      cancelled_ = true;
      if (process_) process_->terminate();
    });
  }
  shown_->show();
  shown_->raise();
  shown_->activateWindow();
}

void PacsController::search() {
  searched_ = shown_->query();
  const bool names = shown_->namesWanted();
  shown_->showSeries({}, false);
  checks_.clear();
  ask("find", {{"query", objectOf(searched_)}}, names ? QStringList{"--names"} : QStringList{},
      tr("Searching"), [this, names](const QJsonObject& answer) {
        QList<ui::PacsSeries> series;
        const QJsonArray list = answer["series"].toArray();
        for (const QJsonValue& value : list) {
          const QJsonObject one = value.toObject();
          series << ui::PacsSeries{.study = one["study"].toInt(),
                                   .modality = one["modality"].toString(),
                                   .date = one["study_date"].toString(),
                                   .number = countIn(one, "number"),
                                   .images = countIn(one, "images"),
                                   .patient = one["patient_name"].toString(),
                                   .patient_id = one["patient_id"].toString(),
                                   .study_name = one["study_description"].toString(),
                                   .series_name = one["series_description"].toString()};
          checks_ << one["check"].toString().toLatin1();
        }
        shown_->showSeries(series, names);
        shown_->showAnswer(series.isEmpty() ? tr("The server has no series that match.")
                                            : tr("%1 series match.").arg(series.size()),
                           true);
      });
}

void PacsController::fetch(int series) {
  if (series < 0 || series >= checks_.size()) return;
  const QString move = servers_.value(shown_->chosenServer()).move;
  ask("get",
      {{"query", objectOf(searched_)},
       {"index", series},
       {"check", QString::fromLatin1(checks_[series])}},
      move.isEmpty() ? QStringList{} : QStringList{"--move", move}, tr("Fetching"),
      [this](const QJsonObject& answer) {
        QStringList told;
        const QJsonArray warnings = answer["warnings"].toArray();
        for (const QJsonValue& warning : warnings) told << sentenceIn(warning.toObject());
        shown_->showAnswer(
            told.isEmpty()
                ? tr("%1 images were fetched and are opened.").arg(answer["images"].toInteger())
                : told.join(' '),
            told.isEmpty());
        // nothing stands before the scan, unless there is something to read
        if (told.isEmpty()) shown_->hide();
        // the program keeps the folder until its standard input ends
        release(std::exchange(holds_folder_, std::move(process_)));
        holds_folder_->disconnect(this);
        emit openWanted(answer["folder"].toString(), tr("From the PACS"));
      });
}

void PacsController::ask(const QString& command, const QJsonObject& input,
                         const QStringList& options, const QString& what, Answer done) {
  if (process_) return;
  const ui::PacsServer server = servers_.value(shown_->chosenServer());
  QJsonObject all = input;
  if (server.web && server.login == ui::PacsServer::Login::Basic)
    all["login"] = QJsonObject{{"user", server.user}, {"password", shown_->secret()}};
  if (server.web && server.login == ui::PacsServer::Login::Bearer)
    all["login"] = QJsonObject{{"token", shown_->secret()}};
  heard_.clear();
  answered_ = cancelled_ = false;
  done_ = std::move(done);
  process_ = std::make_unique<QProcess>();
  process_->setStandardErrorFile(QProcess::nullDevice());
  connect(process_.get(), &QProcess::readyReadStandardOutput, this, &PacsController::read);
  connect(process_.get(), &QProcess::finished, this, [this] {
    read();
    end(cancelled_ ? tr("Cancelled.") : tr("palpate-fetch ended without an answer; try again."));
  });
  connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart)
      end(tr("palpate-fetch cannot be started; install it again."));
  });
  shown_->setBusy(what);
  process_->start(program_, QStringList{command} + optionsOf(server) + options +
                                QStringList{"--attached", "--json"});
  process_->write(QJsonDocument(all).toJson(QJsonDocument::Compact) + '\n');
}

void PacsController::read() {
  if (!process_) return;
  heard_ += process_->readAllStandardOutput();
  while (process_) {
    const qsizetype end = heard_.indexOf('\n');
    if (end < 0) break;
    const QByteArray line = heard_.first(end);
    heard_.remove(0, end + 1);
    take(QJsonDocument::fromJson(line).object());
  }
  if (process_ && heard_.size() > kLongestLine) process_->kill();
}

void PacsController::take(const QJsonObject& line) {
  if (line["event"].toString() == QLatin1String("progress"))
    return shown_->showProgress(line["images"].toInteger(), countIn(line, "of"),
                                line["bytes"].toInteger());
  if (answered_) return;
  answered_ = true;
  if (line.contains("error")) {
    const QJsonObject error = line["error"].toObject();
    const QString sentence = sentenceIn(error);
    log::write(log::Level::Warning, "pacs-refused",
               {{"reason", log::nameOfProgram(error["reason"].toString().toStdString())}});
    return end(cancelled_ || sentence.isEmpty() ? tr("Cancelled.") : sentence);
  }
  const Answer done = std::exchange(done_, {});
  shown_->setBusy({});
  if (done) done(line);
  if (process_) letGo(std::move(process_));  // not the one that holds a folder
}

void PacsController::end(const QString& sentence) {
  if (!process_) return;
  letGo(std::move(process_));
  done_ = {};
  shown_->setBusy({});
  shown_->showAnswer(sentence, cancelled_);
}

void PacsController::letGo(std::unique_ptr<QProcess> process) {
  process->disconnect(this);
  process->closeWriteChannel();
  // this may be its own signal
  QProcess* ending = process.release();
  if (ending->state() == QProcess::NotRunning)
    ending->deleteLater();
  else
    connect(ending, &QProcess::finished, ending, &QObject::deleteLater);
}

void PacsController::release(std::unique_ptr<QProcess> process) {
  if (!process) return;
  process->closeWriteChannel();
  if (!process->waitForFinished(kEnd_ms)) process->kill();
}

}  // namespace app
