// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "haptics/devices/hid_port.h"

namespace fake {

using Bytes = std::vector<std::uint8_t>;

/// A HID device as a test has it: what it will report, and what was written to it.
struct Hid {
  std::deque<Bytes> reports;
  std::vector<Bytes> written;
  bool gone = false;                                   ///< unplugged: reads say so
  bool takes = true;                                   ///< false: writes fail
  int refuses = 0;                                     ///< so many more writes fail
  long reads = 0;                                      ///< how often it was asked
  std::function<void(const Bytes&)> answer = nullptr;  ///< called for each write that is taken
};

class Port final : public haptics::HidPort {
 public:
  explicit Port(std::shared_ptr<Hid> hid) : hid_{std::move(hid)} {}
  std::optional<std::size_t> read(std::span<std::uint8_t> report,
                                  std::chrono::milliseconds) noexcept override {
    ++hid_->reads;
    if (hid_->gone) return std::nullopt;
    if (hid_->reports.empty()) return 0;
    // as the system has it: what does not fit is cut off
    const Bytes next = hid_->reports.front();
    hid_->reports.pop_front();
    const std::size_t length = std::min(next.size(), report.size());
    std::copy_n(next.begin(), length, report.begin());
    return length;
  }
  bool write(std::span<const std::uint8_t> report) noexcept override {
    if (!hid_->takes || hid_->gone) return false;
    if (hid_->refuses > 0) return --hid_->refuses, false;
    hid_->written.emplace_back(report.begin(), report.end());
    if (hid_->answer) hid_->answer(hid_->written.back());
    return true;
  }

 private:
  std::shared_ptr<Hid> hid_;
};

}  // namespace fake
