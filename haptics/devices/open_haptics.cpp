// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/open_haptics.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <thread>

#include "haptics/devices/relay.h"
#include "haptics/devices/shared_library.h"

namespace haptics {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kDriver = "openhaptics";
constexpr const char* kName = "Touch or PHANTOM (OpenHaptics)";
constexpr const char* kProduct = "OpenHaptics";
Message thisDevice() { return {"openhaptics-device", {}}; }

constexpr std::chrono::milliseconds kFresh = 15ms, kSilent = 500ms;
constexpr std::chrono::milliseconds kLastCall = 100ms;  // that closing waits for zero to be sent
constexpr int kCallsToCalibration = 100;                // between two looks at it
constexpr int kMostErrors = 32;                         // that are taken off the stack in one call
constexpr std::int64_t kCalmNs = 1'000'000'000;  // without error or wish, before force comes back
constexpr double kMetresPerMm = 1e-3;
constexpr double kFarthest = 2.0;   // m from the base: no model reaches so far
constexpr double kSkew = 1e-3;      // how far from a rotation a matrix may be
constexpr double kPlausible = 3.0;  // by how much a unit may differ from the table's

// what can be asked for, set, and switched on
constexpr unsigned kButtons = 0x2000, kTransform = 0x2052, kModel = 0x2501, kInputs = 0x2553,
                   kOutputs = 0x2554, kStyle = 0x2555, kMaxStiffness = 0x2602, kMaxForce = 0x2603,
                   kMaxContinuousForce = 0x2604, kMaxTorque = 0x2622, kForce = 0x2700,
                   kTorque = 0x2701, kForceOutput = 0x4000, kForceClamping = 0x4001;
constexpr unsigned kNoUnit = 0xFFFFFFFF;
constexpr unsigned kCalibrated = 0x5000, kCanUpdate = 0x5001;  // 0x5002: by hand
constexpr int kAutomatic = 2, kInkwell = 4;                    // styles of calibration, bits
constexpr unsigned kDone = 0, kGoOn = 1;
constexpr unsigned short kFirst = 0xFFFF;  // priority

// its errors
constexpr unsigned kWarmMotors = 0x200, kDeviceErrors = 0x300, kAlreadyOpen = 0x301, kLink = 0x302,
                   kDeviceErrorsEnd = 0x3FF, kLicence = 0x600;

/// An error as the library returns it: by value, so all of it is declared.
struct HdError {
  unsigned code;
  int inner;
  unsigned unit;
};

using Call = unsigned (*)(void*);

/// The library's functions that are used.
struct Hd {
  SharedLibrary library;
  unsigned (*open)(const char*) = nullptr;
  void (*close)(unsigned) = nullptr;
  void (*makeCurrent)(unsigned) = nullptr;
  void (*begin)(unsigned) = nullptr;
  void (*end)(unsigned) = nullptr;
  HdError (*error)() = nullptr;
  void (*enable)(unsigned) = nullptr;
  void (*disable)(unsigned) = nullptr;
  void (*doubles)(unsigned, double*) = nullptr;
  void (*integers)(unsigned, int*) = nullptr;
  const char* (*words)(unsigned) = nullptr;
  void (*set)(unsigned, const double*) = nullptr;
  unsigned (*calibration)() = nullptr;
  void (*calibrate)(unsigned) = nullptr;
  unsigned long (*schedule)(Call, void*, unsigned short) = nullptr;
  void (*unschedule)(unsigned long) = nullptr;
  void (*start)() = nullptr;
  void (*stop)() = nullptr;
};

/// Whether this program has one open.
std::atomic<bool> taken{false};

Expected<Hd> load(std::span<const std::string> libraries) {
  auto library = SharedLibrary::open(libraries, kProduct);
  if (!library) return tl::unexpected(library.error());
  Hd hd{std::move(*library)};
  SharedLibrary& of = hd.library;
  of.need(hd.open, "hdInitDevice");
  of.need(hd.close, "hdDisableDevice");
  of.need(hd.makeCurrent, "hdMakeCurrentDevice");
  of.need(hd.begin, "hdBeginFrame");
  of.need(hd.end, "hdEndFrame");
  of.need(hd.error, "hdGetError");
  of.need(hd.enable, "hdEnable");
  of.need(hd.disable, "hdDisable");
  of.need(hd.doubles, "hdGetDoublev");
  of.need(hd.integers, "hdGetIntegerv");
  of.need(hd.words, "hdGetString");
  of.need(hd.set, "hdSetDoublev");
  of.need(hd.calibration, "hdCheckCalibration");
  of.need(hd.calibrate, "hdUpdateCalibration");
  of.need(hd.schedule, "hdScheduleAsynchronous");
  of.need(hd.unschedule, "hdUnschedule");
  of.need(hd.start, "hdStartScheduler");
  of.need(hd.stop, "hdStopScheduler");
  if (!of.lacks().empty())
    return tl::unexpected(
        refusal(Trouble::NoLibrary, {"library-old", {kProduct, of.name(), of.lacks()}}));
  return hd;
}

bool isFault(unsigned error) { return error >= kDeviceErrors && error <= kDeviceErrorsEnd; }

/// How bad an error is: a fault of the device, anything else, warm motors, none.
int severity(unsigned error) {
  if (error == 0) return 0;
  if (error == kWarmMotors) return 1;
  return isFault(error) ? 3 : 2;
}

/// Takes the errors off the stack: the worst, 0 if there is none. Bounded, whatever the library
/// does.
unsigned worstError(const Hd& hd) {
  unsigned worst = 0;
  for (int n = 0; n < kMostErrors; ++n) {
    const unsigned code = hd.error().code;
    if (code == 0) break;
    if (severity(code) > severity(worst)) worst = code;
  }
  return worst;
}

/// The row of the table for what a unit calls itself [U]; where that is not known, the weakest.
const DeviceRating& rowFor(const char* words) {
  std::string model{words != nullptr ? words : ""};
  for (char& letter : model)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const auto has = [&model](const char* word) { return model.find(word) != std::string::npos; };
  if (has("premium")) return *findRating(has("3.0") ? "premium-3.0" : "premium-1.5");
  if (has("desktop") || has("touch x")) return *findRating("desktop");
  return *findRating(has("omni") ? "omni" : "touch");
}

/// A number that the library tells, the first where it is several: there is room for more than any
/// is documented to have. 0 where there is none.
double asked(const Hd& hd, unsigned what) {
  std::array<double, 64> values{};
  hd.doubles(what, values.data());
  return worstError(hd) == 0 ? values[0] : 0.0;
}
int askedCount(const Hd& hd, unsigned what) {
  std::array<int, 64> values{};
  hd.integers(what, values.data());
  return worstError(hd) == 0 ? values[0] : 0;
}

/// A number that the unit tells of itself, times `unit`; the table's where it tells none that can
/// be.
double told(const Hd& hd, unsigned what, double unit, double table) {
  const double value = asked(hd, what) * unit;
  const bool fits = value >= table / kPlausible && value <= table * kPlausible;
  return fits ? value : table;
}

/// What the unit that is current can do.
DeviceRating ratingOf(const Hd& hd) {
  const char* const words = hd.words(kModel);
  DeviceRating rating = rowFor(worstError(hd) == 0 ? words : nullptr);
  if (askedCount(hd, kInputs) == 3) rating.sensed = 3;
  rating.stiffness = told(hd, kMaxStiffness, 1.0 / kMetresPerMm, rating.stiffness);
  rating.force = told(hd, kMaxForce, 1.0, rating.force);
  rating.continuous_force =
      std::min(told(hd, kMaxContinuousForce, 1.0, rating.continuous_force), rating.force);

  // torque in another unit would be a thousand times too strong
  const double torque = asked(hd, kMaxTorque) * 1e-3;
  const bool torques = askedCount(hd, kOutputs) >= 6 && torque >= rating.torque / kPlausible &&
                       torque <= rating.torque * kPlausible;
  if (!torques) {
    rating.torque = rating.angular_stiffness = 0.0;
    rating.actuated = 3;
  }
  return rating;
}

/// A unit that is open, and what the library's thread does with it.
class Unit {
 public:
  Unit(Hd hd, unsigned unit) : hd_{std::move(hd)}, unit_{unit} {}

