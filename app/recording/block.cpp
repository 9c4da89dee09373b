// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/block.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/recording/number_columns.h"

namespace app {
namespace {

constexpr int kLevel = 6;

struct ContactColumn {
  const char* name;
  const char* unit;
  double per_unit;  ///< as StepColumn::per_unit
};
// a tenth of a micrometre, a twentieth of a milliradian, a tenth of a millinewton
constexpr double kPerArm = 1e7, kPerNormal = 1e4, kPerPush = 1e4;
constexpr ContactColumn kContactColumns[] = {
    {"arm_x", "m", kPerArm},       {"arm_y", "m", kPerArm},       {"arm_z", "m", kPerArm},
    {"normal_x", "1", kPerNormal}, {"normal_y", "1", kPerNormal}, {"normal_z", "1", kPerNormal},
    {"push", "N", kPerPush},
};
/// Of a number of a contact, as it is stored.
std::size_t contactBytes(Layout layout) {
  return layout == Layout::Exact ? sizeof(float) : sizeof(std::int64_t);
}
/// The number of the contact in column k.
auto& numberOf(auto& contact, std::size_t k) {
  const auto axis = static_cast<Eigen::Index>(k % 3);
  return k < 3 ? contact.r_W[axis] : k < 6 ? contact.n_W[axis] : contact.push;
}

/// Of the column of RecordedStep::check.
constexpr std::size_t kCheckBytes = sizeof(std::uint32_t);

bool isRounded(const StepColumn& column, Layout layout) {
  return layout == Layout::Rounded && column.per_unit > 0.0;
}

// What is not finite, or beyond the whole numbers of a double, is stored as this and read as NaN.
constexpr auto kNoNumber = std::numeric_limits<std::int64_t>::min();
constexpr double kMostWhole = 0x1p53;

std::uint64_t rounded(double value, double per_unit) {
  const double whole = std::round(value * per_unit);
  return static_cast<std::uint64_t>(std::abs(whole) <= kMostWhole ? static_cast<std::int64_t>(whole)
                                                                  : kNoNumber);
}
double unrounded(std::uint64_t stored, double per_unit) {
  const auto whole = static_cast<std::int64_t>(stored);
  return whole == kNoNumber ? std::numeric_limits<double>::quiet_NaN() : double(whole) / per_unit;
}

/// Appends a column of numbers of `width` bytes each.
void put(std::span<const std::uint64_t> values, std::size_t width, Layout layout,
         std::vector<std::uint8_t>& bytes) {
  if (layout == Layout::Exact)
    putPlanes(values, width, bytes);
  else
    putDifferences(values, bytes);
}
bool take(std::span<const std::uint8_t>& bytes, std::size_t width, Layout layout,
          std::span<std::uint64_t> values) {
  if (layout == Layout::Exact) return takePlanes(bytes, width, values);
  return takeDifferences(bytes, values) && std::ranges::all_of(values, [&](std::uint64_t value) {
           return width == sizeof value || value >> (8 * width) == 0;
         });
}

/// Where the contacts of a block are: numbers of the step and of the contact within the step.
struct PlaceInBlock {
  std::size_t step, slot;
};
/// In the order of the layout. Rounded: the first contacts of all steps, then the second ones, and
/// so on, since a contact mostly keeps its place from step to step.
std::vector<PlaceInBlock> placesOf(std::span<const std::uint8_t> contacts, Layout layout) {
  std::vector<PlaceInBlock> places;
  for (std::size_t step = 0; step < contacts.size(); ++step)
    for (std::size_t slot = 0; slot < contacts[step]; ++slot) places.push_back({step, slot});
  if (layout == Layout::Rounded)
    std::ranges::stable_sort(places, {}, [](const PlaceInBlock& place) { return place.slot; });
  return places;
}

std::vector<std::uint8_t> compressed(const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return {};
  uLongf size = compressBound(bytes.size());
  std::vector<std::uint8_t> packed(size);
  compress2(packed.data(), &size, bytes.data(), bytes.size(), kLevel);
  packed.resize(size);
  return packed;
}

/// Unpacks to at most as many bytes as `bytes` has room for, and gives it their number.
bool unpack(const std::vector<std::uint8_t>& packed, std::vector<std::uint8_t>& bytes) {
  if (packed.empty() || bytes.empty()) {
    bytes.clear();
    return packed.empty();
  }
  uLongf size = bytes.size();
  if (uncompress(bytes.data(), &size, packed.data(), packed.size()) != Z_OK) return false;
  bytes.resize(size);
  return true;
}

haptics::Pose poseFrom(const PoseNumbers& n) {
  return haptics::poseOf({n[0], n[1], n[2]}, haptics::Quat{n[3], n[4], n[5], n[6]});
}

tl::unexpected<haptics::Error> damagedBlock() {
  return tl::unexpected(
      haptics::Error{haptics::Error::Kind::Malformed, {"recording-damaged", {}}, "damaged"});
}

/// The rotation, exact, from the quaternion and the bits in which it differs from it.
void setDevicePose(PartlyRead& read) {
  haptics::Pose& X_WD = read.row.step.X_WD;
  X_WD = poseFrom(read.row.device);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      double& entry = X_WD.matrix()(r, c);
      entry = std::bit_cast<double>(std::bit_cast<std::uint64_t>(entry) ^
                                    read.device_bits[static_cast<std::size_t>(3 * r + c)]);
    }
}

/// The steps of a block without their contacts.
bool readSteps(std::span<const std::uint8_t> bytes, Layout layout, std::vector<PartlyRead>& steps) {
  std::vector<std::uint64_t> values(steps.size());
  for (const StepColumn& column : stepColumns()) {
    if (!take(bytes, bytesOf(column.type), layout, values)) return false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (isRounded(column, layout))
        values[i] = std::bit_cast<std::uint64_t>(unrounded(values[i], column.per_unit));
      if (!column.set(steps[i], values[i])) return false;
    }
  }
  if (layout == Layout::Rounded) {
    if (!take(bytes, kCheckBytes, layout, values)) return false;
    for (std::size_t i = 0; i < steps.size(); ++i)
      steps[i].row.check = static_cast<std::uint32_t>(values[i]);
  }
  for (PartlyRead& read : steps) {
    setDevicePose(read);
    read.row.step.X_WP = poseFrom(read.row.proxy);
  }
  return bytes.empty();
}

