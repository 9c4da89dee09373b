// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <thread>

#include "tests/bus/usb_port.h"

namespace bus {

/// A HID device that the kernel's uhid plays, as if it were on USB. In the system while it lives.
class UhidPort {
 public:
  /// Called on a thread of its own with each output report, its id first.
  using Heard = std::function<void(std::span<const std::uint8_t>)>;

  /// Throws std::runtime_error where the system does not show it.
  UhidPort(const std::string& name, std::uint16_t vendor, std::uint16_t product,
           const Bytes& descriptor, Heard heard);
  ~UhidPort();
  UhidPort(const UhidPort&) = delete;
  UhidPort& operator=(const UhidPort&) = delete;

  /// Any bytes as an input report. Any thread.
  void report(const Bytes& bytes);
  std::string node() const { return node_; }  ///< "/dev/hidraw0"

 private:
  void listen();

  const Heard heard_;
  int file_ = -1;
  std::string node_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

/// The hidraw node of a HID device, or empty: "/dev/hidraw0".
std::string hidNode(std::uint16_t vendor, std::uint16_t product);

}  // namespace bus
