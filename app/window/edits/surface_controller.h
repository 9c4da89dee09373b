// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <memory>

#include "app/background/task.h"
#include "app/window/scan/shared_state.h"
#include "datasets/surface/surface.h"
#include "ui/dialogs/surface_question.h"
#include "ui/window/loading.h"
#include "ui/window/main_window.h"
#include "ui/window/messages.h"

namespace app {

/// Writes the surface on view as a file of triangles: asks what of it, counts its triangles in the
/// background, and writes them there.
class SurfaceController : public QObject {
  Q_OBJECT
 public:
  SurfaceController(ui::MainWindow& window, SharedState& shared);

  /// Whether a surface is being written.
  bool isWriting() const { return writer_.isRunning(); }
  void stopWriting() { writer_.cancel(); }

 signals:
  /// A surface was written, or not. `why`: why not, for the user; empty: cancelled.
  void written(bool well, const QString& why);

 private:
  using MadeSurface = std::shared_ptr<const datasets::Surface>;

  void ask();
  void count(const ui::SurfaceWish& wish);
  void write(const ui::SurfaceWish& wish);

  ui::Messages& messages_;
  ui::Loading& loading_;
  SharedState& shared_;
  std::shared_ptr<const haptics::Volume> volume_;  ///< that was on view when the user asked
  double isovalue_ = 0.0;
  MadeSurface surface_;  ///< that the dialog asks about; null: not counted yet
  QPointer<ui::SurfaceDialog> dialog_;
  background::Task<MadeSurface> counter_;
  background::Task<QString> writer_;  ///< the name of the written file
};

}  // namespace app
