// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/polhem.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "haptics/core/clock.h"

namespace haptics {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::string_view kDriver = "polhem";
constexpr std::uint16_t kVendor = 0x16c0, kProduct = 0x0486;
constexpr std::uint16_t kRawPage = 0xffab, kRawUsage = 0x0200;

constexpr std::size_t kReportBytes = 64;
constexpr int kButtonFold = 10'000;
constexpr std::int16_t kSetEncoders = 1;  // a command; 0: currents

// m; the letters are those of the header
constexpr double kL0 = 0.034, kL1 = 0.165, kL2 = 0.025, kL3 = 0.190, kL4 = 0.034, kL5 = 0.1308;
constexpr double kOriginOut = 0.2045, kOriginUp = 0.0325;  // m, the workspace's middle
constexpr double kDeadPoint = 0.02;                        // sine of the forearm's angle to the rod

constexpr double kTurn = 2.0 * std::numbers::pi;
// capstan over sector, by the diameters in mm, and which way the body turns with its motor
constexpr std::array<double, 3> kRatio{28.8534 / 175.0, -13.6981 / 100.0, 13.7281 / 100.0};
constexpr std::array<double, 3> kTorquePerAmpere{0.0603, 0.0538, 0.0538};  // N·m/A
constexpr double kMotorCounts = 4096.0, kGimbalCounts = 1024.0;            // a turn

constexpr int kNearRest = 100;        // counts
constexpr int kLongestJump = 2'000;   // counts between two answers: a motor's half turn
constexpr int kRoundsToSet = 20;      // rounds that setting may take
constexpr int kMostAnswers = 8;       // a round
constexpr int kRoundsToWakeUp = 100;  // of 5 ms

PolhemCommand commandOf(const std::array<std::int16_t, 7>& words) noexcept {
  PolhemCommand command{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto word = static_cast<std::uint16_t>(words[i]);
    command[1 + 2 * i] = static_cast<std::uint8_t>(word & 0xff);
    command[2 + 2 * i] = static_cast<std::uint8_t>(word >> 8);
  }
  return command;
}

Vec2 along(double angle) noexcept { return {std::cos(angle), std::sin(angle)}; }
Vec2 across(const Vec2& v) noexcept { return {-v.y(), v.x()}; }

/// From the makers' axes (towards the user, right, up) to those of B.
Mat3 toBase() noexcept {
  Mat3 R_BH;
  R_BH << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return R_BH;
}

class PolhemTransport final : public Transport {
 public:
  explicit PolhemTransport(std::unique_ptr<HidPort> port) : port_{std::move(port)} {}
  ~PolhemTransport() override { port_->write(polhemCurrents(Vec3::Zero())); }
  PolhemTransport(const PolhemTransport&) = delete;
  PolhemTransport& operator=(const PolhemTransport&) = delete;

  DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept override {
    if (!port_->write(next(wrench_B))) {
      J_B_.reset();
      return DeviceStatus::Stale;
    }
    bool gone = false;
    const std::optional<PolhemReport> report = newest(gone);
    if (!report) {
      J_B_.reset();
      return gone ? DeviceStatus::Lost : DeviceStatus::Stale;
    }
    return takeIn(*report, reading);
  }

 private:
  enum class Zero : std::uint8_t { Unset, Setting, Set, Gone };

  PolhemCommand next(const Wrench& wrench_B) const noexcept {
    if (zero_ == Zero::Setting) return polhemAtRest();
    return polhemCurrents(J_B_ ? polhemCurrentsFor(wrench_B.force, *J_B_) : Vec3{Vec3::Zero()});
  }

  /// The last of the answers that are there; waits for the first.
  std::optional<PolhemReport> newest(bool& gone) noexcept {
    std::optional<PolhemReport> report;
    std::chrono::milliseconds wait = kLongestWait;
    for (int i = 0; i < kMostAnswers; ++i) {
      const auto length = port_->read(bytes_, wait);
      gone = !length;
      if (!length) return std::nullopt;
      if (*length == 0) break;
      if (const auto decoded =
              decodePolhem(std::span{bytes_}.first(std::min(*length, bytes_.size()))))
        report = decoded;
      wait = std::chrono::milliseconds{0};
    }
    return report;
  }

  DeviceStatus takeIn(const PolhemReport& report, DeviceReading& reading) noexcept {
    const std::optional<PolhemArm> arm = polhemArm(polhemAngles(report.counts));
    settle(report, arm.has_value());
    last_ = report;

    reading.buttons = report.button ? 1 : 0;
    reading.time_ns = monotonicNs();
    if (zero_ == Zero::Gone) {
      J_B_.reset();
      reading.trouble = Trouble::Lost;
      return DeviceStatus::Lost;
    }
    if (zero_ != Zero::Set) {
      J_B_.reset();
      reading.trouble = Trouble::NeedsCalibration;
      return DeviceStatus::NotReady;
    }
    J_B_ = arm->J_B;
    reading.X_BD = arm->X_BD;
    reading.trouble = Trouble::None;
    return DeviceStatus::Ok;
  }

