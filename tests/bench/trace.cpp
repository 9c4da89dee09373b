// SPDX-License-Identifier: BSD-3-Clause

// palpate-trace SCENE: ours alone on a short fixed trace with counted work, for instructions.py,
// which counts its instructions. What comes before the first tick is not counted.

#include <algorithm>
#include <cstdio>

#include "app/study/comparison/course.h"
#include "haptics/proxy/tick.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define COUNTING(what) CALLGRIND_##what##_INSTRUMENTATION
#else
#define COUNTING(what) static_cast<void>(0)
#endif

int main(int argc, char** argv) {
  const auto& names = comparison::sceneNames();
  if (argc != 2 || std::find(names.begin(), names.end(), argv[1]) == names.end()) {
    std::fprintf(stderr, "Usage: palpate-trace bunny|engine|hole|bone\n");
    return 2;
  }
  const comparison::Touched scene = comparison::makeScene(argv[1]);
  const auto built = haptics::makeScene(scene.volume, comparison::toolOf(scene)).value();
  const auto courses = comparison::coursesIn(*built, scene, 0.3).value();
  std::vector<std::unique_ptr<comparison::Method>> methods;
  methods.push_back(comparison::ours(built, scene.isovalue, {0, haptics::kTickWork}));

  COUNTING(START);
  const auto tracks = comparison::follow(methods, courses);
  COUNTING(STOP);

  long long ticks = 0, work = 0;
  for (const auto& course : tracks.front().ticks)
    for (const comparison::Tick& tick : course) {
      ++ticks;
      work += tick.work;
    }
  std::printf("{\"scene\": \"%s\", \"ticks\": %lld, \"work\": %lld}\n", argv[1], ticks, work);
  return 0;
}
