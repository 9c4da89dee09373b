// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/recordings.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSaveFile>
#include <QStandardPaths>
#include <QTemporaryFile>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "app/recording/recording.h"
#include "app/recording/unfinished.h"
#include "app/view_file/view_file.h"
#include "app/window/scan/loader.h"
#include "haptics/process/input_file.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLongestLabels = 1'000'000;  // bytes

/// Of a recording, finished or not.
QString keyOf(const QString& id) { return id.section(QStringLiteral(".palpate"), 0, 0); }

QDateTime changedAt(const fs::path& path) {
  return QFileInfo(QString::fromStdString(path.string())).lastModified();
}

}  // namespace

Recordings::Recordings(fs::path folder) { setFolder(std::move(folder)); }

void Recordings::setFolder(fs::path folder) {
  folder_ = folder.empty() ? ownRecordings() : std::move(folder);
}

fs::path ownRecordings() {
  return fs::path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString()) /
         "recordings";
}

QString refusalOf(const fs::path& folder) {
  const QString path = QString::fromStdString(folder.string());
  const auto say = [&](const char* sentence) {
    return QCoreApplication::translate("app::Recordings", sentence).arg(path);
  };
  std::error_code error;
  if (!fs::is_directory(folder, error))
    return say(
        QT_TRANSLATE_NOOP("app::Recordings", "'%1' is not a folder; choose one that exists."));
  // by writing: permissions do not tell of a disk that is mounted for reading
  QTemporaryFile file(path + "/palpate");  // and what makes it new
  if (!file.open() || file.write("x") != 1 || !file.flush())
    return say(QT_TRANSLATE_NOOP(
        "app::Recordings",
        "Nothing can be written to '%1'; choose a folder with room that you may write to."));
  return {};
}

fs::path Recordings::next() const {
  std::error_code error;
  fs::create_directories(folder_, error);
  for (int n = 1;; ++n) {
    char name[32];
    std::snprintf(name, sizeof name, "session-%04d.palpate", n);
    if (!fs::exists(folder_ / name, error) &&
        !fs::exists(folder_ / (std::string(name) + ".part"), error))
      // a number that is used again brings no label of a recording that is gone
      return setLabel(name, {}), folder_ / name;
  }
}

fs::path Recordings::labelFile() const {
  const fs::path folder = folder_.has_filename() ? folder_ : folder_.parent_path();
  return folder.parent_path() / (folder.filename().string() + "-labels.json");
}

QJsonObject Recordings::labels() const {
  const auto text = haptics::readInput(labelFile(), kLongestLabels);
  if (!text) return {};
  return QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
}

bool Recordings::setLabel(const QString& id, const QString& label) const {
  QJsonObject all = labels();
  const QString key = keyOf(id);
  if (all.value(key).toString() == label) return true;
  if (label.isEmpty())
    all.remove(key);
  else
    all.insert(key, label);
  QSaveFile file(QString::fromStdString(labelFile().string()));
  if (!file.open(QIODevice::WriteOnly)) return false;
  file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
  file.write(QJsonDocument(all).toJson());
  return file.commit();
}

QList<ui::PastRecording> Recordings::list(const fs::path& present, const std::atomic<bool>& cancel,
                                          const QHash<QString, QString>& scans) const {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const fs::path& path = entry.path();
    const bool finished = path.extension() == ".palpate";
    const bool unfinished = path.extension() == ".part" && path.stem().extension() == ".palpate";
    // what another window is writing is that one's
    if (finished || (unfinished && path != present && !isInUse(path))) paths.push_back(path);
  }
  std::sort(paths.rbegin(), paths.rend());
  const QJsonObject labels = this->labels();
  QList<ui::PastRecording> recordings;
  for (const fs::path& path : paths) {
    if (cancel) break;
    const auto id = QString::fromStdString(path.filename().string());
    if (path.extension() == ".part") {
      // most of it is in the log beside it
      std::uintmax_t bytes = fs::file_size(path, error);
      const std::uintmax_t log = fs::file_size(path.string() + "-wal", error);
      if (!error) bytes += log;
      recordings.append({.id = id,
                         .name = QString::fromStdString(path.stem().stem().string()),
                         .bytes = static_cast<qint64>(bytes),
                         .finished = false,
                         .label = labels.value(keyOf(id)).toString(),
                         .changed = changedAt(path)});
      continue;
    }
    const auto summary = summaryOf(path, &cancel);
    ui::PastRecording recording{.id = id,
                                .name = QString::fromStdString(path.stem().string()),
                                .label = labels.value(keyOf(id)).toString(),
                                .changed = changedAt(path)};
    if (summary) {
      recording.duration = summary->duration;
      recording.tool = labelOf({.name = summary->tool});
      recording.bytes = summary->bytes;
      if (summary->scan)
        recording.scan =
            scans.value(QString::fromStdString(hexOf(*summary->scan)),
                        QCoreApplication::translate("app::Recordings", "another scan"));
    } else {
      recording.tool = QCoreApplication::translate("app::Recordings", "(cannot be read)");
      recording.bytes = static_cast<qint64>(fs::file_size(path, error));
    }
    recordings.append(recording);
  }
  return recordings;
}

double Recordings::room() const {
  std::error_code error;
  const fs::space_info space = fs::space(folder_, error);
  return error ? 0.0 : static_cast<double>(space.available);
}

}  // namespace app
