// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QPointF>
#include <QString>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "app/application.h"
#include "app/window/scan/loader.h"
#include "haptics/scene/scene.h"
#include "ui/panels/edit_panel.h"
#include "ui/views/volume_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

namespace window {

/// The program with a scan on view, and what a user does to it. Places are in mm of W.
class Editing : public testing::Test {
 protected:
  using Vector3d = Eigen::Vector3d;

  // two balls of 100 in a cube of 64 mm about the origin
  static constexpr double kLarge_mm = 14.0, kSmall_mm = 5.0;  ///< their radii
  static const Vector3d kLargeAt, kSmallAt;

  void open(const std::filesystem::path& scan, double isovalue);
  void openBalls();

  ui::MainWindow& window() { return application_->window(); }
  ui::EditPanel& panel() { return *window().findChild<ui::EditPanel*>(); }
  ui::SliceView& slice(ui::Plane plane) { return window().views().slice(plane); }
  QPointF inSpace(const Vector3d& p_mm) { return window().views().volume().projected(p_mm * 1e-3); }
  const haptics::Volume& volume() { return *application_->shown()->picture.volume; }
  template <class T = QAbstractButton>
  T& child(const char* name) {
    T* found = window().findChild<T*>(name);
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }
  double number(const char* name);
  QString message() { return child<QLabel>("message").text(); }
  bool messageIsShown() { return child<QLabel>("message").isVisible(); }

  void press(const char* menu, const char* entry);
  void click(const char* button);
  void type(const char* number, const char* text);
  void undo();
  void redo();
  /// Waits until no edit is under way.
  void settle();
  bool previewed();
  static void mouse(QWidget& view, QEvent::Type type, QPointF at, Qt::MouseButtons held);
  /// A drag with the left button; `before_release` is called with the button still down.
  static void drag(QWidget& view, const std::vector<QPointF>& way,
                   const std::function<void()>& before_release = {});
  static void clickAt(QWidget& view, QPointF at) { drag(view, {at}); }
  /// Keeps the window's picture. What is painted over the 3-D view is not in a grab of the window.
  void keepWindow(const char* name);

  /// The field that is touched.
  double felt(const Vector3d& p_mm);
  /// Whether it is solid at a place. The three slices through the place must show the same there.
  bool isThere(const Vector3d& p_mm);
  /// Whether the surface is drawn where this place is seen.
  bool isSeen(const Vector3d& p_mm);
  /// Slices, their contours, the histogram, the 3-D view and the servo must have one volume.
  void expectTheSameEverywhere();
  /// The slices must show this field, pixel by pixel, and its contour.
  void expectSlicesShow(const std::function<double(const Vector3d& p_mm)>& field);
  /// Where the tool comes to when a hand pulls it there.
  Vector3d pulledTo(const Vector3d& p_mm);

  QTemporaryDir recordings_, scans_;
  std::unique_ptr<app::Application> application_;
  double isovalue_ = 50.0;
};

/// Answers the next question about unsaved work with Discard.
void discardWhenAsked(ui::MainWindow& window);

}  // namespace window
