// SPDX-License-Identifier: BSD-3-Clause
#include <libusb-1.0/libusb.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

#include "haptics/core/clock.h"
#include "haptics/devices/catalogue.h"
#include "haptics/devices/falcon_packets.h"
#include "haptics/devices/falcon_port.h"

namespace haptics::falcon {
namespace {

constexpr std::uint16_t kVendor = 0x0403, kProduct = 0xcb48;
constexpr std::uint8_t kOut = 0x02, kIn = 0x81, kVendorOut = 0x40;
constexpr int kInterface = 0;
constexpr unsigned kRequestMs = 1000;
constexpr std::int64_t kMillisecond = 1'000'000, kLastWords = 50 * kMillisecond,
                       kCancelled = 500 * kMillisecond;  // ns

/// Transfers that are kept in flight: reads always, so that the bus never waits for this program.
/// libusb takes a small block off the heap for every transfer that it submits, and locks; the
/// thread that does so is the transport's, never the servo thread.
class UsbPort final : public FalconPort {
 public:
  /// Takes over both. Whether it works shows isReady().
  UsbPort(libusb_context* context, libusb_device_handle* handle)
      : context_{context}, handle_{handle} {
    out_ = libusb_alloc_transfer(0);
    if (out_ == nullptr) return;
    libusb_fill_bulk_transfer(out_, handle_, kOut, out_bytes_.data(), 0, &UsbPort::sent, this, 0);
    for (Read& read : reads_) {
      read.owner = this;
      read.transfer = libusb_alloc_transfer(0);
      if (read.transfer == nullptr) return;
      libusb_fill_bulk_transfer(read.transfer, handle_, kIn, read.bytes.data(),
                                static_cast<int>(read.bytes.size()), &UsbPort::received, &read, 0);
      submit(read);
    }
    ready_ = !gone_ && !deaf_;
  }
  ~UsbPort() override {
    waitWhile([this] { return sending_ && !gone_; }, kLastWords);
    gone_ = true;  // nothing is submitted any more
    if (sending_) libusb_cancel_transfer(out_);
    for (const Read& read : reads_)
      if (read.in_flight) libusb_cancel_transfer(read.transfer);
    waitWhile([this] { return isInFlight(); }, kCancelled);
    // what libusb will not give back must not be freed
    if (!sending_) libusb_free_transfer(out_);
    for (const Read& read : reads_)
      if (!read.in_flight) libusb_free_transfer(read.transfer);
    libusb_release_interface(handle_, kInterface);
    libusb_close(handle_);
    libusb_exit(context_);
  }
  UsbPort(const UsbPort&) = delete;
  UsbPort& operator=(const UsbPort&) = delete;

  bool isReady() const { return ready_; }

  bool request(std::uint8_t request, std::uint16_t value) noexcept override {
    return !gone_ && libusb_control_transfer(handle_, kVendorOut, request, value, 0, nullptr, 0,
                                             kRequestMs) == 0;
  }

  Sent send(std::span<const std::uint8_t> bytes) noexcept override {
    handleEvents(0);
    if (gone_) return Sent::Gone;
    if (sending_ || bytes.size() > out_bytes_.size()) return Sent::Busy;
    std::copy(bytes.begin(), bytes.end(), out_bytes_.begin());
    out_->length = static_cast<int>(bytes.size());
    if (libusb_submit_transfer(out_) != 0) {
      gone_ = true;
      return Sent::Gone;
    }
    sending_ = true;
    return Sent::Taken;
  }

  std::optional<std::size_t> receive(std::span<std::uint8_t> transfer,
                                     std::chrono::nanoseconds wait) noexcept override {
    waitWhile([this] { return waiting_ == 0 && !gone_ && !deaf_; }, wait.count());
    if (waiting_ == 0) return gone_ || deaf_ ? std::nullopt : std::optional<std::size_t>{0};
    Read& read = *order_[0];
    std::copy(order_.begin() + 1, order_.end(), order_.begin());
    --waiting_;
    const std::size_t length =
        std::min(transfer.size(), static_cast<std::size_t>(read.transfer->actual_length));
    std::copy_n(read.bytes.begin(), length, transfer.begin());
    submit(read);
    return length;
  }

  std::int64_t now() const noexcept override { return monotonicNs(); }

 private:
  struct Read {
    libusb_transfer* transfer = nullptr;
    UsbPort* owner = nullptr;
    bool in_flight = false;
    std::array<std::uint8_t, kUsbPacket> bytes{};
  };

  void submit(Read& read) noexcept {
    if (gone_ || deaf_) return;
    read.in_flight = libusb_submit_transfer(read.transfer) == 0;
    deaf_ = !read.in_flight;
  }

  static void LIBUSB_CALL sent(libusb_transfer* transfer) noexcept {
    UsbPort& port = *static_cast<UsbPort*>(transfer->user_data);
    port.sending_ = false;
    if (transfer->status != LIBUSB_TRANSFER_COMPLETED || transfer->actual_length < transfer->length)
      port.gone_ = true;
  }

  static void LIBUSB_CALL received(libusb_transfer* transfer) noexcept {
    Read& read = *static_cast<Read*>(transfer->user_data);
    UsbPort& port = *read.owner;
    read.in_flight = false;
    if (transfer->status != LIBUSB_TRANSFER_COMPLETED) {
      port.deaf_ = true;
      port.gone_ = port.gone_ || transfer->status == LIBUSB_TRANSFER_NO_DEVICE;
    } else if (transfer->actual_length > 2) {
      port.order_[port.waiting_++] = &read;  // one place for each
    } else {
      port.submit(read);  // only the chip's status, which comes every millisecond
    }
  }

