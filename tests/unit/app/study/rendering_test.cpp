// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/display.h"
#include "app/study/rendering/drawing.h"
#include "datasets/phantoms/sampling.h"

// Needs an X display with GLX. That the cases see an error that is there: planted in pictures.

namespace {

using study::BackEnd;
using study::Camera;
using study::Case;
using study::Drawn;
using study::Image;
using study::Outcome;
using study::Reference;

bool allPass(const Outcome& outcome) {
  return !outcome.cases.empty() && std::ranges::all_of(outcome.cases, &Case::pass);
}

/// A ball beside the middle, its formula's picture, and what the window draws of it.
class SphereDrawn : public testing::Test {
 protected:
  static constexpr int kSide = 200;
  static void SetUpTestSuite() {
    display_ = new app::HeldDisplay;
    if (!display_->draws()) return;
    const datasets::Ramp ramp;
    auto volume = datasets::sampled<std::int16_t>(
        datasets::centredGrid(48, 48, 48, 0.001), ramp, [](const haptics::Vec3& p) {
          return (p * 1e3 - kSphere.centre_mm).norm() * 1e-3 - kSphere.radius_mm * 1e-3;
        });
    drawing_ = new study::Drawing({std::move(volume.value()), ramp.isovalue, ""}, kSide);
  }
  static void TearDownTestSuite() {
    delete drawing_;
    delete display_;
  }
  void SetUp() override { ASSERT_NE(drawing_, nullptr) << "there is no X display with GLX"; }

  Drawn drawn(BackEnd back_end, const Camera& camera) const {
    return {
        nameOf(back_end), 1.0, {drawing_->shoot(back_end, drawing_->ownSampleDistance(), camera)}};
  }
  Image formula(const Camera& camera) const {
    return imageOf(kSphere, drawing_->look(), camera, kSide);
  }

  static constexpr double kFar_mm = 2600.0;  // at one degree: 45 mm from edge to edge
  inline static const study::Sphere kSphere{{3.0, -2.0, 4.0}, 15.0};
  inline static const Camera kCamera{{0, -kFar_mm, 0}, {0, 0, 0}, {0, 0, 1}, 1.0};
  inline static app::HeldDisplay* display_ = nullptr;  // outlives what draws on it
  inline static study::Drawing* drawing_ = nullptr;
};

TEST_F(SphereDrawn, IsWhatTheFormulaSays) {
  // from nearby too: the ray caster's light comes along each ray
  for (const Camera& camera : {kCamera, Camera{{60, -60, 30}, {0, 0, 0}, {0, 0, 1}, 30.0}}) {
    const Drawn cast = drawn(BackEnd::RayCast, camera);
    EXPECT_TRUE(allPass(
        study::agreement({"formula", {formula(camera)}}, {"drawn", {cast.views[0].image}})));
    EXPECT_TRUE(allPass(study::silhouettes({kSphere, {camera}, 1.0}, {cast})));
    EXPECT_EQ(cast.views[0].frames_ms.size(), 1u);
    EXPECT_GT(cast.views[0].frames_ms[0], 0.0);
  }
}

TEST_F(SphereDrawn, ByEveryBackEndHasTheSphereSilhouette) {
  for (const BackEnd back_end :
       {BackEnd::RayCast, BackEnd::RayCastCoarse, BackEnd::Mesh, BackEnd::ReducedMesh}) {
    SCOPED_TRACE(nameOf(back_end));
    for (const Case& c :
         study::silhouettes({kSphere, {kCamera}, 1.0}, {drawn(back_end, kCamera)}).cases)
      EXPECT_TRUE(c.pass()) << c.name << ": " << c.value << ' ' << c.unit;
  }
}

TEST_F(SphereDrawn, SeesAMirroredPicture) {
  Drawn mirrored = drawn(BackEnd::RayCast, kCamera);
  Image& image = mirrored.views[0].image;
  for (auto row = image.grey.begin(); row != image.grey.end(); row += kSide)
    std::reverse(row, row + kSide);
  const Outcome outcome = study::silhouettes({kSphere, {kCamera}, 1.0}, {mirrored});
  ASSERT_EQ(outcome.cases.size(), 2u);
  EXPECT_FALSE(outcome.cases[0].pass());
  EXPECT_FALSE(outcome.cases[1].pass());
}

TEST_F(SphereDrawn, SeesAPictureAPixelAside) {
  Drawn shifted = drawn(BackEnd::RayCast, kCamera);
  auto& grey = shifted.views[0].image.grey;
  std::rotate(grey.begin(), grey.begin() + 1, grey.end());
  EXPECT_FALSE(study::silhouettes({kSphere, {kCamera}, 1.0}, {shifted}).cases[0].pass());
}

/// The formula's picture at one degree, once more: all rays parallel, and its normals turned about
/// the patient's axis.
Image turnedNormals(const study::Sphere& sphere, const study::Look& look, double mm_per_pixel,
                    int side, double angle) {
  Image image{side, side};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double nx =
          ((x + 0.5 - 0.5 * side) * mm_per_pixel - sphere.centre_mm.x()) / sphere.radius_mm;
      const double nz =
          ((y + 0.5 - 0.5 * side) * mm_per_pixel - sphere.centre_mm.z()) / sphere.radius_mm;
      const double rest = 1.0 - nx * nx - nz * nz;
      const double facing =
          rest < 0.0 ? 0.0
                     : std::max(0.0, std::cos(angle) * std::sqrt(rest) + std::sin(angle) * nx);
      const double shine = look.specular * std::pow(facing, look.power);
      const double mean =
          (look.colour * (look.ambient + look.diffuse * facing)).array().min(1.0 - shine).mean();
      image.grey.push_back(rest < 0.0 ? 0.0 : 255.0 * (mean + shine));
    }
  return image;
}