/// The contacts of the block's steps, which have as many as is known.
bool readContacts(std::span<const std::uint8_t> bytes, Layout layout,
                  std::span<const PlaceInBlock> places, std::vector<PartlyRead>& steps) {
  std::vector<std::uint64_t> values(places.size());
  for (PartlyRead& read : steps)
    for (int k = 0; k < read.contacts; ++k) read.row.step.contacts.push({});
  for (std::size_t k = 0; k < std::size(kContactColumns) && !places.empty(); ++k) {
    if (!take(bytes, contactBytes(layout), layout, values)) return false;
    for (std::size_t i = 0; i < places.size(); ++i)
      numberOf(steps[places[i].step].row.step.contacts[places[i].slot], k) =
          double(layout == Layout::Rounded
                     ? static_cast<float>(unrounded(values[i], kContactColumns[k].per_unit))
                     : std::bit_cast<float>(static_cast<std::uint32_t>(values[i])));
  }
  return bytes.empty();
}

// a tenth of a micrometre
constexpr double kPerNearness = 1e7;

/// The distances of the block's steps, whose structures are known.
bool readNearness(std::span<const std::uint8_t> bytes, Layout layout,
                  std::span<const std::uint8_t> structures, std::vector<PartlyRead>& steps) {
  std::vector<std::uint64_t> values(steps.size());
  for (const std::uint8_t structure : structures)
    for (PartlyRead& read : steps) read.row.step.near.push({structure});
  for (std::size_t of = 0; of < structures.size(); ++of)
    for (float haptics::Nearness::*number :
         {&haptics::Nearness::tip, &haptics::Nearness::nearest}) {
      if (!take(bytes, contactBytes(layout), layout, values)) return false;
      for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i].row.step.near[of].*number =
            layout == Layout::Rounded ? static_cast<float>(unrounded(values[i], kPerNearness))
                                      : std::bit_cast<float>(static_cast<std::uint32_t>(values[i]));
    }
  return bytes.empty();
}

// Of a cut, after the number of its step within the block. Exact: they are what a replay and every
// other view of the volume carry out.
struct CutColumn {
  const char* name;
  const char* unit;
};
constexpr CutColumn kCutColumns[] = {{"from_x", "m"}, {"from_y", "m"},  {"from_z", "m"},
                                     {"to_x", "m"},   {"to_y", "m"},    {"to_z", "m"},
                                     {"radius", "m"}, {"isovalue", ""}, {"removed", "m3"}};
