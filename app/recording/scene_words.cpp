// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/scene_words.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "datasets/edits/edit_history.h"
#include "datasets/edits/edited.h"
#include "datasets/edits/walls.h"
#include "haptics/process/input_file.h"
#include "haptics/structures/nearness.h"

namespace app {
namespace {

using nlohmann::json;

constexpr std::size_t kMostPoints = 10'000'000;

constexpr std::pair<haptics::FieldKind, const char*> kFields[] = {
    {haptics::FieldKind::Trilinear, "trilinear"}, {haptics::FieldKind::CubicSpline, "spline"}};
constexpr std::pair<haptics::NormalKind, const char*> kNormals[] = {
    {haptics::NormalKind::Central, "central"},
    {haptics::NormalKind::Cell, "cell"},
    {haptics::NormalKind::Spline, "spline"}};
constexpr std::pair<bool haptics::Plan::*, const char*> kPlan[] = {
    {&haptics::Plan::free_space, "free_space"},
    {&haptics::Plan::empty_space, "empty_space"},
    {&haptics::Plan::unspent_room, "unspent_room"},
    {&haptics::Plan::far_gradients, "far_gradients"},
    {&haptics::Plan::central_differences, "central_differences"},
    {&haptics::Plan::still_rows, "still_rows"}};
constexpr haptics::ScalarType kScalars[] = {haptics::ScalarType::UInt8,  haptics::ScalarType::Int8,
                                            haptics::ScalarType::UInt16, haptics::ScalarType::Int16,
                                            haptics::ScalarType::UInt32, haptics::ScalarType::Int32,
                                            haptics::ScalarType::Float32};

template <class T, std::size_t N>
const char* nameIn(const std::pair<T, const char*> (&names)[N], T value) {
  for (const auto& [known, name] : names)
    if (known == value) return name;
  return "";
}
template <class T, std::size_t N>
T valueIn(const std::pair<T, const char*> (&names)[N], const std::string& name) {
  for (const auto& [value, known] : names)
    if (name == known) return value;
  throw json::other_error::create(501, "no such name", nullptr);
}

/// What is no whole number, or too large a one, is not taken for another.
template <class T>
T whole(const json& word) {
  const bool fits = word.is_number_unsigned()  ? std::in_range<T>(word.get<std::uint64_t>())
                    : word.is_number_integer() ? std::in_range<T>(word.get<std::int64_t>())
                                               : false;
  if (!fits) throw json::other_error::create(501, "no such number", nullptr);
  return word.get<T>();
}

json parsed(const std::string& text) {
  if (haptics::isNestedDeeper(text, haptics::kDeepestJson))
    throw json::other_error::create(501, "too deep", nullptr);
  return json::parse(text);
}

/// Row by row.
template <class M>
json listOf(const M& matrix) {
  json list = json::array();
  for (int r = 0; r < matrix.rows(); ++r)
    for (int c = 0; c < matrix.cols(); ++c) list.push_back(matrix(r, c));
  return list;
}
template <class M>
void take(const json& list, M& matrix) {
  if (list.size() != static_cast<std::size_t>(matrix.size()))
    throw json::other_error::create(501, "not so many numbers", nullptr);
  std::size_t i = 0;
  for (int r = 0; r < matrix.rows(); ++r)
    for (int c = 0; c < matrix.cols(); ++c) matrix(r, c) = list[i++].get<double>();
}

// JSON has no infinity: null stands for it
json limitWord(double limit) { return std::isfinite(limit) ? json(limit) : json(); }
double limitFrom(const json& word) {
  return word.is_null() ? std::numeric_limits<double>::infinity() : word.get<double>();
}

template <class T>
std::vector<std::uint8_t> packed(const std::vector<T>& items) {
  const std::size_t bytes = items.size() * sizeof(T);
  uLongf size = compressBound(bytes);
  std::vector<std::uint8_t> out(size);
  compress2(out.data(), &size, reinterpret_cast<const Bytef*>(items.data()), bytes, 1);
  out.resize(size);
  return out;
}
template <class T>
std::vector<T> unpacked(const std::vector<std::uint8_t>& bytes, std::size_t count) {
  // zlib makes at most 1,032 bytes of one: what asks for more is not allocated
  if (count > kMostPoints || count * sizeof(T) > 1100 * bytes.size() + 1)
    throw json::other_error::create(501, "too many", nullptr);
  std::vector<T> items(count);
  uLongf size = count * sizeof(T);
  std::uint8_t nothing = 0;
  Bytef* out = count == 0 ? &nothing : reinterpret_cast<Bytef*>(items.data());
  if (uncompress(out, &size, bytes.data(), bytes.size()) != Z_OK || size != count * sizeof(T))
    throw json::other_error::create(501, "cannot be unpacked", nullptr);
  return items;
}
static_assert(sizeof(haptics::Vec3) == 3 * sizeof(double));

tl::unexpected<haptics::Error> damagedWords(haptics::Message message) {
  return tl::unexpected(
      haptics::Error{haptics::Error::Kind::Malformed, std::move(message), "damaged"});
}

json settingsOf(const haptics::Scene& scene) {
  json plan = json::object();
  for (const auto& [omission, name] : kPlan) plan[name] = scene.plan.*omission;
  const haptics::PointShell& shell = scene.tool.shell;
  return {{"field", nameIn(kFields, scene.field.kind())},
          {"normal", nameIn(kNormals, scene.normal)},
          {"plan", plan},
          {"epsilon", scene.fineness.epsilon},
          {"sub_steps", scene.fineness.sub_steps},
          {"points", shell.points.size()},
          {"vertices", scene.tool.mesh.vertices.size()},
          {"triangles", scene.tool.mesh.triangles.size()},
          {"shell_radius_m", shell.radius},
          {"shell_inertia_m2", listOf(shell.inertia)},
          {"shell_spacing_m", shell.spacing},
          {"shell_origin_m", listOf(shell.origin)}};
}

json volumeWords(const haptics::Volume& volume) {
  return {{"dims", volume.grid.dims},
          {"spacing_m", listOf(volume.grid.spacing)},
          {"origin_m", listOf(volume.grid.origin)},
          {"direction", listOf(volume.grid.direction)},
          {"scalar", nameOf(volume.type)},
          {"least", volume.least},
          {"greatest", volume.greatest},
          {"unit", volume.unit},
          {"modality", volume.modality},
          {"orientation_known", volume.orientation_known},
          {"resampled", volume.resampled},
          {"slices_left_out", volume.slices_left_out}};
}

// JSON's numbers are doubles to many who read it
std::string digestWord(std::uint64_t digest) {
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), digest, 16).ptr;
  return {digits.data(), end};
}

