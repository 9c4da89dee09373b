// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>

#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/recorded_run.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "app/cli/trace.h"
#include "app/measurement/quantile.h"
#include "haptics/devices/ratings.h"
#include "haptics/servo/servo_tick.h"
#include "haptics/simulation/allowed_stiffness.h"
#include "haptics/simulation/closed_loop.h"
#include "haptics/simulation/penetration.h"
#include "haptics/smoothing.h"
#include "resources/messages/messages.h"
#include "resources/named_tools.h"

namespace app::cli {
namespace {

constexpr double kDepth = 0.008;  // m that a hand brings the device beyond the surface

struct RunOptions {
  VolumeChoice volume;
  ToolChoice tool;
  double isovalue = 0.0;
  std::string hand = "tap";
  double seconds = 5.0;
  double stiffness = 1000.0;
  double angular_stiffness = 0.0;
  double friction = 0.0;
  std::string field = "trilinear";
  std::string normal = "central";
  std::string device = {};
  int rate = haptics::ServoRate{}.hz;
  std::string trace = {};
  std::string record = {};
  std::uint64_t seed = 1;
};

const std::map<std::string, haptics::HandMotion>& motions() {
  using haptics::HandMotion;
  static const std::map<std::string, HandMotion> kMotions{
      {"tap", HandMotion::Tap},    {"slide", HandMotion::Slide}, {"wedge", HandMotion::Wedge},
      {"pry", HandMotion::Pry},    {"hook", HandMotion::Hook},   {"jerk", HandMotion::Jerk},
      {"twist", HandMotion::Twist}};
  return kMotions;
}

const std::map<std::string, haptics::FieldKind>& fields() {
  static const std::map<std::string, haptics::FieldKind> kFields{
      {"trilinear", haptics::FieldKind::Trilinear}, {"spline", haptics::FieldKind::CubicSpline}};
  return kFields;
}

const std::map<std::string, haptics::NormalKind>& normals() {
  static const std::map<std::string, haptics::NormalKind> kNormals{
      {"central", haptics::NormalKind::Central},
      {"cell", haptics::NormalKind::Cell},
      {"spline", haptics::NormalKind::Spline}};
  return kNormals;
}

template <class T>
std::vector<std::string> namesIn(const std::map<std::string, T>& kinds) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds) names.push_back(name);
  return names;
}

std::vector<int> servoRates() {
  std::vector<int> rates;
  for (const haptics::ServoRate rate : haptics::kServoRates) rates.push_back(rate.hz);
  return rates;
}

CLI::Range within(haptics::Range range) { return {range.least, range.most}; }

/// What is told of a run, gathered row by row.
struct Tally {
  std::vector<double> tick_us;
  std::int64_t ticks = 0, contact_ticks = 0, non_finite = 0;
  int most_contacts = 0;
  double penetration_mm = 0.0, coupling_m = 0.0, force = 0.0, torque = 0.0;

  void add(const haptics::TraceRow& row, const haptics::Scene& scene, double isovalue) {
    ++ticks;
    tick_us.push_back(double(row.cpu_ns) * 1e-3);
    // the norms, too: a force may be finite and its size not
    if (!row.X_WP.matrix().allFinite() || !std::isfinite(row.coupling_W.force.norm()) ||
        !std::isfinite(row.coupling_W.torque.norm())) {
      ++non_finite;
      return;
    }
    penetration_mm =
        std::max(penetration_mm, haptics::penetration(scene, isovalue, row.X_WP) * 1e3);
    force = std::max(force, row.sent_W.force.norm());
    torque = std::max(torque, row.sent_W.torque.norm());
    most_contacts = std::max(most_contacts, row.contacts);
    if (row.contacts == 0) return;
    ++contact_ticks;
    const Eigen::AngleAxisd turn{row.X_WD.linear() * row.X_WP.linear().transpose()};
    const haptics::Twist apart{row.X_WD.translation() - row.X_WP.translation(),
                               turn.angle() * turn.axis()};
    coupling_m += scene.metric.whitened(apart, row.X_WP.linear()).norm();
  }

