// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

/// USB devices that a program plays to the kernel it runs under, through USB/IP and vhci_hcd: the
/// drivers on the other side cannot tell. Protocol: the kernel's Documentation/usb/usbip_protocol.
namespace bus {

using Bytes = std::vector<std::uint8_t>;

/// The eight bytes that begin a control transfer.
struct Setup {
  std::uint8_t type = 0, request = 0;
  std::uint16_t value = 0, index = 0, length = 0;
};

/// What a device is, and what it answers. Called by its port's thread.
class UsbFunction {
 public:
  virtual ~UsbFunction() = default;
  virtual Bytes deviceDescriptor() const = 0;
  virtual Bytes configuration() const = 0;
  virtual std::vector<std::string> strings() const = 0;  ///< from index 1, ASCII
  /// A control transfer that is not the standard's: what it answers; none: it is refused (stall).
  virtual std::optional<Bytes> control(const Setup& setup, std::span<const std::uint8_t> out) = 0;
  virtual void received(int endpoint, std::span<const std::uint8_t> bytes) = 0;
  /// What it sends now, at most `room` bytes; none: nothing yet. Asked again each millisecond.
  virtual std::optional<Bytes> toSend(int endpoint, std::size_t room) = 0;
};

/// A port of the virtual hub, with a device in it from construction on.
class UsbPort {
 public:
  /// Waits until the port is free and the kernel has taken the device; throws std::runtime_error
  /// where it does not. `function` outlives the port.
  UsbPort(int port, UsbFunction& function);
  ~UsbPort();  ///< pulls the plug
  UsbPort(const UsbPort&) = delete;
  UsbPort& operator=(const UsbPort&) = delete;

  /// Where the system shows it: "/dev/bus/usb/001/002". Empty before it is enumerated.
  std::string node() const;

 private:
  struct Pending {
    std::uint32_t sequence = 0;
    int endpoint = 0;
    std::size_t room = 0;
  };

  void serve();
  bool submitted(std::span<const std::uint8_t> header);
  bool unlinked(std::span<const std::uint8_t> header);
  std::optional<Bytes> controlled(const Setup& setup, std::span<const std::uint8_t> out);
  std::optional<Bytes> standard(const Setup& setup) const;
  bool answer(std::uint32_t sequence, int status, std::size_t moved,
              std::span<const std::uint8_t> bytes);
  bool sendPending();

  int port_;
  UsbFunction& function_;
  int socket_ = -1;
  std::vector<Pending> pending_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace bus
