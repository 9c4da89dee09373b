// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bus/uhid_port.h"

#include <fcntl.h>
#include <linux/uhid.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace bus {

std::string hidNode(std::uint16_t vendor, std::uint16_t product) {
  namespace fs = std::filesystem;
  std::array<char, 32> id{};
  std::snprintf(id.data(), id.size(), ":%08X:%08X", vendor, product);
  std::error_code failed;
  for (const auto& node : fs::directory_iterator{"/sys/class/hidraw", failed}) {
    std::ifstream words{node.path() / "device/uevent"};
    std::string line;
    while (std::getline(words, line))
      if (line.starts_with("HID_ID=") && line.ends_with(id.data()))
        return "/dev/" + node.path().filename().string();
  }
  return {};
}

UhidPort::UhidPort(const std::string& name, std::uint16_t vendor, std::uint16_t product,
                   const Bytes& descriptor, Heard heard)
    : heard_{std::move(heard)} {
  file_ = open("/dev/uhid", O_RDWR | O_CLOEXEC);
  uhid_event event{};
  event.type = UHID_CREATE2;
  uhid_create2_req& made = event.u.create2;
  std::snprintf(reinterpret_cast<char*>(made.name), sizeof made.name, "%s", name.c_str());
  std::copy(descriptor.begin(), descriptor.end(), made.rd_data);
  made.rd_size = std::uint16_t(descriptor.size());
  made.bus = 3;  // USB
  made.vendor = vendor;
  made.product = product;
  if (file_ < 0 || write(file_, &event, sizeof event) != ssize_t(sizeof event)) {
    if (file_ >= 0) close(file_);
    throw std::runtime_error{"uhid did not take the device"};
  }
  thread_ = std::thread{[this] { listen(); }};
  for (int n = 0; n < 3000 && node_.empty(); ++n) {
    node_ = hidNode(vendor, product);
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  }
  if (!node_.empty()) return;
  ending_ = true;
  thread_.join();
  close(file_);
  throw std::runtime_error{"the kernel shows no hidraw node for the device"};
}

UhidPort::~UhidPort() {
  ending_ = true;
  thread_.join();
  close(file_);  // unplugs it
}

void UhidPort::listen() {
  while (!ending_) {
    pollfd waiting{file_, POLLIN, 0};
    uhid_event event{};
    if (poll(&waiting, 1, 10) <= 0 || ::read(file_, &event, sizeof event) <= 0) continue;
    if (event.type == UHID_OUTPUT)
      heard_({&event.u.output.data[0], std::min<std::size_t>(event.u.output.size, UHID_DATA_MAX)});
  }
}

void UhidPort::report(const Bytes& bytes) {
  uhid_event event{};
  event.type = UHID_INPUT2;
  event.u.input2.size = std::uint16_t(std::min<std::size_t>(bytes.size(), UHID_DATA_MAX));
  std::copy_n(bytes.begin(), event.u.input2.size, event.u.input2.data);
  if (write(file_, &event, sizeof event) < 0) throw std::runtime_error{"uhid took no report"};
}

}  // namespace bus
