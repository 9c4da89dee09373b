// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QObject>
#include <vector>

#include "app/background/task.h"
#include "datasets/readers/volume_reader.h"

namespace app {

/// Draws the middle slices of a survey, one after another, on a thread of low priority. Signals
/// arrive on the thread that owns it, and only for the survey that was started last and not
/// stopped. Starting and stopping do not wait for the slice under way; the destructor does.
class Thumbnails : public QObject {
  Q_OBJECT
 public:
  explicit Thumbnails(QObject* parent = nullptr) : QObject(parent) {}

  /// Pictures of at most `longest` pixels to a side.
  void start(std::vector<datasets::SeriesVerdict> series, int longest);
  void stop() { task_.abandon(); }

 signals:
  /// A null image where none can be drawn.
  void ready(int series, const QImage& picture);

 private:
  background::Task<void> task_;
};

}  // namespace app