  Relay& relay() { return relay_; }
  const DeviceRating& rating() const { return rating_; }

  /// Finds out what it is, and has the library call from now on. Refused if it does not.
  Expected<void> begin() {
    worstError(hd_);
    rating_ = ratingOf(hd_);
    style_ = askedCount(hd_, kStyle);

    hd_.enable(kForceOutput);
    hd_.enable(kForceClamping);
    if (const unsigned error = worstError(hd_)) return refused(error);
    call_ = hd_.schedule(&Unit::called, this, kFirst);
    if (const unsigned error = worstError(hd_)) return refused(error);
    scheduled_ = true;
    hd_.start();
    if (const unsigned error = worstError(hd_)) return refused(error);
    return {};
  }

  /// Zero is sent, the library's thread ended, the force switched off and the unit closed. False:
  /// the library has not called any more, and may still.
  bool end() {
    relay_.stop();
    ending_.store(true);
    for (auto waited = 0ms; scheduled_ && !ended_.load() && waited < kLastCall; waited += 1ms)
      std::this_thread::sleep_for(1ms);
    if (scheduled_) {
      hd_.stop();
      hd_.unschedule(call_);
    }
    // where no call has sent zero it is sent from here
    hd_.makeCurrent(unit_);
    if (!ended_.load()) {
      hd_.begin(unit_);
      send({});
      hd_.end(unit_);
    }
    hd_.disable(kForceOutput);
    hd_.close(unit_);
    worstError(hd_);
    return !scheduled_ || ended_.load();
  }

