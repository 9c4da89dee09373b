// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "tests/bus/usb_port.h"

namespace bus {

/// What a cap reports: X, Y, Z, Rx, Ry, Rz, each -350 to 350, Y towards the user and Z down.
using CapAxes = std::array<int, 6>;

/// A SpaceNavigator (046d:c626), for a UsbPort: two reports a motion, the light through the control
/// pipe. Any thread.
class SpaceNavigatorEmulator final : public UsbFunction {
 public:
  void move(const CapAxes& axes);
  void press(unsigned buttons);
  int lit() const { return lit_; }  ///< the light: 0, 1, or -1 where nobody has said

  Bytes deviceDescriptor() const override;
  Bytes configuration() const override;
  std::vector<std::string> strings() const override;
  std::optional<Bytes> control(const Setup& setup, std::span<const std::uint8_t> out) override;
  void received(int endpoint, std::span<const std::uint8_t> bytes) override;
  std::optional<Bytes> toSend(int endpoint, std::size_t room) override;

 private:
  std::mutex mutex_;
  std::deque<Bytes> reports_;
  std::atomic<int> lit_{-1};
};

/// A SpaceMouse Compact (256f:c635) that the kernel's uhid plays. In the system while it lives.
class UhidSpaceMouse {
 public:
  UhidSpaceMouse();  ///< throws std::runtime_error where the system does not show it
  ~UhidSpaceMouse();
  UhidSpaceMouse(const UhidSpaceMouse&) = delete;
  UhidSpaceMouse& operator=(const UhidSpaceMouse&) = delete;

  void move(const CapAxes& axes);
  void press(unsigned buttons);
  /// Any bytes as an input report.
  void report(const Bytes& bytes);
  int lit() const { return lit_; }
  std::string node() const { return node_; }  ///< "/dev/hidraw0"

 private:
  void listen();

  int file_ = -1;
  std::string node_;
  std::atomic<int> lit_{-1};
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

/// The hidraw node of a HID device, or empty: "/dev/hidraw0".
std::string hidNode(std::uint16_t vendor, std::uint16_t product);

}  // namespace bus
