// SPDX-License-Identifier: BSD-3-Clause
#include "app/view_file/view_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "haptics/process/input_file.h"
#include "haptics/process/output_file.h"

namespace app {
namespace {

using haptics::Error;
using haptics::Message;
using nlohmann::json;

constexpr double kMmPerMetre = 1000.0;
constexpr int kVersion = 2;
constexpr double kMostAway_m = 100.0;    // of a place of a scan
constexpr double kMostFar_m = 10'000.0;  // of an eye
constexpr double kMostIntensity = 1e38;
constexpr std::int64_t kMostVoxelsOfAxis = 1'000'000;
constexpr std::size_t kMostPathBytes = 4'000;
constexpr std::size_t kMostTextBytes = 4 * ui::kLongestMeasureText;

constexpr std::pair<ui::MeasureKind, const char*> kKinds[] = {
    {ui::MeasureKind::Distance, "distance"},
    {ui::MeasureKind::Angle, "angle"},
    {ui::MeasureKind::Point, "point"},
    {ui::MeasureKind::Note, "note"}};
constexpr haptics::ScalarType kScalarTypes[] = {
    haptics::ScalarType::UInt8,  haptics::ScalarType::Int8,   haptics::ScalarType::UInt16,
    haptics::ScalarType::Int16,  haptics::ScalarType::UInt32, haptics::ScalarType::Int32,
    haptics::ScalarType::Float32};

constexpr std::pair<ui::Arrangement, const char*> kArrangements[] = {
    {ui::Arrangement::One, "one"},
    {ui::Arrangement::FourUp, "four_up"},
    {ui::Arrangement::VolumeLarge, "volume_large"},
    {ui::Arrangement::SlicesLarge, "slices_large"}};
constexpr std::pair<ui::Interpolation, const char*> kInterpolations[] = {
    {ui::Interpolation::Linear, "linear"}, {ui::Interpolation::Nearest, "nearest"}};
constexpr std::pair<ui::SlabKind, const char*> kSlabs[] = {{ui::SlabKind::None, "none"},
                                                           {ui::SlabKind::Maximum, "maximum"},
                                                           {ui::SlabKind::Mean, "mean"},
                                                           {ui::SlabKind::Minimum, "minimum"}};
constexpr std::pair<ui::SurfaceColours, const char*> kColours[] = {
    {ui::SurfaceColours::Ivory, "ivory"},
    {ui::SurfaceColours::Tissue, "tissue"},
    {ui::SurfaceColours::Vessels, "vessels"}};

/// The word of a value in one of these tables.
template <class Value, std::size_t n>
const char* wordOf(Value value, const std::pair<Value, const char*> (&table)[n]) {
  for (const auto& [known, word] : table)
    if (known == value) return word;
  return "";
}

/// Leaves the reader with a reason.
struct Refused {
  Message message;
  const char* reason;
};

json listOfNumbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
json listOfMetres(const Eigen::Vector3d& v_mm) { return listOfNumbers(v_mm / kMmPerMetre); }

/// A value of the file, which knows where in the file it stands.
class Field {
 public:
  Field(const std::string& file, std::string name, const json& value)
      : file_(file), name_(std::move(name)), value_(value) {}

  [[noreturn]] void refuse() const {
    throw Refused{{"view-field-wrong", {file_, name_}}, "damaged"};
  }

  /// An object with all of these fields and no others but the optional ones.
  void hasOnly(std::initializer_list<const char*> needed,
               std::initializer_list<const char*> optional = {}) const {
    if (!value_.is_object()) refuse();
    for (const char* name : needed)
      if (!value_.contains(name))
        throw Refused{{"view-field-wrong", {file_, inside(name)}}, "damaged"};
    const auto isIn = [](std::initializer_list<const char*> names, const std::string& name) {
      return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
    };
    for (const auto& [name, value] : value_.items())
      if (!isIn(needed, name) && !isIn(optional, name))
        throw Refused{{"view-of-another-program", {file_}}, "damaged"};
  }
  bool has(const char* name) const { return value_.contains(name); }
  Field at(const char* name) const { return {file_, inside(name), value_.at(name)}; }

  std::vector<Field> list(std::size_t least, std::size_t most) const {
    if (!value_.is_array() || value_.size() < least || value_.size() > most) refuse();
    std::vector<Field> items;
    for (std::size_t i = 0; i < value_.size(); ++i)
      items.emplace_back(file_, name_ + "[" + std::to_string(i) + "]", value_[i]);
    return items;
  }

