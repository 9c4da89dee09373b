// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/space_mouse.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace haptics {
namespace {

constexpr std::string_view kDriver = "spacemouse";
constexpr std::uint16_t kLogitech = 0x046d, k3Dconnexion = 0x256f;
constexpr std::uint16_t kReceiver = 0xc652;
constexpr std::uint16_t kGenericDesktop = 1, kMultiAxis = 8;  // usage page, usage

constexpr std::array kModels{
    SpaceMouseModel{kLogitech, 0xc603, "SpaceMouse Plus XT"},
    SpaceMouseModel{kLogitech, 0xc605, "CADman"},
    SpaceMouseModel{kLogitech, 0xc606, "SpaceMouse Classic"},
    SpaceMouseModel{kLogitech, 0xc621, "Spaceball 5000"},
    SpaceMouseModel{kLogitech, 0xc623, "SpaceTraveler"},
    SpaceMouseModel{kLogitech, 0xc625, "SpacePilot"},
    SpaceMouseModel{kLogitech, 0xc626, "SpaceNavigator"},
    SpaceMouseModel{kLogitech, 0xc627, "SpaceExplorer"},
    SpaceMouseModel{kLogitech, 0xc628, "SpaceNavigator for Notebooks"},
    SpaceMouseModel{kLogitech, 0xc629, "SpacePilot Pro"},
    SpaceMouseModel{kLogitech, 0xc62b, "SpaceMouse Pro"},
    SpaceMouseModel{kLogitech, 0xc640, "NuLOOQ"},
    SpaceMouseModel{k3Dconnexion, 0xc62e, "SpaceMouse Wireless (cable)"},
    SpaceMouseModel{k3Dconnexion, 0xc62f, "SpaceMouse Wireless (receiver)"},
    SpaceMouseModel{k3Dconnexion, 0xc631, "SpaceMouse Pro Wireless (cable)"},
    SpaceMouseModel{k3Dconnexion, 0xc632, "SpaceMouse Pro Wireless (receiver)"},
    SpaceMouseModel{k3Dconnexion, 0xc633, "SpaceMouse Enterprise"},
    SpaceMouseModel{k3Dconnexion, 0xc635, "SpaceMouse Compact"},
    SpaceMouseModel{k3Dconnexion, 0xc636, "SpaceMouse Module"},
    SpaceMouseModel{k3Dconnexion, 0xc638, "SpaceMouse Pro Wireless Bluetooth (cable)"},
    SpaceMouseModel{k3Dconnexion, 0xc63a, "SpaceMouse Wireless Bluetooth"},
    SpaceMouseModel{k3Dconnexion, kReceiver, "SpaceMouse (universal receiver)"},
};

constexpr std::uint8_t kShiftReport = 1, kTurnReport = 2, kButtonReport = 3, kLightReport = 4;
constexpr std::size_t kThreeAxes = 7, kSixAxes = 13, kLongestAxes = 16;  // bytes, with the id
constexpr int kMostCounts = 1000;
constexpr int kMostReports = 16;  // a read, of one port

/// Three axes from little-endian bytes; nothing if one is out of reach.
std::optional<std::array<std::int16_t, 3>> axesAt(std::span<const std::uint8_t> bytes) noexcept {
  std::array<std::int16_t, 3> axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i] = static_cast<std::int16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8);
    if (std::abs(int{axes[i]}) > kMostCounts) return std::nullopt;
  }
  return axes;
}

/// The share of the full speed that a deflection asks for, along it.
Vec3 rateOf(const Vec3& counts) noexcept {
  const double size = counts.norm();
  if (!(size > RateControl::kDeadBand)) return Vec3::Zero();  // nor what is not a number
  constexpr double kReach = RateControl::kFullDeflection - RateControl::kDeadBand;
  const double share = std::min((size - RateControl::kDeadBand) / kReach, 1.0);
  return counts * (share * share / size);
}

class SpaceMouse final : public Device {
 public:
  SpaceMouse(std::vector<std::unique_ptr<HidPort>> ports, MonotonicClock clock) : clock_{clock} {
    for (std::unique_ptr<HidPort>& port : ports) ports_.push_back({std::move(port)});
    light(1);
  }
  ~SpaceMouse() override { light(0); }

  const DeviceRating& rating() const noexcept override { return rating_; }