  /// Whether the counts mean anything, after this report.
  void settle(const PolhemReport& report, bool makes_an_arm) noexcept {
    const bool pressed = report.button && last_ && !last_->button;
    switch (zero_) {
      case Zero::Unset:
        if (report.asks || pressed) beginSetting();
        return;
      case Zero::Setting:
        if (!report.asks && makes_an_arm && atRest(report))
          zero_ = Zero::Set;
        else if (++rounds_ > kRoundsToSet)
          zero_ = Zero::Unset;
        return;
      case Zero::Set:
        if (report.asks)
          beginSetting();
        else if (!makes_an_arm || jumped(report))
          zero_ = Zero::Gone;
        return;
      case Zero::Gone:
        return;
    }
  }

  void beginSetting() noexcept {
    zero_ = Zero::Setting;
    rounds_ = 0;
  }

  static bool atRest(const PolhemReport& report) noexcept {
    for (std::size_t i = 0; i < kPolhemRest.size(); ++i)
      if (std::abs(report.counts[i] - kPolhemRest[i]) > kNearRest) return false;
    return true;
  }

  bool jumped(const PolhemReport& report) const noexcept {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::abs(report.counts[i] - last_->counts[i]) > kLongestJump) return true;
    return false;
  }

  std::unique_ptr<HidPort> port_;
  std::array<std::uint8_t, kReportBytes + 1> bytes_{};  // one more: what is too long shows
  Zero zero_ = Zero::Unset;
  int rounds_ = 0;
  std::optional<PolhemReport> last_;
  std::optional<Mat3> J_B_;  ///< of the newest answer; none: no force
};

std::string nameOf(std::size_t count) {
  std::string name{findRating(kDriver)->name};
  return count > 1 ? name + " (one of " + std::to_string(count) + ")" : name;
}

std::vector<HidPlace> placesAmong(std::span<const HidPlace> places) {
  std::vector<HidPlace> found;
  std::ranges::copy_if(places, std::back_inserter(found), [](const HidPlace& place) {
    return place.vendor == kVendor && place.product == kProduct && place.usage_page == kRawPage &&
           place.usage == kRawUsage;
  });
  return found;
}

std::string idOf(const HidPlace& place) { return std::string{kDriver} + ":" + place.path; }

Error notThere() {
  return refusal(Trouble::NotPluggedIn,
                 "No Polhem is plugged in; switch its power on and plug its USB cable in.");
}

}  // namespace

std::optional<PolhemReport> decodePolhem(std::span<const std::uint8_t> report) noexcept {
  if (report.size() != kReportBytes) return std::nullopt;
  const auto word = [&](std::size_t i) {
    return static_cast<std::int16_t>(report[2 * i] | report[2 * i + 1] << 8);
  };
  PolhemReport decoded;
  for (std::size_t i = 0; i < decoded.counts.size(); ++i) decoded.counts[i] = word(i);
  std::int16_t& d = decoded.counts[3];
  decoded.button = d > kButtonFold / 2;
  if (decoded.button) d = static_cast<std::int16_t>(d - kButtonFold);
  decoded.asks = word(6) == 1;
  return decoded;
}

PolhemCommand polhemCurrents(const Vec3& currents) noexcept {
  if (!currents.allFinite()) return {};
  const double most = currents.cwiseAbs().maxCoeff();
  // what is almost infinite is shortened before it can be multiplied
  const Vec3 capped =
      most > kPolhemMostCurrent ? Vec3{currents / most * kPolhemMostCurrent} : currents;
  std::array<std::int16_t, 7> words{};
  for (Eigen::Index i = 0; i < 3; ++i)
    words[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(capped[i] * 1e3));
  return commandOf(words);
}

PolhemCommand polhemAtRest() noexcept {
  const auto& rest = kPolhemRest;
  return commandOf({rest[3], rest[4], rest[5], kSetEncoders, rest[0], rest[1], rest[2]});
}

PolhemAngles polhemAngles(const std::array<std::int16_t, 6>& counts) noexcept {
  PolhemAngles angles{};
  for (std::size_t i = 0; i < 3; ++i) angles[i] = counts[i] * (kTurn / kMotorCounts) * kRatio[i];
  // the gimbal's encoders come in reverse order, and turn against their bodies
  for (std::size_t i = 0; i < 3; ++i) angles[3 + i] = -counts[5 - i] * (kTurn / kGimbalCounts);
  return angles;
}