  bool isInFlight() const noexcept {
    return sending_ || std::any_of(reads_.begin(), reads_.end(),
                                   [](const Read& read) { return read.in_flight; });
  }

  void handleEvents(std::int64_t wait_ns) noexcept {
    timeval wait{.tv_sec = wait_ns / 1'000'000'000,
                 .tv_usec = static_cast<suseconds_t>(wait_ns % 1'000'000'000 / 1000)};
    libusb_handle_events_timeout_completed(context_, &wait, nullptr);
  }

  /// Lets libusb work while that holds, or until the time is over; once at least.
  template <class Condition>
  void waitWhile(Condition holds, std::int64_t wait_ns) noexcept {
    const std::int64_t end = monotonicNs() + wait_ns;
    for (std::int64_t left = wait_ns; holds() && left >= 0; left = end - monotonicNs()) {
      handleEvents(left);
      if (left == 0) break;
    }
  }

  libusb_context* context_;
  libusb_device_handle* handle_;
  libusb_transfer* out_ = nullptr;
  std::array<std::uint8_t, kUsbPacket> out_bytes_{};
  std::array<Read, 4> reads_;
  std::array<Read*, 4> order_{};  ///< those that wait to be received, the oldest first
  std::size_t waiting_ = 0;
  bool sending_ = false;
  bool gone_ = false;
  bool deaf_ = false;  ///< nothing can be read any more
  bool ready_ = false;
};

/// "1-2.3", as the kernel calls the socket; empty for a hub of the computer itself.
std::string socketOf(libusb_device* device) {
  std::array<std::uint8_t, 8> ports{};
  const int depth = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  std::string where;
  for (int i = 0; i < depth; ++i)
    where += (i == 0 ? std::to_string(libusb_get_bus_number(device)) + "-" : std::string{"."}) +
             std::to_string(ports[static_cast<std::size_t>(i)]);
  return where;
}

bool isPermitted(libusb_device* device) {
  std::array<char, 64> path{};
  std::snprintf(path.data(), path.size(), "/dev/bus/usb/%03d/%03d", libusb_get_bus_number(device),
                libusb_get_device_address(device));
  return ::access(path.data(), R_OK | W_OK) == 0;
}

/// A program that has claimed the interface shows as its driver "usbfs".
bool isClaimed(const std::string& where) {
  std::error_code absent;
  const auto driver =
      std::filesystem::read_symlink("/sys/bus/usb/devices/" + where + ":1.0/driver", absent);
  return !absent && driver.filename() == "usbfs";
}

/// Calls `visit` with each Falcon until it says false.
template <class Visit>
void forEachFalcon(libusb_context* context, Visit visit) {
  libusb_device** devices = nullptr;
  const ssize_t count = libusb_get_device_list(context, &devices);
  if (count < 0) return;
  for (ssize_t i = 0; i < count; ++i) {
    libusb_device_descriptor words{};
    if (libusb_get_device_descriptor(devices[i], &words) != 0 || words.idVendor != kVendor ||
        words.idProduct != kProduct)
      continue;
    if (!visit(devices[i])) break;
  }
  libusb_free_device_list(devices, 1);
}

Error refusalOf(int code) {
  switch (code) {
    case LIBUSB_ERROR_ACCESS:
      return refusal(Trouble::NoPermission, {"device-not-permitted", {kFalcon}});
    case LIBUSB_ERROR_BUSY:
      return refusal(Trouble::InUse, {"device-in-use", {kFalcon}});
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      return refusal(Trouble::NotPluggedIn, {"device-gone", {kFalcon}});
    default:
      return refusal(Trouble::Refused, {"device-not-opened", {kFalcon, libusb_error_name(code)}});
  }
}

}  // namespace

std::vector<FalconPlace> findFalcons() {
  std::vector<FalconPlace> places;
  libusb_context* context = nullptr;
  if (libusb_init(&context) != 0) return places;  // a system without USB
  forEachFalcon(context, [&](libusb_device* device) {
    const std::string where = socketOf(device);
    places.push_back({where, isPermitted(device), isClaimed(where)});
    return true;
  });
  libusb_exit(context);
  return places;
}

Expected<std::unique_ptr<FalconPort>> openFalconPort(const std::string& where) {
  libusb_context* context = nullptr;
  if (libusb_init(&context) != 0) return tl::unexpected(refusalOf(LIBUSB_ERROR_NOT_FOUND));
  libusb_device_handle* handle = nullptr;
  int code = LIBUSB_ERROR_NOT_FOUND;
  forEachFalcon(context, [&](libusb_device* device) {
    if (socketOf(device) != where) return true;
    code = libusb_open(device, &handle);
    return false;
  });
  if (code == 0) {
    // a serial port of the system's, should it ever know this device, steps aside
    libusb_set_auto_detach_kernel_driver(handle, 1);
    code = libusb_claim_interface(handle, kInterface);
  }
  if (code != 0) {
    if (handle != nullptr) libusb_close(handle);
    libusb_exit(context);
    return tl::unexpected(refusalOf(code));
  }
  auto port = std::make_unique<UsbPort>(context, handle);
  if (!port->isReady()) return tl::unexpected(refusalOf(LIBUSB_ERROR_IO));
  return port;
}

}  // namespace haptics::falcon