std::uint64_t digestFrom(const json& word) {
  const std::string text = word.get<std::string>();
  std::uint64_t digest = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digest, 16);
  if (error != std::errc{} || end != text.data() + text.size())
    throw json::other_error::create(501, "no digest", nullptr);
  return digest;
}

/// The geometry, what was taken away from the scan, and which structures the touch had otherwise.
json describedVolume(const haptics::Volume& volume) {
  json words = volumeWords(volume);
  if (const datasets::Walled* walled = datasets::walledOf(volume)) {
    json structures = json::array();
    for (const datasets::Walled::Wall& wall : walled->walls)
      structures.push_back(
          {{"number", wall.structure + 1}, {"feel", wall.solid ? "solid" : "not-there"}});
    words["walls"] = {{"structures", std::move(structures)},
                      {"isovalue", walled->isovalue},
                      {"digest", digestWord(walled->digest_of_walls)}};
  }
  const datasets::Edited* edited = datasets::editedOf(volume);
  if (edited == nullptr || edited->edits.empty()) return words;
  json edits = json::array();
  for (const datasets::Edit& edit : edited->edits)
    edits.push_back(json::parse(datasets::textOf(edit)));
  words["edits"] = std::move(edits);
  words["edits_digest"] = digestWord(edited->digest);
  return words;
}

