// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "datasets/edits/edit.h"
#include "haptics/process/input_file.h"

namespace datasets {
namespace {

using nlohmann::json;

constexpr std::int64_t kMostAlong = 1 << 20;  // voxels: a product of three fits in 64 bits
constexpr double kFarthest = 1e4;             // m, or a tangent
constexpr double kSkew = 1e-6;                // of unit vectors and rotations that were rounded

json listOfNumbers(const haptics::Vec3& v) { return {v.x(), v.y(), v.z()}; }

json wordsOfEdit(const Crop& crop) {
  return {{"edit", "crop"}, {"first", crop.kept.first}, {"end", crop.kept.end}};
}
json wordsOfEdit(const PlaneCut& cut) {
  return {{"edit", "plane"},
          {"point_m", listOfNumbers(cut.point_W)},
          {"normal", listOfNumbers(cut.normal_W)},
          {"isovalue", cut.isovalue}};
}
json wordsOfEdit(const LassoCut& cut) {
  json outline = json::array();
  for (const auto& corner : cut.outline) {
    outline.push_back(corner[0]);
    outline.push_back(corner[1]);
  }
  json camera = json::array();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) camera.push_back(cut.X_WC.matrix()(r, c));
  return {{"edit", "lasso"},
          {"outline", std::move(outline)},
          {"camera", std::move(camera)},
          {"parallel", cut.parallel},
          {"from_m", cut.from},
          {"until_m", cut.until},
          {"inside", cut.inside},
          {"isovalue", cut.isovalue}};
}
json wordsOfEdit(const RemovePiece& piece) {
  return {{"edit", "remove-piece"},
          {"seed_m", listOfNumbers(piece.seed_W)},
          {"isovalue", piece.isovalue}};
}
json wordsOfEdit(const KeepPiece& piece) {
  return {{"edit", "keep-piece"},
          {"seed_m", listOfNumbers(piece.seed_W)},
          {"isovalue", piece.isovalue}};
}
json wordsOfEdit(const RemoveSmallPieces& pieces) {
  return {{"edit", "remove-small-pieces"},
          {"isovalue", pieces.isovalue},
          {"least_volume_m3", pieces.least_volume}};
}
json wordsOfEdit(const RemoveHolder& holder) {
  return {{"edit", "remove-holder"}, {"isovalue", holder.isovalue}};
}

/// Runs as the voxels between them and their own, in the order of the scan's voxels.
json wordsOfEdit(const TissueTable& table) {
  const auto& dims = table.dims();
  json parts = json::array();
  for (const TissueTable::Part& part : table.parts()) {
    json runs = json::array();
    std::int64_t end = 0;
    for (const haptics::VoxelRun& run : part.runs) {
      const std::int64_t first = (run.k * dims[1] + run.j) * dims[0] + run.i;
      runs.push_back(first - end);
      runs.push_back(run.count);
      end = first + run.count;
    }
    json words{{"structure", part.structure}, {"runs", std::move(runs)}};
    // without: it may not be cut
    if (part.energy != haptics::Tissues::kNever) words["energy_J_m3"] = part.energy;
    parts.push_back(std::move(words));
  }
  return {{"edit", "tissues"}, {"dims", dims}, {"parts", std::move(parts)}};
}

/// Cuts that go on where the one before has ended are one way, a list of places.
json wordsOfEdit(const Stroke& stroke) {
  const std::vector<haptics::BurrCut>& cuts = stroke.cuts();
  json ways = json::array();
  for (std::size_t n = 0; n < cuts.size(); ++n) {
    const haptics::BurrCut& cut = cuts[n];
    const haptics::BurrCut* before = n > 0 ? &cuts[n - 1] : nullptr;
    if (before == nullptr || before->to_W != cut.from_W || before->radius != cut.radius ||
        before->isovalue != cut.isovalue)
      ways.push_back({{"radius_m", cut.radius},
                      {"isovalue", cut.isovalue},
                      {"places_m", listOfNumbers(cut.from_W)}});
    for (const double number : {cut.to_W.x(), cut.to_W.y(), cut.to_W.z()})
      ways.back()["places_m"].push_back(number);
  }
  return {{"edit", "stroke"}, {"removed_m3", stroke.removed()}, {"ways", std::move(ways)}};
}

[[noreturn]] void refuseWord() {
  throw json::other_error::create(501, "not what an edit holds", nullptr);
}

/// The words of one edit: each is taken once, and none may be left.
class EditWords {
 public:
  explicit EditWords(const json& words) : words_{words} {
    if (!words.is_object()) refuseWord();
  }
  const json& take(const char* key) {
    ++taken_;
    return words_.at(key);
  }
  /// A finite number of at most this size.
  double number(const char* key, double most) { return numberOf(take(key), most); }
  bool truth(const char* key) { return take(key).get<bool>(); }
  haptics::Vec3 place(const char* key) {
    const json& list = take(key);
    if (!list.is_array() || list.size() != 3) refuseWord();
    return {numberOf(list[0], kFarthest), numberOf(list[1], kFarthest),
            numberOf(list[2], kFarthest)};
  }
  std::array<std::int64_t, 3> index(const char* key) {
    const json& list = take(key);
    if (!list.is_array() || list.size() != 3) refuseWord();
    std::array<std::int64_t, 3> index{};
    for (std::size_t a = 0; a < 3; ++a) index[a] = wholeOf(list[a], std::int64_t{1} << 31);
    return index;
  }
  std::int64_t whole(const char* key, std::int64_t most) { return wholeOf(take(key), most); }
  bool has(const char* key) const { return words_.contains(key); }
  void end() const {
    if (taken_ != words_.size()) refuseWord();
  }

