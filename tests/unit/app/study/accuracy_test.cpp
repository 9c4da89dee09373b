// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "app/study/accuracy/carving.h"
#include "app/study/accuracy/closed_forms.h"
#include "app/study/accuracy/collision.h"
#include "app/study/accuracy/contenders.h"
#include "app/study/accuracy/field_error.h"
#include "app/study/accuracy/led.h"
#include "app/study/accuracy/projection.h"
#include "app/study/accuracy/work_precision.h"
#include "app/study/comparison/slack.h"
#include "app/study/studies.h"
#include "datasets/phantoms/making.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/phantoms/shapes.h"
#include "haptics/collision/motion_rows.h"
#include "tests/support/made.h"

// That the references see an error that is there: each test plants one in what is judged.

namespace {

namespace arcs = study::arcs;
using study::Case;
using study::Outcome;

bool allPass(const Outcome& outcome) {
  return !outcome.cases.empty() && std::ranges::all_of(outcome.cases, &Case::pass);
}

/// Whether a case whose name ends so fails.
bool fails(const Outcome& outcome, const std::string& end) {
  return std::ranges::any_of(outcome.cases,
                             [&](const Case& c) { return c.name.ends_with(end) && !c.pass(); });
}

TEST(ParetoFront, LeavesOutWhatAnotherOutdoes) {
  EXPECT_EQ(study::accuracy::paretoFront({{1, 5}, {2, 3}, {3, 4}, {4, 3}, {5, 1}, {1, 5}}),
            (std::vector<bool>{true, true, false, false, true, true}));
}

TEST(WorkPrecision, ShowsMedianTailAndFront) {
  Outcome outcome;
  study::accuracy::addTo(outcome,
                         {"T",
                          "D.",
                          "t",
                          "e",
                          {{"m", "a", {1, 3}, {4, 2, 6}, comparison::MeanCounts{1, 2, 3, 4, 5}},
                           {"m", "b", {5, 7, 12}, {9}, {}, {5, 7, 12}},
                           {"n", "", {1}, {0}}}});
  ASSERT_EQ(outcome.plots.size(), 1u);
  const auto& series = outcome.plots[0].series;
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].points[0].x, 2.0);
  EXPECT_EQ(series[0].points[0].y, 4.0);
  EXPECT_EQ(series[0].points[0].high, 6.0);
  EXPECT_TRUE(series[0].points[0].in_line);
  EXPECT_FALSE(series[0].points[1].in_line);
  // of three runs the median, and all three in the table
  EXPECT_EQ(series[0].points[1].x, 7.0);
  EXPECT_EQ(outcome.tables[0].rows[0],
            (std::vector<std::string>{"m", "a", "1, 3, 3, 3", "one run", "4, 6, 6, 6", "yes", "1",
                                      "2", "3", "4", "5"}));
  EXPECT_EQ(outcome.tables[0].rows[1][3], "5, 7, 12");
  EXPECT_EQ(outcome.tables[0].rows[1][5], "no");
}