  double number(double least, double most) const {
    if (!value_.is_number()) refuse();
    const double number = value_.get<double>();
    if (!(number >= least && number <= most)) refuse();
    return number;
  }
  std::int64_t whole(std::int64_t least, std::int64_t most) const {
    if (!value_.is_number_integer() ||
        (value_.is_number_unsigned() && !std::in_range<std::int64_t>(value_.get<std::uint64_t>())))
      refuse();
    const auto number = value_.get<std::int64_t>();
    if (number < least || number > most) refuse();
    return number;
  }
  bool flag() const {
    if (!value_.is_boolean()) refuse();
    return value_.get<bool>();
  }
  /// One line without control characters, not empty.
  std::string text(std::size_t most_bytes) const {
    if (!value_.is_string()) refuse();
    std::string text = value_.get<std::string>();
    if (text.empty() || text.size() > most_bytes || hasControls(text)) refuse();
    return text;
  }
  /// The value of a word in one of the tables.
  template <class Value, std::size_t n>
  Value oneOf(const std::pair<Value, const char*> (&table)[n]) const {
    const std::string word = text(20);
    for (const auto& [value, known] : table)
      if (word == known) return value;
    refuse();
  }
  bool isNull() const { return value_.is_null(); }
  Eigen::Vector3d vector(double most) const {
    Eigen::Vector3d v;
    const std::vector<Field> numbers = list(3, 3);
    for (int a = 0; a < 3; ++a) v[a] = numbers[std::size_t(a)].number(-most, most);
    return v;
  }
  Eigen::Vector3d place_mm(double most_m) const { return vector(most_m) * kMmPerMetre; }

 private:
  std::string inside(const std::string& name) const {
    return name_.empty() ? name : name_ + "." + name;
  }
  /// Control characters and the separators of lines and paragraphs, in valid UTF-8.
  static bool hasControls(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto byte = [&](std::size_t at) {
        return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
      };
      if (byte(i) < 0x20 || byte(i) == 0x7f) return true;
      if (byte(i) == 0xc2 && byte(i + 1) < 0xa0) return true;
      if (byte(i) == 0xe2 && byte(i + 1) == 0x80 && (byte(i + 2) == 0xa8 || byte(i + 2) == 0xa9))
        return true;
    }
    return false;
  }

