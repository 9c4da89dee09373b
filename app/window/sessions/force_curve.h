// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <filesystem>
#include <map>
#include <vector>

#include "app/background/task.h"
#include "haptics/core/error.h"

namespace app {

/// Least and greatest norm of the force [N] in equal intervals of a recording's time; not a number
/// where an interval has no step.
struct ForceCurve {
  std::vector<float> least, most;
};

/// Reads the curve of a finished recording, on any thread. If the file has more than `most_blocks`
/// blocks, only so many are read, evenly spaced; 0: all.
haptics::Expected<ForceCurve> forceCurveOf(const std::filesystem::path& path, std::size_t intervals,
                                           std::size_t most_blocks, const background::Watch& watch);

/// The small curves of a list of recordings, read one after the other by a thread that goes last.
/// They are kept in memory alone. GUI thread.
class ForceCurves : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t kIntervals = 64;
  static constexpr std::size_t kMostBlocks = 128;

  /// Reads those of these recordings that are not known. A file that has changed since is read
  /// again; of one that cannot be read the curve is empty.
  void want(const std::filesystem::path& folder, const QList<QString>& ids);
  /// Greatest force of each interval, N; empty: not known.
  QList<float> of(const QString& id) const;

 signals:
  void read(const QString& id, const QList<float>& most);

 private:
  struct Known {
    std::filesystem::file_time_type changed;
    QList<float> most;
  };
  void readNext();

  std::filesystem::path folder_;
  QList<QString> wanted_;
  std::map<QString, Known> known_;
  background::Task<ForceCurve> reader_;
};

}  // namespace app
