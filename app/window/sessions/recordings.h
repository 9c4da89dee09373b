// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QHash>
#include <QJsonObject>
#include <QList>
#include <QString>
#include <atomic>
#include <filesystem>

#include "ui/panels/recording_panel.h"

namespace app {

/// The folder of recordings and its content. Names have numbers, and no person or date. The labels
/// that the user gives stand in a file beside that folder, so that neither a recording nor an
/// export holds them. GUI thread, but for list().
class Recordings {
 public:
  /// An empty path: the user's own folder for Palpate's files.
  explicit Recordings(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }
  /// From now on; an empty path: the user's own.
  void setFolder(std::filesystem::path folder);
  /// A path that does not exist yet, without a label; makes the folder.
  std::filesystem::path next() const;
  /// All recordings except `present`, which is being written; the newest first. On a thread of its
  /// own, with a copy: each file is opened, and may be anybody's. Ends early once `cancel` is true.
  /// `scans`: the names of scans by their hashes, as hexOf() writes them.
  QList<ui::PastRecording> list(const std::filesystem::path& present,
                                const std::atomic<bool>& cancel,
                                const QHash<QString, QString>& scans = {}) const;
  std::filesystem::path pathOf(const QString& id) const { return folder_ / id.toStdString(); }
  /// The label of a recording; an empty one is forgotten. False: it could not be kept.
  bool setLabel(const QString& id, const QString& label) const;
  /// Free space of the disk, bytes.
  double room() const;

 private:
  std::filesystem::path labelFile() const;
  QJsonObject labels() const;

  std::filesystem::path folder_;
};

/// The user's own folder for recordings.
std::filesystem::path ownRecordings();
/// Why recordings cannot be written to a folder, as a sentence; empty: they can.
QString refusalOf(const std::filesystem::path& folder);

}  // namespace app
