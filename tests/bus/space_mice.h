// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

#include "tests/bus/uhid_port.h"
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
  UhidSpaceMouse();

  void move(const CapAxes& axes);
  void press(unsigned buttons);
  /// Any bytes as an input report.
  void report(const Bytes& bytes) { port_.report(bytes); }
  int lit() const { return lit_; }
  std::string node() const { return port_.node(); }

 private:
  std::atomic<int> lit_{-1};
  UhidPort port_;
};

}  // namespace bus
