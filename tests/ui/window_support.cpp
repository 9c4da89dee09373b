// SPDX-License-Identifier: BSD-3-Clause
#include "tests/ui/window_support.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QDeadlineTimer>
#include <QDir>
#include <QLabel>
#include <QScrollArea>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace window {
namespace {

/// With a pixel for each of the widget's, whatever the scale of the screen.
QImage unscaled(QImage image, QSize size) {
  image.setDevicePixelRatio(1.0);
  if (image.size() != size)
    image = image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  return image.convertToFormat(QImage::Format_RGB32);
}

}  // namespace

std::shared_ptr<const haptics::Volume> volumeOf(
    const haptics::Grid& grid, haptics::ScalarType type,
    const std::function<double(const haptics::Vec3& p_W)>& intensity, haptics::VolumeFacts facts) {
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), type).value();
  haptics::visitVoxels(type, voxels.get(), [&](const auto* first) {
    using T = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    auto* out = const_cast<T*>(first);
    for (std::int64_t k = 0; k < grid.dims[2]; ++k)
      for (std::int64_t j = 0; j < grid.dims[1]; ++j)
        for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
          const haptics::Vec3 index{static_cast<double>(i), static_cast<double>(j),
                                    static_cast<double>(k)};
          *out++ = static_cast<T>(std::lround(intensity(grid.worldOf(index))));
        }
  });
  return std::make_shared<const haptics::Volume>(
      haptics::makeVolume(grid, type, std::move(voxels), std::move(facts)).value());
}

haptics::Grid cubeGrid(int n, const haptics::Mat3& direction) {
  haptics::Grid grid;
  grid.dims = {n, n, n};
  grid.spacing = haptics::Vec3::Constant(1e-3);
  grid.direction = direction;
  grid.origin = -direction * haptics::Vec3::Constant(0.5e-3 * (n - 1));
  return grid;
}

std::function<double(const haptics::Vec3&)> ball(const haptics::Vec3& centre_W, double radius) {
  return [=](const haptics::Vec3& p) {
    return std::clamp(50.0 + ((radius - (p - centre_W).norm()) / 3e-3) * 100.0, 0.0, 100.0);
  };
}

haptics::TriangleMesh octahedron(double size) {
  haptics::TriangleMesh mesh;
  for (int a = 0; a < 3; ++a)
    for (const double side : {size, -size}) mesh.vertices.push_back(haptics::Vec3::Unit(a) * side);
  for (const std::uint32_t x : {0U, 1U})
    for (const std::uint32_t y : {2U, 3U})
      for (const std::uint32_t z : {4U, 5U}) {
        if ((x + y + z) % 2 == 0)
          mesh.triangles.push_back({x, y, z});
        else
          mesh.triangles.push_back({x, z, y});
      }
  return mesh;
}

bool waitFor(const std::function<bool()>& done, double seconds) {
  const QDeadlineTimer deadline(std::llround(seconds * 1e3));
  while (!done()) {
    if (deadline.hasExpired()) return false;
    QTest::qWait(10);
  }
  return true;
}

void showAndWait(QWidget& widget, QSize size) {
  widget.resize(size);
  widget.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&widget, 120'000));
  QTest::qWait(50);
}

QImage pictureOf(QWidget& widget) {
  QTest::qWait(30);
  return unscaled(widget.grab().toImage(), widget.size());
}

void showCamera(ui::VolumeView& view) {
  ui::ViewLook look;
  view.tell(look);
  view.look(look);
}

void rest(ui::VolumeView& view) {
  QTest::qWait(10);
  auto& still = *view.findChild<QTimer*>("still");
  const int interval = still.interval();
  if (still.isActive()) still.start(0);
  EXPECT_TRUE(waitFor([&] { return view.isAtRest(); }));
  still.setInterval(interval);
}

void rest(ui::SliceView& view) {
  if (!view.isVisible()) return;
  auto& refine = *view.findChild<QTimer*>("refine");
  const int interval = refine.interval();
  view.grab();  // follows the contour
  if (refine.isActive()) refine.start(0);
  EXPECT_TRUE(waitFor([&] { return !refine.isActive(); }));
  refine.setInterval(interval);
  view.grab();
}

QImage pictureAtRest(ui::VolumeView& view) {
  rest(view);
  QTest::qWait(10);
  return unscaled(view.grabFramebuffer(), view.size());
}

void keep(const QImage& image, const char* name) {
  const QString folder = QDir::tempPath() + "/palpate-window-tests";
  QDir().mkpath(folder);
  image.save(folder + "/" + name + ".png");
}

