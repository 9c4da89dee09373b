// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/force_dimension.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <ctime>
#include <optional>
#include <tuple>

#include "haptics/core/clock.h"
#include "haptics/devices/shared_library.h"
#include "haptics/devices/threaded.h"

namespace haptics {
namespace {

constexpr std::string_view kDriver = "force-dimension";
constexpr const char* kName = "Force Dimension device";
Message thisDevice() { return {"force-dimension-device", {}}; }

constexpr std::tuple kOldest{3, 3, 2};           // with the watchdog
constexpr int kNewestMajor = 3;                  // another one may have other functions
constexpr int kMostUnits = 8;                    // that are counted
constexpr unsigned char kWatchdog = 40;          // of 125 us: 5 ms
constexpr std::int64_t kRoundNs = 250'000;       // the link's 4 kHz
constexpr std::int64_t kCalmNs = 1'000'000'000;  // without wish, before force comes back
constexpr std::int64_t kSlowNs = 5'000'000;      // a round that takes longer is in doubt
constexpr unsigned kRoundsToStatus = 64;         // 16 ms and more
constexpr std::chrono::milliseconds kFresh{15};
constexpr double kFarthest = 1.0;  // m from the base: no model reaches so far
constexpr double kSkew = 1e-3;     // how far from a rotation a matrix may be

// codes of the library's last error
constexpr int kErrorCommunication = 2, kErrorBusy = 3, kErrorNoDriver = 4, kErrorNoDevice = 5,
              kErrorInUse = 20;

/// Places in what it tells of a unit's state: seventeen numbers by its header. A later version may
/// have more, so there is room.
enum State { kConnected = 1, kReset = 3, kForce = 5, kForceOffCause = 14, kStates = 64 };
enum ForceOffCause {
  kNoCause = 0,
  kButton,
  kSpeed,
  kWatchdogCause,
  kSoftware,
  kUnplugged,
  kDeadMan
};

/// The library's functions that are used.
struct Dhd {
  SharedLibrary library;
  void (*version)(int*, int*, int*, int*) = nullptr;
  int (*count)() = nullptr;
  int (*open)(char) = nullptr;
  int (*close)(char) = nullptr;
  int (*brake)(char) = nullptr;
  int (*lastError)() = nullptr;
  int (*model)(char) = nullptr;
  bool (*hasActiveWrist)(char) = nullptr;
  int (*enableExpertMode)() = nullptr;
  int (*setWatchdog)(unsigned char, char) = nullptr;
  int (*enableForce)(unsigned char, char) = nullptr;
  int (*bearWeight)(int, char) = nullptr;
  int (*state)(int*, char) = nullptr;
  int (*pose)(double*, double*, double*, double (*)[3], char) = nullptr;
  unsigned (*buttons)(char) = nullptr;
  int (*setWrench)(double, double, double, double, double, double, double, char) = nullptr;
  bool (*isInitialised)(char) = nullptr;  ///< null where only libdhd is installed
};

/// A model by the library's number, and the row of the table that is nearest to it.
struct Model {
  int number;
  std::string_view name, row;
  int sensed, actuated;  ///< degrees of freedom
};
constexpr std::array kModels{
    Model{63, "Force Dimension delta.3", "delta.3", 3, 3},
    Model{33, "Force Dimension omega.3", "omega.3", 3, 3},
    Model{34, "Force Dimension omega.6", "omega.6", 6, 3},
    Model{36, "Force Dimension omega.6, left-handed", "omega.6", 6, 3},
    Model{35, "Force Dimension omega.7", "omega.7", 7, 4},
    Model{37, "Force Dimension omega.7, left-handed", "omega.7", 7, 4},
    Model{206, "Force Dimension sigma.3", "sigma.7", 3, 3},
    Model{104, "Force Dimension sigma.7", "sigma.7", 7, 7},
    Model{105, "Force Dimension sigma.7, left-handed", "sigma.7", 7, 7},
    Model{203, "Force Dimension lambda.3", "lambda.7", 3, 3},
    Model{131, "Force Dimension lambda.6", "lambda.7", 6, 6},
    Model{132, "Force Dimension lambda.6, left-handed", "lambda.7", 6, 6},
    Model{108, "Force Dimension lambda.7", "lambda.7", 7, 7},
    Model{109, "Force Dimension lambda.7, left-handed", "lambda.7", 7, 7},
};

/// Whether this program has one open.
std::atomic<bool> taken{false};

/// The maker's base F in B: its y is to the right, its z up, its x towards the user.
Mat3 axes() {
  Mat3 R_BF;
  R_BF << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return R_BF;
}

Expected<Dhd> load(std::span<const std::string> libraries) {
  auto library = SharedLibrary::open(libraries, {"force-dimension-product", {}});
  if (!library) return tl::unexpected(library.error());
  Dhd dhd{std::move(*library)};
  SharedLibrary& of = dhd.library;
  of.need(dhd.version, "dhdGetSDKVersion");
  of.need(dhd.count, "dhdGetDeviceCount");
  of.need(dhd.lastError, "dhdErrorGetLast");
  of.need(dhd.brake, "dhdStop");
  of.need(dhd.model, "dhdGetSystemType");
  of.need(dhd.hasActiveWrist, "dhdHasActiveWrist");
  of.need(dhd.enableExpertMode, "dhdEnableExpertMode");
  of.need(dhd.setWatchdog, "dhdSetWatchdog");
  of.need(dhd.enableForce, "dhdEnableForce");
  of.need(dhd.bearWeight, "dhdSetGravityCompensation");
  of.need(dhd.state, "dhdGetStatus");
  of.need(dhd.pose, "dhdGetPositionAndOrientationFrame");
  of.need(dhd.buttons, "dhdGetButtonMask");
  of.need(dhd.setWrench, "dhdSetForceAndTorqueAndGripperForce");

  // only the robotics library knows what is initialised, of what it has opened itself
  of.find(dhd.isInitialised, "drdIsInitialized");
  const bool robotics = dhd.isInitialised != nullptr;
  of.need(dhd.open, robotics ? "drdOpenID" : "dhdOpenID");
  of.need(dhd.close, robotics ? "drdClose" : "dhdClose");

  if (!of.lacks().empty())
    return tl::unexpected(
        refusal(Trouble::NoLibrary,
                {"library-old", {{"force-dimension-product", {}}, of.name(), of.lacks()}}));
  int major = 0, minor = 0, release = 0, revision = 0;
  dhd.version(&major, &minor, &release, &revision);
  if (std::tuple{major, minor, release} < kOldest || major > kNewestMajor)
    return tl::unexpected(
        refusal(Trouble::NoLibrary,
                {"force-dimension-library-version",
                 {std::to_string(major), std::to_string(minor), std::to_string(release)}}));
  return dhd;
}

/// One unit. Made when it is open; closes it.
class ForceDimension final : public Transport {
 public:
  ForceDimension(Dhd dhd, int unit) : dhd_{std::move(dhd)}, id_{static_cast<char>(unit)} {}
  ~ForceDimension() override {
    send({});
    dhd_.brake(id_);
    dhd_.close(id_);
    taken.store(false);
  }
  ForceDimension(const ForceDimension&) = delete;
  ForceDimension& operator=(const ForceDimension&) = delete;