  const std::string& file_;
  std::string name_;
  const json& value_;
};

void takeScan(const Field& scan, ViewFile& view) {
  scan.hasOnly({"dims", "spacing_m", "origin_m", "direction", "scalar", "hash"}, {"place"});
  const std::vector<Field> dims = scan.at("dims").list(3, 3);
  for (std::size_t a = 0; a < 3; ++a) view.grid.dims[a] = dims[a].whole(1, kMostVoxelsOfAxis);
  view.grid.spacing = scan.at("spacing_m").vector(1.0);
  if (!(view.grid.spacing.minCoeff() > 0.0)) scan.at("spacing_m").refuse();
  view.grid.origin = scan.at("origin_m").vector(kMostAway_m);
  const std::vector<Field> direction = scan.at("direction").list(9, 9);
  for (std::size_t n = 0; n < 9; ++n)
    view.grid.direction(int(n / 3), int(n % 3)) = direction[n].number(-1.001, 1.001);
  const haptics::Mat3 square = view.grid.direction.transpose() * view.grid.direction;
  if (!square.isIdentity(1e-3)) scan.at("direction").refuse();
  const std::string scalar = scan.at("scalar").text(20);
  const auto* type = std::find_if(std::begin(kScalarTypes), std::end(kScalarTypes),
                                  [&](haptics::ScalarType t) { return scalar == nameOf(t); });
  if (type == std::end(kScalarTypes)) scan.at("scalar").refuse();
  view.type = *type;
  if (scan.has("place")) {
    view.place = scan.at("place").text(kMostPathBytes);
    if (std::filesystem::path(view.place).is_absolute()) scan.at("place").refuse();
  }
}

std::optional<VolumeHash> hashFrom(const Field& field) {
  if (field.isNull()) return {};
  const auto hash = hashFromHex(field.text(2 * std::tuple_size_v<VolumeHash>));
  if (!hash) field.refuse();
  return hash;
}

haptics::Pose poseFrom(const Field& field) {
  field.hasOnly({"at_m", "axes"});
  haptics::Pose X_WP = haptics::Pose::Identity();
  X_WP.translation() = field.at("at_m").vector(kMostAway_m);
  const std::vector<Field> axes = field.at("axes").list(9, 9);
  haptics::Mat3 turn;
  for (std::size_t n = 0; n < 9; ++n) turn(int(n / 3), int(n % 3)) = axes[n].number(-1.001, 1.001);
  const haptics::Mat3 square = turn.transpose() * turn;
  if (!square.isIdentity(1e-3) || turn.determinant() < 0.0) field.at("axes").refuse();
  X_WP.linear() = turn;
  return X_WP;
}

ui::Measure markFrom(const Field& field) {
  field.hasOnly({"kind", "text", "places_m"});
  ui::Measure mark;
  mark.kind = field.at("kind").oneOf(kKinds);
  mark.text = field.at("text").text(kMostTextBytes);
  const std::size_t places = ui::placesOf(mark.kind);
  for (const Field& place : field.at("places_m").list(places, places))
    mark.places_mm.push_back(place.place_mm(kMostAway_m));
  return mark;
}

ui::LayoutLook layoutFrom(const Field& field) {
  using ui::LayoutLook;
  field.hasOnly({"arrangement", "tool_view", "active", "alone", "shares"});
  LayoutLook layout;
  layout.arrangement = field.at("arrangement").oneOf(kArrangements);
  layout.tool_view = field.at("tool_view").flag();
  layout.active = static_cast<std::size_t>(field.at("active").whole(0, LayoutLook::kViews - 1));
  layout.alone = field.at("alone").flag();
  for (const Field& column : field.at("shares").list(0, LayoutLook::kViews)) {
    std::vector<double>& shares = layout.shares.emplace_back();
    for (const Field& share : column.list(2, LayoutLook::kViews + 1))
      shares.push_back(share.number(LayoutLook::kLeastShare, LayoutLook::kMostShare));
  }
  return layout;
}

ui::SliceLook voxelsFrom(const Field& field) {
  using ui::SliceLook;
  field.hasOnly({"interpolation", "slab", "thickness_m"});
  SliceLook look;
  look.interpolation = field.at("interpolation").oneOf(kInterpolations);
  look.slab = field.at("slab").oneOf(kSlabs);
  look.thickness_mm = kMmPerMetre * field.at("thickness_m")
                                        .number(SliceLook::kThinnest_mm / kMmPerMetre,
                                                SliceLook::kThickest_mm / kMmPerMetre);
  return look;
}

ui::ViewLook lookFrom(const Field& field) {
  field.hasOnly(
      {"camera", "surface", "cross_m", "grey", "slices", "voxels", "tool_plane", "layout"});
  ui::ViewLook look;
  const Field camera = field.at("camera"), grey = field.at("grey");
  camera.hasOnly({"eye_m", "focus_m", "up", "parallel", "half_height_m"});
  look.eye_mm = camera.at("eye_m").place_mm(kMostFar_m);
  look.focus_mm = camera.at("focus_m").place_mm(kMostFar_m);
  look.up = camera.at("up").vector(1.001);
  look.parallel = camera.at("parallel").flag();
  look.half_height_mm = camera.at("half_height_m").number(0.0, kMostFar_m) * kMmPerMetre;
  if (!(look.half_height_mm > 0.0)) camera.at("half_height_m").refuse();
  // it looks somewhere, and has an up
  const Eigen::Vector3d along = look.focus_mm - look.eye_mm;
  if (!(along.norm() > 1e-6)) camera.at("focus_m").refuse();
  if (!(look.up.cross(along.normalized()).norm() > 1e-6)) camera.at("up").refuse();
  look.cross_mm = field.at("cross_m").place_mm(kMostAway_m);
  const std::vector<Field> slices = field.at("slices").list(look.slices.size(), look.slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i) {
    slices[i].hasOnly({"zoom", "shift_m"});
    look.slices[i].zoom = slices[i].at("zoom").number(1e-3, 1e6);
    const std::vector<Field> shift = slices[i].at("shift_m").list(2, 2);
    for (int a = 0; a < 2; ++a)
      look.slices[i].shift_mm[a] =
          shift[std::size_t(a)].number(-kMostAway_m, kMostAway_m) * kMmPerMetre;
  }
  look.voxels = voxelsFrom(field.at("voxels"));
  const Field plane = field.at("tool_plane");
  plane.hasOnly({"along", "depth_m"});
  look.tool_plane = {
      .along = plane.at("along").flag(),
      .depth_mm = plane.at("depth_m").number(-kMostAway_m, kMostAway_m) * kMmPerMetre};
  const Field surface = field.at("surface");
  surface.hasOnly({"colours", "second"}, {"second_opacity"});
  look.colours = surface.at("colours").oneOf(kColours);
  const Field second = surface.at("second");
  if (!second.isNull()) look.second = second.number(-kMostIntensity, kMostIntensity);
  if (surface.has("second_opacity"))
    look.second_opacity = surface.at("second_opacity").number(ui::kLeastOpacity, 1.0);
  look.layout = layoutFrom(field.at("layout"));
  grey.hasOnly({"level", "width"});
  look.grey_level = grey.at("level").number(-kMostIntensity, kMostIntensity);
  look.grey_width = grey.at("width").number(1e-38, kMostIntensity);
  return look;
}

ViewFile viewFrom(const json& words, const std::string& file) {
  const Field all(file, {}, words);
  // the version first: what a later Palpate writes may be anything else
  if (!words.is_object() || !words.contains("palpate_view"))
    throw Refused{{"view-of-another-program", {file}}, "damaged"};
  const std::int64_t version =
      all.at("palpate_view").whole(1, std::numeric_limits<std::int64_t>::max());
  if (version > kVersion) throw Refused{{"file-of-later-palpate", {file}}, "later"};
  if (version < kVersion) throw Refused{{"view-of-earlier-palpate", {file}}, "earlier"};
  all.hasOnly({"palpate_view", "scan", "edits", "isovalue", "marks", "view"},
              {"tool", "tool_file", "tool_place"});
  ViewFile view;
  takeScan(all.at("scan"), view);
  view.hash = hashFrom(all.at("scan").at("hash"));
  for (const Field& field : all.at("edits").list(0, kMostEdits)) {
    auto edit = datasets::editFrom(field.text(kMostViewBytes));
    if (!edit) field.refuse();
    view.edits.push_back(std::move(*edit));
  }
  view.isovalue = all.at("isovalue").number(-kMostIntensity, kMostIntensity);
  if (all.has("tool")) view.tool = all.at("tool").text(20);
  if (all.has("tool_file")) {
    const Field file_of_tool = all.at("tool_file");
    file_of_tool.hasOnly({"hash", "unit"});
    view.tool_file = hashFrom(file_of_tool.at("hash"));
    view.tool_unit = file_of_tool.at("unit").text(2);
  }
  if (all.has("tool_place")) view.X_WP = poseFrom(all.at("tool_place"));
  for (const Field& mark : all.at("marks").list(0, kMostMarks))
    view.marks.push_back(markFrom(mark));
  view.look = lookFrom(all.at("view"));
  return view;
}

tl::unexpected<Error> refusedView(Message message, const char* reason) {
  const std::string_view why = reason;
  const Error::Kind kind =
      why == "later" || why == "earlier" ? Error::Kind::Unsupported : Error::Kind::Malformed;
  return tl::unexpected(Error{kind, std::move(message), reason});
}

json listOfRows(const haptics::Mat3& matrix) {
  json rows = json::array();
  for (int n = 0; n < 9; ++n) rows.push_back(matrix(n / 3, n % 3));
  return rows;
}

}  // namespace

