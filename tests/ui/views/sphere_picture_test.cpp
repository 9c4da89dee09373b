// SPDX-License-Identifier: BSD-3-Clause
// The surface in the picture is where and what it is: a sphere as the ray caster and the meshes
// draw it, beside a picture by its formula that shares no code with VTK.
#include <gtest/gtest.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "datasets/phantoms/sampling.h"
#include "ui/props/volume_prop.h"

namespace {

using haptics::Vec3;
using ui::SurfaceMode;

constexpr int kSphereSide = 200;        // px
const Vec3 kMiddle_mm{3.0, -2.0, 4.0};  // beside the middle of the picture
constexpr double kRadius_mm = 15.0, kVoxel_mm = 1.0;

/// Grey levels, rows from the bottom up; 0 where nothing is drawn, and nowhere else.
using Picture = std::vector<double>;

struct Camera {
  Vec3 eye_mm;
  double angle_deg;
};
const Camera kFar{{0.0, -2600.0, 0.0}, 1.0};  // 45 mm from edge to edge
// the ray caster's light comes along each ray, that of meshes along the camera's axis
const Camera kNear{{60.0, -60.0, 30.0}, 30.0};

/// The unit direction from the eye through a pixel's middle.
Vec3 rayThrough(const Camera& camera, int x, int y) {
  const Vec3 ahead = -camera.eye_mm.normalized();
  const Vec3 right = ahead.cross(Vec3::UnitZ()).normalized();
  const double half = std::tan(0.5 * camera.angle_deg * std::numbers::pi / 180.0);
  return (ahead + half * ((2.0 * x + 1.0) / kSphereSide - 1.0) * right +
          half * ((2.0 * y + 1.0) / kSphereSide - 1.0) * right.cross(ahead))
      .normalized();
}

/// How far the ray through a pixel's middle passes from the sphere; less than zero where it hits.
double clearance_mm(const Camera& camera, int x, int y) {
  return rayThrough(camera, x, y).cross(kMiddle_mm - camera.eye_mm).norm() - kRadius_mm;
}

/// A window that nobody sees, with the sphere in it.
class Stage {
 public:
  Stage() {
    const datasets::Ramp ramp;
    auto volume = datasets::sampled<std::int16_t>(
        datasets::centredGrid(48, 1e-3 * kVoxel_mm), ramp,
        [](const Vec3& p) { return ((p * 1e3 - kMiddle_mm).norm() - kRadius_mm) * 1e-3; });
    const ui::Picture picture =
        ui::pictureOf(std::make_shared<const haptics::Volume>(std::move(volume.value())));
    surface_.show(picture);
    surface_.setIsovalue(ramp.isovalue);
    surface_.showFine(ui::isosurfaceMesh(picture.image, ramp.isovalue, picture.mirrored()),
                      ramp.isovalue);
    renderer_->SetBackground(0.0, 0.0, 0.0);
    renderer_->AddVolume(surface_.rayCast());
    renderer_->AddActor(surface_.mesh());
    renderer_->CreateLight();
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);
    window_->SetSize(kSphereSide, kSphereSide);
    window_->AddRenderer(renderer_);
  }

  Picture drawn(SurfaceMode mode, bool moving, const Camera& camera) {
    surface_.setMode(mode);
    surface_.setMoving(moving);
    surface_.update();
    vtkCamera* view = renderer_->GetActiveCamera();
    view->SetPosition(camera.eye_mm.data());
    view->SetFocalPoint(0.0, 0.0, 0.0);
    view->SetViewUp(0.0, 0.0, 1.0);
    view->SetViewAngle(camera.angle_deg);
    renderer_->ResetCameraClippingRange();
    window_->Render();
    vtkNew<vtkUnsignedCharArray> rgb;
    window_->GetPixelData(0, 0, kSphereSide - 1, kSphereSide - 1, 0, rgb);
    Picture picture;
    for (vtkIdType n = 0; n < rgb->GetNumberOfTuples(); ++n)
      picture.push_back((rgb->GetTypedComponent(n, 0) + rgb->GetTypedComponent(n, 1) +
                         rgb->GetTypedComponent(n, 2)) /
                        3.0);
    return picture;
  }