  /// Finds out what it is and makes it safe; then it can exchange.
  Expected<DeviceRating> prepare() {
    const int number = dhd_.model(id_);
    const auto model = std::find_if(kModels.begin(), kModels.end(),
                                    [number](const Model& m) { return m.number == number; });
    if (model == kModels.end())
      return tl::unexpected(
          refusal(Trouble::Refused, {"force-dimension-model-unknown", {std::to_string(number)}}));
    const std::string name{model->name};

    // without the watchdog a killed program would leave the last force on
    if (dhd_.enableExpertMode() < 0 || dhd_.setWatchdog(kWatchdog, id_) < 0)
      return tl::unexpected(refusal(Trouble::Refused, {"force-dimension-no-watchdog", {name}}));
    dhd_.bearWeight(1, id_);  // where it fails the hand bears it

    DeviceRating rating = *findRating(model->row);
    rating.name = model->name;
    rating.sensed = model->sensed;
    rating.actuated = model->actuated;
    turns_ = model->sensed >= 6;
    torques_ = model->actuated >= 6 && dhd_.hasActiveWrist(id_);
    if (!torques_) {
      rating.torque = rating.angular_stiffness = 0.0;
      rating.actuated -= model->actuated >= 6 ? 3 : 0;
    }
    return rating;
  }

  DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept override {
    // first, while the wrench is new; zero is the answer to every doubt of the round before
    const bool sent = send(ready_ ? wrench_B : Wrench{});
    const std::int64_t now = monotonicNs();
    if (!wrench_B.force.isZero(0.0) || !wrench_B.torque.isZero(0.0)) asked_ns_ = now;
    const bool calm = now - asked_ns_ > kCalmNs;
    if (rounds_++ % kRoundsToStatus == 0 || !answered_) told_ = look(calm);
    pace();
    answered_ = poll(reading) && told_;

    // after a pause force comes back only when none is asked for: it begins without a jump
    paused_ = state_ != Trouble::None || (paused_ && !calm);
    // the library has no bound
    const bool slow = monotonicNs() - now > kSlowNs;
    ready_ = answered_ && !paused_ && !slow;
    reading.trouble = paused_ && state_ == Trouble::None ? Trouble::ForceOff : state_;
    if (state_ == Trouble::Lost) return DeviceStatus::Lost;
    if (!sent || !answered_) return DeviceStatus::Stale;
    return ready_ ? DeviceStatus::Ok : DeviceStatus::NotReady;
  }

 private:
  /// Waits until the link can carry the next round: the library answers at once where it has data
  /// that are recent.
  void pace() noexcept {
    // a round that was a little late makes none after it late
    next_ns_ = std::max(next_ns_ + kRoundNs, monotonicNs() - kRoundNs);
    sleepUntil(next_ns_);
  }

  /// Reads pose and buttons. False: nothing came, or what cannot be; then `reading` stays.
  bool poll(DeviceReading& reading) noexcept {
    const double nan = std::nan("");
    Vec3 p_F{nan, nan, nan};
    double frame[3][3] = {{nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}};
    if (dhd_.pose(&p_F.x(), &p_F.y(), &p_F.z(), frame, id_) < 0) return false;
    if (!p_F.allFinite() || p_F.norm() > kFarthest) return false;

    Mat3 R_FD = Mat3::Identity();
    if (turns_) {
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) R_FD(row, column) = frame[row][column];
      const double skew = (R_FD * R_FD.transpose() - Mat3::Identity()).norm();
      if (!(skew < kSkew) || !(R_FD.determinant() > 0.0)) return false;
    }
    reading.time_ns = monotonicNs();
    reading.X_BD = poseOf(R_BF_ * p_F, Quat{Mat3{R_BF_ * R_FD * R_BF_.transpose()}});
    reading.buttons = dhd_.buttons(id_);
    return true;
  }

  /// Asks for the unit's state, and switches its force on where it may be. False: no answer.
  bool look(bool calm) noexcept {
    std::array<int, kStates> state{};
    state[kConnected] = state[kForce] = 1;
    if (dhd_.state(state.data(), id_) < 0) return false;
    if (state[kConnected] == 0 || state[kForceOffCause] == kUnplugged) {
      state_ = Trouble::Lost;
      return true;
    }
    if (state[kReset] != 0 ||
        (state_ == Trouble::NeedsCalibration && dhd_.isInitialised && !dhd_.isInitialised(id_))) {
      state_ = Trouble::NeedsCalibration;
      return true;
    }
    if (state[kForce] != 0) {
      state_ = Trouble::None;
      return true;
    }
    // what its user has switched off stays off
    const int cause = state[kForceOffCause];
    if (calm && cause != kButton && cause != kDeadMan) dhd_.enableForce(1, id_);
    state_ = Trouble::ForceOff;
    return true;
  }

  /// Sends it, the grip's force zero. False: it was not taken.
  bool send(const Wrench& wrench_B) noexcept {
    if (!wrench_B.force.allFinite() || !wrench_B.torque.allFinite()) return send({});
    const Vec3 f = R_BF_.transpose() * wrench_B.force;
    const Vec3 t = torques_ ? Vec3{R_BF_.transpose() * wrench_B.torque} : Vec3{Vec3::Zero()};
    return dhd_.setWrench(f.x(), f.y(), f.z(), t.x(), t.y(), t.z(), 0.0, id_) >= 0;
  }

