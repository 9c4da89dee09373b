// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/capstan_board.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>

#include "haptics/core/clock.h"

namespace haptics {
namespace {

constexpr std::uint16_t kRawPage = 0xffab, kRawUsage = 0x0200;

constexpr std::size_t kOldReport = 8;  // bytes, of firmware before October 2019
constexpr int kButtonFold = 10'000;
constexpr std::int16_t kSetEncoders = 1;  // a command; 0: currents

constexpr int kNearRest = 100;       // counts
constexpr int kLongestJump = 2'000;  // counts between two answers: half a turn of a motor, or one
constexpr int kRoundsToSet = 20;     // rounds that setting may take
constexpr int kMostAnswers = 8;      // a round
constexpr int kStill = 20;           // counts
constexpr int kLastRounds = 10;      // of 5 ms
constexpr std::int64_t kHoldNs = 1'000'000'000, kLongestWakeUpNs = 500'000'000;

// one more than the longest report: what is too long shows
using Buffer = std::array<std::uint8_t, kTeensyBoard.report + 1>;

BoardCommand commandOf(const std::array<std::int16_t, 7>& words) noexcept {
  BoardCommand command{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto word = static_cast<std::uint16_t>(words[i]);
    command[1 + 2 * i] = static_cast<std::uint8_t>(word & 0xff);
    command[2 + 2 * i] = static_cast<std::uint8_t>(word >> 8);
  }
  return command;
}

class ArmTransport final : public Transport {
 public:
  ArmTransport(const CapstanArm& arm, std::unique_ptr<HidPort> port, std::size_t report,
               MonotonicClock clock)
      : arm_{arm}, port_{std::move(port)}, report_{report}, clock_{clock} {}
  ~ArmTransport() override {
    for (int round = 0; round < kLastRounds && !send(boardCurrents(Vec3::Zero())); ++round)
      if (!port_->read(bytes_, kLongestWait)) return;
  }
  ArmTransport(const ArmTransport&) = delete;
  ArmTransport& operator=(const ArmTransport&) = delete;

  DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept override {
    if (!send(next(wrench_B))) {
      J_B_.reset();
      // the round is waited out all the same: what is well again in a moment is not Lost
      return port_->read(bytes_, kLongestWait) ? DeviceStatus::Stale : DeviceStatus::Lost;
    }
    bool gone = false;
    const std::optional<BoardReport> report = newest(gone);
    if (!report) {
      J_B_.reset();
      return gone ? DeviceStatus::Lost : DeviceStatus::Stale;
    }
    return takeIn(*report, reading);
  }

 private:
  enum class Zero : std::uint8_t { Unset, Setting, Set, Gone };

  bool send(const BoardCommand& command) noexcept {
    return port_->write(std::span{command}.first(1 + report_));
  }

  BoardCommand next(const Wrench& wrench_B) const noexcept {
    if (zero_ == Zero::Setting) return boardSets(arm_.rest);
    return boardCurrents(J_B_ ? currentsFor(arm_, wrench_B.force, *J_B_) : Vec3{Vec3::Zero()});
  }

  /// The last of the answers that are there; waits for the first.
  std::optional<BoardReport> newest(bool& gone) noexcept {
    std::optional<BoardReport> report;
    std::chrono::milliseconds wait = kLongestWait;
    for (int i = 0; i < kMostAnswers; ++i) {
      const auto length = port_->read(bytes_, wait);
      gone = !length;
      if (!length) return std::nullopt;
      if (*length == 0) break;
      if (*length == report_) report = decodeBoard(std::span{bytes_}.first(report_));
      wait = std::chrono::milliseconds{0};
    }
    return report;
  }

  DeviceStatus takeIn(const BoardReport& report, DeviceReading& reading) noexcept {
    const std::optional<ArmState> state = arm_.state(report.counts);
    reading.time_ns = clock_();
    settle(report, state.has_value(), reading.time_ns);
    last_ = report;

    reading.buttons = report.button ? 1 : 0;
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
    J_B_ = state->J_B;
    reading.X_BD = state->X_BD;
    reading.trouble = Trouble::None;
    return DeviceStatus::Ok;
  }