TEST(Collisions, SeeADroppedRoot) {
  const auto ours = study::accuracy::detectors().front();
  EXPECT_TRUE(allPass(study::accuracy::collisions({ours}, "noise", made::trials(1'000), 5)));
  // what only grazes is not seen: a root of the cubic that is taken back within a tenth of a voxel
  const study::accuracy::Detector grazing{
      "planted", "", [](const arcs::Target& target, double s, const arcs::Arc& arc) {
        arcs::Crossing crossing = arcs::detected(target, s, arc);
        const double on = crossing.time + 1e-4 / arc.speed();
        if (crossing.met && on < 1.0 && target.field.value(target.field.indexOf(arc.at(on))) < s)
          return arcs::Crossing{1.0, false};
        return crossing;
      }};
  EXPECT_FALSE(allPass(study::accuracy::collisions({grazing}, "noise", made::trials(1'000), 5)));
  // met, but a hundredth of a voxel late
  const study::accuracy::Detector late{
      "planted", "", [](const arcs::Target& target, double s, const arcs::Arc& arc) {
        arcs::Crossing crossing = arcs::detected(target, s, arc);
        if (crossing.met) crossing.time += 1e-5 / arc.speed();
        return crossing;
      }};
  EXPECT_FALSE(allPass(study::accuracy::collisions({late}, "gyroid", made::trials(1'000), 5)));
  // one that never moves misses nothing
  const study::accuracy::Detector timid{"planted", "",
                                        [](const arcs::Target&, double, const arcs::Arc&) {
                                          return arcs::Crossing{0.0, true};
                                        }};
  EXPECT_FALSE(allPass(study::accuracy::collisions({timid}, "gyroid", made::trials(1'000), 5)));
}

TEST(Projections, SeeOneThatStopsEarly) {
  const auto ours = study::accuracy::solvers().front();
  EXPECT_TRUE(allPass(study::accuracy::projections({ours}, 6, false, 100, 7)));
  // stops after the rows that it met first: the last of them is left out
  const study::accuracy::Solver early{
      "planted", [&](const study::accuracy::ProjectionProblem& problem, auto& pivots) {
        study::accuracy::ProjectionProblem less = problem;
        less.rows.pop_back();
        return ours.solve(less, pivots);
      }};
  EXPECT_FALSE(allPass(study::accuracy::projections({early}, 6, false, 100, 7)));
  // a relaxation that ends a thousandth short
  const study::accuracy::Solver loose{
      "planted", [&](const study::accuracy::ProjectionProblem& problem, auto& pivots) {
        haptics::Twist V = ours.solve(problem, pivots);
        V.linear += 1e-3 * (problem.free.linear - V.linear);
        return V;
      }};
  EXPECT_FALSE(allPass(study::accuracy::projections({loose}, 6, false, 100, 7)));
}

TEST(Projections, SeeANumberThatIsNone) {
  int calls = 0;
  const study::accuracy::Solver none{
      "planted", [&](const study::accuracy::ProjectionProblem& problem, auto& pivots) {
        haptics::Twist V = study::accuracy::solvers().front().solve(problem, pivots);
        if (++calls == 2) V.linear.x() = NAN;
        return V;
      }};
  EXPECT_FALSE(allPass(study::accuracy::projections({none}, 3, false, 20, 7)));
}

TEST(Projections, EnumerationAndTheReferenceAgree) {
  // two references, neither of which shares code with the other
  const auto all = study::accuracy::solvers();
  for (const bool coplanar : {false, true})
    EXPECT_TRUE(allPass(study::accuracy::projections({all[1]}, 6, coplanar, 100, 8)));
}

/// Ours, with something wrong in what comes out.
class Planted final : public comparison::Method {
 public:
  enum class Error { LaggingForce, Sinks, StopsEarly };
  Planted(std::unique_ptr<comparison::Method> ours, Error error)
      : ours_{std::move(ours)}, error_{error} {}
  const char* name() const override { return "planted"; }
  void start(const haptics::Pose& X_WP) override { ours_->start(X_WP); }

 private:
  void step(const haptics::Pose& X_WD, comparison::Tick& tick) override {
    tick = ours_->tick(X_WD);
    const haptics::Vec3 force = tick.force;
    if (error_ == Error::LaggingForce) tick.force = last_;
    if (error_ == Error::Sinks) tick.X_WP.translation() -= 3e-5 * force;
    if (error_ == Error::StopsEarly && force.norm() > 0.0)
      tick.X_WP.translation() += 2e-4 * force.normalized();
    last_ = force;
  }
  std::unique_ptr<comparison::Method> ours_;
  Error error_;
  haptics::Vec3 last_ = haptics::Vec3::Zero();
};

constexpr study::accuracy::HeldEffort kFew{2, 1, false};

std::unique_ptr<comparison::Method> oursIn(std::shared_ptr<const haptics::Scene> scene,
                                           double isovalue) {
  return comparison::ours(std::move(scene), isovalue, study::accuracy::kByCount);
}

study::accuracy::OursMade planted(Planted::Error error) {
  return [error](std::shared_ptr<const haptics::Scene> scene, double isovalue) {
    return std::make_unique<Planted>(oursIn(std::move(scene), isovalue), error);
  };
}

TEST(ClosedForms, SeeASinkingProxyAndAForceThatLagsATick) {
  EXPECT_TRUE(allPass(study::accuracy::closedForms("sphere", kFew, 9)));
  EXPECT_FALSE(
      allPass(study::accuracy::closedForms("sphere", kFew, 9, planted(Planted::Error::Sinks))));
  EXPECT_FALSE(allPass(
      study::accuracy::closedForms("halfspace", kFew, 9, planted(Planted::Error::LaggingForce))));
}

/// A field whose values are right and whose gradients, all of them, are turned about an axis.
struct Turned : haptics::ScalarField {
  Turned(std::shared_ptr<const haptics::Volume> volume, haptics::FieldKind kind, double degrees)
      : ScalarField{std::move(volume), kind} {
    const haptics::Vec3 axis = haptics::Vec3{1, -2, 1}.normalized();
    A_VW_t_ = Eigen::AngleAxisd{degrees * std::numbers::pi / 180.0, axis} * A_VW_t_;
  }
};

/// The scene over a turned field: a new scene takes over the field of the one before.
std::shared_ptr<const haptics::Scene> turned(const haptics::Scene& scene, double degrees) {
  const auto field = std::make_shared<const Turned>(scene.volume, scene.field.kind(), degrees);
  const haptics::Scene before{
      scene.id,      scene.volume, scene.tool, scene.tree, field, *field, scene.metric,
      scene.lengths, scene.normal, {},         scene.plan, {},    {}};
  return haptics::makeScene(scene.volume, scene.tool, {}, &before).value();
}

TEST(ClosedForms, SeeATurnedNormal) {
  // the same detour without a turn is ours
  const auto by = [](double degrees) -> study::accuracy::OursMade {
    return [degrees](std::shared_ptr<const haptics::Scene> scene, double isovalue) {
      return oursIn(turned(*scene, degrees), isovalue);
    };
  };
  EXPECT_TRUE(allPass(study::accuracy::closedForms("halfspace", kFew, 9, by(0.0))));
  for (const char* solid : {"halfspace", "sphere"})
    EXPECT_FALSE(allPass(study::accuracy::closedForms(solid, kFew, 9, by(3.0)))) << solid;
}

TEST(Fields, SeeATurnedNormal) {
  const auto by = [](double degrees) -> study::accuracy::FieldMade {
    return [degrees](study::accuracy::Interpolation kind, const haptics::Volume& volume) {
      return Turned{made::shared(volume),
                    kind == study::accuracy::Interpolation::Trilinear
                        ? haptics::FieldKind::Trilinear
                        : haptics::FieldKind::CubicSpline,
                    degrees};
    };
  };
  for (const double noise : {0.0, 0.02}) {
    EXPECT_TRUE(allPass(study::accuracy::fieldErrors(noise, 100, 3, by(0.0))));
    EXPECT_FALSE(allPass(study::accuracy::fieldErrors(noise, 100, 3, by(3.0))));
  }
  EXPECT_FALSE(allPass(study::accuracy::fieldErrors(0.0, 100, 3, by(0.5))));
}

TEST(ClosedForms, TheirCasesRepeat) {
  // no clock decides: twice the same, to the bit, however often it was run
  const Outcome one = study::accuracy::closedForms("slot", {3, 1, false}, 4);
  const Outcome two = study::accuracy::closedForms("slot", {3, 2, false}, 4);
  ASSERT_EQ(one.cases.size(), two.cases.size());
  for (std::size_t n = 0; n < one.cases.size(); ++n)
    EXPECT_EQ(one.cases[n].value, two.cases[n].value) << one.cases[n].name;
}

/// A ball of 3 mm is pressed 5 mm deep into the sphere and slides along.
std::vector<haptics::Pose> pressedBy() {
  std::vector<haptics::Pose> device;
  for (int n = 0; n < 120; ++n)
    device.push_back(made::at(5e-5 * std::max(0, n - 60), 0.0, 0.025 - 1.2e-4 * std::min(n, 60)));
  return device;
}

/// What a method does then.
std::vector<comparison::Tick> pressed(comparison::Method& method) {
  std::vector<comparison::Tick> ticks;
  method.start(made::at(0.0, 0.0, 0.025));
  for (const haptics::Pose& X_WD : pressedBy()) ticks.push_back(method.tick(X_WD));
  return ticks;
}

struct Pressed {
  datasets::Phantom phantom = datasets::makePhantom("sphere").value();
  comparison::Touched scene{"sphere", made::shared(phantom.volume), phantom.isovalue, "", 0};
  haptics::Tool tool = made::tool(datasets::ballPoints(100, 3e-3));
  std::shared_ptr<const haptics::Scene> built = haptics::makeScene(scene.volume, tool).value();
};

TEST(Slack, SeesAProxyThatStopsEarlyWhichIsNotFrozen) {
  const Pressed p;
  const comparison::FreeBlocks blocks{*p.scene.volume, p.scene.isovalue};
  const comparison::Judge judge{p.scene, p.tool.shell, blocks};
  const double rest_gap = p.built->lengths.rest_gap;
  std::vector<comparison::Course> courses{{"slide", pressedBy(), false}};
  const auto summary = [&](std::unique_ptr<comparison::Method> method) {
    std::vector<std::unique_ptr<comparison::Method>> methods;
    methods.push_back(std::move(method));
    return comparison::summaryOf(comparison::follow(methods, courses).front(), courses,
                                 p.tool.shell, judge, 10, rest_gap);
  };
  const auto judged = [&](const comparison::Summary& of) {
    Outcome outcome;
    study::accuracy::addLegal(outcome, "planted", of);
    study::accuracy::addSlack(outcome, "planted", of, p.built->lengths.voxel);
    return allPass(outcome);
  };
  const auto ours = summary(oursIn(p.built, p.scene.isovalue));
  EXPECT_TRUE(judged(ours));
  const auto early = summary(
      std::make_unique<Planted>(oursIn(p.built, p.scene.isovalue), Planted::Error::StopsEarly));
  EXPECT_FALSE(judged(early));
  EXPECT_LE(early.frozen, ours.frozen);
  EXPECT_NEAR(early.sorted(&comparison::Part::slack_mm).front(), 0.2, 0.05);
  // to the bit again, and not that of another seed
  const auto again = summary(oursIn(p.built, p.scene.isovalue));
  EXPECT_EQ(again.parts[0].slack_mm, ours.parts[0].slack_mm);
}

TEST(Slack, IsTheWayThatIsLeft) {
  // a plate over a plane, and a device below it
  const datasets::Phantom phantom = datasets::makePhantom("halfspace").value();
  const comparison::Touched scene{"plane", made::shared(phantom.volume), phantom.isovalue, "", 0};
  const haptics::Tool plate = made::tool(datasets::platePoints(5, 0.01));
  const comparison::FreeBlocks blocks{*scene.volume, scene.isovalue};
  const comparison::Judge judge{scene, plate.shell, blocks};
  const auto slack = [&](double height) {
    return comparison::localSlack(made::at(0.0, 0.0, height), made::at(0.0, 0.0, -3e-3),
                                  plate.shell, judge, 200, 1);
  };
  for (const double gap : {1e-5, 1e-4}) EXPECT_NEAR(slack(gap).value(), gap, 0.1 * gap + 1e-6);
  EXPECT_FALSE(slack(-1e-4));  // inside
  EXPECT_NEAR(slack(2e-3).value(), comparison::kSlackWithin, 1e-4);
}

/// How many points the judge sees go through a plate, half a voxel to each side of x = 8, when a
/// point goes from before it to behind it. In the row y = 10 the plate has this value: below the
/// isovalue of 5000 there is a slit.
int throughAPlate(std::uint16_t in_row) {
  haptics::Grid grid;
  grid.dims = {17, 20, 24};
  grid.spacing = haptics::Vec3::Constant(1e-3);
  auto voxels = haptics::allocateVoxels(grid.voxelCount(), haptics::ScalarType::UInt16).value();
  for (std::int64_t n = 8; n < grid.voxelCount(); n += grid.dims[0])
    static_cast<std::uint16_t*>(voxels.get())[n] = n / grid.dims[0] % 20 == 10 ? in_row : 10'000;
  auto volume = haptics::makeVolume(grid, haptics::ScalarType::UInt16, std::move(voxels)).value();
  const comparison::Touched scene{"plate", made::shared(std::move(volume)), 5000.0, "", 0};
  haptics::PointShell point = made::tool(datasets::ballPoints(100, 3e-3)).shell;
  point.points = {haptics::Vec3::Zero()};
  const comparison::FreeBlocks blocks{*scene.volume, scene.isovalue};
  const comparison::Judge judge{scene, point, blocks};
  const double y = 9.476e-3, z = 12e-3;
  return judge.passages(made::at(7.2e-3, y, z), made::at(8.8e-3, y, z), true);
}

TEST(Judge, TellsAWayThroughASlitFromOneThroughAWall) {
  EXPECT_EQ(throughAPlate(10'000), 1);
  EXPECT_EQ(throughAPlate(5'010), 1);  // no slit, and at its thinnest 0.004 voxel
  EXPECT_EQ(throughAPlate(4'975), 0);  // 0.01 voxel wide: no place of a lattice of 0.05 lies in it
  EXPECT_EQ(throughAPlate(0), 0);
}

TEST(Hands, AreOthersWithAnotherSeed) {
  const comparison::Touched scene = comparison::makeScene("hole");
  const auto built = haptics::makeScene(scene.volume, comparison::toolOf(scene)).value();
  const auto two = comparison::coursesIn(*built, scene, 0.1, {}, 1, 2).value();
  const auto second = comparison::coursesIn(*built, scene, 0.1, {}, 2).value();
  ASSERT_EQ(two.size(), 2 * second.size());
  for (std::size_t n = 0; n < second.size(); ++n) {
    EXPECT_EQ(two[n].hand, second[n].hand);
    EXPECT_NE(two[n].device.front().matrix(), second[n].device.front().matrix());
    EXPECT_EQ(two[second.size() + n].device.back().matrix(), second[n].device.back().matrix());
    EXPECT_EQ(two[second.size() + n].seed, 2u);
  }
  // in the hole the peg is free where it is put
  const comparison::FreeBlocks blocks{*scene.volume, scene.isovalue};
  const comparison::Judge judge{scene, built->tool.shell, blocks};
  for (unsigned seed = 1; seed <= 50; ++seed) EXPECT_TRUE(judge.legal(scene.place(seed))) << seed;
}

TEST(Fineness, TheConstantsThemselvesChangeNothing) {
  const Pressed p;
  const auto ours = pressed(*oursIn(p.built, p.scene.isovalue));
  auto same = study::accuracy::withFineness(*p.built, p.scene.isovalue, {{0.05}, {8}});
  for (const auto& method : same.methods) {
    const auto ticks = pressed(*method);
    for (std::size_t n = 0; n < ours.size(); ++n) {
      EXPECT_EQ(ticks[n].X_WP.matrix(), ours[n].X_WP.matrix());
      EXPECT_EQ(ticks[n].work, ours[n].work);
    }
  }
}

TEST(Fineness, OtherValuesAreFelt) {
  const Pressed p;
  auto others = study::accuracy::withFineness(*p.built, p.scene.isovalue, {{0.0125, 0.2}, {1, 8}});
  // half of epsilon stays between tool and surface
  const double R = datasets::shapes::Sphere{}.radius, voxel = p.built->lengths.voxel;
  std::vector<double> gaps;
  for (int k = 0; k < 2; ++k) {
    const auto ticks = pressed(*others.methods[std::size_t(k)]);
    double gap = INFINITY;
    for (const haptics::Vec3& r : p.tool.shell.points)
      gap = std::min(gap, (ticks[60].X_WP * r).norm() - R);
    gaps.push_back(gap / voxel);
  }
  EXPECT_NEAR(gaps[1] - gaps[0], 0.5 * (0.2 - 0.0125), 0.03);
  // one sub-step that contacts shape in a tick, and one through free space, where there were more
  std::int64_t one = 0, eight = 0;
  for (const auto& tick : pressed(*others.methods[2])) one = std::max(one, tick.counts.sub_steps);
  for (const auto& tick : pressed(*others.methods[3]))
    eight = std::max(eight, tick.counts.sub_steps);
  EXPECT_LE(one, 2);
  EXPECT_GT(eight, one);
}

TEST(Counts, OfOnePointAreExact) {
  const Pressed p;
  const auto scene = haptics::makeScene(p.scene.volume, made::point()).value();
  const haptics::Isosurface solid{scene->field, p.scene.isovalue};
  const double R = datasets::shapes::Sphere{}.radius, band = scene->lengths.band;
  const haptics::Pose X = made::at(0.0, 0.0, R + 0.5 * band);
  haptics::Budget budget = haptics::Budget::counted(1'000'000);
  haptics::Clearance clearance{scene->tree};
  EXPECT_EQ(clearance.collect(solid, scene->tree, X, band, budget),
            haptics::Clearance::Verdict::Legal);
  EXPECT_EQ(budget.counts.samples, 1);
  EXPECT_EQ(budget.counts.gradients, 0);
  // its own sample and gradient, and six look-ups for a central difference
  haptics::SurfaceRows surface;
  haptics::gatherRows({solid, scene->tree, X, clearance}, scene->lengths,
                      haptics::NormalKind::Central, {}, surface, budget);
  ASSERT_EQ(surface.rows.size(), 1u);
  EXPECT_EQ(budget.counts.samples, 8);
  EXPECT_EQ(budget.counts.gradients, 2);
  // in an empty block nothing is looked up
  haptics::Budget none = haptics::Budget::counted(1'000'000);
  haptics::Clearance far{scene->tree};
  far.collect(solid, scene->tree, made::at(0.0, 0.0, R + 0.02), band, none);
  EXPECT_EQ(none.counts.samples, 0);
  EXPECT_GT(none.spent(), 0);
  // one row in the way enters the active set; one that is not does not
  const haptics::MotionRow row{haptics::Vec3::UnitZ(), haptics::Vec3::Zero(), 0.0};
  for (const double way : {-1e-3, 1e-3}) {
    const auto motion =
        haptics::constrainedMotion({{0.0, 0.0, way}, haptics::Vec3::Zero()}, {&row, 1},
                                   scene->metric, haptics::Mat3::Identity());
    EXPECT_EQ(motion.pivots, way < 0.0 ? 1 : 0);
  }
}

TEST(Counts, AreWhatWasDone) {
  const Pressed p;
  // far away nothing is looked up, and one motion leads to the device
  const auto ours = oursIn(p.built, p.scene.isovalue);
  ours->start(made::at(0.0, 0.0, 0.029));
  const comparison::Tick far = ours->tick(made::at(0.0, 0.0, 0.0295));
  EXPECT_EQ(far.counts.sub_steps, 1);
  EXPECT_EQ(far.counts.gradients, 0);
  EXPECT_EQ(far.counts.pivots, 0);
  // in contact every row near the surface has its gradient, and some bear
  for (const auto& tick : pressed(*ours)) {
    EXPECT_LE(tick.counts.sub_steps, 8);
    if (tick.contacts == 0) continue;
    EXPECT_GE(tick.counts.pivots, tick.contacts);
    // a look-up alone is four units of work, sixteen at a time one, a central difference beside
    // its sample three for seven
    EXPECT_LE(tick.counts.samples, 3 * tick.work);
    EXPECT_LE(2 * tick.counts.gradients, tick.counts.samples);
  }
  // a rival looks at every point on its way, at each end of every piece
  auto literal =
      comparison::rival(p.scene, p.tool.shell,
                        reference::choicesFor(p.scene.volume->grid, reference::Variant::Literal));
  literal->start(made::at(0.0, 0.0, 0.029));
  const comparison::Tick free = literal->tick(made::at(0.0, 0.0, 0.0291));
  EXPECT_EQ(free.counts.samples, 100);
  EXPECT_EQ(free.counts.sub_steps, 1);
  EXPECT_EQ(free.counts.gradients, 0);
  EXPECT_EQ(free.work, 0);
  std::int64_t pivots = 0;
  for (const auto& tick : pressed(*literal)) {
    EXPECT_GE(tick.counts.samples, 6 * tick.counts.gradients);
    pivots += tick.counts.pivots;
  }
  EXPECT_GT(pivots, 0);
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

/// Some places of burrs of 3 and 6 voxels.
const study::accuracy::CarvingEffort kSomeCarving{{3.0, 6.0}, 3, 200};

TEST(Carving, OfABurrIsTheIdealShape) {
  for (const std::string& shape : study::accuracy::carvedShapes()) {
    const Outcome outcome =
        study::accuracy::carvings({study::accuracy::carvers().front()}, shape, kSomeCarving, 3);
    // place, normal and volume of two radii in four materials
    EXPECT_EQ(outcome.cases.size(), 24u);
    for (const Case& c : outcome.cases)
      EXPECT_TRUE(c.pass()) << c.name << ": " << c.value << " against " << c.bound;
  }
}

TEST(Carving, SeesABurrOfAnotherSizeAndOneThatCountsWrongly) {
  using study::accuracy::carvings;
  const auto ours = study::accuracy::carvers().front();
  // without what a ball is written larger by, so that its wall comes out right
  const study::accuracy::Carver unbiased{
      "planted", [&](const auto& volume, void* voxels, haptics::BurrCut cut) {
        cut.radius -= 0.165e-6 / cut.radius;
        return ours.cut(volume, voxels, cut);
      }};
  EXPECT_TRUE(fails(carvings({unbiased}, "ball", kSomeCarving, 3), ": place of the wall, rms"));
  const study::accuracy::Carver miscounted{"planted",
                                           [&](const auto& volume, void* voxels, const auto& cut) {
                                             return 1.02 * ours.cut(volume, voxels, cut);
                                           }};
  EXPECT_TRUE(fails(carvings({miscounted}, "groove", kSomeCarving, 3),
                    ": volume removed, off the shape's"));
  // a ball at the end of each step, and nothing between
  const study::accuracy::Carver leaping{
      "planted", [&](const auto& volume, void* voxels, haptics::BurrCut cut) {
        cut.from_W = cut.to_W;
        return ours.cut(volume, voxels, cut);
      }};
  EXPECT_TRUE(fails(carvings({leaping}, "groove", kSomeCarving, 3), ": place of the wall, rms"));
}

TEST(Carving, SeesWholeVoxelsAndShowsThemBesideTheBurr) {
  const auto& all = study::accuracy::carvers();
  for (const std::string& shape : study::accuracy::carvedShapes()) {
    const Outcome whole = study::accuracy::carvings({all.back()}, shape, kSomeCarving, 3);
    EXPECT_TRUE(fails(whole, ": place of the wall, rms")) << shape;
    EXPECT_TRUE(fails(whole, ": normal of the wall, rms")) << shape;
  }
  const Outcome outcome = study::accuracy::carvings(all, "ball", kSomeCarving, 3);
  EXPECT_TRUE(allPass(outcome));
  // ours in four materials, two others in one
  for (const std::size_t plot : {0u, 1u}) {
    const auto& series = outcome.plots[plot].series;
    ASSERT_EQ(series.size(), 6u);
    EXPECT_EQ(series.back().name, "whole voxels, int16, 1200 at 300");
    for (std::size_t n = 0; n < 2; ++n)
      EXPECT_GT(series.back().points[n].y, 10.0 * series.front().points[n].y);
  }
  for (const auto& row : outcome.tables.front().rows)
    EXPECT_EQ(row.size(), outcome.tables.front().head.size());
}

TEST(Carving, WallsMoveWithTheIsovalueByItOverTheSlope) {
  const auto& all = study::accuracy::carvers();
  EXPECT_TRUE(allPass(study::accuracy::carvedAtOtherIsovalues(all[0], kSomeCarving, 3)));
  // a steeper edge moves less
  EXPECT_TRUE(fails(study::accuracy::carvedAtOtherIsovalues(all[1], kSomeCarving, 3),
                    "at -300: place of the wall, off"));
}

TEST(CarvingRates, AreThoseOfTheLawAndSeeAWrongFactor) {
  const study::accuracy::RateEffort effort{{2.0, 10.0}, {1000}};
  haptics::CutLaw law = study::accuracy::pressedLaw();
  const Outcome outcome = study::accuracy::carvingRates(law, effort);
  // volume and depth of two forces in three types
  EXPECT_EQ(outcome.cases.size(), 12u);
  EXPECT_TRUE(allPass(outcome));
  law.share *= 1.04;
  const Outcome planted = study::accuracy::carvingRates(law, effort);
  EXPECT_TRUE(fails(planted, ": volume removed, off the law"));
  EXPECT_TRUE(fails(planted, ": volume of the hole, off the law"));
}

}  // namespace
