// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "app/study/arcs/arcs.h"
#include "datasets/phantoms/making.h"

namespace {

namespace arcs = study::arcs;

void print(const std::string& name, const char* what, const arcs::Tally& tally) {
  std::printf("%-15s %-7s %9ld %9ld %7ld %7ld %10.2e %8ld\n", name.c_str(), what, tally.arcs,
              tally.met, tally.missed, tally.late, tally.latest, tally.early);
  std::fflush(stdout);
}

}  // namespace

// palpate-arcs [--arcs N] [--seed S]: half of the arcs in noise, a third at plates, the rest at a
// gyroid; a fifth of each with a whole shell. 1 if any was missed or late.
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
  datasets::Random random{seed};
  std::printf("%-15s %-7s %9s %9s %7s %7s %10s %8s\n", "target", "of", "arcs", "met", "missed",
              "late", "latest/h", "early");
  arcs::Tally points, shells;
  const auto shoot = [&](const arcs::Target& target, double share) {
    const arcs::Tally a =
        arcs::shootPoints(target, std::lround(0.8 * share * double(count)), random);
    const arcs::Tally b =
        arcs::shootShells(target, std::lround(0.2 * share * double(count)), random);
    print(target.name, "points", a);
    print(target.name, "shells", b);
    points += a;
    shells += b;
  };
  for (int k = 0; k < 5; ++k) {
    shoot(arcs::noise(seed + unsigned(k)), 0.1);
    shoot(arcs::slantedPlate(random), 0.04);
  }
  shoot(arcs::uprightPlates(), 0.14);
  shoot(arcs::gyroid(), 0.16);
  print("all", "points", points);
  print("all", "shells", shells);
  return points.missed + points.late + shells.missed + shells.late > 0 ? 1 : 0;
}