  /// A whole number from 0 on.
  static std::int64_t wholeOf(const json& word, std::int64_t most) {
    if (!word.is_number_integer()) refuseWord();
    const auto value = word.get<std::int64_t>();
    if (value < 0 || value > most) refuseWord();
    return value;
  }
  static double numberOf(const json& word, double most) {
    if (!word.is_number()) refuseWord();
    const double value = word.get<double>();
    if (!(std::abs(value) <= most)) refuseWord();
    return value;
  }

 private:
  const json& words_;
  std::size_t taken_ = 0;
};

constexpr double kGreatestValue = 1e38;  // of a voxel

Edit lassoFrom(EditWords& words) {
  LassoCut cut;
  const json& outline = words.take("outline");
  if (!outline.is_array() || outline.size() % 2 != 0 || outline.size() < 6 ||
      outline.size() > 2 * kMostCorners)
    refuseWord();
  for (std::size_t n = 0; n < outline.size(); n += 2)
    cut.outline.push_back({EditWords::numberOf(outline[n], kFarthest),
                           EditWords::numberOf(outline[n + 1], kFarthest)});
  const json& camera = words.take("camera");
  if (!camera.is_array() || camera.size() != 12) refuseWord();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      cut.X_WC.matrix()(r, c) =
          EditWords::numberOf(camera[static_cast<std::size_t>(4 * r + c)], kFarthest);
  const haptics::Mat3 turn = cut.X_WC.linear();
  if ((turn.transpose() * turn - haptics::Mat3::Identity()).cwiseAbs().maxCoeff() > kSkew ||
      turn.determinant() < 0.0)
    refuseWord();
  cut.parallel = words.truth("parallel");
  cut.from = words.number("from_m", kFarthest);
  cut.until = words.number("until_m", kFarthest);
  if (!(cut.from < cut.until)) refuseWord();
  cut.inside = words.truth("inside");
  cut.isovalue = words.number("isovalue", kGreatestValue);
  return cut;
}

Edit strokeFrom(EditWords& all) {
  const double removed = all.number("removed_m3", kFarthest);
  const json& ways = all.take("ways");
  if (!(removed >= 0.0) || !ways.is_array() || ways.empty()) refuseWord();
  std::vector<haptics::BurrCut> cuts;
  for (const json& one : ways) {
    EditWords words{one};
    const double radius = words.number("radius_m", haptics::kLargestBurr);
    const double isovalue = words.number("isovalue", kGreatestValue);
    const json& places = words.take("places_m");
    words.end();
    if (!places.is_array() || places.size() < 6 || places.size() % 3 != 0 ||
        places.size() / 3 + cuts.size() > kMostCuts + 1)
      refuseWord();
    const auto place = [&](std::size_t n) {
      return haptics::Vec3{EditWords::numberOf(places[3 * n], kFarthest),
                           EditWords::numberOf(places[3 * n + 1], kFarthest),
                           EditWords::numberOf(places[3 * n + 2], kFarthest)};
    };
    haptics::Vec3 from = place(0);
    for (std::size_t n = 1; n < places.size() / 3; ++n) {
      const haptics::Vec3 to = place(n);
      cuts.push_back({from, to, radius, isovalue});
      if (!isPossible(cuts.back())) refuseWord();
      from = to;
    }
  }
  return Stroke{std::move(cuts), removed};
}

TissueTable::Part tissuesFrom(const json& one, const std::array<std::int64_t, 3>& dims) {
  EditWords words{one};
  TissueTable::Part part;
  part.structure = static_cast<int>(words.whole("structure", kMostParts - 1));
  if (words.has("energy_J_m3")) {
    part.energy = words.number("energy_J_m3", kGreatestValue);
    if (!(part.energy > 0.0)) refuseWord();
  }
  const json& runs = words.take("runs");
  words.end();
  if (!runs.is_array() || runs.size() % 2 != 0) refuseWord();
  const std::int64_t voxels = dims[0] * dims[1] * dims[2];
  std::int64_t at = 0;
  for (std::size_t n = 0; n < runs.size(); n += 2) {
    at += EditWords::wholeOf(runs[n], voxels);
    const std::int64_t count = EditWords::wholeOf(runs[n + 1], dims[0]), i = at % dims[0];
    if (count == 0 || i + count > dims[0] || at + count > voxels) refuseWord();
    const std::int64_t j = at / dims[0] % dims[1], k = at / (dims[0] * dims[1]);
    part.runs.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j),
                         static_cast<std::int32_t>(k), static_cast<std::int32_t>(count)});
    at += count;
  }
  return part;
}