std::string hexOf(const VolumeHash& hash) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string hex;
  for (const std::uint8_t byte : hash) {
    hex += kDigits[byte >> 4];
    hex += kDigits[byte & 15];
  }
  return hex;
}

std::optional<VolumeHash> hashFromHex(std::string_view hex) {
  VolumeHash hash{};
  if (hex.size() != 2 * hash.size()) return {};
  for (std::size_t i = 0; i < hex.size(); ++i) {
    const char c = hex[i];
    const bool letter = c >= 'a' && c <= 'f';
    if (!letter && !(c >= '0' && c <= '9')) return {};
    hash[i / 2] = static_cast<std::uint8_t>(16 * hash[i / 2] + (letter ? c - 'a' + 10 : c - '0'));
  }
  return hash;
}

std::string textOf(const ViewFile& view) {
  json marks = json::array();
  for (const ui::Measure& mark : view.marks) {
    json places = json::array();
    for (const Eigen::Vector3d& p_mm : mark.places_mm) places.push_back(listOfMetres(p_mm));
    marks.push_back(
        {{"kind", wordOf(mark.kind, kKinds)}, {"text", mark.text}, {"places_m", places}});
  }
  json slices = json::array();
  for (const ui::SliceFrame& slice : view.look.slices)
    slices.push_back({{"zoom", slice.zoom},
                      {"shift_m", json::array({slice.shift_mm.x() / kMmPerMetre,
                                               slice.shift_mm.y() / kMmPerMetre})}});
  json edits = json::array();
  for (const datasets::Edit& edit : view.edits) edits.push_back(textOf(edit));
  const ui::ViewLook& look = view.look;
  json words = {
      {"palpate_view", kVersion},
      {"scan",
       {{"dims", view.grid.dims},
        {"spacing_m", listOfNumbers(view.grid.spacing)},
        {"origin_m", listOfNumbers(view.grid.origin)},
        {"direction", listOfRows(view.grid.direction)},
        {"scalar", nameOf(view.type)},
        {"hash", view.hash ? json(hexOf(*view.hash)) : json()}}},
      {"edits", edits},
      {"isovalue", view.isovalue},
      {"marks", marks},
      {"view",
       {{"camera",
         {{"eye_m", listOfMetres(look.eye_mm)},
          {"focus_m", listOfMetres(look.focus_mm)},
          {"up", listOfNumbers(look.up)},
          {"parallel", look.parallel},
          {"half_height_m", look.half_height_mm / kMmPerMetre}}},
        {"cross_m", listOfMetres(look.cross_mm)},
        {"slices", slices},
        {"voxels",
         {{"interpolation", wordOf(look.voxels.interpolation, kInterpolations)},
          {"slab", wordOf(look.voxels.slab, kSlabs)},
          {"thickness_m", look.voxels.thickness_mm / kMmPerMetre}}},
        {"tool_plane",
         {{"along", look.tool_plane.along}, {"depth_m", look.tool_plane.depth_mm / kMmPerMetre}}},
        {"surface",
         {{"colours", wordOf(look.colours, kColours)},
          {"second", look.second ? json(*look.second) : json()},
          {"second_opacity", look.second_opacity}}},
        {"layout",
         {{"arrangement", wordOf(look.layout.arrangement, kArrangements)},
          {"tool_view", look.layout.tool_view},
          {"active", look.layout.active},
          {"alone", look.layout.alone},
          {"shares", look.layout.shares}}},
        {"grey", {{"level", look.grey_level}, {"width", look.grey_width}}}}}};
  if (!view.place.empty()) words["scan"]["place"] = view.place;
  if (!view.tool.empty()) words["tool"] = view.tool;
  if (view.tool_file)
    words["tool_file"] = {{"hash", hexOf(*view.tool_file)}, {"unit", view.tool_unit}};
  if (view.X_WP)
    words["tool_place"] = {{"at_m", listOfNumbers(view.X_WP->translation())},
                           {"axes", listOfRows(view.X_WP->linear())}};
  // the name of a folder may be no text
  return words.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

haptics::Expected<ViewFile> viewFileFrom(std::string_view text, const std::string& name) {
  if (text.size() > kMostViewBytes)
    return refusedView({"input-too-large", {name, "64 MB"}}, "too-large");
  if (haptics::isNestedDeeper(text, haptics::kDeepestJson))
    return refusedView({"view-of-another-program", {name}}, "damaged");
  try {
    return viewFrom(json::parse(text), name);
  } catch (const Refused& refused) {
    return refusedView(refused.message, refused.reason);
  } catch (const json::exception&) {
    return refusedView({"view-of-another-program", {name}}, "damaged");
  }
}

haptics::Expected<ViewFile> readViewFile(const std::filesystem::path& path) {
  auto text = haptics::readInput(path, kMostViewBytes);
  if (!text) return tl::unexpected(std::move(text.error()));
  return viewFileFrom(*text, path.string());
}

haptics::Expected<void> writeViewFile(const std::filesystem::path& path, const ViewFile& view) {
  const std::string text = textOf(view);
  if (text.size() > kMostViewBytes)
    return refusedView({"view-not-saved-too-large", {path.string()}}, "too-large");
  return haptics::writeFile(path, text);
}

}  // namespace app
