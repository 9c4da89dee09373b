// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/cohort/touch.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <numeric>

#include "app/measurement/quantile.h"
#include "app/recording/replay.h"
#include "app/study/comparison/course.h"
#include "app/study/comparison/measures.h"
#include "app/study/reference/run.h"
#include "datasets/readers/meshes/tool_mesh.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/simulation/closed_loop.h"
#include "resources/messages/messages.h"
#include "resources/named_tools.h"

namespace cohort {
namespace {

using haptics::Error;
using haptics::Expected;
using haptics::Pose;
using haptics::Scene;
using haptics::Volume;
using Clock = std::chrono::steady_clock;
using Row = std::vector<std::string>;

constexpr double kDepth = 0.008;  // m that a hand brings the device beyond the surface, as in `run`

std::string word(double value) {
  if (!std::isfinite(value)) return "n/a";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}
std::string word(std::int64_t value) { return std::to_string(value); }
std::string word(int value) { return std::to_string(value); }

double secondsSince(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// Sets the process's greatest memory to what it has now, so that each scan is measured alone.
void forgetPeak() {
  // who leaves no core dump may not open it
  static const int file = [] {
    const int dumps = prctl(PR_GET_DUMPABLE, 0, 0, 0, 0);
    prctl(PR_SET_DUMPABLE, 1, 0, 0, 0);
    const int opened = ::open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
    prctl(PR_SET_DUMPABLE, dumps, 0, 0, 0);
    return opened;
  }();
  [[maybe_unused]] const auto written = ::write(file, "5", 1);
}
/// MB that the process had at most since then; NaN where the system does not say.
double peak_MB() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::atof(line.c_str() + 6) / 1024.0;
  return NAN;
}

/// Why a scan or a touch has no figures: a word for programs, and no path.
std::string reasonOf(const Error& error) {
  return !error.reason.empty()       ? error.reason
         : !error.message.id.empty() ? error.message.id
                                     : "refused";
}

/// The cells of a row by column; what is not given is n/a.
Row rowOf(const std::vector<Column>& columns, const std::map<std::string, std::string>& cells) {
  Row row;
  for (const Column& column : columns) {
    const auto found = cells.find(column.name);
    row.push_back(found != cells.end() && !found->second.empty() ? found->second : "n/a");
  }
  return row;
}

study::Table tableOf(const char* caption, const std::vector<Column>& columns) {
  study::Table table{caption, {}, {}};
  for (const Column& column : columns) table.head.push_back(column.name);
  return table;
}

haptics::HandMotion motionOf(const std::string& hand) {
  const auto at = std::ranges::find(handNames(), hand) - handNames().begin();
  return static_cast<haptics::HandMotion>(at);
}

std::string three(const auto& values, auto&& wordOf) {
  return wordOf(values[0]) + " x " + wordOf(values[1]) + " x " + wordOf(values[2]);
}

/// What one touch came to, tick by tick.
struct Tally {
  std::vector<reference::Record> records;
  std::vector<Pose> device;
  std::vector<double> tick_us, force;
  double coupling = 0.0, torque = 0.0, penetration = 0.0;  ///< m, N·m, m
  std::int64_t contact = 0, work = 0, cut = 0, non_finite = 0;
  int most_contacts = 0;
  Pose hardest = Pose::Identity();  ///< where the greatest force was