  /// By the sphere's formula, lit from the eye after Phong as the ray caster is. Its normals turn
  /// by `turn` about the patient's axis.
  Picture formula(const Camera& camera, double turn = 0.0) const {
    vtkVolumeProperty* look = surface_.rayCast()->GetProperty();
    const Vec3 colour{look->GetRGBTransferFunction()->GetColor(0.0)};
    const Eigen::AngleAxisd turned{turn, Vec3::UnitZ()};
    const Vec3 to_middle = kMiddle_mm - camera.eye_mm;
    Picture picture;
    for (int y = 0; y < kSphereSide; ++y)
      for (int x = 0; x < kSphereSide; ++x) {
        const Vec3 ray = rayThrough(camera, x, y);
        const double aside = ray.cross(to_middle).norm();
        picture.push_back(0.0);
        if (aside > kRadius_mm) continue;
        const double deep = std::sqrt(kRadius_mm * kRadius_mm - aside * aside);
        const Vec3 normal = ((ray.dot(to_middle) - deep) * ray - to_middle) / kRadius_mm;
        const double facing = std::max(0.0, -(turned * normal).dot(ray));
        const double shine = look->GetSpecular() * std::pow(facing, look->GetSpecularPower());
        for (const double part : colour)
          picture.back() +=
              std::round(255.0 *
                         std::min(1.0, part * (look->GetAmbient() + look->GetDiffuse() * facing) +
                                           shine)) /
              3.0;
      }
    return picture;
  }

 private:
  ui::VolumeProp surface_;  // outlives the window, in whose context its textures live
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};

/// The farthest pixel on the wrong side of the outline, voxels.
double outlineError(const Picture& picture, const Camera& camera) {
  double error = 0.0;
  for (int y = 0; y < kSphereSide; ++y)
    for (int x = 0; x < kSphereSide; ++x) {
      const double clearance = clearance_mm(camera, x, y);
      const bool shown = picture[static_cast<std::size_t>(y * kSphereSide + x)] > 0.0;
      if (shown != (clearance < 0.0)) error = std::max(error, std::abs(clearance) / kVoxel_mm);
    }
  return error;
}

/// Root mean square over the pixels where either shows the sphere, grey levels.
double differenceOf(const Picture& a, const Picture& b) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    if (a[n] == 0.0 && b[n] == 0.0) continue;
    sum += (a[n] - b[n]) * (a[n] - b[n]);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : NAN;
}

// With this radius trilinear interpolation sinks by 0.017 voxels, and a chord shorter than a voxel
// is 0.008 deep: twice their sum.
constexpr double kMostOutline = 0.05;  // voxels
// The rim alone makes 1.2: it is dark, over nothing.
constexpr double kMostGrey = 3.0;

TEST(SpherePicture, HasTheOutlineOfTheFormulaHoweverItIsDrawn) {
  Stage stage;
  for (const Camera& camera : {kFar, kNear})
    EXPECT_LT(outlineError(stage.drawn(SurfaceMode::RayCast, false, camera), camera), kMostOutline);
  for (const bool moving : {false, true}) {
    SCOPED_TRACE(moving ? "reduced mesh" : "mesh");
    EXPECT_LT(outlineError(stage.drawn(SurfaceMode::Mesh, moving, kFar), kFar), kMostOutline);
  }
}

TEST(SpherePicture, OfTheRayCasterIsLitAsTheFormulaSays) {
  Stage stage;
  for (const Camera& camera : {kFar, kNear})
    EXPECT_LT(differenceOf(stage.drawn(SurfaceMode::RayCast, false, camera), stage.formula(camera)),
              kMostGrey);
}

TEST(SpherePicture, SeesOneThatIsMirroredOrAPixelAsideOrHasTurnedNormals) {
  Stage stage;
  const Picture drawn = stage.drawn(SurfaceMode::RayCast, false, kFar);
  Picture mirrored = drawn, shifted = drawn;
  for (auto row = mirrored.begin(); row != mirrored.end(); row += kSphereSide)
    std::reverse(row, row + kSphereSide);
  EXPECT_GT(outlineError(mirrored, kFar), kMostOutline);
  std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
  EXPECT_GT(outlineError(shifted, kFar), kMostOutline);
  EXPECT_GT(outlineError(Picture(drawn.size()), kFar), kMostOutline);
  EXPECT_GT(differenceOf(drawn, stage.formula(kFar, 0.05)), kMostGrey);  // rad
}

}  // namespace