 private:
  tl::unexpected<Error> refused(unsigned error) const;

  static unsigned called(void* unit) noexcept { return static_cast<Unit*>(unit)->call(); }

  unsigned call() noexcept {
    if (ended_.load()) return kDone;
    const bool last = ending_.load();
    hd_.makeCurrent(unit_);
    hd_.begin(unit_);
    DeviceReading reading = reading_;
    const bool polled = poll(reading);
    const Wrench due = relay_.due();
    send(polled && !last && forceMay() ? due : Wrench{});
    hd_.end(unit_);

    DeviceStatus status = judge(worstError(hd_), polled);
    if (status == DeviceStatus::Ok) {
      settle(!relay_.asked());
      if (!forceMay()) status = DeviceStatus::NotReady;
    }
    reading.trouble = status == DeviceStatus::Lost ? Trouble::Lost : trouble();
    if (status != DeviceStatus::Stale) reading_ = reading;
    relay_.came(status, reading);
    if (last) ended_.store(true);
    return last ? kDone : kGoOn;
  }

  bool forceMay() const noexcept { return calibrated_ && error_ns_ == 0; }

  Trouble trouble() const noexcept {
    if (!calibrated_) return Trouble::NeedsCalibration;
    if (hot_) return Trouble::MotorsHot;
    return error_ns_ != 0 ? Trouble::ForceOff : Trouble::None;
  }

  /// What came of a frame. After an error the force is off from the next frame on, until settle()
  /// has it back.
  DeviceStatus judge(unsigned error, bool polled) noexcept {
    if (error != 0) error_ns_ = monotonicNs();
    if (error == kWarmMotors) hot_ = true;
    if (isFault(error)) return DeviceStatus::Lost;
    return polled && (error == 0 || error == kWarmMotors) ? DeviceStatus::Ok : DeviceStatus::Stale;
  }

  /// Looks at the calibration now and then, and has the force back where it may be: not while one
  /// is asked for, so that none begins with a jump.
  void settle(bool asked_zero) noexcept {
    const std::int64_t now = monotonicNs();
    if (calls_++ % kCallsToCalibration == 0) {
      const unsigned calibration = hd_.calibration();
      if (calibration == kCanUpdate && (style_ & (kAutomatic | kInkwell)) != 0)
        hd_.calibrate(static_cast<unsigned>(style_ & kInkwell ? kInkwell : kAutomatic));
      worstError(hd_);  // what it says of a calibration is no fault of a frame
      calibrated_ = calibration == kCalibrated;
      if (!calibrated_) error_ns_ = now;
    }
    if (error_ns_ == 0) return;
    if (!asked_zero) {
      error_ns_ = now;
    } else if (now - error_ns_ > kCalmNs) {
      error_ns_ = 0;
      hot_ = false;
    }
  }

  /// Reads pose and buttons within a frame. False: what came cannot be; then `reading` stays.
  bool poll(DeviceReading& reading) noexcept {
    std::array<double, 64> columns;
    columns.fill(std::nan(""));
    hd_.doubles(kTransform, columns.data());
    std::array<int, 64> buttons{};
    hd_.integers(kButtons, buttons.data());
    const Eigen::Map<const Eigen::Matrix4d> X{columns.data()};
    const Vec3 p = X.block<3, 1>(0, 3) * kMetresPerMm;
    const Mat3 R = rating_.sensed >= 6 ? Mat3{X.block<3, 3>(0, 0)} : Mat3{Mat3::Identity()};
    const double skew = (R * R.transpose() - Mat3::Identity()).norm();
    if (!p.allFinite() || !(p.norm() < kFarthest)) return false;
    if (!(skew < kSkew) || !(R.determinant() > 0.0)) return false;
    reading.X_BD = poseOf(p, Quat{R});
    reading.buttons = static_cast<std::uint32_t>(buttons[0]);
    reading.time_ns = monotonicNs();
    return true;
  }

  /// Within a frame, which carries it to the motors when it ends.
  void send(const Wrench& wrench_B) noexcept {
    hd_.set(kForce, wrench_B.force.data());
    if (rating_.torque <= 0.0) return;
    const Vec3 torque_mNm = wrench_B.torque * 1e3;
    hd_.set(kTorque, torque_mNm.data());
  }