double& numberOf(haptics::Step& step, std::size_t k) {
  haptics::BurrCut& cut = *step.cut;
  const auto axis = static_cast<Eigen::Index>(k % 3);
  return k < 3    ? cut.from_W[axis]
         : k < 6  ? cut.to_W[axis]
         : k == 6 ? cut.radius
         : k == 7 ? cut.isovalue
                  : step.removed;
}
constexpr std::size_t kStepOfCut = sizeof(std::uint16_t);

/// Each cut must be possible.
bool readCuts(std::span<const std::uint8_t> bytes, Layout layout, std::size_t count,
              std::vector<PartlyRead>& steps) {
  constexpr double kMostRemoved = 1e-4;  // m3: more than the largest ball and its way
  std::vector<std::uint64_t> values(count);
  std::vector<haptics::Step*> cuts;
  if (count > 0 && !take(bytes, kStepOfCut, layout, values)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (values[i] >= steps.size() || (i > 0 && values[i] <= values[i - 1])) return false;
    steps[values[i]].row.step.cut.emplace();
    cuts.push_back(&steps[values[i]].row.step);
  }
  for (std::size_t k = 0; k < std::size(kCutColumns) && count > 0; ++k) {
    if (!take(bytes, sizeof(double), layout, values)) return false;
    for (std::size_t i = 0; i < count; ++i)
      numberOf(*cuts[i], k) = std::bit_cast<double>(values[i]);
  }
  return bytes.empty() && std::ranges::all_of(cuts, [&](const haptics::Step* step) {
           return step->removed >= 0.0 && step->removed < kMostRemoved && isPossible(*step->cut);
         });
}

std::vector<std::uint8_t> writtenCuts(std::vector<RecordedStep>& rows, Layout layout,
                                      std::int64_t& count) {
  std::vector<std::uint64_t> values;
  std::vector<haptics::Step*> cuts;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].step.cut) {
      values.push_back(i);
      cuts.push_back(&rows[i].step);
    }
  count = static_cast<std::int64_t>(cuts.size());
  std::vector<std::uint8_t> bytes;
  if (cuts.empty()) return bytes;
  put(values, kStepOfCut, layout, bytes);
  for (std::size_t k = 0; k < std::size(kCutColumns); ++k) {
    std::ranges::transform(cuts, values.begin(), [k](haptics::Step* cut) {
      return std::bit_cast<std::uint64_t>(numberOf(*cut, k));
    });
    put(values, sizeof(double), layout, bytes);
  }
  return compressed(bytes);
}

}  // namespace

bool isNext(const haptics::Step& step, const haptics::Step& next) {
  return next.sequence == step.sequence + 1 &&
         std::ranges::equal(step.near, next.near, {}, &haptics::Nearness::structure,
                            &haptics::Nearness::structure);
}

Block encoded(std::span<const haptics::Step> steps, Layout layout) {
  Block block{.first = steps.front().sequence,
              .count = static_cast<std::int64_t>(steps.size()),
              .from_ns = steps.front().time_ns,
              .to_ns = steps.back().time_ns};
  std::vector<RecordedStep> rows;
  std::vector<std::uint8_t> contacts;
  for (const haptics::Step& step : steps) {
    rows.push_back({step, numbersOf(step.X_WD), numbersOf(step.X_WP)});
    contacts.push_back(static_cast<std::uint8_t>(step.contacts.size()));
  }
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint64_t> values(rows.size());
  for (const StepColumn& column : stepColumns()) {
    std::ranges::transform(rows, values.begin(), column.bits);
    if (isRounded(column, layout))
      for (std::uint64_t& value : values)
        value = rounded(std::bit_cast<double>(value), column.per_unit);
    put(values, bytesOf(column.type), layout, bytes);
  }
  if (layout == Layout::Rounded) {
    std::ranges::transform(rows, values.begin(), [](const RecordedStep& row) {
      return checkOf(row.proxy, row.step.sent_W);
    });
    put(values, kCheckBytes, layout, bytes);
  }
  block.steps = compressed(bytes);

  const std::vector<PlaceInBlock> places = placesOf(contacts, layout);
  block.contact_count = static_cast<std::int64_t>(places.size());
  bytes.clear();
  values.resize(places.size());
  for (std::size_t k = 0; k < std::size(kContactColumns) && !places.empty(); ++k) {
    std::ranges::transform(places, values.begin(), [&](const PlaceInBlock& place) {
      const double number = numberOf(rows[place.step].step.contacts[place.slot], k);
      return layout == Layout::Rounded ? rounded(number, kContactColumns[k].per_unit)
                                       : std::bit_cast<std::uint32_t>(static_cast<float>(number));
    });
    put(values, contactBytes(layout), layout, bytes);
  }
  block.contacts = compressed(bytes);

  bytes.clear();
  values.resize(rows.size());
  for (std::size_t of = 0; of < steps.front().near.size(); ++of) {
    block.structures.push_back(steps.front().near[of].structure);
    for (float haptics::Nearness::*number :
         {&haptics::Nearness::tip, &haptics::Nearness::nearest}) {
      std::ranges::transform(steps, values.begin(), [&](const haptics::Step& step) {
        const float distance = step.near[of].*number;
        return layout == Layout::Rounded ? rounded(double(distance), kPerNearness)
                                         : std::bit_cast<std::uint32_t>(distance);
      });
      put(values, contactBytes(layout), layout, bytes);
    }
  }
  block.nearness = compressed(bytes);
  block.cuts = writtenCuts(rows, layout, block.cut_count);
  return block;
}

