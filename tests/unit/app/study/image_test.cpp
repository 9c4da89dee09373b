// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/image.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/study/rendering/sphere_image.h"

namespace {

using study::Image;

/// Of f(x, y).
template <class F>
Image imageOf(int width, int height, F&& f) {
  Image image{width, height};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.grey.push_back(f(x, y));
  return image;
}

Image stripes(int shift) {
  return imageOf(32, 32, [=](int x, int) { return (x + shift) % 8 < 4 ? 50.0 : 150.0; });
}

TEST(Rmse, IsZeroForEqualAndTheOffsetForAConstantOne) {
  EXPECT_EQ(rmse(stripes(0), stripes(0)), 0.0);
  Image brighter = stripes(0);
  for (double& grey : brighter.grey) grey += 7.0;
  EXPECT_DOUBLE_EQ(rmse(stripes(0), brighter), 7.0);
}

TEST(Rmse, OfAShiftedPictureIsThatOfTheEdges) {
  // of eight columns two change, by 100
  EXPECT_DOUBLE_EQ(rmse(stripes(0), stripes(1)), 100.0 * std::sqrt(2.0 / 8.0));
}

TEST(Rmse, CountsThePixelsWhereEitherShowsTheObject) {
  // 0 is background: two pixels of four show something, one of them in one picture only
  const Image a{4, 1, {0, 0, 100, 40}}, b{4, 1, {0, 0, 0, 40}};
  EXPECT_DOUBLE_EQ(rmse(a, b), 100.0 / std::sqrt(2.0));
  EXPECT_EQ(a.shown(), 2);
  EXPECT_TRUE(std::isnan(rmse(Image{2, 1, {0, 0}}, Image{2, 1, {0, 0}})));
  EXPECT_EQ(rmse(a, Image{2, 1, {0, 0}}), INFINITY);
}

TEST(Ssim, IsOneForEqualAndFallsWithAShift) {
  EXPECT_DOUBLE_EQ(ssim(stripes(0), stripes(0)), 1.0);
  EXPECT_LT(ssim(stripes(0), stripes(1)), 0.9);
  EXPECT_LT(ssim(stripes(0), stripes(4)), -0.5);  // light for dark
}

TEST(Ssim, OfAConstantOffsetIsTheMeansTerm) {
  // no spread in either: (2 a b + C1) / (a² + b² + C1), C1 = (0.01 · 255)²
  const auto flat = [](double grey) { return imageOf(16, 16, [=](int, int) { return grey; }); };
  EXPECT_NEAR(ssim(flat(100.0), flat(120.0)), 24'006.5025 / 24'406.5025, 1e-12);
}

TEST(Ssim, OfHalfTheContrastIsTheSpreadsTerm) {
  // about the same mean: stripes so fine that every window holds as much of either
  const auto fine = [](double contrast) {
    return imageOf(40, 40,
                   [=](int x, int y) { return 100.0 + ((x + y) % 2 ? contrast : -contrast); });
  };
  // 2 s t + C2 over s² + t² + C2, C2 = (0.03 · 255)²
  EXPECT_NEAR(ssim(fine(20.0), fine(10.0)), 458.5225 / 558.5225, 1e-3);
}

TEST(Ssim, LooksOnlyWhereAnObjectIs) {
  const auto spot = [](double grey) {
    return imageOf(64, 64,
                   [=](int x, int y) { return std::hypot(x - 32, y - 32) < 8 ? grey : 0.0; });
  };
  // the same difference in a much larger empty picture is no smaller
  const auto wide = [](double grey) {
    return imageOf(256, 256,
                   [=](int x, int y) { return std::hypot(x - 128, y - 128) < 8 ? grey : 0.0; });
  };
  EXPECT_NEAR(ssim(spot(80), spot(160)), ssim(wide(80), wide(160)), 1e-12);
  EXPECT_LT(ssim(spot(80), spot(160)), 0.9);
}

TEST(SphereImage, IsARoundSpotWhereItStandsAndBrightestInItsMiddle) {
  // 100 mm off, 10 mm wide: seen under asin(0.05); right and up of the middle
  const study::Camera camera{{0, -100, 0}, {0, 0, 0}, {0, 0, 1}, 30.0};
  const study::Sphere sphere{{12, 0, 6}, 5.0};
  const study::Look look{{1, 0.5, 0.25}, 0.1, 0.6, 0.2, 10.0};
  const Image image = study::imageOf(sphere, look, camera, 200);
  const double pixels_per_mm = 100.0 / (100.0 * std::tan(M_PI / 12));
  const int x = static_cast<int>(100 + 12 * pixels_per_mm),
            y = static_cast<int>(100 + 6 * pixels_per_mm);
  EXPECT_NEAR(image.shown(), M_PI * 25 * pixels_per_mm * pixels_per_mm, 0.03 * image.shown());
  // facing: 0.7 of the colour and the shine, each clamped and rounded
  EXPECT_NEAR(image.at(x, y),
              (std::round(255 * 0.9) + std::round(255 * 0.55) + std::round(255 * 0.375)) / 3, 1.0);
  EXPECT_EQ(image.at(199 - x, y), 0.0);
  EXPECT_EQ(image.at(x, 199 - y), 0.0);
  EXPECT_LT(study::clearance_mm(sphere, camera, 200, x, y), -4.8);
  EXPECT_GT(study::clearance_mm(sphere, camera, 200, 199 - x, y), 15.0);
}

}  // namespace
