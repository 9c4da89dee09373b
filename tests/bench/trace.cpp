// SPDX-License-Identifier: BSD-3-Clause

// palpate-trace SCENE: ours alone on a short fixed trace with counted work, for instructions.py,
// which counts its instructions. What comes before the first tick is not counted.

#include <algorithm>
#include <cstdio>

#include "haptics/servo/tick.h"
#include "tests/bench/course.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define COUNTING(what) CALLGRIND_##what##_INSTRUMENTATION
#else
#define COUNTING(what) static_cast<void>(0)
#endif

int main(int argc, char** argv) {
  const auto& names = bench::sceneNames();
  if (argc != 2 || std::find(names.begin(), names.end(), argv[1]) == names.end()) {
    std::fprintf(stderr, "Usage: palpate-trace bunny|engine|hole|bone\n");
    return 2;
  }
  const bench::Case scene = bench::makeScene(argv[1]);
  const auto built = haptics::makeScene(scene.volume, bench::toolOf(scene)).value();
  const auto courses = bench::coursesIn(*built, scene, 0.3).value();
  std::vector<std::unique_ptr<bench::Method>> methods;
  methods.push_back(bench::ours(built, scene.isovalue, {0, haptics::kTickWork}));

  COUNTING(START);
  const auto tracks = bench::follow(methods, courses);
  COUNTING(STOP);

  long long ticks = 0, work = 0;
  for (const auto& course : tracks.front().ticks)
    for (const bench::Tick& tick : course) {
      ++ticks;
      work += tick.samples;
    }
  std::printf("{\"scene\": \"%s\", \"ticks\": %lld, \"work\": %lld}\n", argv[1], ticks, work);
  return 0;
}