haptics::Expected<std::vector<RecordedStep>> decoded(const Block& block, Layout layout) {
  constexpr auto kMost = static_cast<std::int64_t>(haptics::Bearing::capacity());
  if (block.count < 1 || block.count > kMostStepsInBlock || block.contact_count < 0 ||
      block.contact_count > kMost * block.count)
    return damagedBlock();
  const auto count = static_cast<std::size_t>(block.count);
  const auto contact_count = static_cast<std::size_t>(block.contact_count);
  std::vector<std::uint8_t> bytes((stepColumns().size() + 1) * mostColumnBytes(count));
  std::vector<PartlyRead> read(count);
  if (!unpack(block.steps, bytes) || !readSteps(bytes, layout, read)) return damagedBlock();
  std::vector<std::uint8_t> contacts;
  for (std::size_t i = 0; i < count; ++i) {
    read[i].row.step.sequence = block.first + i;
    contacts.push_back(read[i].contacts);
  }
  const std::vector<PlaceInBlock> places = placesOf(contacts, layout);
  bytes.resize(contact_count == 0 ? 0
                                  : std::size(kContactColumns) * mostColumnBytes(contact_count));
  if (places.size() != contact_count || !unpack(block.contacts, bytes) ||
      !readContacts(bytes, layout, places, read))
    return damagedBlock();
  if (block.structures.size() > haptics::kMostWatched) return damagedBlock();
  bytes.resize(2 * block.structures.size() * mostColumnBytes(count));
  if (!unpack(block.nearness, bytes) || !readNearness(bytes, layout, block.structures, read))
    return damagedBlock();
  if (block.cut_count < 0 || block.cut_count > block.count) return damagedBlock();
  const auto cut_count = static_cast<std::size_t>(block.cut_count);
  bytes.resize(cut_count == 0 ? 0 : (std::size(kCutColumns) + 1) * mostColumnBytes(cut_count));
  if (!unpack(block.cuts, bytes) || !readCuts(bytes, layout, cut_count, read))
    return damagedBlock();
  std::vector<RecordedStep> steps;
  for (const PartlyRead& one : read) steps.push_back(one.row);
  return steps;
}

std::string stepLayout(Layout layout) {
  nlohmann::json columns = nlohmann::json::array();
  for (const StepColumn& column : stepColumns()) {
    columns.push_back({column.name, nameOf(column.type), column.unit});
    if (isRounded(column, layout)) columns.back().push_back(column.per_unit);
  }
  if (layout == Layout::Rounded) columns.push_back({"check", nameOf(ColumnType::Uint32), ""});
  return columns.dump();
}

std::string contactLayout(Layout layout) {
  nlohmann::json columns = nlohmann::json::array();
  for (const ContactColumn& column : kContactColumns) {
    columns.push_back({column.name, "float32", column.unit});
    if (layout == Layout::Rounded) columns.back().push_back(column.per_unit);
  }
  return columns.dump();
}

std::string cutLayout() {
  nlohmann::json columns = nlohmann::json::array();
  columns.push_back({"step", nameOf(ColumnType::Uint16), ""});
  for (const CutColumn& column : kCutColumns)
    columns.push_back({column.name, nameOf(ColumnType::Float64), column.unit});
  return columns.dump();
}

}  // namespace app
