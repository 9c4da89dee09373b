// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/columns.h"

namespace app {
namespace {

template <class T>
constexpr ColumnType kTypeOf = ColumnType::Uint8;
template <>
constexpr ColumnType kTypeOf<std::int64_t> = ColumnType::Int64;
template <>
constexpr ColumnType kTypeOf<std::uint64_t> = ColumnType::Uint64;
template <>
constexpr ColumnType kTypeOf<double> = ColumnType::Float64;
template <>
constexpr ColumnType kTypeOf<std::uint32_t> = ColumnType::Uint32;
template <>
constexpr ColumnType kTypeOf<std::uint16_t> = ColumnType::Uint16;

constexpr bool kSteady = true, kChanging = false;

/// A column of a number of the step; `member` is a lambda that gives a reference to it.
template <class Member>
constexpr StepColumn column(const char* name, const char* unit, const char* path, bool steady,
                            const char* meaning, Member) {
  using T = std::remove_cvref_t<decltype(Member{}(std::declval<RecordedStep&>()))>;
  return {name,
          kTypeOf<T>,
          unit,
          path,
          steady,
          meaning,
          [](const RecordedStep& row) -> std::uint64_t {
            const T value = Member{}(row);
            if constexpr (std::is_same_v<T, double>)
              return std::bit_cast<std::uint64_t>(value);
            else
              return static_cast<std::uint64_t>(value);
          },
          [](PartlyRead& read, std::uint64_t bits) {
            if constexpr (std::is_same_v<T, double>)
              Member{}(read.row) = std::bit_cast<double>(bits);
            else
              Member{}(read.row) = static_cast<T>(bits);
            return true;
          }};
}

/// Part of a vector or a pose.
template <class Member>
constexpr StepColumn part(const char* name, const char* unit, const char* meaning, Member member) {
  return column(name, unit, nullptr, kChanging, meaning, member);
}

// 1 nm; a turn that moves a point at 0.1 m by 2 nm; 1 uN; 1 uN at 0.1 m
constexpr double kPerMetre = 1e9, kPerQuaternion = 1e8, kPerNewton = 1e6, kPerNewtonMetre = 1e7;

/// Part of a result of the tick.
template <class Member>
constexpr StepColumn result(const char* name, const char* unit, const char* meaning,
                            double per_unit, Member member) {
  StepColumn column = part(name, unit, meaning, member);
  column.per_unit = per_unit;
  return column;
}

template <int k>
constexpr StepColumn devicePart(const char* name) {
  return part(
      name, k < 3 ? "m" : "1", "device as it was read",
      [](auto& row) -> auto& { return row.device[k]; });
}
template <int k>
constexpr StepColumn proxyPart(const char* name) {
  return result(
      name, k < 3 ? "m" : "1", "proxy after the tick", k < 3 ? kPerMetre : kPerQuaternion,
      [](auto& row) -> auto& { return row.proxy[k]; });
}
template <int axis>
constexpr StepColumn forcePart(const char* name) {
  return result(
      name, "N", "force sent to the hand", kPerNewton,
      [](auto& row) -> auto& { return row.step.sent_W.force[axis]; });
}
template <int axis>
constexpr StepColumn torquePart(const char* name) {
  return result(
      name, "N.m", "torque sent to the hand, about the device's origin", kPerNewtonMetre,
      [](auto& row) -> auto& { return row.step.sent_W.torque[axis]; });
}

template <int r, int c>
constexpr StepColumn deviceBits(const char* name) {
  return {name,
          ColumnType::Uint64,
          "",
          nullptr,
          kChanging,
          "bits in which the device's rotation matrix differs from that of the quaternion",
          [](const RecordedStep& row) {
            const auto& n = row.device;
            const haptics::Mat3 R =
                haptics::poseOf({n[0], n[1], n[2]}, haptics::Quat{n[3], n[4], n[5], n[6]}).linear();
            return std::bit_cast<std::uint64_t>(row.step.X_WD.linear()(r, c)) ^
                   std::bit_cast<std::uint64_t>(R(r, c));
          },
          [](PartlyRead& read, std::uint64_t bits) {
            read.device_bits[3 * r + c] = bits;
            return true;
          }};
}

const StepColumn kColumns[] = {
    column(
        "time", "ns", nullptr, kChanging, "time since the recording began",
        [](auto& row) -> auto& { return row.step.time_ns; }),
    devicePart<0>("device_x"),
    devicePart<1>("device_y"),
    devicePart<2>("device_z"),
    devicePart<3>("device_qw"),
    devicePart<4>("device_qx"),
    devicePart<5>("device_qy"),
    devicePart<6>("device_qz"),
    deviceBits<0, 0>("device_bits_00"),
    deviceBits<0, 1>("device_bits_01"),
    deviceBits<0, 2>("device_bits_02"),
    deviceBits<1, 0>("device_bits_10"),
    deviceBits<1, 1>("device_bits_11"),
    deviceBits<1, 2>("device_bits_12"),
    deviceBits<2, 0>("device_bits_20"),
    deviceBits<2, 1>("device_bits_21"),
    deviceBits<2, 2>("device_bits_22"),
    proxyPart<0>("proxy_x"),
    proxyPart<1>("proxy_y"),
    proxyPart<2>("proxy_z"),
    proxyPart<3>("proxy_qw"),
    proxyPart<4>("proxy_qx"),
    proxyPart<5>("proxy_qy"),
    proxyPart<6>("proxy_qz"),
    forcePart<0>("force_x"),
    forcePart<1>("force_y"),
    forcePart<2>("force_z"),
    torquePart<0>("torque_x"),
    torquePart<1>("torque_y"),
    torquePart<2>("torque_z"),
    column(
        "isovalue", "", "settings/isovalue", kSteady, "where the surface is, in the scan's unit",
        [](auto& row) -> auto& { return row.step.settings.isovalue; }),
    column(
        "stiffness", "N/m", "settings/stiffness", kSteady, "of the virtual coupling",
        [](auto& row) -> auto& { return row.step.settings.stiffness; }),
    column(
        "angular_stiffness", "N.m/rad", "settings/angular_stiffness", kSteady,
        "of the virtual coupling; 0: stiffness times the tool's mean inertia",
        [](auto& row) -> auto& { return row.step.settings.angular_stiffness; }),
    column(
        "friction", "1", "settings/friction", kSteady,
        "Coulomb's coefficient between tool and surface",
        [](auto& row) -> auto& { return row.step.settings.friction; }),
    column(
        "force_scale", "1", "settings/force_scale", kSteady, "hand force divided by tool force",
        [](auto& row) -> auto& { return row.step.settings.force_scale; }),
    column(
        "position_scale", "1", "settings/position_scale", kSteady,
        "metres that the tool moves for each metre of the hand",
        [](auto& row) -> auto& { return row.step.settings.position_scale; }),
    column(
        "cut_at", "", "tick/cut_at", kChanging, "work at which the tick was cut off; 0: it was not",
        [](auto& row) -> auto& { return row.step.cut_at; }),
    column(
        "cpu", "ns", "tick/cpu", kChanging, "time of the thread that the tick took",
        [](auto& row) -> auto& { return row.step.cpu_ns; }),
    column(
        "scene", "", "tick/scene", kSteady, "number of the scene; 0: none",
        [](auto& row) -> auto& { return row.step.scene; }),
    column(
        "late_ticks", "", "tick/late", kChanging,
        "ticks that began late since the servo loop started",
        [](auto& row) -> auto& { return row.step.late_ticks; }),
    column(
        "missed_ticks", "", "tick/missed", kChanging,
        "ticks that were left out since the servo loop started",
        [](auto& row) -> auto& { return row.step.missed_ticks; }),
    {"force_state", ColumnType::Uint8, "", "tick/force_state", kChanging,
     "0 off, 1 ready, 2 armed, 3 ramping, 4 on, 5 fault",
     [](const RecordedStep& row) { return static_cast<std::uint64_t>(row.step.force_state); },
     [](PartlyRead& read, std::uint64_t bits) {
       read.row.step.force_state = static_cast<haptics::ForceState>(bits);
       return bits <= static_cast<std::uint64_t>(haptics::ForceState::Fault);
     }},
    column(
        "flags", "", "tick/flags", kChanging,
        "sum of 1 another scene, 2 a setting changed, 4 armed by the user, 8 no reading from the "
        "device, 16 the last reading again, 32 no other reading for 1.5 ms or "
        "more, 64 device not homed, 128 clutch held, 256 hold-to-run key released, 512 no tick for "
        "5 ms before this one, 1024 device too fast for force, 2048 device faster than a hand, "
        "4096 third gap in ten seconds, 8192 stiffness changed, 16384 other structures "
        "felt, 32768 the burr's key held",
        [](auto& row) -> auto& { return row.step.flags; }),
    {"contacts", ColumnType::Uint8, "", "tick/contacts", kChanging,
     "contacts that bear on the tool",
     [](const RecordedStep& row) { return std::uint64_t{row.step.contacts.size()}; },
     [](PartlyRead& read, std::uint64_t bits) {
       read.contacts = static_cast<std::uint8_t>(bits);
       return bits <= haptics::Bearing::capacity();
     }},
};

}  // namespace

const char* nameOf(ColumnType type) {
  constexpr const char* kNames[] = {"int64", "uint64", "float64", "uint32", "uint16", "uint8"};
  return kNames[static_cast<std::size_t>(type)];
}

std::size_t bytesOf(ColumnType type) {
  constexpr std::size_t kBytes[] = {8, 8, 8, 4, 2, 1};
  return kBytes[static_cast<std::size_t>(type)];
}

PoseNumbers numbersOf(const haptics::Pose& X) {
  const haptics::Vec3 p = X.translation();
  const haptics::Quat q = haptics::rotationOf(X);
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

std::uint32_t checkOf(const PoseNumbers& proxy, const haptics::Wrench& sent_W) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15;  // 2^64 divided by the golden ratio
  constexpr int kBits = 23;
  std::uint64_t mixed = 0;
  const auto mix = [&](double number) {
    // the upper bits are those of the product that depend on all others
    mixed = (mixed ^ (mixed >> 32) ^ std::bit_cast<std::uint64_t>(number)) * kOdd;
  };
  for (const double number : proxy) mix(number);
  for (const double number : sent_W.force) mix(number);
  for (const double number : sent_W.torque) mix(number);
  return static_cast<std::uint32_t>(mixed >> (64 - kBits));
}

std::span<const StepColumn> stepColumns() { return kColumns; }

}  // namespace app