void takeEdits(const json& words, RecordedScene& scene) {
  if (!words.contains("edits")) return;
  const json& edits = words.at("edits");
  if (!edits.is_array() || edits.empty() || edits.size() > datasets::EditHistory::kMostSteps)
    throw json::other_error::create(501, "no edits", nullptr);
  for (const json& words_of_one : edits) {
    auto edit = datasets::editFrom(words_of_one.dump());
    if (!edit) throw json::other_error::create(501, "no edit", nullptr);
    scene.edits.push_back(std::move(*edit));
  }
  scene.edits_digest = digestFrom(words.at("edits_digest"));
}

void takeWalls(const json& words, RecordedScene& scene) {
  if (!words.contains("walls")) return;
  const json& walls = words.at("walls");
  const json& structures = walls.at("structures");
  if (!structures.is_array() || structures.empty() || structures.size() > haptics::kMostWatched)
    throw json::other_error::create(501, "no walls", nullptr);
  for (const json& one : structures) {
    const int number = whole<int>(one.at("number"));
    const std::string feel = one.at("feel").get<std::string>();
    if (number < 1 || number > 255 || (feel != "solid" && feel != "not-there"))
      throw json::other_error::create(501, "no wall", nullptr);
    scene.walls.push_back({static_cast<std::uint8_t>(number - 1), feel == "solid"});
  }
  scene.walls_isovalue = walls.at("isovalue").get<double>();
  if (!std::isfinite(scene.walls_isovalue))
    throw json::other_error::create(501, "not finite", nullptr);
  scene.walls_digest = digestFrom(walls.at("digest"));
}

void takeSettings(const json& words, const SceneWords& stored, RecordedScene& scene) {
  scene.options.field = valueIn(kFields, words.at("field").get<std::string>());
  scene.options.normal = valueIn(kNormals, words.at("normal").get<std::string>());
  for (const auto& [omission, name] : kPlan)
    scene.options.plan.*omission = words.at("plan").at(name).get<bool>();
  scene.options.fineness.epsilon = words.at("epsilon").get<double>();
  scene.options.fineness.sub_steps = whole<int>(words.at("sub_steps"));
  if (!(scene.options.fineness.epsilon > 0.0 && scene.options.fineness.epsilon < 1.0) ||
      scene.options.fineness.sub_steps < 1 || scene.options.fineness.sub_steps > 1000)
    throw json::other_error::create(501, "out of range", nullptr);
  haptics::PointShell& shell = scene.tool.shell;
  shell.points = unpacked<haptics::Vec3>(stored.points, whole<std::size_t>(words.at("points")));
  shell.radius = words.at("shell_radius_m").get<double>();
  take(words.at("shell_inertia_m2"), shell.inertia);
  shell.spacing = words.at("shell_spacing_m").get<double>();
  // recordings of earlier versions do not say it
  if (words.contains("shell_origin_m")) take(words.at("shell_origin_m"), shell.origin);
  haptics::TriangleMesh& mesh = scene.tool.mesh;
  mesh.vertices =
      unpacked<haptics::Vec3>(stored.vertices, whole<std::size_t>(words.at("vertices")));
  mesh.triangles = unpacked<std::array<std::uint32_t, 3>>(
      stored.triangles, whole<std::size_t>(words.at("triangles")));
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.vertices.size())
        throw json::other_error::create(501, "no such corner", nullptr);
  for (const haptics::Vec3& point : shell.points)
    if (!point.allFinite()) throw json::other_error::create(501, "not finite", nullptr);
  if (shell.points.empty() || !shell.inertia.allFinite() || !shell.origin.allFinite() ||
      !std::isfinite(shell.radius))
    throw json::other_error::create(501, "no shell", nullptr);
  shell.tip = haptics::tipOf(shell.points);
}

