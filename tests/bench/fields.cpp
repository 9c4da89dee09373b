// SPDX-License-Identifier: BSD-3-Clause

// palpate-fields SCANS: what a tick takes with the spline field, beside the trilinear one: the five
// scans and hands of haptics/MEASURED.md, "Normals", in closed loop and by counted work. Thread CPU
// time, the median of some runs; the fields take turns.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "datasets/readers/volume_reader.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/simulation/hand.h"
#include "resources/named_tools.h"

namespace {

using haptics::FieldKind;
using haptics::HandMotion;

struct Place {
  const char* name;
  const char* path;
  double isovalue;
  const char* tool;
};
constexpr Place kPlaces[] = {
    {"bunny", "stanford_bunny/bunny_512x512x361_airflat.nrrd", 1500, "cane"},
    {"engine", "volvis_classics/engine.nhdr", 90, "wrench"},
    {"head", "visible_human_female_head/vhf_head_512x512x234.nrrd", 300, "drill"},
    {"slab", "visible_human_female_head/dicom_slab", 300, "drill"},
    {"phantom", "philips_head_phantom/bone_1mm", 300, "drill"}};
constexpr std::pair<const char*, HandMotion> kHands[] = {{"tap", HandMotion::Tap},
                                                         {"slide", HandMotion::Slide},
                                                         {"wedge", HandMotion::Wedge},
                                                         {"pry", HandMotion::Pry},
                                                         {"hook", HandMotion::Hook}};
constexpr std::array<FieldKind, 2> kKinds{FieldKind::Trilinear, FieldKind::CubicSpline};
constexpr double kStiffness = 1000.0;  // N/m
constexpr double kDepth = 0.008;       // m beyond the surface

/// A hand's run, by the tick.
struct Ran {
  double us = 0.0, work = 0.0, cut = 0.0, coupling_mm = 0.0;
  Ran& operator+=(const Ran& other) {
    us += other.us;
    work += other.work;
    cut += other.cut;
    coupling_mm += other.coupling_mm;
    return *this;
  }
};

Ran run(const std::shared_ptr<const haptics::Scene>& scene, const Place& place, HandMotion motion,
        int ticks) {
  haptics::ClosedLoop loop{scene, {.isovalue = place.isovalue, .stiffness = kStiffness}, {}, {}};
  loop.grip.gyration = std::sqrt(scene->tool.shell.inertia.trace() / 3.0);
  const double reach = haptics::Hand::reachFor(kDepth, kStiffness, loop.grip.stiffness);
  const auto hand = haptics::Hand::aimed(motion, *scene, place.isovalue, reach, 1).value();
  Ran ran;
  int contact = 0;
  const auto done = loop.run(hand, ticks, [&](const haptics::TraceRow& row) {
    ran.us += 1e-3 * double(row.cpu_ns) / ticks;
    ran.work += double(row.work) / ticks;
    ran.cut += double(row.cut_at != 0) / ticks;
    if (row.contacts > 0) {
      ++contact;
      ran.coupling_mm += 1e3 * (row.X_WD.translation() - row.X_WP.translation()).norm();
    }
    return true;
  });
  if (!done) std::exit(1);
  ran.coupling_mm /= std::max(1, contact);
  return ran;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "Usage: palpate-fields SCANS [RUNS [SECONDS [PLACE [FIELD]]]]\n");
    return 2;
  }
  const std::filesystem::path folder = words[1];
  const int runs = count > 2 ? std::atoi(words[2]) : 5;
  const int ticks = static_cast<int>(1e3 * (count > 3 ? std::atof(words[3]) : 3.0));
  const std::string only = count > 4 ? words[4] : "", alone = count > 5 ? words[5] : "";
  std::printf("%-8s %-6s %24s %8s %28s %16s\n", "", "", "us, trilinear, spline", "ratio",
              "units of work, and ns a unit", "cut");
  for (const Place& place : kPlaces) {
    if (!only.empty() && only != place.name) continue;
    auto read = datasets::readVolume(folder / place.path);
    if (!read) {
      std::printf("%s was not read\n", place.name);
      continue;
    }
    const auto volume = std::make_shared<const haptics::Volume>(std::move(*read));
    std::array<std::shared_ptr<const haptics::Scene>, 2> scenes;
    for (std::size_t k = 0; k < 2; ++k)
      scenes[k] =
          haptics::makeScene(
              volume,
              haptics::makeTool(place.tool, resources::namedToolMesh(place.tool).value()).value(),
              {kKinds[k], haptics::NormalKind::Central})
              .value();
    const auto tell = [&](const char* hand, const std::array<std::vector<double>, 2>& us,
                          const std::vector<double>& ratio, const std::array<Ran, 2>& last) {
      const double mean[2] = {median(us[0]), median(us[1])};
      std::printf(
          "%-8s %-6s %11.2f %11.2f %8.2f %9.0f %9.0f %5.1f %5.1f %6.3f %6.3f  %6.3f %6.3f\n",
          place.name, hand, mean[0], mean[1], median(ratio), last[0].work, last[1].work,
          1e3 * mean[0] / last[0].work, 1e3 * mean[1] / last[1].work, last[0].cut, last[1].cut,
          last[0].coupling_mm, last[1].coupling_mm);
      std::fflush(stdout);
    };
    std::array<std::vector<double>, 2> all_us{std::vector<double>(std::size_t(runs)),
                                              std::vector<double>(std::size_t(runs))};
    std::array<Ran, 2> all{};
    for (const auto& [name, motion] : kHands) {
      std::array<std::vector<double>, 2> us;
      std::vector<double> ratio;
      std::array<Ran, 2> last;
      for (int n = 0; n < runs; ++n) {
        for (std::size_t turn = 0; turn < 2; ++turn) {
          const std::size_t k = (turn + std::size_t(n)) % 2;
          if (alone == "spline" && k == 0) continue;
          if (alone == "trilinear" && k == 1) continue;
          last[k] = run(scenes[k], place, motion, ticks);
          all_us[k][std::size_t(n)] += last[k].us / std::size(kHands);
        }
        for (std::size_t k = 0; k < 2; ++k) us[k].push_back(last[k].us);
        ratio.push_back(last[1].us / last[0].us);
      }
      tell(name, us, ratio, last);
      for (std::size_t k = 0; k < 2; ++k) {
        Ran share = last[k];
        share.work /= std::size(kHands);
        share.cut /= std::size(kHands);
        share.coupling_mm /= std::size(kHands);
        all[k] += share;
      }
    }
    std::vector<double> ratio;
    for (std::size_t n = 0; n < std::size_t(runs); ++n)
      ratio.push_back(all_us[1][n] / all_us[0][n]);
    tell("all", all_us, ratio, all);
  }
  return 0;
}