TEST_F(SphereDrawn, SeesATurnedNormal) {
  const Reference drawn_one{"drawn", {drawn(BackEnd::RayCast, kCamera).views[0].image}};
  const double mm_per_pixel = 2.0 * kFar_mm * std::tan(M_PI / 360.0) / kSide;
  const auto turned = [&](double angle) {
    return Reference{"turned",
                     {turnedNormals(kSphere, drawing_->look(), mm_per_pixel, kSide, angle)}};
  };
  EXPECT_TRUE(allPass(study::agreement(turned(0.0), drawn_one)));
  EXPECT_FALSE(study::agreement(turned(0.05), drawn_one).cases[0].pass());
}

TEST(Judged, SeesAnErrorThatRisesAndAnEmptyPicture) {
  const Image meant{16, 16, std::vector<double>(256, 100.0)};
  const auto off_by = [&](double error) {
    Image image = meant;
    for (double& grey : image.grey) grey += error;
    return study::Shot{image, {1.0}};
  };
  const Reference reference{"what is meant", {meant}};
  EXPECT_TRUE(
      allPass(judged("S", reference, {{"b", 2.0, {off_by(4.0)}}, {"b", 1.0, {off_by(2.0)}}})));
  EXPECT_FALSE(
      allPass(judged("S", reference, {{"b", 2.0, {off_by(2.0)}}, {"b", 1.0, {off_by(4.0)}}})));
  EXPECT_FALSE(allPass(judged("S", reference, {{"b", 0.0, {off_by(-100.0)}}})));
  EXPECT_FALSE(allPass(judged("S", reference, {{"b", 0.0, {}}})));
}

TEST(Convergence, SeesASampleDistanceWithoutEffect) {
  const Image meant{16, 16, std::vector<double>(256, 100.0)};
  const auto off_by = [&](double error) {
    Image image = meant;
    for (double& grey : image.grey) grey += error;
    return std::vector{study::Shot{image, {1.0}}};
  };
  const auto passes = [&](double error) {
    return allPass(study::convergence("S", "refined", "b",
                                      {{"refined", 2.0, off_by(0.0)},
                                       {"refined", 0.5, off_by(0.0)},
                                       {"b", 2.0, off_by(8.0)},
                                       {"b", 0.5, off_by(error)}}));
  };
  EXPECT_TRUE(passes(2.0));
  EXPECT_FALSE(passes(8.0));
  EXPECT_FALSE(passes(3.5));
  // a missed edge that both have in common is not counted; without the refined there is no verdict
  EXPECT_TRUE(allPass(study::convergence("S", "refined", "b",
                                         {{"refined", 2.0, off_by(50.0)},
                                          {"refined", 0.5, off_by(50.0)},
                                          {"b", 2.0, off_by(58.0)},
                                          {"b", 0.5, off_by(52.0)}})));
  EXPECT_FALSE(allPass(
      study::convergence("S", "refined", "b", {{"b", 2.0, off_by(8.0)}, {"b", 0.5, off_by(2.0)}})));
}

TEST(Rendering, WithoutADisplayIsAnOmissionAndNoCase) {
  const std::string display = std::getenv("DISPLAY") ? std::getenv("DISPLAY") : "";
  for (const char* none : {"", ":4711"}) {
    if (*none)
      ::setenv("DISPLAY", none, 1);
    else
      ::unsetenv("DISPLAY");
    for (const study::Job& job : study::renderingJobs(study::Depth::Quick)) {
      const Outcome outcome = job.run(1);
      EXPECT_TRUE(outcome.cases.empty());
      ASSERT_EQ(outcome.tables.size(), 1u);
      EXPECT_EQ(outcome.tables[0].caption, "Omissions");
      EXPECT_NE(outcome.tables[0].rows[0][1].find("display"), std::string::npos);
    }
  }
  if (!display.empty()) ::setenv("DISPLAY", display.c_str(), 1);
}

TEST(Rendering, QuicklyDrawsEveryScene) {
  ASSERT_TRUE(app::HeldDisplay{}.draws());
  for (const study::Job& job : study::renderingJobs(study::Depth::Quick)) {
    SCOPED_TRACE(job.name);
    const Outcome outcome = job.run(1);
    EXPECT_GE(outcome.plots.size(), 2u);
    EXPECT_FALSE(outcome.cases.empty());
    for (const Case& c : outcome.cases)
      EXPECT_TRUE(c.pass()) << c.name << ": " << c.value << ' ' << c.unit;
  }
}

}  // namespace
