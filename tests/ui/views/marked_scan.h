// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QTest>
#include <memory>
#include <optional>

#include "app/window/scan/touched_surface.h"
#include "app/window/views/marks_controller.h"
#include "tests/ui/panelled_window.h"
#include "tests/ui/window_support.h"
#include "ui/panels/marks_panel.h"
#include "ui/window/menus.h"
#include "ui/window/side_panel.h"
#include "ui/window/top_bar.h"
#include "ui/window/views.h"

namespace window {

/// The same with the controller of marks.
struct MarkedScan : Panelled {
  app::MarksController controller{window.views(), window.menus(),  window.panels(),
                                  window.bar(),   window.escape(), shared};

  MarkedScan() {
    QObject::connect(&isosurface, &app::IsosurfaceController::changed, &controller.measures(),
                     &ui::Measures::surfaceChanged);
  }

  /// Shows a volume as the application does.
  void show(std::shared_ptr<const haptics::Volume> volume, double isovalue,
            const QString& title = "A scan", const std::filesystem::path& place = {}) {
    app::Loaded loaded;
    loaded.picture = ui::pictureOf(volume);
    loaded.scene =
        haptics::makeScene(volume, haptics::makeTool("ball", octahedron(2e-3)).value()).value();
    loaded.isovalue = isovalue;
    loaded.title = title;
    loaded.place = place;
    shared.shown = loaded;
    shared.settings.isovalue = isovalue;
    window.show(loaded.picture, isovalue, title);
    window.views().show(loaded.scene->tool.mesh);
    isosurface.showScene(true);
    window.views().setTouched(app::touchedSurfaceOf(loaded.scene));
    controller.showScene();
  }

  ui::Measures& measures() { return controller.measures(); }
  ui::MarksPanel& panel() { return *window.findChild<ui::MarksPanel*>(); }
  ui::SliceView& slice(ui::Plane plane) { return window.views().slice(plane); }
  const ui::Measure& last() { return measures().all().back(); }
  QString value(std::size_t index) {
    return ui::valueOf(measures().all()[index], measures().scan());
  }
};

/// Shows the window, with the keyboard.
inline void showActive(QWidget& widget) {
  showAndWait(widget, {1240, 840});
  widget.activateWindow();
  EXPECT_TRUE(QTest::qWaitForWindowActive(&widget, 120'000));
}

inline void click(QWidget& view, QPointF at) {
  QTest::mouseClick(&view, Qt::LeftButton, {}, at.toPoint());
}
inline void dragFrom(QWidget& view, QPointF from, QPointF to) {
  QTest::mousePress(&view, Qt::LeftButton, {}, from.toPoint());
  // in steps, as a hand does
  for (const double share : {0.4, 0.8, 1.0}) {
    const QPointF at = from + (to - from) * share;
    QMouseEvent move(QEvent::MouseMove, at.toPoint(), view.mapToGlobal(at.toPoint()), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to.toPoint());
}

struct Reading {
  double number, accuracy;
};
/// "30 mm ± 1 mm" as numbers.
inline std::optional<Reading> readingOf(const QString& words) {
  static const QRegularExpression form(R"(^(-?[\d.]+)[^\d±]*±\D*([\d.]+))");
  const QRegularExpressionMatch match = form.match(words);
  if (!match.hasMatch()) return {};
  return Reading{match.captured(1).toDouble(), match.captured(2).toDouble()};
}

inline bool inked(QColor c) { return c.red() > 200 && c.blue() > 220 && c.green() < 240; }

}  // namespace window