  void add(const haptics::TraceRow& row, const Scene& scene, const comparison::Judge& judge) {
    tick_us.push_back(double(row.cpu_ns) * 1e-3);
    work += row.work;
    cut += row.cut_at > 0;
    const double newtons = row.sent_W.force.norm();
    if (!row.X_WP.matrix().allFinite() || !std::isfinite(newtons) ||
        !std::isfinite(row.sent_W.torque.norm())) {
      ++non_finite;
      return;
    }
    reference::Record record;
    record.X_WP = row.X_WP;
    record.contacts = row.contacts;
    records.push_back(record);
    device.push_back(row.X_WD);
    penetration = std::max(penetration, judge.depth(row.X_WP));
    torque = std::max(torque, row.sent_W.torque.norm());
    most_contacts = std::max(most_contacts, row.contacts);
    if (row.contacts == 0) return;
    ++contact;
    if (force.empty() || newtons > *std::ranges::max_element(force)) hardest = row.X_WP;
    force.push_back(newtons);
    coupling += comparison::massDistance(row.X_WP, row.X_WD, scene.tool.shell);
  }
};

/// A scan that was read, and what is touched in it.
class ScanAtHand {
 public:
  ScanAtHand(const Line& line, const std::atomic<bool>& cancel) : line_{line}, cancel_{cancel} {
    touched_.outcome.tables = {tableOf(kTouches, touchColumns()), tableOf(kCosts, costColumns()),
                               tableOf(kReplays, replayColumns())};
  }

  Touched run() {
    forgetPeak();
    const auto begun = Clock::now();
    auto read = datasets::readVolume(line_.path, {.series = line_.series}, {.cancel = &cancel_});
    read_s_ = secondsSince(begun);
    if (!read) {
      refuse(reasonOf(read.error()));
      return std::move(touched_);
    }
    volume_ = std::make_shared<const Volume>(std::move(*read));
    describe();
    line_.recording.empty() ? touchAll() : replay();
    return std::move(touched_);
  }

 private:
  study::Table& table(int n) { return touched_.outcome.tables[static_cast<std::size_t>(n)]; }

  /// A row for the whole line, with what is known of the scan.
  void refuse(const std::string& reason) {
    auto cells = scan_;
    cells["label"] = line_.label;
    cells["status"] = "refused";
    cells["reason"] = reason;
    const bool replays = !line_.recording.empty();
    table(replays ? 2 : 0).rows.push_back(rowOf(replays ? replayColumns() : touchColumns(), cells));
  }

  void describe() {
    scan_["label"] = line_.label;
    scan_["verdict"] = volume_->resampled             ? "corrected"
                       : volume_->slices_left_out > 0 ? "part"
                                                      : "sound";
    scan_["dims"] = three(volume_->grid.dims, [](std::int64_t n) { return word(n); });
    scan_["spacing_mm"] =
        three(volume_->grid.spacing, [](double metres) { return word(metres * 1e3); });
    scan_["unit"] = volume_->unit;
    scan_["orientation"] = volume_->orientation_known ? "known" : "unknown";
  }

  void touchAll() {
    const auto isovalue = isovalueOf(line_.touching, volume_->unit);
    if (!isovalue) return refuse("isovalue-needs-hounsfield-units");
    if (*isovalue <= volume_->least || *isovalue > volume_->greatest)
      return refuse("isovalue-outside-the-range");
    scan_["isovalue"] = word(*isovalue);
    comparison::Touched touched;
    touched.name = line_.label;
    touched.volume = volume_;
    touched.isovalue = *isovalue;
    const comparison::FreeBlocks blocks(*volume_, *isovalue);
    std::shared_ptr<const Scene> scene;
    for (const std::string& name : line_.touching.tools) {
      const auto begun = Clock::now();
      auto mesh = meshOf(name);
      if (!mesh) return refuse(reasonOf(mesh.error()));
      auto tool = haptics::makeTool(name, std::move(*mesh));
      if (!tool) return refuse(reasonOf(tool.error()));
      const Touching& how = line_.touching;
      auto made = haptics::makeScene(volume_, std::move(*tool),
                                     {.field = app::fieldNamed(how.field),
                                      .normal = app::normalNamed(how.normals),
                                      .fineness = how.fineness,
                                      .cancel = &cancel_},
                                     scene.get());
      if (!made) return refuse(reasonOf(made.error()));
      scene = *made;
      scene_s_ = secondsSince(begun);
      const comparison::Judge judge(touched, scene->tool.shell, blocks);
      for (const std::string& hand : line_.touching.hands)
        for (int n = 1; n <= line_.touching.repetitions; ++n) {
          if (cancel_) return;
          touchOnce(*scene, judge, *isovalue, name, hand, n);
        }
    }
  }