  /// Whether the counts mean anything, after this report.
  void settle(const BoardReport& report, bool makes_an_arm, std::int64_t now) noexcept {
    switch (zero_) {
      case Zero::Unset:
        if (isHeldStill(report, now) || report.asks) beginSetting();
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

  /// Whether the stylus' button has been down long enough, pressed here, with the arm still.
  bool isHeldStill(const BoardReport& report, std::int64_t now) noexcept {
    const bool pressed = report.button && last_ && !last_->button;
    if (!report.button)
      held_.reset();
    else if (pressed || (held_ && furthest(report.counts, held_->counts) > kStill))
      held_ = {report.counts, now};
    return held_ && now - held_->since_ns >= kHoldNs;
  }

  void beginSetting() noexcept {
    zero_ = Zero::Setting;
    rounds_ = 0;
    held_.reset();
  }

  static int furthest(const BoardCounts& a, const BoardCounts& b) noexcept {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  }

  bool atRest(const BoardReport& report) const noexcept {
    return furthest(report.counts, arm_.rest) <= kNearRest;
  }

  bool jumped(const BoardReport& report) const noexcept {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::abs(report.counts[i] - last_->counts[i]) > kLongestJump) return true;
    return false;
  }

  const CapstanArm& arm_;
  std::unique_ptr<HidPort> port_;
  std::size_t report_;  ///< bytes
  MonotonicClock clock_;
  Buffer bytes_{};
  Zero zero_ = Zero::Unset;
  int rounds_ = 0;
  struct Held {
    BoardCounts counts;
    std::int64_t since_ns;
  };
  std::optional<Held> held_;  ///< the stylus' button, and where the arm stood
  std::optional<BoardReport> last_;
  std::optional<Mat3> J_B_;  ///< of the newest answer; none: no force
};

std::string nameOf(const CapstanArm& arm) { return std::string{findRating(arm.driver)->name}; }

/// A place and the board that its ids say it is.
struct Found {
  HidPlace place;
  std::size_t report;
};

std::vector<Found> boardsAmong(const CapstanArm& arm, std::span<const HidPlace> places) {
  std::vector<Found> found;
  for (const HidPlace& place : places)
    for (const BoardIds& board : arm.boards)
      if (place.vendor == board.vendor && place.product == board.product &&
          place.usage_page == kRawPage && place.usage == kRawUsage)
        found.push_back({place, board.report});
  return found;
}

std::vector<HidPlace> placesFor(const CapstanArm& arm) {
  std::vector<HidPlace> places;
  for (const BoardIds& board : arm.boards)
    std::ranges::move(findHid(board.vendor), std::back_inserter(places));
  return places;
}

std::string idOf(const CapstanArm& arm, const HidPlace& place) {
  return std::string{arm.driver} + ":" + place.path;
}

Error notThere(const CapstanArm& arm) {
  return refusal(Trouble::NotPluggedIn, {"device-not-plugged-in", {nameOf(arm)}});
}

}  // namespace

std::optional<BoardReport> decodeBoard(std::span<const std::uint8_t> report) noexcept {
  if (report.size() != kTeensyBoard.report && report.size() != kMbedBoard.report)
    return std::nullopt;
  const auto word = [&](std::size_t i) {
    return static_cast<std::int16_t>(report[2 * i] | report[2 * i + 1] << 8);
  };
  BoardReport decoded;
  for (std::size_t i = 0; i < decoded.counts.size(); ++i) decoded.counts[i] = word(i);
  std::int16_t& d = decoded.counts[3];
  decoded.button = d > kButtonFold / 2;
  if (decoded.button) d = static_cast<std::int16_t>(d - kButtonFold);
  decoded.asks = word(6) == 1;
  return decoded;
}

BoardCommand boardCurrents(const Vec3& currents) noexcept {
  if (!currents.allFinite()) return {};
  const double most = currents.cwiseAbs().maxCoeff();
  // what is almost infinite is shortened before it can be multiplied
  const Vec3 capped =
      most > kBoardMostCurrent ? Vec3{currents / most * kBoardMostCurrent} : currents;
  std::array<std::int16_t, 7> words{};
  for (Eigen::Index i = 0; i < 3; ++i)
    words[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(capped[i] * 1e3));
  return commandOf(words);
}

BoardCommand boardSets(const BoardCounts& counts) noexcept {
  return commandOf(
      {counts[3], counts[4], counts[5], kSetEncoders, counts[0], counts[1], counts[2]});
}

Mat3 makersAxes() noexcept {
  Mat3 R_BH;
  R_BH << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return R_BH;
}

Vec3 currentsFor(const CapstanArm& arm, const Vec3& force_B, const Mat3& J_B) noexcept {
  Vec3 currents = J_B.transpose() * force_B;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto motor = static_cast<std::size_t>(i);
    currents[i] *= arm.ratio[motor] / arm.torque_constant[motor];
  }
  return currents;
}

std::unique_ptr<Transport> armTransport(const CapstanArm& arm, std::unique_ptr<HidPort> port,
                                        std::size_t report, MonotonicClock clock) {
  return std::make_unique<ArmTransport>(arm, std::move(port), report, clock);
}

std::vector<DeviceEntry> armsAmong(const CapstanArm& arm, std::span<const HidPlace> places) {
  const std::vector<Found> found = boardsAmong(arm, places);
  const DeviceRating& rating = *findRating(arm.driver);
  const std::string name = nameOf(arm);
  std::vector<DeviceEntry> entries;
  for (const auto& [place, report] : found) {
    auto [trouble, why] = hidObstacle(place, name);
    if (trouble == Trouble::None) why = {"capstan-which-arm", {}};
    entries.push_back({idOf(arm, place), name, rating.sensed, rating.actuated, true, trouble, why});
  }
  return entries;
}

Expected<std::unique_ptr<Device>> armAt(const CapstanArm& arm, std::unique_ptr<HidPort> port,
                                        std::size_t report, MonotonicClock clock) {
  const std::string name = nameOf(arm);
  // a wake-up, until it answers in its own way
  const BoardCommand zero = boardCurrents(Vec3::Zero());
  Buffer bytes{};
  bool old = false;
  const std::int64_t begun = clock();
  while (clock() - begun < kLongestWakeUpNs) {
    const bool sent = port->write(std::span{zero}.first(1 + report));
    const auto length = port->read(bytes, Transport::kLongestWait);
    if (!length) return tl::unexpected(refusal(Trouble::Lost, {"device-gone", {name}}));
    old = old || *length == kOldReport;
    if (sent && *length == report) {
      // an answer may be 20 ms old: a round waits 5, and three that fail end it
      return threaded(armTransport(arm, std::move(port), report, clock), *findRating(arm.driver),
                      std::chrono::milliseconds{20});
    }
  }
  if (old) return tl::unexpected(refusal(Trouble::Refused, {"capstan-firmware-old", {name}}));
  return tl::unexpected(refusal(Trouble::Refused, {"capstan-no-answer", {name}}));
}

std::vector<DeviceEntry> surveyArms(const CapstanArm& arm) {
  std::vector<DeviceEntry> entries = armsAmong(arm, placesFor(arm));
  const DeviceRating& rating = *findRating(arm.driver);
  if (entries.empty())
    entries.push_back({std::string{arm.driver}, nameOf(arm), rating.sensed, rating.actuated, false,
                       Trouble::NotPluggedIn, notThere(arm).message});
  return entries;
}

Expected<std::unique_ptr<Device>> openArm(const CapstanArm& arm, const OpenRequest& request) {
  Error error = notThere(arm);
  for (const auto& [place, report] : boardsAmong(arm, placesFor(arm))) {
    if (request.id != arm.driver && request.id != idOf(arm, place)) continue;
    auto port = openHid(place, nameOf(arm));
    auto device = port ? armAt(arm, std::move(*port), report) : tl::unexpected(port.error());
    if (device) return device;
    error = device.error();
  }
  return tl::unexpected(error);
}

}  // namespace haptics