Edit tableFrom(EditWords& words) {
  const auto dims = words.index("dims");
  if (std::ranges::any_of(dims, [](std::int64_t n) { return n < 1 || n > kMostAlong; }))
    refuseWord();
  const json& all = words.take("parts");
  if (!all.is_array() || all.size() > kMostParts) refuseWord();
  std::vector<TissueTable::Part> parts;
  for (const json& one : all) parts.push_back(tissuesFrom(one, dims));
  return TissueTable{dims, std::move(parts)};
}

Edit editOfWords(const json& all) {
  EditWords words{all};
  const std::string kind = words.take("edit").get<std::string>();
  Edit edit;
  if (kind == "crop") {
    Crop crop{{words.index("first"), words.index("end")}};
    for (std::size_t a = 0; a < 3; ++a)
      if (crop.kept.first[a] >= crop.kept.end[a]) refuseWord();
    edit = crop;
  } else if (kind == "plane") {
    PlaneCut cut{words.place("point_m"), words.place("normal"),
                 words.number("isovalue", kGreatestValue)};
    if (std::abs(cut.normal_W.norm() - 1.0) > kSkew) refuseWord();
    edit = cut;
  } else if (kind == "lasso") {
    edit = lassoFrom(words);
  } else if (kind == "remove-piece") {
    edit = RemovePiece{words.place("seed_m"), words.number("isovalue", kGreatestValue)};
  } else if (kind == "keep-piece") {
    edit = KeepPiece{words.place("seed_m"), words.number("isovalue", kGreatestValue)};
  } else if (kind == "remove-small-pieces") {
    RemoveSmallPieces pieces{words.number("isovalue", kGreatestValue),
                             words.number("least_volume_m3", kFarthest)};
    if (pieces.least_volume < 0.0) refuseWord();
    edit = pieces;
  } else if (kind == "remove-holder") {
    edit = RemoveHolder{words.number("isovalue", kGreatestValue)};
  } else if (kind == "tissues") {
    edit = tableFrom(words);
  } else if (kind == "stroke") {
    edit = strokeFrom(words);
  } else {
    refuseWord();
  }
  words.end();
  return edit;
}

}  // namespace

Stroke::Stroke(std::vector<haptics::BurrCut> cuts, double removed)
    : made_{std::make_shared<Made>(std::move(cuts), removed)} {}

const std::string& Stroke::text() const {
  std::call_once(made_->once, [this] { made_->text = wordsOfEdit(*this).dump(); });
  return made_->text;
}

std::string textOf(const Edit& edit) {
  if (const auto* stroke = std::get_if<Stroke>(&edit)) return stroke->text();
  return std::visit([](const auto& kind) { return wordsOfEdit(kind).dump(); }, edit);
}

haptics::Expected<Edit> editFrom(std::string_view text) {
  try {
    if (text.size() > kLongestText || haptics::isNestedDeeper(text, haptics::kDeepestJson))
      refuseWord();
    return editOfWords(json::parse(text));
  } catch (const json::exception&) {
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Malformed, {"edit-damaged", {}}, "damaged"});
  }
}

}  // namespace datasets