void takeVolume(const json& words, haptics::Volume& volume) {
  for (std::size_t a = 0; a < 3; ++a)
    volume.grid.dims[a] = whole<std::int64_t>(words.at("dims").at(a));
  take(words.at("spacing_m"), volume.grid.spacing);
  take(words.at("origin_m"), volume.grid.origin);
  take(words.at("direction"), volume.grid.direction);
  const std::string scalar = words.at("scalar").get<std::string>();
  for (const haptics::ScalarType type : kScalars)
    if (scalar == nameOf(type)) volume.type = type;
  volume.least = words.at("least").get<double>();
  volume.greatest = words.at("greatest").get<double>();
  volume.unit = words.at("unit").get<std::string>();
  volume.modality = words.at("modality").get<std::string>();
  volume.orientation_known = words.at("orientation_known").get<bool>();
  volume.resampled = words.at("resampled").get<bool>();
  volume.slices_left_out = whole<std::int64_t>(words.at("slices_left_out"));
}

}  // namespace

const char* nameOf(haptics::FieldKind kind) { return nameIn(kFields, kind); }
const char* nameOf(haptics::NormalKind kind) { return nameIn(kNormals, kind); }
haptics::FieldKind fieldNamed(const std::string& name) { return valueIn(kFields, name); }
haptics::NormalKind normalNamed(const std::string& name) { return valueIn(kNormals, name); }

SameVolume compared(const std::optional<VolumeHash>& one, const std::optional<VolumeHash>& other) {
  constexpr int kKeyBytes = 8;
  if (!one || !other || !std::equal(one->begin(), one->begin() + kKeyBytes, other->begin()))
    return SameVolume::Unknown;
  return *one == *other ? SameVolume::Same : SameVolume::Another;
}

SceneWords wordsOf(const haptics::Scene& scene) {
  // a word of a scan's own that is no text must not end the recording
  const auto text = [](const json& words) {
    return words.dump(-1, ' ', false, json::error_handler_t::replace);
  };
  return {text(settingsOf(scene)), text(describedVolume(*scene.volume)),
          packed(scene.tool.shell.points), packed(scene.tool.mesh.vertices),
          packed(scene.tool.mesh.triangles)};
}

haptics::Expected<RecordedScene> sceneFrom(const SceneWords& words) {
  RecordedScene scene;
  try {
    takeSettings(parsed(words.settings), words, scene);
    const json volume = parsed(words.volume);
    takeVolume(volume, scene.volume);
    takeEdits(volume, scene);
    takeWalls(volume, scene);
  } catch (const json::exception&) {
    return damagedWords({"recording-damaged", {}});
  }
  return scene;
}

std::string wordsOf(const haptics::ProxyStart& start) {
  const haptics::ForceLimits& limits = start.limits;
  const haptics::Safety::Memory& safety = start.safety;
  const haptics::PassivityGuard::Memory& guard = safety.passivity;
  return json{{"scene", start.scene},
              {"proxy", listOf(start.X_WP.matrix().topRows<3>().eval())},
              {"turn", listOf(start.turn)},
              {"rate", start.rate.hz},
              {"limits",
               {{"force", limitWord(limits.force)},
                {"torque", limitWord(limits.torque)},
                {"ramp_time", limits.ramp_time},
                {"slew_time", limits.slew_time},
                {"rise_time", limits.rise_time},
                {"continuous_force", limitWord(limits.continuous_force)},
                {"guard_passivity", limits.guard_passivity}}},
              {"force_state", static_cast<int>(safety.state)},
              {"reason", static_cast<int>(safety.reason)},
              {"withheld", static_cast<int>(safety.withheld)},
              {"let_go", safety.let_go},
              {"gain", safety.gain},
              {"slewing", safety.slewing},
              {"slew_left", safety.slew_left},
              {"heat", safety.heat},
              {"sent_force", listOf(safety.sent.force)},
              {"sent_torque", listOf(safety.sent.torque)},
              {"passivity",
               {{"device", listOf(guard.X_WD.matrix().topRows<3>().eval())},
                {"begun", guard.begun},
                {"waited", guard.waited},
                {"slow_linear", listOf(guard.slow_motion.linear)},
                {"slow_angular", listOf(guard.slow_motion.angular)},
                {"slow_force", listOf(guard.slow_wrench.force)},
                {"slow_torque", listOf(guard.slow_wrench.torque)},
                {"made", guard.made},
                {"turns", guard.turns},
                {"power", guard.power},
                {"power_before", guard.power_before},
                {"direction", guard.direction},
                {"since", guard.since},
                {"share", guard.share}}}}
      .dump();
}

