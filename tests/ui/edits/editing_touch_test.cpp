// SPDX-License-Identifier: BSD-3-Clause
// What was taken away is gone for the hand as for the eye, after each kind of edit.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/window/edits/edit_controller.h"
#include "app/window/scan/loader.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/simulation/penetration.h"
#include "tests/ui/edits/editing.h"
#include "tests/ui/window_support.h"
#include "ui/views/volume_view.h"
#include "ui/window/views.h"

namespace {

using Eigen::Vector3d;
using haptics::Vec3;
using window::Editing;

constexpr double kVoxel_mm = 2.0;
constexpr double kIsovalue = 50.0;
const Vector3d kBodyAt{-20, 0, 0}, kPieceAt{34, 0, 24}, kHolderAt{-20, 54, 0};
constexpr double kBody_mm = 26.0, kPiece_mm = 10.0;  // radii

/// A body, a piece beside it, and a rail behind it, 128 mm wide; 100 in what is solid.
double scanAt(const Vec3& p_W) {
  const Vector3d p = p_W * 1e3;
  const double body = (p - kBodyAt).norm() - kBody_mm;
  const double piece = (p - kPieceAt).norm() - kPiece_mm;
  const double rail = std::max(
      {std::abs(p.x()) - 50.0, std::abs(p.y() - kHolderAt.y()) - 6.0, std::abs(p.z()) - 10.0});
  return 100.0 * std::clamp(0.5 - std::min({body, piece, rail}) / 6.0, 0.0, 1.0);
}

/// An edit, and the line on which a hand comes, through what goes to what stays. mm of W.
struct Kind {
  const char* name;
  datasets::Edit edit;
  Vector3d from, gone, left;  ///< `left`: below the surface that stays
  ui::Side seen_from = ui::Side::Superior;
};

std::vector<Kind> kinds() {
  const Vector3d beside{60, 0, 0}, middle{0, 0, 0};
  const Vector3d to_body = (kBodyAt - kPieceAt).normalized();
  const Vector3d before_piece = kPieceAt - 26.0 * to_body;
  const Vector3d in_body = kBodyAt - (kBody_mm - 8.0) * to_body;
  datasets::LassoCut lasso;  // from the front, over the body's left half
  lasso.outline = {{-0.020, -0.035}, {0.015, -0.035}, {0.015, 0.035}, {-0.020, 0.035}};
  lasso.parallel = true;
  lasso.X_WC.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  lasso.X_WC.translation() = Vec3{0, -0.3, 0};
  lasso.isovalue = kIsovalue;
  const Vec3 normal = Vec3{1.0, 0.3, 0.2}.normalized();
  return {
      {"crop", datasets::Crop{{{0, 0, 0}, {22, 64, 64}}}, beside, middle, {-28, 0, 0}},
      {"plane", datasets::PlaneCut{kBodyAt * 1e-3, normal, kIsovalue}, beside, middle, {-30, 0, 0}},
      {"scalpel", lasso, beside, middle, {-28, 0, 0}},
      {"keep", datasets::KeepPiece{kBodyAt * 1e-3, kIsovalue}, before_piece, kPieceAt, in_body},
      {"remove", datasets::RemovePiece{kPieceAt * 1e-3, kIsovalue}, before_piece, kPieceAt,
       in_body},
      {"small", datasets::RemoveSmallPieces{kIsovalue, 6e-6}, before_piece, kPieceAt, in_body},
      {"holder", datasets::RemoveHolder{kIsovalue}, {-20, 76, 0}, kHolderAt, {-20, 18, 0}}};
}

/// What a hand that goes from one place to another, and then stays there, meets.
struct Sweep {
  double free_mm = 0.0;  ///< how far it came before it touched anything
  int contacts = 0;      ///< at the end
  double force = 0.0;    ///< N, at the end
  haptics::Pose X_WP;    ///< at the end
};

Sweep swept(const std::shared_ptr<const haptics::Scene>& scene, const Vector3d& from,
            const Vector3d& to) {
  const auto at = [](const Vector3d& p) {
    haptics::Pose X = haptics::Pose::Identity();
    X.translation() = p * 1e-3;
    return X;
  };
  const auto hand = haptics::Hand::along({0.0, 1.0}, {at(from), at(to)});
  EXPECT_TRUE(hand);
  haptics::ClosedLoop loop;
  loop.scene = scene;
  loop.settings.isovalue = kIsovalue;
  loop.hand_is_device = true;
  const Vector3d along = (to - from).normalized();
  Sweep sweep;
  bool free = true;
  const auto ran = loop.run(*hand, 1300, [&](const haptics::TraceRow& row) {
    const double device_mm = along.dot(row.X_WD.translation() * 1e3 - from);
    free = free && row.contacts == 0 && row.sent_W.force.isZero();
    if (free) sweep.free_mm = device_mm;
    sweep.contacts = row.contacts;
    sweep.force = row.sent_W.force.norm();
    sweep.X_WP = row.X_WP;
    return true;
  });
  EXPECT_TRUE(ran);
  return sweep;
}

/// The place of the surface that is nearest to the tool, its normal, and how far away it is; mm.
struct Touched {
  Vector3d place;
  Vector3d normal;
  double away_mm = std::numeric_limits<double>::infinity();
};

Touched touchedBy(const haptics::PointShell& shell, const haptics::Pose& X_WP,
                  const haptics::ScalarField& field) {
  Touched nearest;
  for (const Vec3& p : shell.points) {
    const Vec3 p_W = X_WP * p;
    const haptics::FieldSample here = field.sample(field.indexOf(p_W));
    const double slope = here.gradient_W.norm();
    if (slope < 1.0) continue;  // per metre: nothing is near
    const double away_mm = 1e3 * (kIsovalue - here.value) / slope;
    if (away_mm >= nearest.away_mm) continue;
    const Vector3d uphill = here.gradient_W / slope;
    nearest = {1e3 * p_W + away_mm * uphill, -uphill, away_mm};
  }
  return nearest;
}

double distance(const Vector3d& p, const std::pair<Vector3d, Vector3d>& piece) {
  const Vector3d by = piece.second - piece.first;
  const double at = by.squaredNorm() > 0.0 ? by.dot(p - piece.first) / by.squaredNorm() : 0.0;
  return (p - piece.first - by * std::clamp(at, 0.0, 1.0)).norm();
}

TEST_F(Editing, AfterEachKindOfEditTheHandFindsWhatTheViewsShow) {
  {
    haptics::Grid grid = window::cubeGrid(64);
    grid.spacing *= kVoxel_mm;
    grid.origin *= kVoxel_mm;
    const auto path = std::filesystem::path(scans_.path().toStdString()) / "parts.nrrd";
    const auto scan = window::volumeOf(grid, haptics::ScalarType::Int16, scanAt);
    ASSERT_TRUE(datasets::writeNrrd(*scan, path).has_value());
    open(path, kIsovalue);
    ASSERT_FALSE(HasFatalFailure());
  }
  const double radius_mm = application_->shown()->scene->tool.shell.radius * 1e3;
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const auto scene = [&] { return application_->shown()->scene; };
    const Vector3d along = (kind.left - kind.from).normalized();
    const double gone_mm = along.dot(kind.gone - kind.from);
    const Vector3d to = kind.left - radius_mm * along;  // it presses on what is left
    window().views().volume().lookFrom(kind.seen_from);
    EXPECT_TRUE(isThere(kind.gone));
    EXPECT_TRUE(isSeen(kind.gone));
    const Sweep before = swept(scene(), kind.from, to);
    EXPECT_GT(before.contacts, 0);
    EXPECT_LT(before.free_mm, gone_mm);  // what is there is in the way, or is gone round

    application_->editing().restore({kind.edit});
    settle();
    ASSERT_EQ(application_->editing().edits().size(), 1U) << message().toStdString();
    EXPECT_FALSE(isThere(kind.gone));
    EXPECT_FALSE(isSeen(kind.gone));
    EXPECT_TRUE(isThere(kind.left));
    EXPECT_TRUE(isSeen(kind.left));
    // the live session has this scene, too
    EXPECT_TRUE(window::waitFor([&] { return application_->snapshot().scene == scene()->id; }));
    const Sweep after = swept(scene(), kind.from, to);
    EXPECT_GT(after.free_mm, gone_mm + radius_mm);  // all of the tool went through it
    EXPECT_GT(after.contacts, 0);
    EXPECT_GT(after.force, 0.5);
    // it is held at the isosurface of the field that is on view
    const haptics::ScalarField shown{window().views().volume().picture().volume};
    const Touched touched = touchedBy(scene()->tool.shell, after.X_WP, shown);
    EXPECT_LT(std::abs(touched.away_mm), 0.1 * kVoxel_mm) << touched.place.transpose();
    EXPECT_EQ(haptics::penetration(*scene(), kIsovalue, after.X_WP), 0.0);
    // and of the contours in the slices through that place
    window().views().setCross(touched.place);
    for (ui::SliceView* slice : window().views().slices().slices()) window::rest(*slice);
    for (const auto& [plane, axis] :
         {std::pair{ui::Plane::Axial, 2}, std::pair{ui::Plane::Coronal, 1},
          std::pair{ui::Plane::Sagittal, 0}}) {
      if (std::abs(touched.normal[axis]) > 0.9) continue;  // the slice lies in the surface
      window::pictureOf(slice(plane));
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& piece : slice(plane).contour_W_mm())
        nearest = std::min(nearest, distance(touched.place, piece));
      EXPECT_LT(nearest, 0.1 * kVoxel_mm) << int(plane);
    }
    keepWindow(qPrintable(QString("edit_touch_%1").arg(kind.name)));

    undo();
    ASSERT_TRUE(application_->editing().edits().empty()) << message().toStdString();
    EXPECT_TRUE(isThere(kind.gone));
    EXPECT_TRUE(isSeen(kind.gone));
    const Sweep again = swept(scene(), kind.from, to);
    EXPECT_EQ(again.contacts, before.contacts);
    EXPECT_LT((again.X_WP.translation() - before.X_WP.translation()).norm(), 1e-9);
  }
}

}  // namespace