  DeviceStatus read(DeviceReading& reading) noexcept override {
    const std::int64_t now = clock_();
    bool there = false;
    for (Port& port : ports_) {
      take(port, now);
      there = there || !port.gone;
    }
    if (!there) {
      control_.rest();
      cap_.buttons = 0;
    }
    reading.X_BD = control_.step(now);
    reading.buttons = cap_.buttons;
    reading.time_ns = now;
    reading.trouble = there ? Trouble::None : Trouble::Lost;
    return there ? DeviceStatus::Ok : DeviceStatus::Lost;
  }
  DeviceStatus write(const Wrench&) noexcept override { return DeviceStatus::Ok; }
  void stop() noexcept override {}
  void resume() noexcept override {}

 private:
  struct Port {
    std::unique_ptr<HidPort> open;
    bool gone = false;
  };

  /// What has come to one port.
  void take(Port& port, std::int64_t now) noexcept {
    for (int i = 0; i < kMostReports && !port.gone; ++i) {
      const auto length = port.open->read(report_, std::chrono::milliseconds{0});
      port.gone = !length;
      if (!length || *length == 0) return;
      switch (decodeCap(std::span{report_}.first(std::min(*length, report_.size())), cap_)) {
        case CapReport::Shift:
          control_.shift(capInBase(cap_.shift), now);
          break;
        case CapReport::Turn:
          control_.turn(capInBase(cap_.turn), now);
          break;
        case CapReport::Both:
          control_.shift(capInBase(cap_.shift), now);
          control_.turn(capInBase(cap_.turn), now);
          break;
        case CapReport::Buttons:
        case CapReport::Unknown:
          break;
      }
    }
  }

  void light(std::uint8_t on) noexcept {
    const std::array<std::uint8_t, 2> report{kLightReport, on};
    for (Port& port : ports_)
      if (!port.gone) port.open->write(report);
  }

  const DeviceRating rating_ = *findRating(kDriver);
  const MonotonicClock clock_;
  std::vector<Port> ports_;
  std::array<std::uint8_t, 64> report_{};
  CapState cap_;
  RateControl control_;
};

const SpaceMouseModel* modelOf(const HidPlace& place) {
  const auto found = std::ranges::find_if(kModels, [&](const SpaceMouseModel& model) {
    return model.vendor == place.vendor && model.product == place.product;
  });
  return found == kModels.end() ? nullptr : &*found;
}

/// One device: a model and the places at which it may report.
struct Found {
  const SpaceMouseModel* model;
  std::vector<HidPlace> places;
  std::string name() const { return "3Dconnexion " + std::string{model->name}; }
};

std::vector<Found> devicesAmong(std::span<const HidPlace> places) {
  std::vector<Found> devices;
  for (const HidPlace& place : places) {
    const SpaceMouseModel* const model = modelOf(place);
    const bool unknown = place.usage_page == 0 && place.usage == 0;
    const bool cap = place.usage_page == kGenericDesktop && place.usage == kMultiAxis;
    if (model == nullptr || !(cap || unknown)) continue;
    // a place is listed once for each of its collections
    if (std::ranges::any_of(devices, [&](const Found& device) {
          return std::ranges::any_of(
              device.places, [&](const HidPlace& other) { return other.path == place.path; });
        }))
      continue;
    const auto receiver = std::ranges::find_if(devices, [&](const Found& device) {
      return device.model == model && model->product == kReceiver;
    });
    if (receiver != devices.end())
      receiver->places.push_back(place);
    else
      devices.push_back({model, {place}});
  }
  return devices;
}

std::string idOf(const Found& device) {
  return std::string{kDriver} + ":" + device.places.front().path;
}

std::vector<HidPlace> allPlaces() {
  std::vector<HidPlace> places = findHid(kLogitech);
  const std::vector<HidPlace> more = findHid(k3Dconnexion);
  places.insert(places.end(), more.begin(), more.end());
  return places;
}

Error notThere() {
  return refusal(Trouble::NotPluggedIn, {"device-not-plugged-in", {"SpaceMouse"}});
}

}  // namespace

std::span<const SpaceMouseModel> spaceMouseModels() { return kModels; }

