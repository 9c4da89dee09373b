// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QString>
#include <filesystem>

#include "ui/panels/recording_panel.h"

namespace app {

/// The folder in which sessions are kept, and what is in it. Names are numbers: neither who nor
/// when. GUI thread.
class Recordings {
 public:
  /// An empty path: the user's own folder for Palpate's files.
  explicit Recordings(std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }
  /// A file that is not there yet; makes the folder.
  std::filesystem::path next() const;
  /// The newest first; all but `present`, which is being written.
  QList<ui::PastRecording> list(const std::filesystem::path& present) const;
  std::filesystem::path pathOf(const QString& id) const { return folder_ / id.toStdString(); }
  /// Bytes that the disk has room for.
  double room() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace app
