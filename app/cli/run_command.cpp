// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>

#include "app/build_info/build_info.h"
#include "app/cli/commands.h"
#include "app/cli/interrupts.h"
#include "app/cli/options.h"
#include "app/cli/recorded_run.h"
#include "app/cli/sources.h"
#include "app/cli/terminal.h"
#include "app/cli/trace.h"
#ifdef PALPATE_READERS
#include "app/cli/watching.h"
#include "datasets/edits/edit_history.h"
#include "datasets/readers/nrrd/writer.h"
#endif
#include "app/export/facts.h"
#include "app/measurement/quantile.h"
#include "app/recording/facts.h"
#include "app/recording/walls.h"
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
constexpr std::int64_t kUnitsPerMicrosecond = 100;  // of counted work
constexpr std::int64_t kMuchWork = 1000;  // units: what a tick does besides is little of its time
constexpr int kSchema = 1;                // of the report; run.schema.json says what may change

struct RunOptions {
  VolumeChoice volume;
  ToolChoice tool;
#ifdef PALPATE_READERS
  WatchChoice watch;
#endif
  double isovalue = 0.0;
  std::string hand = "tap";
  double seconds = 5.0;
  double stiffness = 1000.0;
  double angular_stiffness = 0.0;
  double friction = 0.0;
  std::string field = "trilinear";
  std::string normal = "central";
  haptics::Fineness fineness = {};
  std::int64_t budget_us = 0;  ///< counted, 10 ns a unit; 0: what the rate gives
  std::string device = {};
  int rate = haptics::ServoRate{}.hz;
  bool cut = false;
  double burr_speed_rpm = 60'000.0;
  double burr_energy = 1.0;               ///< J/mm3
  double burr_vibration = 0.0;            ///< of the normal force
  std::vector<std::string> bands = {};    ///< "700=2": from a value on, J/mm3
  std::vector<std::string> tissues = {};  ///< "3=0.2", "1=never": of a structure
  std::string save_volume = {};
  std::string trace = {};
  std::string record = {};
  std::uint64_t seed = 1;
  bool epoch = false, open_hash = false;

  std::int64_t budget_work() const {
    return budget_us > 0 ? budget_us * kUnitsPerMicrosecond
                         : haptics::ServoRate{rate}.budget_work();
  }
};

