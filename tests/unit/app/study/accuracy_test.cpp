// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/study/accuracy/closed_forms.h"
#include "app/study/accuracy/collision.h"
#include "app/study/accuracy/projection.h"
#include "app/study/accuracy/work_precision.h"
#include "app/study/made/made.h"
#include "app/study/studies.h"

// That the references see an error that is there: each test plants one in what is judged.

namespace {

using study::Case;
using study::Outcome;

bool allPass(const Outcome& outcome) {
  return !outcome.cases.empty() && std::ranges::all_of(outcome.cases, &Case::pass);
}

TEST(ParetoFront, LeavesOutWhatAnotherOutdoes) {
  EXPECT_EQ(study::paretoFront({{1, 5}, {2, 3}, {3, 4}, {4, 3}, {5, 1}, {1, 5}}),
            (std::vector<bool>{true, true, false, false, true, true}));
}

TEST(WorkPrecision, ShowsMedianTailAndFront) {
  Outcome outcome;
  study::addTo(outcome,
               {"T",
                "D.",
                "t",
                "e",
                {{"m", "a", {1, 3}, {4, 2, 6}}, {"m", "b", {5}, {9}}, {"n", "", {1}, {0}}}});
  ASSERT_EQ(outcome.plots.size(), 1u);
  const auto& series = outcome.plots[0].series;
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].points[0].x, 2.0);
  EXPECT_EQ(series[0].points[0].y, 4.0);
  EXPECT_EQ(series[0].points[0].high, 6.0);
  EXPECT_TRUE(series[0].points[0].in_line);
  EXPECT_FALSE(series[0].points[1].in_line);
  EXPECT_EQ(outcome.tables[0].rows[1].back(), "no");
}

TEST(Collisions, SeeADroppedRoot) {
  const auto ours = study::detectors().front();
  EXPECT_TRUE(allPass(study::collisions({ours}, "noise", made::trials(1'000), 5)));
  // what only grazes is not seen: a root of the cubic that is taken back within a tenth of a voxel
  const study::Detector grazing{
      "planted", "", [](const arcs::Target& target, double s, const made::Arc& arc) {
        made::Crossing crossing = arcs::detected(target, s, arc);
        const double on = crossing.time + 1e-4 / arc.speed();
        if (crossing.met && on < 1.0 && target.field.value(target.field.indexOf(arc.at(on))) < s)
          return made::Crossing{1.0, false};
        return crossing;
      }};
  EXPECT_FALSE(allPass(study::collisions({grazing}, "noise", made::trials(1'000), 5)));
  // met, but a hundredth of a voxel late
  const study::Detector late{"planted", "",
                             [](const arcs::Target& target, double s, const made::Arc& arc) {
                               made::Crossing crossing = arcs::detected(target, s, arc);
                               if (crossing.met) crossing.time += 1e-5 / arc.speed();
                               return crossing;
                             }};
  EXPECT_FALSE(allPass(study::collisions({late}, "gyroid", made::trials(1'000), 5)));
  // one that never moves misses nothing
  const study::Detector timid{"planted", "", [](const arcs::Target&, double, const made::Arc&) {
                                return made::Crossing{0.0, true};
                              }};
  EXPECT_FALSE(allPass(study::collisions({timid}, "gyroid", made::trials(1'000), 5)));
}

TEST(Projections, SeeOneThatStopsEarly) {
  const auto ours = study::solvers().front();
  EXPECT_TRUE(allPass(study::projections({ours}, 6, false, 100, 7)));
  // stops after the rows that it met first: the last of them is left out
  const study::Solver early{"planted", [&](const study::ProjectionProblem& problem) {
                              study::ProjectionProblem less = problem;
                              less.rows.pop_back();
                              return ours.solve(less);
                            }};
  EXPECT_FALSE(allPass(study::projections({early}, 6, false, 100, 7)));
  // a relaxation that ends a thousandth short
  const study::Solver loose{"planted", [&](const study::ProjectionProblem& problem) {
                              haptics::Twist V = ours.solve(problem);
                              V.linear += 1e-3 * (problem.free.linear - V.linear);
                              return V;
                            }};
  EXPECT_FALSE(allPass(study::projections({loose}, 6, false, 100, 7)));
}

TEST(Projections, SeeANumberThatIsNone) {
  int calls = 0;
  const study::Solver none{"planted", [&](const study::ProjectionProblem& problem) {
                             haptics::Twist V = study::solvers().front().solve(problem);
                             if (++calls == 2) V.linear.x() = NAN;
                             return V;
                           }};
  EXPECT_FALSE(allPass(study::projections({none}, 3, false, 20, 7)));
}

TEST(Projections, EnumerationAndTheReferenceAgree) {
  // two references, neither of which shares code with the other
  const auto all = study::solvers();
  for (const bool coplanar : {false, true})
    EXPECT_TRUE(allPass(study::projections({all[1]}, 6, coplanar, 100, 8)));
}

/// Ours, with something wrong in what comes out.
class Planted final : public comparison::Method {
 public:
  enum class Error { None, TurnedNormal, LaggingForce, Sinks };
  Planted(std::unique_ptr<comparison::Method> ours, Error error)
      : ours_{std::move(ours)}, error_{error} {}
  const char* name() const override { return "planted"; }
  void start(const haptics::Pose& X_WP) override { ours_->start(X_WP); }

 private:
  void step(const haptics::Pose& X_WD, comparison::Tick& tick) override {
    tick = ours_->tick(X_WD);
    const haptics::Vec3 force = tick.force;
    if (error_ == Error::TurnedNormal)
      tick.force = Eigen::AngleAxisd{0.05, force.normalized().unitOrthogonal()} * force;
    if (error_ == Error::LaggingForce) tick.force = last_;
    if (error_ == Error::Sinks) tick.X_WP.translation() -= 3e-5 * force;
    last_ = force;
  }
  std::unique_ptr<comparison::Method> ours_;
  Error error_;
  haptics::Vec3 last_ = haptics::Vec3::Zero();
};

TEST(ClosedForms, SeeATurnedNormalAndASinkingProxy) {
  EXPECT_TRUE(allPass(study::closedForms("sphere", 2, 9)));
  for (const auto error : {Planted::Error::TurnedNormal, Planted::Error::Sinks}) {
    const auto plant = [&](std::unique_ptr<comparison::Method> ours) {
      return std::make_unique<Planted>(std::move(ours), error);
    };
    EXPECT_FALSE(allPass(study::closedForms("sphere", 2, 9, plant)));
  }
}

TEST(ClosedForms, SeeAForceThatLagsATick) {
  const auto plant = [&](std::unique_ptr<comparison::Method> ours) {
    return std::make_unique<Planted>(std::move(ours), Planted::Error::LaggingForce);
  };
  EXPECT_FALSE(allPass(study::closedForms("halfspace", 2, 9, plant)));
}

TEST(Studies, HaveJobsAndCasesWithNamesOfTheirOwn) {
  for (const std::string& name : study::studyNames())
    for (const auto depth : {study::Depth::Quick, study::Depth::Full}) {
      std::set<std::string> names, files;
      const auto study = study::makeStudy(name, depth);
      ASSERT_TRUE(study);
      EXPECT_EQ(study->name, name);
      for (const study::Job& job : study->jobs) {
        EXPECT_TRUE(names.insert(job.name).second) << job.name;
        std::string file = job.name;
        for (char& c : file)
          if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
        EXPECT_TRUE(files.insert(file).second) << job.name;
        EXPECT_GT(job.cost, 0.0);
      }
    }
  EXPECT_FALSE(study::makeStudy("nothing", study::Depth::Quick));
}

}  // namespace