  nlohmann::ordered_json report() const {
    std::vector<double> sorted = tick_us;
    std::sort(sorted.begin(), sorted.end());
    const auto quantile = [&](double q) { return measurement::quantile(sorted, q); };
    nlohmann::ordered_json json;
    json["ticks"] = ticks;
    json["mean_us"] =
        sorted.empty() ? 0.0
                       : std::accumulate(sorted.begin(), sorted.end(), 0.0) / double(sorted.size());
    json["p50_us"] = quantile(0.5);
    json["p99_us"] = quantile(0.99);
    json["max_us"] = quantile(1.0);
    json["contact_ticks"] = contact_ticks;
    json["max_contacts"] = most_contacts;
    json["max_penetration_mm"] = penetration_mm;
    json["coupling_mm"] = contact_ticks > 0 ? coupling_m / double(contact_ticks) * 1e3 : 0.0;
    json["max_force_N"] = force;
    json["max_torque_Nm"] = torque;
    json["nonfinite"] = non_finite;
    return json;
  }
};

haptics::Expected<haptics::Hand> handFor(const RunOptions& options, const haptics::Scene& scene,
                                         const haptics::Grip& grip) {
  const auto found = motions().find(options.hand);
  if (found == motions().end()) {
    if (options.hand.find('.') == std::string::npos) {
      std::string names;
      for (const auto& [name, motion] : motions()) names += (names.empty() ? "" : ", ") + name;
      return tl::unexpected(haptics::Error{haptics::Error::Kind::NotFound,
                                           {"name-or-file-unknown", {options.hand, names}}});
    }
    return readHand(options.hand);
  }
  const double reach = haptics::Hand::reachFor(kDepth, options.stiffness, grip.stiffness);
  return haptics::Hand::aimed(found->second, scene, options.isovalue, reach, options.seed);
}

/// N/m: what the loop may carry: our grip, and the device whose limits are taken. None where the
/// hand is the device, which nothing moves.
std::optional<double> allowedIn(const haptics::ClosedLoop& loop,
                                const haptics::DeviceRating* rating) {
  if (loop.hand_is_device) return {};
  const haptics::PointShell& shell = loop.scene->tool.shell;
  const double gripped = haptics::allowedStiffness(loop.grip, shell, loop.rate.period());
  if (rating == nullptr) return gripped;
  return std::min(gripped,
                  haptics::allowedStiffness(*rating, shell, {loop.rate.period(), rating->delay}));
}

std::string shown(double stiffness) {
  return nlohmann::json(std::llround(stiffness)).dump() + " N/m";
}

/// What ended a run early: its last tick.
std::string notFinite(const Tally& tally, double stiffness, std::optional<double> allowed) {
  return "Tick " + std::to_string(tally.ticks - 1) +
         " gave a number that is not finite, and the run ended there; " +
         (allowed && stiffness > *allowed
              ? shown(stiffness) + " is more than the " + shown(*allowed) + " that are allowed."
              : "please report it.");
}

/// A tool's name if it is one of ours; what a file is called is nobody's business.
std::string nameOf(const ToolChoice& choice) {
  return resources::findNamedTool(choice.name) != nullptr ? choice.name : std::string{};
}

