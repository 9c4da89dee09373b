// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/recording/block.h"

#include <zlib.h>

#include <bit>
#include <iterator>
#include <nlohmann/json.hpp>

namespace haptics {
namespace {

constexpr int kLevel = 6;

struct ContactColumn {
  const char* name;
  const char* unit;
};
constexpr ContactColumn kContactColumns[] = {
    {"arm_x", "m"},    {"arm_y", "m"},    {"arm_z", "m"}, {"normal_x", "1"},
    {"normal_y", "1"}, {"normal_z", "1"}, {"push", "N"},
};
constexpr std::size_t kContactWidth = std::size(kContactColumns) * sizeof(float);

std::size_t stepWidth() {
  std::size_t width = 0;
  for (const StepColumn& column : stepColumns()) width += bytesOf(column.type);
  return width;
}

/// Rows of values taken apart into planes of bytes, or put together again: value by value in the
/// order of the columns.
class Planes {
 public:
  Planes(std::size_t width, std::size_t count) : bytes(width * count), count_{count} {}
  void row(std::size_t i) {
    i_ = i;
    at_ = 0;
  }
  /// The lowest `size` bytes.
  void put(std::uint64_t value, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k)
      bytes[(at_ + k) * count_ + i_] = static_cast<std::uint8_t>(value >> (8 * k));
    at_ += size;
  }
  std::uint64_t get(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < size; ++k)
      value |= std::uint64_t{bytes[(at_ + k) * count_ + i_]} << (8 * k);
    at_ += size;
    return value;
  }
  void put(float value) { put(std::bit_cast<std::uint32_t>(value), sizeof value); }
  float getFloat() { return std::bit_cast<float>(static_cast<std::uint32_t>(get(sizeof(float)))); }

  std::vector<std::uint8_t> bytes;

 private:
  std::size_t count_, i_ = 0, at_ = 0;
};

std::vector<std::uint8_t> compressed(const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return {};
  uLongf size = compressBound(bytes.size());
  std::vector<std::uint8_t> packed(size);
  compress2(packed.data(), &size, bytes.data(), bytes.size(), kLevel);
  packed.resize(size);
  return packed;
}

/// False unless it unpacks to just as many bytes.
bool unpack(const std::vector<std::uint8_t>& packed, std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return packed.empty();
  uLongf size = bytes.size();
  return uncompress(bytes.data(), &size, packed.data(), packed.size()) == Z_OK &&
         size == bytes.size();
}

void put(Planes& planes, const Vec3& v) {
  for (int a = 0; a < 3; ++a) planes.put(static_cast<float>(v[a]));
}
void get(Planes& planes, Vec3& v) {
  for (int a = 0; a < 3; ++a) v[a] = double(planes.getFloat());
}

Pose poseFrom(const PoseNumbers& n) {
  return poseOf({n[0], n[1], n[2]}, Quat{n[3], n[4], n[5], n[6]});
}

tl::unexpected<Error> damagedBlock() {
  return tl::unexpected(Error{Error::Kind::Malformed, {"recording-part-damaged", {}}, "damaged"});
}

}  // namespace

Block encoded(std::span<const Step> steps) {
  Block block{.first = steps.front().sequence,
              .count = static_cast<std::int64_t>(steps.size()),
              .from_ns = steps.front().time_ns,
              .to_ns = steps.back().time_ns};
  for (const Step& step : steps)
    block.contact_count += static_cast<std::int64_t>(step.contacts.size());
  Planes planes{stepWidth(), steps.size()};
  Planes contacts{kContactWidth, static_cast<std::size_t>(block.contact_count)};
  std::size_t contact = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    const RecordedStep row{step, numbersOf(step.X_WD), numbersOf(step.X_WP)};
    planes.row(i);
    for (const StepColumn& column : stepColumns())
      planes.put(column.bits(row), bytesOf(column.type));
    for (const BearingContact& c : step.contacts) {
      contacts.row(contact++);
      put(contacts, c.r_W);
      put(contacts, c.n_W);
      contacts.put(static_cast<float>(c.push));
    }
  }
  block.steps = compressed(planes.bytes);
  block.contacts = compressed(contacts.bytes);
  return block;
}

Expected<std::vector<RecordedStep>> decoded(const Block& block) {
  constexpr auto kMost = static_cast<std::int64_t>(Bearing::capacity());
  if (block.count < 1 || block.count > kMostStepsInBlock || block.contact_count < 0 ||
      block.contact_count > kMost * block.count)
    return damagedBlock();
  const auto count = static_cast<std::size_t>(block.count);
  Planes planes{stepWidth(), count};
  Planes contacts{kContactWidth, static_cast<std::size_t>(block.contact_count)};
  if (!unpack(block.steps, planes.bytes) || !unpack(block.contacts, contacts.bytes))
    return damagedBlock();
  std::vector<RecordedStep> steps(count);
  std::int64_t contact = 0;
  for (std::size_t i = 0; i < count; ++i) {
    PartlyRead read;
    planes.row(i);
    for (const StepColumn& column : stepColumns())
      if (!column.set(read, planes.get(bytesOf(column.type)))) return damagedBlock();
    Step& step = read.row.step;
    step.sequence = block.first + i;
    step.X_WD = poseFrom(read.row.device);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        double& entry = step.X_WD.matrix()(r, c);
        entry = std::bit_cast<double>(std::bit_cast<std::uint64_t>(entry) ^
                                      read.device_bits[static_cast<std::size_t>(3 * r + c)]);
      }
    step.X_WP = poseFrom(read.row.proxy);
    if (contact + read.contacts > block.contact_count) return damagedBlock();
    for (int k = 0; k < read.contacts; ++k) {
      contacts.row(static_cast<std::size_t>(contact++));
      BearingContact c;
      get(contacts, c.r_W);
      get(contacts, c.n_W);
      c.push = double(contacts.getFloat());
      step.contacts.push(c);
    }
    steps[i] = read.row;
  }
  if (contact != block.contact_count) return damagedBlock();
  return steps;
}

std::string stepLayout() {
  nlohmann::json layout = nlohmann::json::array();
  for (const StepColumn& column : stepColumns())
    layout.push_back({column.name, nameOf(column.type), column.unit});
  return layout.dump();
}
std::string contactLayout() {
  nlohmann::json layout = nlohmann::json::array();
  for (const ContactColumn& column : kContactColumns)
    layout.push_back({column.name, "float32", column.unit});
  return layout.dump();
}

}  // namespace haptics