  Expected<haptics::TriangleMesh> meshOf(const std::string& tool) const {
    const Touching& how = line_.touching;
    if (tool != kOwnMesh || how.mesh.empty()) return resources::namedToolMesh(tool);
    auto read = datasets::readToolMesh(how.mesh, datasets::meshUnitNamed(how.mesh_unit).value());
    if (!read) return tl::unexpected(read.error());
    return std::move(read->mesh);
  }

  void touchOnce(const Scene& scene, const comparison::Judge& judge, double isovalue,
                 const std::string& tool, const std::string& hand, int repetition) {
    const Touching& how = line_.touching;
    auto cells = scan_;
    cells["tool"] = tool;
    cells["points"] = word(std::int64_t(scene.tool.shell.points.size()));
    cells["hand"] = hand;
    cells["repetition"] = word(repetition);
    cells["seconds"] = word(how.seconds);
    cells["stiffness_N_m"] = word(how.stiffness);
    cells["angular_stiffness_Nm_rad"] = word(how.angular_stiffness);
    cells["friction"] = word(how.friction);
    cells["field"] = how.field;
    cells["normals"] = how.normals;
    cells["epsilon_voxels"] = word(how.fineness.epsilon);
    cells["sub_steps"] = word(how.fineness.sub_steps);
    cells["rate_Hz"] = word(how.rate.hz);
    cells["budget_work"] = word(how.budget_work());
    cells["seed"] = std::to_string(how.seed + static_cast<std::uint64_t>(repetition));
    haptics::ClosedLoop loop;
    loop.scene = shared(scene);
    loop.settings.isovalue = isovalue;
    loop.settings.stiffness = how.stiffness;
    loop.settings.angular_stiffness = how.angular_stiffness;
    loop.settings.friction = how.friction;
    loop.rate = how.rate;
    loop.budget_work = how.budget_work();
    loop.grip.gyration = std::sqrt(scene.tool.shell.inertia.trace() / 3.0);
    const double reach = haptics::Hand::reachFor(kDepth, how.stiffness, loop.grip.stiffness);
    auto aimed = haptics::Hand::aimed(motionOf(hand), scene, isovalue, reach,
                                      how.seed + static_cast<std::uint64_t>(repetition));
    Tally tally;
    Expected<void> done;
    if (aimed)
      done = loop.run(*aimed, std::llround(how.seconds * how.rate.hz),
                      [&](const haptics::TraceRow& row) {
                        tally.add(row, scene, judge);
                        return tally.non_finite == 0 && !cancel_;
                      });
    if (!aimed || !done) {
      cells["status"] = "refused";
      cells["reason"] = reasonOf(aimed ? done.error() : aimed.error());
      table(0).rows.push_back(rowOf(touchColumns(), cells));
      return;
    }
    const auto ticks = double(tally.tick_us.size());
    cells["status"] = tally.penetration > 0.0 ? "entered"
                      : tally.non_finite > 0  ? "not-finite"
                                              : "ok";
    cells["penetration_mm"] = word(tally.penetration * 1e3);
    cells["not_finite"] = word(tally.non_finite);
    cells["contact_share"] = word(double(tally.contact) / ticks);
    cells["contacts_max"] = word(tally.most_contacts);
    if (tally.contact > 0) {
      std::ranges::sort(tally.force);
      const auto contacts = double(tally.contact);
      cells["coupling_mm"] = word(1e3 * tally.coupling / contacts);
      cells["frozen_share"] =
          word(reference::frozenShare(tally.records, tally.device, scene.tool.shell));
      cells["force_mean_N"] =
          word(std::accumulate(tally.force.begin(), tally.force.end(), 0.0) / contacts);
      cells["force_p95_N"] = word(measurement::quantile(tally.force, 0.95));
      cells["force_max_N"] = word(tally.force.back());
      cells["torque_max_Nm"] = word(tally.torque);
    }
    cells["work_per_tick"] = word(double(tally.work) / ticks);
    cells["cut_share"] = word(double(tally.cut) / ticks);
    std::string left_out;
    for (const haptics::PlanLine& line : scene.planned)
      if (line.left_out)
        left_out += (left_out.empty() ? "" : "; ") + resources::sentence(line.what);
    cells["left_out"] = left_out;
    table(0).rows.push_back(rowOf(touchColumns(), cells));

    std::ranges::sort(tally.tick_us);
    std::size_t bytes = 0;
    for (const haptics::Structure& built : scene.structures) bytes += built.bytes;
    table(1).rows.push_back(
        rowOf(costColumns(),
              {{"label", line_.label},
               {"tool", tool},
               {"hand", hand},
               {"repetition", word(repetition)},
               {"read_s", word(read_s_)},
               {"scene_s", word(scene_s_)},
               {"tick_mean_us",
                word(std::accumulate(tally.tick_us.begin(), tally.tick_us.end(), 0.0) / ticks)},
               {"tick_p99_us", word(measurement::quantile(tally.tick_us, 0.99))},
               {"structures_MB", word(double(bytes) / 1048576.0)},
               {"peak_MB", word(peak_MB())}}));
    const std::string name =
        line_.label + ", " + tool + ", " + hand + ", " + std::to_string(repetition);
    touched_.outcome.cases.push_back({name + ": depth of the proxy in the solid",
                                      tally.non_finite > 0 ? NAN : tally.penetration * 1e3, 0.0,
                                      "mm"});
    if (touched_.pictures.empty() && tally.contact > 0) {
      const auto slices = slicesThrough(*volume_, isovalue, tally.hardest.translation());
      touched_.pictures.assign(slices.begin(), slices.end());
    }
  }