std::optional<PolhemArm> polhemArm(const PolhemAngles& angles) noexcept {
  const Vec2 u_b = along(angles[1]), u_c = along(angles[2]);
  const Vec2 E = Vec2{kL0 / 2, 0.0} + kL1 * u_b;
  const Vec2 K = Vec2{-kL0 / 2, 0.0} + kL2 * u_c;

  // the triangle of elbow, crank's end and forearm's end, by its angle at the elbow
  const Vec2 EK = K - E;
  const double s = EK.norm();
  const double cosine = (kL4 * kL4 + s * s - kL3 * kL3) / (2.0 * kL4 * s);
  if (!(std::abs(cosine) < 1.0)) return std::nullopt;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const Vec2 e = EK / s;
  const Vec2 u_l = -(cosine * e - sine * across(e));
  const Vec2 w = E - kL4 * u_l - K;
  const double lever = w.dot(across(u_l));
  if (!(std::abs(lever) > kDeadPoint * kL3)) return std::nullopt;

  const Vec2 G = E + kL5 * u_l;
  const double dl_db = kL1 * w.dot(across(u_b)) / (kL4 * lever);
  const double dl_dc = -kL2 * w.dot(across(u_c)) / (kL4 * lever);
  const Vec2 dG_db = kL1 * across(u_b) + kL5 * across(u_l) * dl_db;
  const Vec2 dG_dc = kL5 * across(u_l) * dl_dc;

  // out of the arm's plane
  const Vec2 u_a = along(angles[0]);
  const auto out = [&](const Vec2& v) { return Vec3{v.x() * u_a.x(), v.x() * u_a.y(), v.y()}; };
  Mat3 J;
  J.col(0) = G.x() * Vec3{-u_a.y(), u_a.x(), 0.0};
  J.col(1) = out(dG_db);
  J.col(2) = out(dG_dc);

  using Eigen::AngleAxisd;
  const double l = std::atan2(u_l.y(), u_l.x());
  const Quat rotation = AngleAxisd{angles[0], Vec3::UnitZ()} * AngleAxisd{-l, Vec3::UnitY()} *
                        AngleAxisd{angles[3], Vec3::UnitX()} *
                        AngleAxisd{angles[4], Vec3::UnitY()} * AngleAxisd{angles[5], Vec3::UnitX()};
  const Mat3 R_BH = toBase();
  PolhemArm arm;
  arm.X_BD = poseOf(R_BH * (out(G) - Vec3{kOriginOut, 0.0, kOriginUp}),
                    Quat{R_BH * rotation.toRotationMatrix() * R_BH.transpose()});
  arm.J_B = R_BH * J;
  return arm;
}

Vec3 polhemCurrentsFor(const Vec3& force_B, const Mat3& J_B) noexcept {
  Vec3 currents = J_B.transpose() * force_B;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto motor = static_cast<std::size_t>(i);
    currents[i] *= kRatio[motor] / kTorquePerAmpere[motor];
  }
  return currents;
}

std::unique_ptr<Transport> polhemTransport(std::unique_ptr<HidPort> port) {
  return std::make_unique<PolhemTransport>(std::move(port));
}

std::vector<DeviceEntry> polhemsAmong(std::span<const HidPlace> places) {
  const std::vector<HidPlace> found = placesAmong(places);
  std::vector<DeviceEntry> entries;
  for (const HidPlace& place : found) {
    const std::string name = nameOf(found.size());
    const auto [trouble, why] = hidObstacle(place, name);
    entries.push_back(
        {found.size() == 1 ? std::string{kDriver} : idOf(place), name, 6, 3, true, trouble, why});
  }
  return entries;
}

Expected<std::unique_ptr<Device>> polhemAt(std::unique_ptr<HidPort> port) {
  // a wake-up, until it answers in its own way
  std::array<std::uint8_t, kReportBytes + 1> bytes{};
  for (int round = 0; round < kRoundsToWakeUp; ++round) {
    const bool sent = port->write(polhemCurrents(Vec3::Zero()));
    const auto length = port->read(bytes, Transport::kLongestWait);
    if (!length)
      return tl::unexpected(refusal(Trouble::Lost, "The Polhem went away; plug it in again."));
    if (sent && *length <= bytes.size() && decodePolhem(std::span{bytes}.first(*length))) {
      // an answer may be 20 ms old: a round waits 5, and three that fail end it
      return threaded(polhemTransport(std::move(port)), *findRating(kDriver),
                      std::chrono::milliseconds{20});
    }
  }
  return tl::unexpected(
      refusal(Trouble::Refused,
              "What is plugged in does not answer as a Polhem does; switch the Polhem's power on, "
              "or unplug the other device that has its USB ids."));
}

std::vector<DeviceEntry> surveyPolhem() {
  std::vector<DeviceEntry> entries = polhemsAmong(findHid(kVendor));
  if (entries.empty())
    entries.push_back(
        {std::string{kDriver}, nameOf(1), 6, 3, false, Trouble::NotPluggedIn, notThere().what});
  return entries;
}

Expected<std::unique_ptr<Device>> openPolhem(const OpenRequest& request) {
  Error error = notThere();
  for (const HidPlace& place : placesAmong(findHid(kVendor))) {
    if (request.id != kDriver && request.id != idOf(place)) continue;
    auto port = openHid(place, std::string{findRating(kDriver)->name});
    auto device = port ? polhemAt(std::move(*port)) : tl::unexpected(port.error());
    if (device) return device;
    error = device.error();
  }
  return tl::unexpected(error);
}

}  // namespace haptics
