// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/hid_port.h"

#include <fcntl.h>
#include <hidapi/hidapi.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "haptics/devices/catalogue.h"

namespace haptics {
namespace {

class OpenHid final : public HidPort {
 public:
  /// `lock`: the device's file, locked.
  OpenHid(hid_device* device, int lock) : device_{device}, lock_{lock} {}
  ~OpenHid() override {
    hid_close(device_);
    ::close(lock_);
  }
  OpenHid(const OpenHid&) = delete;
  OpenHid& operator=(const OpenHid&) = delete;

  std::optional<std::size_t> read(std::span<std::uint8_t> report,
                                  std::chrono::milliseconds wait) noexcept override {
    const int length =
        hid_read_timeout(device_, report.data(), report.size(), static_cast<int>(wait.count()));
    if (length < 0) return std::nullopt;
    return static_cast<std::size_t>(length);
  }
  bool write(std::span<const std::uint8_t> report) noexcept override {
    return hid_write(device_, report.data(), report.size()) == static_cast<int>(report.size());
  }

 private:
  hid_device* device_;
  int lock_;
};

/// What the system's word means for the user.
HidObstacle obstacleFor(int error, const std::string& name) {
  if (error == EACCES || error == EPERM)
    return {Trouble::NoPermission, {"device-not-permitted", {name}}};
  if (error == EBUSY || error == EWOULDBLOCK) return {Trouble::InUse, {"device-in-use", {name}}};
  return {Trouble::NotPluggedIn, {"device-gone", {name}}};
}

}  // namespace

std::vector<HidPlace> findHid(std::uint16_t vendor) {
  std::vector<HidPlace> places;
  hid_device_info* const first = hid_enumerate(vendor, 0);
  for (const hid_device_info* at = first; at != nullptr; at = at->next)
    places.push_back(
        {at->path, at->vendor_id, at->product_id, at->usage_page, at->usage, at->interface_number});
  hid_free_enumeration(first);
  return places;
}

HidObstacle hidObstacle(const HidPlace& place, const std::string& name) {
  if (::faccessat(AT_FDCWD, place.path.c_str(), R_OK | W_OK, AT_EACCESS) == 0) return {};
  return obstacleFor(errno, name);
}

Expected<std::unique_ptr<HidPort>> openHid(const HidPlace& place, const std::string& name) {
  // hidapi does not say why it could not open: the system does
  const int lock = ::open(place.path.c_str(), O_RDWR | O_CLOEXEC);
  const bool locked = lock >= 0 && ::flock(lock, LOCK_EX | LOCK_NB) == 0;
  if (!locked) {
    const HidObstacle obstacle = obstacleFor(errno, name);
    if (lock >= 0) ::close(lock);
    return tl::unexpected(refusal(obstacle.trouble, obstacle.why));
  }
  if (hid_device* const device = hid_open_path(place.path.c_str()))
    return std::make_unique<OpenHid>(device, lock);
  ::close(lock);
  return tl::unexpected(refusal(Trouble::Refused, {"device-not-opened", {name, "hidapi"}}));
}

}  // namespace haptics