  void replay() {
    auto recording = app::Recording::open(line_.recording);
    if (!recording) return refuse(reasonOf(recording.error()));
    std::optional<Error> failed;
    std::shared_ptr<const Scene> last;
    const auto sceneOf = [&](std::uint32_t id) -> std::shared_ptr<const Scene> {
      const app::RecordedScene* then = recording->scene(id);
      if (then == nullptr || !app::liesLike(then->volume, *volume_)) return nullptr;
      const auto touched = app::touchedAsRecorded(volume_, *then, nullptr);
      auto made = touched ? haptics::makeScene(*touched, then->tool, then->options, last.get())
                          : tl::unexpected(touched.error());
      if (!made) {
        failed = made.error();
        return nullptr;
      }
      return last = *made;
    };
    const auto difference = app::replay(*recording, sceneOf, [this](double) { return !cancel_; });
    if (failed) return refuse(reasonOf(*failed));
    if (!difference) return refuse(reasonOf(difference.error()));
    if (difference->steps == 0) return refuse("another-volume");
    auto cells = scan_;
    cells["status"] = difference->differing == 0 ? "ok" : "differs";
    cells["recorded_by"] = recording->version();
    cells["steps"] = word(std::int64_t(difference->steps));
    cells["skipped"] = word(std::int64_t(difference->skipped));
    cells["differing"] = word(std::int64_t(difference->differing));
    cells["max_distance_mm"] = word(difference->distance * 1e3);
    cells["max_angle_rad"] = word(difference->angle);
    cells["max_force_N"] = word(difference->force);
    cells["max_torque_Nm"] = word(difference->torque);
    table(2).rows.push_back(rowOf(replayColumns(), cells));
  }

  /// The scene as ClosedLoop wants it; it is kept alive by touchAll().
  static std::shared_ptr<const Scene> shared(const Scene& scene) {
    return {std::shared_ptr<const Scene>{}, &scene};
  }

