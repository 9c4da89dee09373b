// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/recording/block.h"

#include <zlib.h>

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

namespace haptics {
namespace {

static_assert(std::endian::native == std::endian::little, "columns are little endian");

constexpr int kLevel = 6;

struct Column {
  const char* name;
  const char* type;
  std::size_t bytes;
  const char* unit;
};
constexpr Column kStepColumns[] = {
    {"time", "int64", 8, "ns"},
    {"device_x", "float64", 8, "m"},
    {"device_y", "float64", 8, "m"},
    {"device_z", "float64", 8, "m"},
    {"device_qw", "float64", 8, "1"},
    {"device_qx", "float64", 8, "1"},
    {"device_qy", "float64", 8, "1"},
    {"device_qz", "float64", 8, "1"},
    // the bits in which the rotation matrix differs from that of the quaternion, row by row
    {"device_bits_00", "uint64", 8, ""},
    {"device_bits_01", "uint64", 8, ""},
    {"device_bits_02", "uint64", 8, ""},
    {"device_bits_10", "uint64", 8, ""},
    {"device_bits_11", "uint64", 8, ""},
    {"device_bits_12", "uint64", 8, ""},
    {"device_bits_20", "uint64", 8, ""},
    {"device_bits_21", "uint64", 8, ""},
    {"device_bits_22", "uint64", 8, ""},
    {"proxy_x", "float64", 8, "m"},
    {"proxy_y", "float64", 8, "m"},
    {"proxy_z", "float64", 8, "m"},
    {"proxy_qw", "float64", 8, "1"},
    {"proxy_qx", "float64", 8, "1"},
    {"proxy_qy", "float64", 8, "1"},
    {"proxy_qz", "float64", 8, "1"},
    {"force_x", "float64", 8, "N"},
    {"force_y", "float64", 8, "N"},
    {"force_z", "float64", 8, "N"},
    {"torque_x", "float64", 8, "N.m"},
    {"torque_y", "float64", 8, "N.m"},
    {"torque_z", "float64", 8, "N.m"},
    {"isovalue", "float64", 8, ""},
    {"stiffness", "float64", 8, "N/m"},
    {"angular_stiffness", "float64", 8, "N.m/rad"},
    {"friction", "float64", 8, "1"},
    {"force_scale", "float64", 8, "1"},
    {"position_scale", "float64", 8, "1"},
    {"cut_at", "int64", 8, ""},
    {"cpu", "int64", 8, "ns"},
    {"scene", "uint32", 4, ""},
    {"late_ticks", "uint32", 4, ""},
    {"missed_ticks", "uint32", 4, ""},
    {"force_state", "uint8", 1, ""},
    {"flags", "uint16", 2, ""},
    {"contacts", "uint8", 1, ""},
};
constexpr Column kContactColumns[] = {
    {"arm_x", "float32", 4, "m"},    {"arm_y", "float32", 4, "m"},
    {"arm_z", "float32", 4, "m"},    {"normal_x", "float32", 4, "1"},
    {"normal_y", "float32", 4, "1"}, {"normal_z", "float32", 4, "1"},
    {"push", "float32", 4, "N"},
};

template <std::size_t N>
constexpr std::size_t widthOf(const Column (&columns)[N]) {
  std::size_t width = 0;
  for (const Column& column : columns) width += column.bytes;
  return width;
}
constexpr std::size_t kStepWidth = widthOf(kStepColumns);
constexpr std::size_t kContactWidth = widthOf(kContactColumns);

template <std::size_t N>
std::string layoutOf(const Column (&columns)[N]) {
  nlohmann::json layout = nlohmann::json::array();
  for (const Column& column : columns) layout.push_back({column.name, column.type, column.unit});
  return layout.dump();
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
  template <class T>
  void put(T value) {
    std::uint8_t raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    for (std::size_t k = 0; k < sizeof(T); ++k) bytes[(at_ + k) * count_ + i_] = raw[k];
    at_ += sizeof(T);
  }
  template <class T>
  T get() {
    std::uint8_t raw[sizeof(T)];
    for (std::size_t k = 0; k < sizeof(T); ++k) raw[k] = bytes[(at_ + k) * count_ + i_];
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }
  template <class T>
  void get(T& value) {
    value = get<T>();
  }

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

/// The bits in which two numbers differ; applied twice it gives the first again.
std::uint64_t differing(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) ^ std::bit_cast<std::uint64_t>(b);
}

Pose poseFrom(const PoseNumbers& n) {
  return poseOf({n[0], n[1], n[2]}, Quat{n[3], n[4], n[5], n[6]});
}

void put(Planes& planes, const PoseNumbers& numbers) {
  for (const double number : numbers) planes.put(number);
}
void put(Planes& planes, const Vec3& v) {
  for (int a = 0; a < 3; ++a) planes.put(v[a]);
}
void get(Planes& planes, PoseNumbers& numbers) {
  for (double& number : numbers) planes.get(number);
}
void get(Planes& planes, Vec3& v) {
  for (int a = 0; a < 3; ++a) planes.get(v[a]);
}
void putFloats(Planes& planes, const Vec3& v) {
  for (int a = 0; a < 3; ++a) planes.put(static_cast<float>(v[a]));
}
void getFloats(Planes& planes, Vec3& v) {
  for (int a = 0; a < 3; ++a) v[a] = double(planes.get<float>());
}

tl::unexpected<Error> damagedBlock() {
  return tl::unexpected(Error{Error::Kind::Malformed,
                              "A part of the recording is damaged and cannot be read.", "damaged"});
}

}  // namespace

PoseNumbers numbersOf(const Pose& X) {
  const Vec3 p = X.translation();
  const Quat q = rotationOf(X);
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

Block encoded(std::span<const Step> steps) {
  Block block{.first = steps.front().sequence,
              .count = static_cast<std::int64_t>(steps.size()),
              .from_ns = steps.front().time_ns,
              .to_ns = steps.back().time_ns};
  for (const Step& step : steps)
    block.contact_count += static_cast<std::int64_t>(step.contacts.size());
  Planes planes{kStepWidth, steps.size()};
  Planes contacts{kContactWidth, static_cast<std::size_t>(block.contact_count)};
  std::size_t contact = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    planes.row(i);
    planes.put(step.time_ns);
    const PoseNumbers device = numbersOf(step.X_WD);
    put(planes, device);
    const Mat3 R = poseFrom(device).linear(), read = step.X_WD.linear();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) planes.put(differing(read(r, c), R(r, c)));
    put(planes, numbersOf(step.X_WP));
    put(planes, step.sent_W.force);
    put(planes, step.sent_W.torque);
    planes.put(step.settings.isovalue);
    planes.put(step.settings.stiffness);
    planes.put(step.settings.angular_stiffness);
    planes.put(step.settings.friction);
    planes.put(step.settings.force_scale);
    planes.put(step.settings.position_scale);
    planes.put(step.cut_at);
    planes.put(step.cpu_ns);
    planes.put(step.scene);
    planes.put(step.late_ticks);
    planes.put(step.missed_ticks);
    planes.put(static_cast<std::uint8_t>(step.force_state));
    planes.put(step.flags);
    planes.put(static_cast<std::uint8_t>(step.contacts.size()));
    for (const BearingContact& c : step.contacts) {
      contacts.row(contact++);
      putFloats(contacts, c.r_W);
      putFloats(contacts, c.n_W);
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
  Planes planes{kStepWidth, count};
  Planes contacts{kContactWidth, static_cast<std::size_t>(block.contact_count)};
  if (!unpack(block.steps, planes.bytes) || !unpack(block.contacts, contacts.bytes))
    return damagedBlock();
  std::vector<RecordedStep> steps(count);
  std::int64_t contact = 0;
  for (std::size_t i = 0; i < count; ++i) {
    auto& [step, device, proxy] = steps[i];
    planes.row(i);
    step.sequence = block.first + i;
    planes.get(step.time_ns);
    get(planes, device);
    step.X_WD = poseFrom(device);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        double& entry = step.X_WD.matrix()(r, c);
        entry = std::bit_cast<double>(std::bit_cast<std::uint64_t>(entry) ^
                                      planes.get<std::uint64_t>());
      }
    get(planes, proxy);
    step.X_WP = poseFrom(proxy);
    get(planes, step.sent_W.force);
    get(planes, step.sent_W.torque);
    planes.get(step.settings.isovalue);
    planes.get(step.settings.stiffness);
    planes.get(step.settings.angular_stiffness);
    planes.get(step.settings.friction);
    planes.get(step.settings.force_scale);
    planes.get(step.settings.position_scale);
    planes.get(step.cut_at);
    planes.get(step.cpu_ns);
    planes.get(step.scene);
    planes.get(step.late_ticks);
    planes.get(step.missed_ticks);
    const auto state = planes.get<std::uint8_t>();
    if (state > static_cast<std::uint8_t>(ForceState::Fault)) return damagedBlock();
    step.force_state = static_cast<ForceState>(state);
    planes.get(step.flags);
    const auto touching = planes.get<std::uint8_t>();
    if (touching > kMost || contact + touching > block.contact_count) return damagedBlock();
    for (int k = 0; k < touching; ++k) {
      contacts.row(static_cast<std::size_t>(contact++));
      BearingContact c;
      getFloats(contacts, c.r_W);
      getFloats(contacts, c.n_W);
      c.push = double(contacts.get<float>());
      step.contacts.push(c);
    }
  }
  if (contact != block.contact_count) return damagedBlock();
  return steps;
}

std::string stepLayout() { return layoutOf(kStepColumns); }
std::string contactLayout() { return layoutOf(kContactColumns); }

}  // namespace haptics