double differing(const QImage& a, const QImage& b, int tolerance) {
  if (a.size() != b.size()) return 1.0;
  std::int64_t apart = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      apart += std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()),
                         std::abs(p.blue() - q.blue())}) > tolerance;
    }
  return static_cast<double>(apart) / (static_cast<double>(a.width()) * a.height());
}

QPointF centroid(const QImage& image, const std::function<bool(QColor)>& wanted, int least) {
  QPointF sum;
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (wanted(image.pixelColor(x, y))) {
        sum += QPointF{x + 0.5, y + 0.5};
        ++found;
      }
  return found < least ? QPointF{-1.0, -1.0} : sum / found;
}

int neighboursApart(const QImage& image, const QRect& where) {
  int differ = 0;
  for (int y = where.top() / 2 * 2; y < where.bottom(); y += 2)
    for (int x = where.left() / 2 * 2; x < where.right(); x += 2)
      differ += std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(x + 1, y))) > 8;
  return differ;
}

int count(const QImage& image, const std::function<bool(QColor)>& wanted) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) found += wanted(image.pixelColor(x, y));
  return found;
}

bool proxyColoured(QColor c) {
  return c.blue() > 80 && c.blue() > c.red() + 40 && c.blue() > c.green() + 12;
}
bool deviceColoured(QColor c) { return c.red() > 150 && c.red() > 2 * c.green() && c.blue() < 90; }
bool surfaceColoured(QColor c) {
  return c.red() > 45 && c.red() >= c.green() && c.green() > c.blue() &&
         c.red() < 1.5 * c.blue() + 20;
}

bool cutColoured(QColor c) {
  return c.red() > 90 && c.red() > 1.4 * c.green() && c.green() > c.blue() &&
         c.blue() > 0.6 * c.green();
}

int expectNothingBeside(const QWidget& panel, const char* where) {
  int looked = 0;
  for (const QWidget* child : panel.findChildren<QWidget*>()) {
    if (!child->isVisible() || child->width() == 0) continue;
    // lists scroll what is in them; what is in a panel has the room that is seen
    const QWidget* room = &panel;
    bool in_list = false;
    for (const QWidget* above = child->parentWidget(); above != &panel;
         above = above->parentWidget()) {
      if (qobject_cast<const QAbstractItemView*>(above) != nullptr) in_list = true;
      if (const auto* scroll = qobject_cast<const QScrollArea*>(above)) room = scroll->viewport();
      if (room != &panel) break;
    }
    // the scroll bars lie beside that room
    if (in_list || (room != &panel && !room->isAncestorOf(child))) continue;
    ++looked;
    const int left = child->mapTo(&panel, QPoint{}).x();
    const int first = room == &panel ? 0 : room->mapTo(&panel, QPoint{}).x();
    const std::string name = std::string(where) + ", " + child->metaObject()->className() + " " +
                             child->objectName().toStdString();
    EXPECT_GE(left, first) << name;
    EXPECT_LE(left + child->width(), first + room->width()) << name;
  }
  return looked;
}

void expectNothingCut(const QWidget& parent, const char* where) {
  int seen = 0;
  for (const QWidget* part : parent.findChildren<QWidget*>()) {
    if (part->visibleRegion().isEmpty()) continue;
    const std::string name = std::string(where) + ", " + part->metaObject()->className() + " " +
                             part->objectName().toStdString();
    int wanted = 0;
    if (const auto* label = qobject_cast<const QLabel*>(part)) {
      // what is longer than its place is cut on purpose, and said in full by its tool tip
      if (label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored ||
          label->objectName() == "viewHint" || label->text().isEmpty())
        continue;
      wanted = label->wordWrap() ? 0 : label->minimumSizeHint().width();
      if (label->wordWrap()) {
        // a text that was set just now is laid out soon
        for (int n = 0; n < 2'000 && label->height() < label->heightForWidth(label->width()); ++n)
          QTest::qWait(10);
        EXPECT_GE(label->height(), label->heightForWidth(label->width())) << name;
      }
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(part)) {
      if (button->text().isEmpty()) continue;
      wanted = button->fontMetrics().horizontalAdvance(button->text().remove('&')) + 8;
      if (const auto* tool = qobject_cast<const QToolButton*>(button))
        if (tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) wanted = 0;
    } else {
      continue;
    }
    ++seen;
    EXPECT_GE(part->width(), wanted) << name;
  }
  EXPECT_GT(seen, 2) << where;
}

}  // namespace window