CapReport decodeCap(std::span<const std::uint8_t> report, CapState& cap) noexcept {
  if (report.size() < 2) return CapReport::Unknown;
  const std::uint8_t id = report[0];
  if (id == kButtonReport) {
    if (report.size() > kLongestAxes) return CapReport::Unknown;
    cap.buttons = 0;
    for (std::size_t i = 1; i < std::min<std::size_t>(report.size(), 5); ++i)
      cap.buttons |= std::uint32_t{report[i]} << (8 * (i - 1));
    return CapReport::Buttons;
  }
  if (id != kShiftReport && id != kTurnReport) return CapReport::Unknown;
  if (report.size() < kThreeAxes || report.size() > kLongestAxes) return CapReport::Unknown;
  const auto first = axesAt(report.subspan(1, 6));
  if (!first) return CapReport::Unknown;
  if (id == kTurnReport) {
    cap.turn = *first;
    return CapReport::Turn;
  }
  if (report.size() < kSixAxes) {
    cap.shift = *first;
    return CapReport::Shift;
  }
  const auto second = axesAt(report.subspan(7, 6));
  if (!second) return CapReport::Unknown;
  cap.shift = *first;
  cap.turn = *second;
  return CapReport::Both;
}

Vec3 capInBase(const std::array<std::int16_t, 3>& counts) noexcept {
  return {static_cast<double>(counts[0]), -static_cast<double>(counts[2]),
          static_cast<double>(counts[1])};
}

void RateControl::shift(const Vec3& counts_B, std::int64_t now_ns) noexcept {
  shift_ = {rateOf(counts_B), now_ns};
}

void RateControl::turn(const Vec3& counts_B, std::int64_t now_ns) noexcept {
  turn_ = {rateOf(counts_B), now_ns};
}

void RateControl::rest() noexcept {
  shift_.rate.setZero();
  turn_.rate.setZero();
}

Pose RateControl::step(std::int64_t now_ns) noexcept {
  const std::int64_t since = started_ ? now_ns - last_ns_ : 0;
  const double dt = 1e-9 * static_cast<double>(std::clamp(since, std::int64_t{0}, kLongestStepNs));
  started_ = true;
  last_ns_ = now_ns;

  // what nobody repeats does not go on
  for (Deflection* deflection : {&shift_, &turn_})
    if (now_ns - deflection->at_ns > kSilenceNs) deflection->rate.setZero();

  translation_ += shift_.rate * (kFullSpeed * dt);
  const double speed = turn_.rate.norm();
  if (speed > 0.0) {
    const Eigen::AngleAxisd turned{kFullTurn * speed * dt, turn_.rate / speed};
    rotation_ = (Quat{turned} * rotation_).normalized();
  }
  return poseOf(translation_, rotation_);
}

std::unique_ptr<Device> spaceMouseAt(std::vector<std::unique_ptr<HidPort>> ports,
                                     MonotonicClock clock) {
  return std::make_unique<SpaceMouse>(std::move(ports), clock);
}

std::vector<DeviceEntry> spaceMiceAmong(std::span<const HidPlace> places) {
  const std::vector<Found> devices = devicesAmong(places);
  std::vector<DeviceEntry> entries;
  for (const Found& device : devices) {
    const std::string name = device.name();
    const auto [trouble, why] = hidObstacle(device.places.front(), name);
    entries.push_back({idOf(device), name, 6, 0, true, trouble, why});
  }
  return entries;
}

std::vector<DeviceEntry> surveySpaceMice() {
  std::vector<DeviceEntry> entries = spaceMiceAmong(allPlaces());
  if (entries.empty())
    entries.push_back({std::string{kDriver}, std::string{findRating(kDriver)->name}, 6, 0, false,
                       Trouble::NotPluggedIn, notThere().message});
  return entries;
}

Expected<std::unique_ptr<Device>> openSpaceMouse(const OpenRequest& request) {
  Error error = notThere();
  for (const Found& device : devicesAmong(allPlaces())) {
    if (request.id != kDriver && request.id != idOf(device)) continue;
    std::vector<std::unique_ptr<HidPort>> ports;
    for (const HidPlace& place : device.places) {
      auto port = openHid(place, device.name());
      if (port)
        ports.push_back(std::move(*port));
      else
        error = port.error();
    }
    if (!ports.empty()) return spaceMouseAt(std::move(ports));
  }
  return tl::unexpected(error);
}

}  // namespace haptics
