// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "app/study/arcs/arcs.h"
#include "datasets/phantoms/making.h"
#include "tests/support/every_target.h"

namespace {

namespace arcs = study::arcs;

void print(const std::string& name, const char* what, const arcs::Tally& tally) {
  std::printf("%-15s %-7s %9ld %9ld %7ld %7ld %10.2e %8ld\n", name.c_str(), what, tally.arcs,
              tally.met, tally.missed, tally.late, tally.latest, tally.early);
  std::fflush(stdout);
}

/// All arcs, on the vectors in force: points and shells.
struct All {
  arcs::Tally points, shells;
};
/// Half of the arcs in noise, a third at plates, the rest at a gyroid; a fifth of each with a whole
/// shell. A line for each where they are judged.
All shootAll(long count, unsigned seed, arcs::Judging judging) {
  datasets::Random random{seed};
  All all;
  const auto shoot = [&](const arcs::Target& target, double share) {
    const arcs::Tally a = arcs::shootPoints(target, std::lround(0.8 * share * double(count)),
                                            random, arcs::detected, judging);
    const arcs::Tally b =
        arcs::shootShells(target, std::lround(0.2 * share * double(count)), random, judging);
    all.points += a;
    all.shells += b;
    if (judging == arcs::Judging::None) return;
    print(target.name, "points", a);
    print(target.name, "shells", b);
  };
  for (int k = 0; k < 5; ++k) {
    shoot(arcs::noise(seed + unsigned(k)), 0.1);
    shoot(arcs::slantedPlate(random), 0.04);
  }
  shoot(arcs::uprightPlates(), 0.14);
  shoot(arcs::gyroid(), 0.16);
  return all;
}

}  // namespace

// palpate-arcs [--arcs N] [--seed S]: judges the arcs by a dense sampling, then shoots them again
// on every kind of vector. 1 if any was missed or late, or stopped elsewhere on another kind.
int main(int argc, char** argv) {
  long count = 1'000'000;
  unsigned seed = 1;
  for (int n = 1; n < argc; n += 2) {
    if (n + 1 < argc && std::strcmp(argv[n], "--arcs") == 0) {
      count = std::strtol(argv[n + 1], nullptr, 10);
    } else if (n + 1 < argc && std::strcmp(argv[n], "--seed") == 0) {
      seed = static_cast<unsigned>(std::strtoul(argv[n + 1], nullptr, 10));
    } else {
      std::fprintf(stderr, "palpate-arcs [--arcs N] [--seed S]\n");
      return 2;
    }
  }
  std::printf("%-15s %-7s %9s %9s %7s %7s %10s %8s\n", "target", "of", "arcs", "met", "missed",
              "late", "latest/h", "early");
  const All judged = shootAll(count, seed, arcs::Judging::Dense);
  print("all", "points", judged.points);
  print("all", "shells", judged.shells);
  bool same = true;
  onEveryTarget([&](const std::string& vectors) {
    const All again = shootAll(count, seed, arcs::Judging::None);
    const bool is_same =
        again.points.stops == judged.points.stops && again.shells.stops == judged.shells.stops;
    std::printf("%-15s %s\n", vectors.c_str(), is_same ? "the same bits" : "OTHER STOPS");
    std::fflush(stdout);
    same = same && is_same;
  });
  const arcs::Tally &points = judged.points, &shells = judged.shells;
  return !same || points.missed + points.late + shells.missed + shells.late > 0 ? 1 : 0;
}