  const Line& line_;
  const std::atomic<bool>& cancel_;
  Touched touched_;
  std::shared_ptr<const Volume> volume_;
  std::map<std::string, std::string> scan_;
  double read_s_ = 0.0, scene_s_ = 0.0;
};

}  // namespace

const std::vector<Column>& touchColumns() {
  static const std::vector<Column> kColumns{
      {"label", "What the scan is called"},
      {"status", "ok; entered: the proxy was in the solid; not-finite: a number was; refused"},
      {"reason", "Why the scan or the touch was refused"},
      {"verdict", "Whether the geometry could be taken as stored: sound, corrected, part"},
      {"dims", "Voxels along the axes of the grid"},
      {"spacing_mm", "Distance of voxels along these axes", "mm"},
      {"unit", "Unit of the voxels; n/a: not stated"},
      {"orientation", "Whether the file says where left and right are"},
      {"isovalue", "Value at which the surface lies, in the unit of the voxels"},
      {"tool", "Named tool"},
      {"points", "Points of the tool"},
      {"hand", "Simulated hand"},
      {"repetition", "Number of the repetition"},
      {"seconds", "Simulated time", "s"},
      {"stiffness_N_m", "Stiffness of the virtual coupling", "N/m"},
      {"penetration_mm",
       "Depth of the deepest point of the proxy in the solid, by the evaluator, "
       "over all ticks",
       "mm"},
      {"not_finite", "Ticks with a number that is not finite; the touch ends there"},
      {"contact_share", "Share of the ticks in contact"},
      {"contacts_max", "Most contacts in a tick"},
      {"coupling_mm", "Mean distance between proxy and device in the mass metric, in contact",
       "mm"},
      {"frozen_share",
       "Share of the ticks in contact in which the proxy rests while the device "
       "moves and is apart from it"},
      {"force_mean_N", "Mean force in contact", "N"},
      {"force_p95_N", "Force that 95 % of the ticks in contact do not exceed", "N"},
      {"force_max_N", "Greatest force", "N"},
      {"torque_max_Nm", "Greatest torque", "N·m"},
      {"work_per_tick", "Counted units of work of a tick, mean"},
      {"cut_share", "Share of the ticks that the budget ended"},
      {"left_out", "Work that this scene leaves out"},
      {"angular_stiffness_Nm_rad", "Angular stiffness; 0: stiffness times the tool's inertia",
       "N·m/rad"},
      {"friction", "Coulomb's coefficient"},
      {"field", "How voxels became a field: trilinear, spline"},
      {"normals", "Normals of points near the surface: central, cell, spline"},
      {"epsilon_voxels", "Distance that counts as contact, in voxels"},
      {"sub_steps", "Most motions in a millisecond that contacts shape or stop"},
      {"rate_Hz", "Ticks in a second", "Hz"},
      {"budget_work", "Counted units of work that a tick may spend"},
      {"seed", "Seed of the hand's aim"}};
  return kColumns;
}

const std::vector<Column>& costColumns() {
  static const std::vector<Column> kColumns{
      {"label", "What the scan is called"},
      {"tool", "Named tool"},
      {"hand", "Simulated hand"},
      {"repetition", "Number of the repetition"},
      {"read_s", "Time to find and read the scan", "s"},
      {"scene_s", "Time to build the scene for the tool", "s"},
      {"tick_mean_us", "Mean CPU time of a tick", "us"},
      {"tick_p99_us", "CPU time that 99 % of the ticks do not exceed", "us"},
      {"structures_MB", "Memory of what was built for the scene", "MB"},
      {"peak_MB", "Most memory of the process since the scan was begun", "MB"}};
  return kColumns;
}

const std::vector<Column>& replayColumns() {
  static const std::vector<Column> kColumns{
      {"label", "What the scan is called"},
      {"status", "ok: to the bit; differs; refused"},
      {"reason", "Why the scan or the recording was refused"},
      {"verdict", "Whether the geometry could be taken as stored: sound, corrected, part"},
      {"recorded_by", "Version that recorded"},
      {"steps", "Steps that were replayed"},
      {"skipped", "Steps that were not, since their scene is not in this volume"},
      {"differing", "Steps whose proxy or force differs"},
      {"max_distance_mm", "Greatest distance of the proxies", "mm"},
      {"max_angle_rad", "Greatest angle between them", "rad"},
      {"max_force_N", "Greatest difference of the forces", "N"},
      {"max_torque_Nm", "Greatest difference of the torques", "N·m"}};
  return kColumns;
}

Touched touch(const Line& line, const std::atomic<bool>& cancel) {
  return ScanAtHand(line, cancel).run();
}

}  // namespace cohort
