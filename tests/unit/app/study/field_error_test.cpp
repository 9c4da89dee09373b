// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/field_error.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/support/made.h"

/// How far each field is from what was scanned: the figures of haptics/MEASURED.md, "Fields".
namespace {

void expectAll(const study::Outcome& outcome) {
  for (const study::Case& c : outcome.cases) {
    std::cout << c.name << ": " << c.value << " " << c.unit << "\n";
    EXPECT_TRUE(c.pass()) << c.name << ": " << c.value << " against " << c.bound;
  }
  EXPECT_FALSE(outcome.cases.empty());
}

TEST(Fields, LieNearWhatWasScannedAsTheReadmeSays) {
  for (const double noise : {0.0, 0.02})
    expectAll(study::accuracy::fieldErrors(noise, made::trials(2000), 42));
}

TEST(Fields, KeepOfAThinPlateWhatTheReadmeSays) {
  // under a sanitizer one plate of each kind must do
  const int plates = std::max(1, made::trials(6));
  const study::Outcome outcome = study::accuracy::plateErrors(plates, made::trials(400), 43);
  expectAll(outcome);
  // what the smoothing spline loses is what the user is told of it
  const auto& series = outcome.plots.front().series;
  EXPECT_GT(series[0].points[2].y, series[1].points[2].y + 0.5);
}

}  // namespace