Outcome run(const RunOptions& options) {
  if (options.volume.path.empty() == options.volume.phantom.empty())
    return usage("run needs either --volume or --phantom.");
  haptics::ForceLimits limits;
  const haptics::DeviceRating* rating = nullptr;
  if (!options.device.empty()) {
    rating = haptics::findRating(options.device);
    if (rating == nullptr || rating->actuated == 0) {
      std::string names;
      for (const auto& r : haptics::deviceRatings())
        if (r.actuated > 0) names += (names.empty() ? "" : ", ") + std::string{r.id};
      return usage("No model with motors is called '" + options.device + "'; choose one of " +
                   names + ".");
    }
    if (options.rate > haptics::rateOf(*rating).hz)
      return usage("The link of " + std::string{rating->name} + " carries " +
                   std::to_string(haptics::rateOf(*rating).hz) + " Hz at most; lower --rate.");
    limits = haptics::limitsOf(*rating);
  }
  if (const auto wrong = contradictionIn(options.tool)) return usage(*wrong);
  std::vector<Target> targets;
  if (!options.trace.empty()) targets.push_back({"--trace", options.trace});
  if (!options.record.empty()) targets.push_back({"--record", options.record});
  if (const auto wrong = overwritten(targets, options.volume, {options.tool.name, options.hand}))
    return usage(*wrong);
  auto loaded = loadTool(options.tool);
  if (!loaded) return refused(loaded.error());
  for (const haptics::Message& warning : loaded->warnings) tell(resources::sentence(warning));
  auto volume = loadVolume(options.volume);
  if (!volume) return refused(volume.error());
  if (options.isovalue <= (*volume)->least)
    return refused(
        {haptics::Error::Kind::Unsupported,
         {"isovalue-below-background",
          {nlohmann::json(options.isovalue).dump(), nlohmann::json((*volume)->least).dump()}},
         "isovalue"});
  auto scene = haptics::makeScene(*volume, std::move(loaded->tool),
                                  {fields().at(options.field), normals().at(options.normal)});
  if (!scene) return refused(scene.error());

  haptics::ClosedLoop loop{*scene,
                           {.isovalue = options.isovalue,
                            .stiffness = options.stiffness,
                            .angular_stiffness = options.angular_stiffness,
                            .friction = options.friction},
                           limits,
                           {},
                           !motions().contains(options.hand),
                           {options.rate}};
  loop.grip.gyration = std::sqrt((*scene)->tool.shell.inertia.trace() / 3.0);
  auto hand = handFor(options, **scene, loop.grip);
  if (!hand) return refused(hand.error());
  const std::optional<double> allowed = allowedIn(loop, rating);
  if (allowed && options.stiffness > *allowed)
    tell("The stiffness of " + shown(options.stiffness) + " is more than the " + shown(*allowed) +
         " that are allowed here: the loop may shake, or diverge.");

  if (interrupted()) return stopped();
  const Closing held;
  std::unique_ptr<TraceWriter> trace;
  if (!options.trace.empty()) {
    auto opened = TraceWriter::open(options.trace);
    if (!opened) return failed(resources::sentence(opened.error()));
    trace = std::make_unique<TraceWriter>(std::move(*opened));
  }
  std::unique_ptr<RecordedRun> recorded;
  if (!options.record.empty()) {
    auto begun = RecordedRun::begin(options.record, loop, nameOf(options.tool));
    if (!begun) return failed(resources::sentence(begun.error()));
    recorded = std::move(*begun);
  }
  Tally tally;
  bool stopped = false;
  const auto ticks = static_cast<std::int64_t>(std::llround(options.seconds * options.rate));
  const auto done = loop.run(*hand, ticks, [&](const haptics::TraceRow& row) {
    tally.add(row, **scene, options.isovalue);
    if (trace) trace->write(row);
    if (recorded) recorded->write(row);
    stopped = stopped || interrupted();
    return !stopped && tally.non_finite == 0;
  });
  if (!done) return refused(done.error());
  Outcome outcome;
  outcome.json = tally.report();
  outcome.aside = !options.trace.empty() && isStandardOutput(options.trace);
  if (allowed) outcome.json["allowed_stiffness_N_m"] = *allowed;
  for (const haptics::Structure& built : (*scene)->structures)
    outcome.json["structures"].push_back(
        {{"name", built.name}, {"bytes", built.bytes}, {"build_ms", built.build_time * 1e3}});
  if ((*scene)->field.kind() == haptics::FieldKind::CubicSpline) {
    const haptics::SmoothingEffect effect = haptics::smoothingEffect(**volume, options.isovalue);
    outcome.json["smoothing"] = {{"erased_share", effect.erased}, {"gained_share", effect.gained}};
  }
  // both are finished before one is judged
  const auto traced = trace ? trace->finish() : haptics::Expected<void>{};
  if (recorded) {
    const auto finished = recorded->finish();
    if (!finished) return {Exit::Failed, outcome.json, {}, resources::sentence(finished.error())};
    outcome.json["recording"] = *finished;
  }
  if (!traced) return {Exit::Failed, outcome.json, {}, resources::sentence(traced.error())};
  if (stopped) {
    outcome.code = Exit::Interrupted;
    outcome.error = "Stopped; the report covers the run until then.";
  } else if (tally.non_finite > 0 || tally.penetration_mm > 0.0) {
    outcome.code = Exit::Failed;
    outcome.error = tally.non_finite > 0 ? notFinite(tally, options.stiffness, allowed)
                                         : "The proxy entered the surface; please report it.";
  }
  return outcome;
}

}  // namespace

