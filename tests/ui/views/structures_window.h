// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "app/application.h"
#include "app/window/scan/loader.h"
#include "app/window/structures/structures_controller.h"
#include "tests/ui/window_support.h"
#include "ui/views/slice_view.h"
#include "ui/window/main_window.h"
#include "ui/window/views.h"

/// A made scan that is stored mirrored, and a segmentation on a grid of its own. Places are in the
/// patient's W.
namespace structures {

using haptics::Vec3;
using ui::Plane;
using window::waitFor;

inline constexpr const char* kSecret = "Doe, Jane: left nerve";
// mm: one before the bone at the patient's left, one within it, one behind it at the right
inline const Eigen::Vector3d kNerve{20.0, -6.0, 3.0}, kCanal{2.0, -1.0, -5.0},
    kSinus{-18.0, 14.0, -8.0};

// no millimetre, so that a distance in voxels is another number
inline constexpr std::array<std::int64_t, 3> kScanDims{75, 62, 50};
inline constexpr double kScanStep = 0.8e-3;  // m

inline haptics::Grid gridOf(std::array<std::int64_t, 3> dims, double spacing,
                            const haptics::Mat3& axes) {
  haptics::Grid grid{.dims = dims, .spacing = Vec3::Constant(spacing), .direction = axes};
  Vec3 half;
  for (int a = 0; a < 3; ++a)
    half[a] = 0.5 * spacing * static_cast<double>(dims[static_cast<std::size_t>(a)] - 1);
  grid.origin = -axes * half;
  return grid;
}

/// Writes a NRRD whose voxels follow a formula of their place [mm].
template <class T>
void write(const QString& path, const haptics::Grid& grid, const char* type,
           const std::string& keys, const std::function<int(const Eigen::Vector3d&)>& formula) {
  const auto vector = [](const Vec3& v) {
    return QStringLiteral("(%1,%2,%3)").arg(v.x()).arg(v.y()).arg(v.z()).toStdString();
  };
  std::string text = "NRRD0004\ntype: " + std::string(type) +
                     "\ndimension: 3\nspace: left-posterior-superior\nendian: little\nsizes:";
  for (const auto dim : grid.dims) text += " " + std::to_string(dim);
  text += "\nspace directions:";
  for (int a = 0; a < 3; ++a)
    text += " " + vector(grid.direction.col(a) * grid.spacing[a] * ui::kMmPerM);
  text +=
      "\nspace origin: " + vector(grid.origin * ui::kMmPerM) + "\nencoding: raw\n" + keys + "\n";
  for (std::int64_t k = 0; k < grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < grid.dims[0]; ++i) {
        const auto value =
            static_cast<T>(formula(grid.worldOf({double(i), double(j), double(k)}) * ui::kMmPerM));
        text.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
  QFile file(path);
  ASSERT_TRUE(file.open(QFile::WriteOnly));
  file.write(text.data(), static_cast<qint64>(text.size()));
}

/// A block, and plates above and below it: the picture has room for what lies beside the block.
inline int boneAt(const Eigen::Vector3d& p) {
  const bool block = std::abs(p.x()) < 12.0 && std::abs(p.y()) < 10.0 && std::abs(p.z()) < 13.0;
  const bool plate = std::abs(p.x()) < 26.0 && std::abs(p.y()) < 20.0 && std::abs(p.z()) > 16.5 &&
                     std::abs(p.z()) < 18.5;
  return block || plate ? 1200 : -1000;
}
inline int labelAt(const Eigen::Vector3d& p) {
  if ((p - kNerve).norm() < 4.0) return 7;
  if ((p - kCanal).norm() < 3.0) return 2;
  return (p - kSinus).norm() < 3.0 ? 9 : 0;
}

class StructuresWindow : public testing::Test {
 protected:
  StructuresWindow() {
    QSettings().clear();
    haptics::Mat3 mirrored, turned;
    mirrored << -1, 0, 0, 0, 1, 0, 0, 0, 1;
    turned << 0, -1, 0, 0, 0, 1, 1, 0, 0;
    write<std::int16_t>(path("scan.nrrd"), gridOf(kScanDims, kScanStep, mirrored), "short", "",
                        boneAt);
    write<std::uint8_t>(path("a.seg.nrrd"), gridOf({80, 120, 100}, 0.5e-3, turned), "uchar",
                        std::string("Segment0_ID:=a\nSegment0_Name:=") + kSecret +
                            "\nSegment0_Color:=1 0 1\nSegment0_LabelValue:=7\n"
                            "Segment1_ID:=b\nSegment1_Name:=Canal <b>x</b>\nSegment1_Color:=0 1 0\n"
                            "Segment1_LabelValue:=2\n",
                        labelAt);
  }
  QString path(const char* name) const { return folder_.filePath(name); }

  void start(const char* labels = "a.seg.nrrd") {
    app::Arguments arguments;
    arguments.load.path = path(scan_).toStdString();
    arguments.load.isovalue = 300.0;
    if (*labels != '\0') arguments.labels = path(labels).toStdString();
    arguments.surface = mode_;
    arguments.notice = false;
    arguments.state = path("state").toStdString();
    arguments.journal = path("journal").toStdString();
    arguments.recordings = path("recordings").toStdString();
    if (free_memory_) arguments.free_memory = free_memory_;
    application_ = std::make_unique<app::Application>(std::move(arguments));
    QSignalSpy opened(&structures(), &app::StructuresController::opened);
    application_->start();
    ASSERT_TRUE(waitFor([&] { return application_->shown().has_value(); }));
    window().resize(1280, 840);
    views().slices().setFollowing(false);
    if (*labels != '\0') {
      ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));
    }
  }
  ui::MainWindow& window() { return application_->window(); }
  ui::Views& views() { return window().views(); }
  app::StructuresController& structures() { return application_->structures(); }
  template <class T>
  T& part(const char* name) {
    return *window().findChild<T*>(name);
  }
  QTableWidget& list() { return part<QTableWidget>("structures"); }
  QString message() { return part<QLabel>("message").text(); }

  std::optional<ui::SurfaceMode> mode_ = ui::SurfaceMode::Mesh;
  QTemporaryDir folder_;
  const char* scan_ = "scan.nrrd";
  std::function<double()> free_memory_;
  std::unique_ptr<app::Application> application_;
};

}  // namespace structures