  const Dhd dhd_;
  const char id_;
  const Mat3 R_BF_ = axes();
  bool turns_ = false, torques_ = false;
  Trouble state_ = Trouble::NeedsCalibration;  ///< until it was looked at
  bool paused_ = true;
  bool ready_ = false;         ///< nothing of the last round speaks against a force
  std::int64_t asked_ns_ = 0;  ///< when a wrench unlike zero was asked for last
  bool told_ = false;          ///< it has answered when it was last asked for its state
  bool answered_ = false;      ///< that, and its pose came in the last round
  unsigned rounds_ = 0;
  std::int64_t next_ns_ = 0;
};

Error notOpened(int error) {
  switch (error) {
    case kErrorInUse:
    case kErrorBusy:
      return refusal(Trouble::InUse, {"device-in-use", {thisDevice()}});
    case kErrorNoDriver:
      return refusal(Trouble::NoPermission, {"device-not-permitted", {thisDevice()}});
    case kErrorNoDevice:
      return refusal(Trouble::NotPluggedIn, {"device-gone", {thisDevice()}});
    case kErrorCommunication:
      return refusal(Trouble::NoPermission, {"force-dimension-no-answer", {}});
    default:
      return refusal(Trouble::Refused,
                     {"device-not-opened", {thisDevice(), std::to_string(error)}});
  }
}

/// Which of several an id means, from 0 on.
std::optional<int> unitOf(std::string_view id) {
  if (id == kDriver) return 0;
  if (!id.starts_with(std::string{kDriver} + ":")) return std::nullopt;
  id.remove_prefix(kDriver.size() + 1);
  int unit = -1;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), unit);
  if (error != std::errc{} || end != id.data() + id.size()) return std::nullopt;
  if (unit < 0 || unit >= kMostUnits) return std::nullopt;
  return unit;
}

Expected<std::unique_ptr<Device>> openUnit(int unit, std::span<const std::string> libraries) {
  auto dhd = load(libraries);
  if (!dhd) return tl::unexpected(dhd.error());
  if (dhd->count() <= unit)
    return tl::unexpected(
        refusal(Trouble::NotPluggedIn, {"device-not-plugged-in", {thisDevice()}}));
  if (dhd->open(static_cast<char>(unit)) < 0) return tl::unexpected(notOpened(dhd->lastError()));

  auto transport = std::make_unique<ForceDimension>(std::move(*dhd), unit);
  const auto rating = transport->prepare();
  if (!rating) return tl::unexpected(rating.error());
  return threaded(std::move(transport), *rating, kFresh, true);
}

/// The names under which the maker installs it; libdrd has all that libdhd has.
std::span<const std::string> forceDimensionLibraries() {
  static const std::array<std::string, 4> names{"libdrd.so.3", "libdrd.so", "libdhd.so.3",
                                                "libdhd.so"};
  return names;
}

}  // namespace

std::vector<DeviceEntry> surveyForceDimension(std::span<const std::string> libraries) {
  DeviceEntry entry{.id = std::string{kDriver}, .name = kName, .sensed = 7, .actuated = 7};
  // the library is not asked while a thread of ours may be in it
  if (taken.load()) {
    entry.present = true;
    entry.trouble = Trouble::InUse;
    entry.why = {"device-open", {thisDevice()}};
    return {entry};
  }
  const auto dhd = load(libraries);
  if (!dhd) {
    entry.trouble = Trouble::NoLibrary;
    entry.why = dhd.error().message;
    return {entry};
  }
  const int count = std::clamp(dhd->count(), 0, kMostUnits);
  if (count == 0) {
    entry.trouble = Trouble::NotPluggedIn;
    entry.why = {"device-not-plugged-in", {thisDevice()}};
    return {entry};
  }
  std::vector<DeviceEntry> entries;
  entry.present = true;
  entry.why = {"force-dimension-model-told-later", {}};
  for (int unit = 0; unit < count; ++unit) {
    entry.id = std::string{kDriver} + ":" + std::to_string(unit);
    entry.name = kName + (count > 1 ? " " + std::to_string(unit + 1) : std::string{});
    entries.push_back(entry);
  }
  return entries;
}

Expected<std::unique_ptr<Device>> openForceDimension(const OpenRequest& request,
                                                     std::span<const std::string> libraries) {
  const std::optional<int> unit = unitOf(request.id);
  if (!unit)
    return tl::unexpected(
        Error{Error::Kind::NotFound, {"device-unknown", {request.id}}, "unknown-device"});
  if (taken.exchange(true))
    return tl::unexpected(refusal(Trouble::InUse, {"device-open", {thisDevice()}}));
  auto device = openUnit(*unit, libraries);
  if (!device) taken.store(false);
  return device;
}

std::vector<DeviceEntry> surveyForceDimension() {
  return surveyForceDimension(forceDimensionLibraries());
}

Expected<std::unique_ptr<Device>> openForceDimension(const OpenRequest& request) {
  return openForceDimension(request, forceDimensionLibraries());
}

}  // namespace haptics
