// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bus/usb_port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace bus {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeader = 48;
constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitted = 3, kUnlinked = 4;
constexpr std::size_t kMostBytes = 1 << 20;
constexpr int kFullSpeed = 2;
const fs::path kHub = "/sys/devices/platform/vhci_hcd.0";

// the protocol's headers are big-endian
std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 |
         std::uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
}
void setWord(std::span<std::uint8_t> bytes, std::size_t at, std::uint32_t word) {
  for (int n = 0; n < 4; ++n) bytes[at + std::size_t(n)] = std::uint8_t(word >> (24 - 8 * n));
}

bool receiveAll(int socket, std::span<std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = recv(socket, bytes.data(), bytes.size(), 0);
    if (n <= 0) return false;
    bytes = bytes.subspan(std::size_t(n));
  }
  return true;
}
bool sendAll(int socket, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n <= 0) return false;
    bytes = bytes.subspan(std::size_t(n));
  }
  return true;
}

// "hs  0000 004 000 00000000 000000 0-0": hub, port, state; 4 is free
bool isFree(int port) {
  std::ifstream status{kHub / "status"};
  std::string line;
  while (std::getline(status, line)) {
    std::istringstream words{line};
    std::string hub;
    int number = -1, state = -1;
    if (words >> hub >> number >> state && hub == "hs" && number == port) return state == 4;
  }
  return false;
}

