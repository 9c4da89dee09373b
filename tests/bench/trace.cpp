// SPDX-License-Identifier: BSD-3-Clause

// palpate-trace SCENE|uncut|burr: ours alone on a short fixed trace with counted work, for
// instructions.py, which counts its instructions. Nothing before the first tick is counted.
// "uncut" is a course of the study of plans, "burr" the same with a burr that is not held.

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/study/comparison/course.h"
#include "app/study/plan/courses.h"
#include "haptics/proxy/tick.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define COUNTING(what) CALLGRIND_##what##_INSTRUMENTATION
#else
#define COUNTING(what) static_cast<void>(0)
#endif

namespace {

int traceCourse(const std::string& name) {
  using study::plan::Burr;
  const auto planned = study::plan::courses(study::Depth::Quick);
  const auto found =
      std::ranges::find(planned, "gyroid and drill, wedge", &study::plan::Planned::name);
  const study::plan::Course course = study::plan::made(*found, 900, 1).value();
  const auto work = study::plan::workOf(course, name == "burr" ? Burr::Ready : Burr::None,
                                        [] { COUNTING(START); });
  COUNTING(STOP);
  std::printf("{\"scene\": \"%s\", \"ticks\": %d, \"work\": %lld}\n", name.c_str(), course.ticks,
              static_cast<long long>(work.value()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto& names = comparison::sceneNames();
  if (argc == 2 && (std::string{argv[1]} == "uncut" || std::string{argv[1]} == "burr"))
    return traceCourse(argv[1]);
  if (argc != 2 || std::find(names.begin(), names.end(), argv[1]) == names.end()) {
    std::fprintf(stderr, "Usage: palpate-trace bunny|engine|hole|bone|uncut|burr\n");
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