const std::map<std::string, haptics::HandMotion>& motions() {
  using haptics::HandMotion;
  static const std::map<std::string, HandMotion> kMotions{
      {"tap", HandMotion::Tap},      {"slide", HandMotion::Slide},   {"wedge", HandMotion::Wedge},
      {"pry", HandMotion::Pry},      {"hook", HandMotion::Hook},     {"jerk", HandMotion::Jerk},
      {"twist", HandMotion::Twist},  {"plunge", HandMotion::Plunge}, {"mill", HandMotion::Mill},
      {"hollow", HandMotion::Hollow}};
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
  std::int64_t ticks = 0, contact_ticks = 0, non_finite = 0, work = 0, cut = 0;
  std::int64_t much_work = 0, much_ns = 0;  ///< of ticks with much of it
  int most_contacts = 0;
  double penetration_mm = 0.0, apart_m = 0.0, coupling_m = 0.0, force = 0.0, torque = 0.0;
  haptics::Removed removed;
  std::int64_t cutting_ticks = 0;  ///< in which the burr bore force
  double cutting_force = 0.0;      ///< N, their sum

  void add(const haptics::TraceRow& row, const haptics::Scene& uncut, double isovalue) {
    const haptics::Scene& scene = row.cutting != nullptr ? *row.cutting->scene() : uncut;
    ++ticks;
    tick_us.push_back(double(row.cpu_ns) * 1e-3);
    work += row.work;
    if (row.work >= kMuchWork) {
      much_work += row.work;
      much_ns += row.cpu_ns;
    }
    cut += row.cut_at > 0;
    // the norms, too: a force may be finite and its size not
    if (!row.X_WP.matrix().allFinite() || !std::isfinite(row.coupling_W.force.norm()) ||
        !std::isfinite(row.coupling_W.torque.norm())) {
      ++non_finite;
      return;
    }
    if (row.cutting != nullptr) {
      removed = row.cutting->removed();
      cutting_ticks += row.cutting->force() > 0.0;
      cutting_force += row.cutting->force();
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
    apart_m += apart.linear.norm();
    coupling_m += scene.metric.whitened(apart, row.X_WP.linear()).norm();
  }

  nlohmann::ordered_json report() const {
    std::vector<double> sorted = tick_us;
    std::sort(sorted.begin(), sorted.end());
    const auto quantile = [&](double q) { return measurement::quantile(sorted, q); };
    nlohmann::ordered_json json;
    json["ticks"] = ticks;
    const double all_us = std::accumulate(sorted.begin(), sorted.end(), 0.0);
    json["mean_us"] = sorted.empty() ? 0.0 : all_us / double(sorted.size());
    json["p50_us"] = quantile(0.5);
    json["p99_us"] = quantile(0.99);
    json["max_us"] = quantile(1.0);
    json["contact_ticks"] = contact_ticks;
    json["max_contacts"] = most_contacts;
    json["max_penetration_mm"] = penetration_mm;
    json["penetration_judged_by"] = "palpate-cli itself, with the arithmetic of its own field";
    const auto meanInContact = [&](double sum) {
      return contact_ticks > 0 ? sum / double(contact_ticks) * 1e3 : 0.0;
    };
    json["coupling_mm"] = meanInContact(apart_m);
    json["coupling_metric_mm"] = meanInContact(coupling_m);
    json["max_force_N"] = force;
    json["max_torque_Nm"] = torque;
    json["nonfinite"] = non_finite;
    json["cut_ticks"] = cut;
    json["work_per_tick"] = ticks > 0 ? double(work) / double(ticks) : 0.0;
    json["ns_per_unit"] = nullptr;
    if (much_work > 0) json["ns_per_unit"] = double(much_ns) / double(much_work);
    return json;
  }
};

haptics::Expected<RecordedHand> handFor(const RunOptions& options, const haptics::Scene& scene,
                                        const haptics::Grip& grip) {
  const auto found = motions().find(options.hand);
  if (found == motions().end()) {
    if (options.hand.find('.') == std::string::npos) {
      std::string names;
      for (const auto& [name, motion] : motions()) names += (names.empty() ? "" : ", ") + name;
      return tl::unexpected(haptics::Error{haptics::Error::Kind::NotFound,
                                           {"name-or-file-unknown", {options.hand, names}},
                                           "unknown-name"});
    }
    return readHand(options.hand);
  }
  const double reach = haptics::Hand::reachFor(kDepth, options.stiffness, grip.stiffness);
  auto aimed = haptics::Hand::aimed(found->second, scene, options.isovalue, reach, options.seed);
  if (!aimed) return tl::unexpected(aimed.error());
  return RecordedHand{std::move(*aimed), INFINITY};
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

/// The ball of a tool that drills: a named burr, or the ball.
std::optional<haptics::Burr> burrOf(const ToolChoice& choice, const haptics::PointShell& shell) {
  const resources::NamedTool* tool = resources::findNamedTool(choice.name);
  if (tool == nullptr || !tool->cuts()) return {};
  return haptics::ballAtTip(shell, 0.5 * tool->tip);
}

/// What it takes to cut the scan: of all values, and from some on.
haptics::Expected<haptics::Material> materialFrom(double energy,
                                                  const std::vector<std::string>& bands) {
  haptics::Material material;
  material.bands[0].energy = energy * 1e9;
  for (const std::string& text : bands) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const auto from = numberIn<double>(text.substr(0, equals));
    const auto takes = energyIn(text.substr(std::min(equals + 1, text.size())));
    if (!from || !std::isfinite(*from) || !takes || material.count == haptics::Material::kBands)
      return tl::unexpected(haptics::Error{
          haptics::Error::Kind::NotFound, {"band-unreadable", {text}}, "unknown-name"});
    material.bands[material.count++] = {*from, *takes};
  }
  std::sort(material.bands.begin() + 1, material.bands.begin() + std::ptrdiff_t(material.count),
            [](const auto& one, const auto& other) { return one.from < other.from; });
  return material;
}

/// All that decides a run: one number or word for each name, and lists of numbers.
nlohmann::ordered_json settingsOf(const RunOptions& options, const haptics::Scene& scene) {
  const haptics::Volume& volume = *scene.volume;
  const haptics::Vec3 spacing_mm = volume.grid.spacing * 1e3,
                      origin_mm = scene.tool.shell.origin * 1e3;
  const bool scripted = motions().contains(options.hand);
  const std::string tool = nameOf(options.tool);
  nlohmann::ordered_json json{
      {"scene", options.volume.phantom.empty() ? "file" : options.volume.phantom},
      {"dims", volume.grid.dims},
      {"spacing_mm", {spacing_mm.x(), spacing_mm.y(), spacing_mm.z()}},
      {"scalar", haptics::nameOf(volume.type)},
      {"range", {volume.least, volume.greatest}},
      {"unit", volume.unit},
      {"isovalue", options.isovalue},
      {"field", options.field},
      {"normals", options.normal},
      {"epsilon_voxels", options.fineness.epsilon},
      {"sub_steps", options.fineness.sub_steps},
      {"rate_Hz", options.rate},
      {"budget_work", options.budget_work()},
      {"budget_clock", "counted work, which repeats; not time"},
      {"stiffness_N_m", options.stiffness},
      {"angular_stiffness_Nm_rad", options.angular_stiffness},
      {"friction", options.friction},
      {"hand", scripted ? options.hand : "file"},
      {"seconds", options.seconds},
      {"device", options.device.empty() ? "none" : options.device},
      {"tool", tool.empty() ? "file" : tool},
      {"points", scene.tool.shell.points.size()},
      {"tool_origin_mm", {origin_mm.x(), origin_mm.y(), origin_mm.z()}}};
  if (scripted) json["seed"] = options.seed;
  if (options.cut) {
    const haptics::CutLaw law;
    json["burr_mm"] = 1e3 * resources::findNamedTool(options.tool.name)->tip;
    json["burr_speed_rpm"] = options.burr_speed_rpm;
    json["burr_share"] = law.share;
    json["burr_energy_J_mm3"] = options.burr_energy;
    json["burr_vibration"] = options.burr_vibration;
    if (!options.bands.empty()) json["burr_bands"] = options.bands;
    if (!options.tissues.empty()) json["tissues"] = options.tissues;
  }
  return json;
}

/// The facts of a run that a recording keeps beside its steps and scenes.
nlohmann::ordered_json aboutOf(const nlohmann::ordered_json& settings) {
  nlohmann::ordered_json about;
  for (const char* name : {"scene", "hand", "seed", "device", "budget_work", "budget_clock"})
    if (settings.contains(name)) about[std::string{"run_"} + name] = settings[name];
  return about;
}

/// What stands beside a trace: the same, and what its columns mean.
std::string besideTrace(const nlohmann::ordered_json& settings) {
  nlohmann::ordered_json json{{"schema", kSchema},
                              {"made_by", madeBy("palpate-cli")},
                              {"settings", settings},
                              {"conventions", exporting::conventions()}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Where a trace has its sidecar; none where it goes into a pipe or a device.
std::optional<std::string> sidecarOf(const std::string& trace) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (trace.empty() || (fs::exists(trace, ignored) && !fs::is_regular_file(trace, ignored)))
    return {};
  return fs::path{trace}.replace_extension(".trace.json").string();
}

/// Tells on a terminal how far a run is, from five seconds on.
class Progress {
 public:
  explicit Progress(std::int64_t ticks) : ticks_{ticks}, shown_{::isatty(STDERR_FILENO) == 1} {}
  void at(std::int64_t tick) {
    if (!shown_ || tick % 64 != 0) return;
    const auto now = Clock::now();
    if (now - told_ < std::chrono::seconds{5}) return;
    told_ = now;
    const double share = double(tick) / double(ticks_);
    const double left = std::chrono::duration<double>(now - begun_).count() * (1.0 / share - 1.0);
    tell(std::to_string(std::llround(100.0 * share)) + " % of the run, about " +
         std::to_string(std::llround(left)) + " s left.");
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::int64_t ticks_;
  bool shown_;
  Clock::time_point begun_ = Clock::now(), told_ = begun_;
};

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
  if (!options.cut && !options.save_volume.empty())
    return usage("--save-volume writes what a run left of the volume; add --cut.");
  std::vector<Target> targets;
  if (!options.trace.empty()) targets.push_back({"--trace", options.trace});
  if (!options.record.empty()) targets.push_back({"--record", options.record});
  if (!options.save_volume.empty()) targets.push_back({"--save-volume", options.save_volume});
  const std::optional<std::string> sidecar = sidecarOf(options.trace);
  if (sidecar) targets.push_back({"the description of --trace", *sidecar});
  std::vector<std::string> inputs{options.tool.name, options.hand};
#ifdef PALPATE_READERS
  inputs.push_back(options.watch.labels);
#endif
  if (options.record.empty() && (options.epoch || options.open_hash))
    return usage("--epoch and --open-hash are for a recording; add --record FILE.palpate.");
  if (const auto wrong = overwritten(targets, options.volume, inputs)) return usage(*wrong);
  auto loaded = loadTool(options.tool);
  if (!loaded) return refused(loaded.error());
  for (const haptics::Message& warning : loaded->warnings) tell(resources::sentence(warning));
  auto volume = loadVolume(options.volume);
  if (!volume) return refused(volume.error());
  if (!((*volume)->greatest > (*volume)->least))
    return refused({haptics::Error::Kind::Unsupported,
                    {"volume-constant", {nlohmann::json((*volume)->least).dump()}},
                    "nothing-inside"});
  if (options.isovalue <= (*volume)->least)
    return refused(
        {haptics::Error::Kind::Unsupported,
         {"isovalue-below-background",
          {nlohmann::json(options.isovalue).dump(), nlohmann::json((*volume)->least).dump()}},
         "isovalue"});
  std::shared_ptr<const haptics::Volume> touched = *volume;
#ifdef PALPATE_READERS
  const auto labels = labelsOf(options.watch, **volume);
  if (!labels) return refused(labels.error());
  auto watch = watchOver(options.watch, *labels);
  if (!watch) return refused(watch.error());
  if (!options.tissues.empty()) {
    auto table = tissuesFrom(options.tissues, **labels);
    if (!table) return refused(table.error());
    auto with = datasets::edited(*volume, std::array{datasets::Edit{std::move(*table)}});
    if (!with) return refused(with.error());
    touched = *with;
  }
  const std::vector<datasets::StructureWall> walls = wallsOf(watch->get());
  const auto before_walls = std::chrono::steady_clock::now();
  auto made = datasets::walled(touched, walls, options.isovalue, {}, &interruption());
  if (!made) return refused(made.error());
  touched = *made;
  const std::chrono::duration<double> wall_time = std::chrono::steady_clock::now() - before_walls;
#endif
  auto scene = haptics::makeScene(touched, std::move(loaded->tool),
                                  {.field = fields().at(options.field),
                                   .normal = normals().at(options.normal),
                                   .fineness = options.fineness});
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
  loop.budget_work = options.budget_work();
#ifdef PALPATE_READERS
  loop.watch = *watch;
  Nearest nearest{*watch};
#endif
  loop.grip.gyration = haptics::gyrationOf((*scene)->tool.shell);
  if (options.cut) {
    const auto burr = burrOf(options.tool, (*scene)->tool.shell);
    if (!burr)
      return usage("The tool \"" + options.tool.name + "\" has no burr that cuts; choose one of " +
                   resources::namesOfCuttingTools() + ".");
    if (datasets::walledOf(*(*scene)->volume) != nullptr)
      return usage(
          "A structure is solid or not there, and its walls would be cut; with --cut, let it be "
          "felt in another way, or add no --labels.");
    loop.cut.emplace();
    loop.cut->burr = *burr;
    loop.cut->speed = options.burr_speed_rpm * 2.0 * std::numbers::pi / 60.0;
    loop.cut->vibration = options.burr_vibration;
    auto material = materialFrom(options.burr_energy, options.bands);
    if (!material) return refused(material.error());
    loop.cut->material = *material;
  }
  auto hand = handFor(options, **scene, loop.grip);
  if (!hand) return refused(hand.error());
  const std::optional<double> allowed = allowedIn(loop, rating);
  if (allowed && options.stiffness > *allowed)
    tell("The stiffness of " + shown(options.stiffness) + " is more than the " + shown(*allowed) +
         " that are allowed here: the loop may shake, or diverge.");

  if (interrupted()) return stopped();
  const Closing held;
  const nlohmann::ordered_json settings = settingsOf(options, **scene);
  std::unique_ptr<TraceWriter> trace;
  if (!options.trace.empty()) {
    auto opened = TraceWriter::open(options.trace, loop.watch.get());
    if (!opened) return failed(resources::sentence(opened.error()));
    trace = std::make_unique<TraceWriter>(std::move(*opened));
  }
  std::unique_ptr<RecordedRun> recorded;
  if (!options.record.empty()) {
    nlohmann::ordered_json about = aboutOf(settings);
    if (options.epoch) {
      about.update(beganNow());
      tell("The recording states when it began, and so do its exports: --epoch.");
    }
    if (options.open_hash) {
      const auto hash = openHashOf(**volume);
      if (interrupted()) return stopped();
      if (!hash) return failed("This build has no open hash; use one with the window.");
      about["voxels_sha256"] = *hash;
      tell(
          "The recording holds an open hash, by which anybody who has this volume recognises it, "
          "and so do its exports: --open-hash.");
    }
    auto begun = RecordedRun::begin(options.record, loop, nameOf(options.tool), about);
    if (!begun) return failed(resources::sentence(begun.error()));
    recorded = std::move(*begun);
  }
  Tally tally;
  bool stopped = false;
  std::shared_ptr<const haptics::Scene> left;  // what the cuts left
  const auto ticks = static_cast<std::int64_t>(std::llround(options.seconds * options.rate));
  Progress progress{ticks};
  const auto done = loop.run(hand->hand, ticks, [&](const haptics::TraceRow& row) {
    tally.add(row, **scene, options.isovalue);
    if (row.cutting != nullptr) left = row.cutting->scene();
    progress.at(tally.ticks);
#ifdef PALPATE_READERS
    nearest.add(row.time, row.near);
#endif
    if (trace) trace->write(row);
    if (recorded) recorded->write(row);
    stopped = stopped || interrupted();
    return !stopped && tally.non_finite == 0;
  });
  if (!done) return refused(done.error());
  Outcome outcome;
  outcome.json["schema"] = kSchema;
  outcome.json.update(tally.report());
  if (hand->seconds < options.seconds) {
    outcome.json["hand_ended_s"] = hand->seconds;
    tell("The hand's file ended after " + nlohmann::json(hand->seconds).dump() +
         " s; from then on it held its last pose.");
  }
  outcome.aside = !options.trace.empty() && isStandardOutput(options.trace);
  if (allowed) outcome.json["allowed_stiffness_N_m"] = *allowed;
  for (const haptics::Structure& built : (*scene)->structures)
    outcome.json["structures"].push_back(
        {{"name", built.name}, {"bytes", built.bytes}, {"build_ms", built.build_time * 1e3}});
#ifdef PALPATE_READERS
  if (const datasets::Walled* walled = datasets::walledOf(*touched))
    outcome.json["structures"].push_back(
        {{"name", "walls"}, {"bytes", walled->bytes}, {"build_ms", wall_time.count() * 1e3}});
#endif
  if ((*scene)->field.kind() == haptics::FieldKind::CubicSpline) {
    const haptics::SmoothingEffect effect = haptics::smoothingEffect(*touched, options.isovalue);
    outcome.json["smoothing"] = {{"erased_share", effect.erased}, {"gained_share", effect.gained}};
  }
#ifdef PALPATE_READERS
  if (loop.watch) outcome.json["watched"] = nearest.report();
#endif
  if (options.cut)
    outcome.json["cutting"] = {
        {"removed_mm3", tally.removed.volume * 1e9},
        {"removed_J", tally.removed.energy},
        {"ticks", tally.cutting_ticks},
        {"mean_force_N",
         tally.cutting_ticks > 0 ? tally.cutting_force / double(tally.cutting_ticks) : 0.0}};
  outcome.json["settings"] = settings;
  outcome.json["made_by"] = madeBy("palpate-cli");
  // both are finished before one is judged
  auto traced = trace ? trace->finish() : haptics::Expected<void>{};
  if (traced && sidecar) traced = haptics::writeFile(*sidecar, besideTrace(settings));
  if (recorded) {
    const auto finished = recorded->finish();
    if (!finished) return {Exit::Failed, outcome.json, {}, resources::sentence(finished.error())};
    outcome.json["recording"] = *finished;
  }
  if (!traced) return {Exit::Failed, outcome.json, {}, resources::sentence(traced.error())};
#ifdef PALPATE_READERS
  if (left && !options.save_volume.empty()) {
    const auto saved = datasets::writeNrrd(*left->volume, options.save_volume);
    if (!saved) return {Exit::Failed, outcome.json, {}, resources::sentence(saved.error())};
  }
#endif
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
      ->add_option(
          "--hand", options->hand,
          "tap, slide, wedge, pry, hook, jerk, twist, plunge, mill, hollow, or a CSV of poses")
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
  command
      ->add_option("--epsilon", options->fineness.epsilon,
                   "Distance that counts as contact, in voxels")
      ->check(finiteNumber() & CLI::Range(0.001, 0.999))
      ->capture_default_str();
  command
      ->add_option("--sub-steps", options->fineness.sub_steps,
                   "Most motions in a millisecond that contacts shape or stop")
      ->check(wholeNumber(1, 1000))
      ->capture_default_str();
  command
      ->add_option(
          "--budget", options->budget_us,
          "What a tick may spend, counted: 100 units of work for each us; without it as the "
          "rate has it")
      ->check(wholeNumber(1, 1'000'000));
  command->add_option("--field", options->field, "How voxels become a field: trilinear, spline")
      ->check(CLI::IsMember(namesIn(fields())));
  // the second as cohort and the report call it
  command
      ->add_option("--normal,--normals", options->normal,
                   "Normals of points near the surface: central, cell, spline")
      ->check(CLI::IsMember(namesIn(normals())));
  command
      ->add_option("--device", options->device,
                   "Apply the limits of this device model (an unknown name lists all)")
      ->check(notEmpty());
  command->add_option("--rate", options->rate, "Ticks of the servo loop in a second [Hz]")
      ->check(CLI::IsMember(servoRates()))
      ->capture_default_str();
  auto* cut = command->add_flag("--cut", options->cut,
                                "The tool's burr removes what it is pressed against");
  command
      ->add_option("--burr-speed", options->burr_speed_rpm, "Turns of the burr in a minute [1/min]")
      ->check(finiteNumber() & CLI::Range(1.0, 500'000.0))
      ->needs(cut)
      ->capture_default_str();
  command->add_option("--burr-energy", options->burr_energy, "What removing a volume takes [J/mm3]")
      ->check(finiteNumber() & CLI::Range(0.001, 1000.0))
      ->needs(cut)
      ->capture_default_str();
  command
      ->add_option("--burr-vibration", options->burr_vibration,
                   "Amplitude of its vibration over the normal force; 0: none")
      ->check(finiteNumber() & CLI::Range(0.0, 1.0))
      ->needs(cut)
      ->capture_default_str();
  command
      ->add_option("--burr-band", options->bands,
                   "What it takes from a value of the scan on: VALUE=ENERGY [J/mm3]; repeat it for "
                   "more than one, at most 3")
      ->allow_extra_args(false)
      ->needs(cut);
#ifdef PALPATE_READERS
  command->add_option("--save-volume", options->save_volume, "NRRD to write: what is left")
      ->check(notEmpty());
  addWatching(*command, options->watch, true);
  command
      ->add_option("--tissue", options->tissues,
                   "What cutting a structure takes: N=ENERGY [J/mm3], or N=never; repeat it for "
                   "more than one")
      ->allow_extra_args(false)
      ->needs(cut)
      ->needs(command->get_option("--labels"));
#endif
  command->add_option("--trace", options->trace, "CSV to write, one row per tick")
      ->check(notEmpty());
  command->add_option("--record", options->record, "Recording to write, NAME.palpate")
      ->check(notEmpty());
  command->add_flag("--epoch", options->epoch,
                    "Write into the recording when it began, to join it with other recordings");
  command->add_flag("--open-hash", options->open_hash,
                    "Write a hash of the voxels into the recording that anybody can compare");
  command->add_option("--seed", options->seed, "Seed of the hand's aim")
      ->check(wholeNumber(0, std::numeric_limits<std::uint64_t>::max()));
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace app::cli