haptics::Expected<haptics::ProxyStart> startFrom(const std::string& text) {
  haptics::ProxyStart start;
  haptics::ForceLimits& limits = start.limits;
  haptics::Safety::Memory& safety = start.safety;
  haptics::PassivityGuard::Memory& guard = safety.passivity;
  try {
    const json words = parsed(text);
    start.scene = whole<std::uint32_t>(words.at("scene"));
    Eigen::Matrix<double, 3, 4> pose;
    take(words.at("proxy"), pose);
    start.X_WP.matrix().topRows<3>() = pose;
    take(words.at("turn"), start.turn);
    // of the first recordings, which were all at 1 kHz, none has it
    if (words.contains("rate")) start.rate.hz = whole<int>(words.at("rate"));
    if (!haptics::isServoRate(start.rate.hz)) return damagedWords({"recording-damaged", {}});
    const json& limit = words.at("limits");
    limits = {limitFrom(limit.at("force")),           limitFrom(limit.at("torque")),
              limit.at("ramp_time").get<double>(),    limit.at("slew_time").get<double>(),
              limit.at("rise_time").get<double>(),    limitFrom(limit.at("continuous_force")),
              limit.at("guard_passivity").get<bool>()};
    const int state = whole<int>(words.at("force_state"));
    const int reason = whole<int>(words.at("reason")), withheld = whole<int>(words.at("withheld"));
    constexpr int kReasons = static_cast<int>(haptics::ForceReason::Stalled);
    if (state < 0 || state > static_cast<int>(haptics::ForceState::Fault) || reason < 0 ||
        reason > kReasons || withheld < 0 || withheld > kReasons)
      return damagedWords({"recording-damaged", {}});
    safety.state = static_cast<haptics::ForceState>(state);
    safety.reason = static_cast<haptics::ForceReason>(reason);
    safety.withheld = static_cast<haptics::ForceReason>(withheld);
    safety.let_go = words.at("let_go").get<bool>();
    safety.gain = words.at("gain").get<double>();
    safety.slewing = words.at("slewing").get<bool>();
    safety.slew_left = words.at("slew_left").get<double>();
    safety.heat = words.at("heat").get<double>();
    take(words.at("sent_force"), safety.sent.force);
    take(words.at("sent_torque"), safety.sent.torque);
    const json& passivity = words.at("passivity");
    take(passivity.at("device"), pose);
    guard.X_WD.matrix().topRows<3>() = pose;
    guard.begun = passivity.at("begun").get<bool>();
    guard.waited = passivity.at("waited").get<double>();
    take(passivity.at("slow_linear"), guard.slow_motion.linear);
    take(passivity.at("slow_angular"), guard.slow_motion.angular);
    take(passivity.at("slow_force"), guard.slow_wrench.force);
    take(passivity.at("slow_torque"), guard.slow_wrench.torque);
    guard.made = passivity.at("made").get<double>();
    guard.turns = passivity.at("turns").get<double>();
    guard.power = passivity.at("power").get<double>();
    guard.power_before = passivity.at("power_before").get<double>();
    guard.direction = passivity.at("direction").get<double>();
    guard.since = passivity.at("since").get<double>();
    guard.share = passivity.at("share").get<double>();
  } catch (const json::exception&) {
    return damagedWords({"recording-damaged", {}});
  }
  return start;
}

}  // namespace app