template <class Ready>
bool waitFor(Ready ready) {
  for (int n = 0; n < 3000; ++n) {
    if (ready()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  return false;
}

}  // namespace

UsbPort::UsbPort(int port, UsbFunction& function) : port_{port}, function_{function} {
  if (!waitFor([&] { return isFree(port); }))
    throw std::runtime_error{"port " + std::to_string(port) + " of the virtual hub is not free"};
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error{"no pair of sockets"};
  socket_ = ends[0];
  {
    std::ofstream attach{kHub / "attach"};
    attach << port << ' ' << ends[1] << ' ' << (1 << 16 | (port + 1)) << ' ' << kFullSpeed
           << std::flush;
    close(ends[1]);  // the kernel has its own hold on it
    if (!attach) {
      close(socket_);
      throw std::runtime_error{"the virtual hub did not take the device"};
    }
  }
  thread_ = std::thread{[this] { serve(); }};
  if (!waitFor([&] { return !node().empty(); })) {
    ending_ = true;
    thread_.join();
    close(socket_);
    throw std::runtime_error{"the kernel did not enumerate the device"};
  }
}

UsbPort::~UsbPort() {
  ending_ = true;
  shutdown(socket_, SHUT_RDWR);
  thread_.join();
  close(socket_);
}

std::string UsbPort::node() const {
  // "1-1" and so on: the first hub's first ports, counted from 1
  std::error_code failed;
  for (const auto& hub : fs::directory_iterator{kHub, failed}) {
    const std::string name = hub.path().filename();
    if (!name.starts_with("usb")) continue;
    const fs::path device = hub.path() / (name.substr(3) + "-" + std::to_string(port_ + 1));
    int bus_number = 0, number = 0;
    // it is there once it has a configuration
    if (!fs::exists(device / (device.filename().string() + ":1.0"), failed)) continue;
    std::ifstream{device / "busnum"} >> bus_number;
    std::ifstream{device / "devnum"} >> number;
    std::array<char, 32> path{};
    std::snprintf(path.data(), path.size(), "/dev/bus/usb/%03d/%03d", bus_number, number);
    return path.data();
  }
  return {};
}

void UsbPort::serve() {
  std::array<std::uint8_t, kHeader> header{};
  while (!ending_) {
    pollfd waiting{socket_, POLLIN, 0};
    const int ready = poll(&waiting, 1, 1);
    if (ready > 0) {
      if (!receiveAll(socket_, header)) return;
      const std::uint32_t command = wordAt(header, 0);
      if (command == kSubmit ? !submitted(header) : command != kUnlink || !unlinked(header)) return;
    }
    if (!sendPending()) return;
  }
}

bool UsbPort::submitted(std::span<const std::uint8_t> header) {
  const std::uint32_t sequence = wordAt(header, 4);
  const bool in = wordAt(header, 12) != 0;
  const int endpoint = int(wordAt(header, 16));
  const std::size_t length = wordAt(header, 24);
  if (length > kMostBytes) return false;
  Bytes out(in ? 0 : length);
  if (!receiveAll(socket_, out)) return false;

  if (endpoint == 0) {
    const auto setup = header.subspan(40);
    const auto half = [&](std::size_t at) { return std::uint16_t(setup[at] | setup[at + 1] << 8); };
    const std::optional<Bytes> reply =
        controlled({setup[0], setup[1], half(2), half(4), half(6)}, out);
    if (!reply) return answer(sequence, -EPIPE, 0, {});
    const std::size_t moved = in ? std::min(reply->size(), length) : length;
    return answer(sequence, 0, moved,
                  in ? std::span{*reply}.first(moved) : std::span<std::uint8_t>{});
  }
  if (in) {
    pending_.push_back({sequence, endpoint, length});
    return true;
  }
  function_.received(endpoint, out);
  return answer(sequence, 0, length, {});
}

bool UsbPort::unlinked(std::span<const std::uint8_t> header) {
  const std::uint32_t unlinked = wordAt(header, 20);
  const auto at = std::find_if(pending_.begin(), pending_.end(), [&](const Pending& transfer) {
    return transfer.sequence == unlinked;
  });
  std::array<std::uint8_t, kHeader> reply{};
  setWord(reply, 0, kUnlinked);
  setWord(reply, 4, wordAt(header, 4));
  if (at != pending_.end()) {
    pending_.erase(at);
    setWord(reply, 20, std::uint32_t(-ECONNRESET));
  }
  return sendAll(socket_, reply);
}

std::optional<Bytes> UsbPort::controlled(const Setup& setup, std::span<const std::uint8_t> out) {
  if (auto known = standard(setup)) return known;
  return function_.control(setup, out);
}

std::optional<Bytes> UsbPort::standard(const Setup& setup) const {
  constexpr std::uint8_t kGetStatus = 0, kGetDescriptor = 6, kSetConfiguration = 9,
                         kSetInterface = 11;
  if ((setup.type & 0x60) != 0) return std::nullopt;
  if (setup.request == kGetStatus && setup.type == 0x80) return Bytes{0, 0};
  if (setup.request == kSetConfiguration || setup.request == kSetInterface) return Bytes{};
  if (setup.request != kGetDescriptor || setup.type != 0x80) return std::nullopt;
  const unsigned index = setup.value & 0xFF;
  switch (setup.value >> 8) {
    case 1:
      return function_.deviceDescriptor();
    case 2:
      return function_.configuration();
    case 3: {
      if (index == 0) return Bytes{4, 3, 0x09, 0x04};  // US English
      const std::vector<std::string> strings = function_.strings();
      if (index > strings.size()) return std::nullopt;
      Bytes text{0, 3};
      for (const char letter : strings[index - 1]) {
        text.push_back(std::uint8_t(letter));
        text.push_back(0);
      }
      text[0] = std::uint8_t(text.size());
      return text;
    }
    default:
      return std::nullopt;
  }
}

bool UsbPort::answer(std::uint32_t sequence, int status, std::size_t moved,
                     std::span<const std::uint8_t> bytes) {
  Bytes reply(kHeader + bytes.size());
  setWord(reply, 0, kSubmitted);
  setWord(reply, 4, sequence);
  setWord(reply, 20, std::uint32_t(status));
  setWord(reply, 24, std::uint32_t(moved));
  std::copy(bytes.begin(), bytes.end(), reply.begin() + kHeader);
  return sendAll(socket_, reply);
}

bool UsbPort::sendPending() {
  for (auto transfer = pending_.begin(); transfer != pending_.end();) {
    const std::optional<Bytes> bytes = function_.toSend(transfer->endpoint, transfer->room);
    if (!bytes) {
      ++transfer;
      continue;
    }
    const std::size_t moved = std::min(bytes->size(), transfer->room);
    if (!answer(transfer->sequence, 0, moved, std::span{*bytes}.first(moved))) return false;
    transfer = pending_.erase(transfer);
  }
  return true;
}

}  // namespace bus
