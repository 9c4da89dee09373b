// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <vector>

#include "app/background/task.h"
#include "datasets/readers/volume_reader.h"
#include "ui/controls/small_picture.h"

namespace app {

/// The middle slice of a series, at most `longest` pixels per side; a null image if it cannot be
/// drawn. Any thread.
ui::SmallPicture pictureOf(const datasets::SeriesVerdict& series, int longest);

/// Draws the middle slices of a survey, one after another, on a thread of low priority. Signals
/// arrive on the thread that owns it, and only for the newest survey, unless stopped. start() and
/// stop() do not wait for the present slice; the destructor does.
class Thumbnails : public QObject {
  Q_OBJECT
 public:
  explicit Thumbnails(QObject* parent = nullptr) : QObject(parent) {}

  /// Draws pictures of at most `longest` pixels per side.
  void start(std::vector<datasets::SeriesVerdict> series, int longest);
  void stop() { task_.abandon(); }

 signals:
  /// `picture` is a null image if none can be drawn.
  void ready(int series, const ui::SmallPicture& picture);

 private:
  background::Task<void> task_;
};

}  // namespace app