  const Hd hd_;
  const unsigned unit_;
  DeviceRating rating_;
  Relay relay_{kFresh, kSilent};
  unsigned long call_ = 0;
  bool scheduled_ = false;
  int style_ = 0;  ///< of calibration
  std::atomic<bool> ending_{false}, ended_{false};
  // the library's thread
  DeviceReading reading_;
  bool calibrated_ = false;    ///< as far as was looked
  bool hot_ = false;           ///< the error was warm motors
  std::int64_t error_ns_ = 0;  ///< when an error, or a wish for force after it, came last; 0: over
  unsigned calls_ = 0;
};

Error notOpened(unsigned error) {
  if (error == kAlreadyOpen) return refusal(Trouble::InUse, {"device-in-use", {thisDevice()}});
  if (error == kLicence) return refusal(Trouble::Refused, {"openhaptics-no-licence", {}});
  if (isFault(error))
    return refusal(Trouble::NotPluggedIn, error == kLink ? Message{"openhaptics-no-answer", {}}
                                                         : Message{"openhaptics-not-found", {}});
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "0x%04x", error);
  return refusal(Trouble::Refused, {"device-not-opened", {thisDevice(), std::string{code.data()}}});
}

tl::unexpected<Error> Unit::refused(unsigned error) const {
  return tl::unexpected(notOpened(error));
}

class OpenHaptics final : public Device {
 public:
  explicit OpenHaptics(std::unique_ptr<Unit> unit) : unit_{std::move(unit)} {}
  ~OpenHaptics() override {
    // what a late call may still touch is kept for it
    static auto& kept = *new std::vector<std::unique_ptr<Unit>>;
    if (!unit_->end()) kept.push_back(std::move(unit_));
    taken.store(false);
  }

  Expected<void> begin() { return unit_->begin(); }
  const DeviceRating& rating() const noexcept override { return unit_->rating(); }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    return unit_->relay().read(reading);
  }
  DeviceStatus write(const Wrench& wrench_B) noexcept override {
    return unit_->relay().write(wrench_B);
  }
  void stop() noexcept override { unit_->relay().stop(); }
  void resume() noexcept override { unit_->relay().resume(); }

 private:
  std::unique_ptr<Unit> unit_;
};

Expected<std::unique_ptr<Device>> openUnit(const std::string& name,
                                           std::span<const std::string> libraries) {
  auto hd = load(libraries);
  if (!hd) return tl::unexpected(hd.error());
  worstError(*hd);
  const unsigned unit = hd->open(name.empty() ? nullptr : name.c_str());
  const unsigned error = worstError(*hd);
  if (unit == kNoUnit || error != 0) {
    if (unit != kNoUnit) hd->close(unit);
    return tl::unexpected(notOpened(error));
  }
  auto device = std::make_unique<OpenHaptics>(std::make_unique<Unit>(std::move(*hd), unit));
  if (const auto begun = device->begin(); !begun) return tl::unexpected(begun.error());
  return device;
}

/// The names under which the maker installs it.
std::span<const std::string> openHapticsLibraries() {
  static const std::array<std::string, 2> names{"libHD.so", "libHD.so.3"};
  return names;
}

}  // namespace

std::vector<DeviceEntry> surveyOpenHaptics(std::span<const std::string> libraries) {
  DeviceEntry entry{.id = std::string{kDriver}, .name = kName, .sensed = 6, .actuated = 3};
  if (taken.load()) {
    entry.present = true;
    entry.trouble = Trouble::InUse;
    entry.why = {"device-open", {thisDevice()}};
  } else if (const auto hd = load(libraries); !hd) {
    entry.trouble = Trouble::NoLibrary;
    entry.why = hd.error().message;
  } else {
    entry.why = {"openhaptics-installed", {}};
  }
  return {entry};
}

Expected<std::unique_ptr<Device>> openOpenHaptics(const OpenRequest& request,
                                                  std::span<const std::string> libraries) {
  const std::size_t colon = request.id.find(':');
  if (taken.exchange(true))
    return tl::unexpected(refusal(Trouble::InUse, {"device-open", {thisDevice()}}));
  auto device = openUnit(colon == std::string::npos ? "" : request.id.substr(colon + 1), libraries);
  if (!device) taken.store(false);
  return device;
}

std::vector<DeviceEntry> surveyOpenHaptics() { return surveyOpenHaptics(openHapticsLibraries()); }

Expected<std::unique_ptr<Device>> openOpenHaptics(const OpenRequest& request) {
  return openOpenHaptics(request, openHapticsLibraries());
}

}  // namespace haptics