void addRun(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      program.add_subcommand("run", "Touch a volume with the simulated hand, in closed loop");
  auto* path = command->add_option("--volume", options->volume.path,
                                   "DICOM folder or file, NRRD, MetaImage or NIfTI");
  path->check(notEmpty());
  command->add_option("--phantom", options->volume.phantom, "A named phantom")
      ->excludes(path)
      ->check(notEmpty());
  addReading(*command, options->volume);
  command
      ->add_option("--isovalue", options->isovalue,
                   "Intensity of the surface, in the volume's unit")
      ->required()
      ->check(finiteNumber());
  command
      ->add_option("--tool", options->tool.name,
                   resources::namesOfTools() + ", or a mesh or CSV file")
      ->required()
      ->check(notEmpty());
  command->add_option("--points", options->tool.points, "Number of points, spread evenly by area")
      ->check(wholeNumber(1, 10'000'000));
  command->add_option("--tool-unit", options->tool.unit, "Unit of a mesh file")
      ->check(CLI::IsMember({"m", "mm", "cm", "in"}));
  command
      ->add_option("--hand", options->hand,
                   "tap, slide, wedge, pry, hook, jerk, twist, or a CSV of poses")
      ->required()
      ->check(notEmpty());
  command->add_option("--seconds", options->seconds, "Length of the run [s]")
      ->required()
      ->check(finiteNumber() & CLI::Range(0.001, 86'400.0));
  command->add_option("--stiffness", options->stiffness, "Stiffness of the virtual coupling [N/m]")
      ->required()
      ->check(finiteNumber() & within(haptics::kStiffnessRange));
  command
      ->add_option("--angular-stiffness", options->angular_stiffness,
                   "Instead of stiffness times the tool's inertia [N·m/rad]")
      ->check(finiteNumber() & within(haptics::kAngularStiffnessRange));
  command
      ->add_option("--friction", options->friction,
                   "Coulomb's coefficient between tool and surface")
      ->check(finiteNumber() & within(haptics::kFrictionRange));
  command->add_option("--field", options->field, "How voxels become a field: trilinear, spline")
      ->check(CLI::IsMember(namesIn(fields())));
  command
      ->add_option("--normal", options->normal,
                   "Normals of points near the surface: central, cell, spline")
      ->check(CLI::IsMember(namesIn(normals())));
  command
      ->add_option("--device", options->device,
                   "Apply the limits of this device model (an unknown name lists all)")
      ->check(notEmpty());
  command->add_option("--rate", options->rate, "Ticks of the servo loop in a second [Hz]")
      ->check(CLI::IsMember(servoRates()))
      ->capture_default_str();
  command->add_option("--trace", options->trace, "CSV to write, one row per tick")
      ->check(notEmpty());
  command->add_option("--record", options->record, "Recording to write, NAME.palpate")
      ->check(notEmpty());
  command->add_option("--seed", options->seed, "Seed of the hand's aim")
      ->check(wholeNumber(0, std::numeric_limits<std::uint64_t>::max()));
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace app::cli
