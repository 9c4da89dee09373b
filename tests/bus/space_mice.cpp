// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bus/space_mice.h"

namespace bus {
namespace {

// two reports of three 16-bit axes, one of buttons, one of the light
const Bytes kMouseReports{
    0x05, 0x01, 0x09, 0x08, 0xA1, 0x01,              // a multi-axis controller
    0x16, 0xA2, 0xFE, 0x26, 0x5E, 0x01,              // -350 to 350
    0x36, 0x88, 0xFA, 0x46, 0x78, 0x05, 0x75, 0x10,  // physically -1400 to 1400; 16 bits
    0xA1, 0x00, 0x85, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x95, 0x03, 0x81, 0x02, 0xC0, 0xA1,
    0x00, 0x85, 0x02, 0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x95, 0x03, 0x81, 0x02, 0xC0, 0xA1, 0x02,
    0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29, 0x10, 0x15, 0x00, 0x25, 0x01, 0x35, 0x00, 0x45, 0x01,
    0x75, 0x01, 0x95, 0x10, 0x81, 0x02, 0xC0, 0xA1, 0x02, 0x85, 0x04, 0x05, 0x08, 0x09, 0x4B, 0x15,
    0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x01, 0x91, 0x02, 0x95, 0x07, 0x91, 0x03, 0xC0,  //
    0xC0};

Bytes axesReport(std::uint8_t id, const CapAxes& axes, std::size_t first) {
  Bytes report{id};
  for (std::size_t n = first; n < first + 3; ++n) {
    report.push_back(std::uint8_t(axes[n]));
    report.push_back(std::uint8_t(axes[n] >> 8));
  }
  return report;
}
Bytes buttonReport(unsigned buttons) {
  return {3, std::uint8_t(buttons), std::uint8_t(buttons >> 8)};
}

}  // namespace

void SpaceNavigatorEmulator::move(const CapAxes& axes) {
  const std::scoped_lock lock{mutex_};
  reports_.push_back(axesReport(1, axes, 0));
  reports_.push_back(axesReport(2, axes, 3));
}

void SpaceNavigatorEmulator::press(unsigned buttons) {
  const std::scoped_lock lock{mutex_};
  reports_.push_back(buttonReport(buttons));
}

Bytes SpaceNavigatorEmulator::deviceDescriptor() const {
  return {18, 1, 0x00, 0x02, 0, 0, 0, 8, 0x6D, 0x04, 0x26, 0xC6, 0x01, 0x04, 1, 2, 0, 1};
}

Bytes SpaceNavigatorEmulator::configuration() const {
  const auto size = std::uint8_t(kMouseReports.size());
  return {9, 2,    34,   0, 1, 1, 0,    0x80, 50,  // one interface
          9, 4,    0,    0, 1, 3, 0,    0,    0,   // HID
          9, 0x21, 0x11, 1, 0, 1, 0x22, size, 0,   // one report descriptor
          7, 5,    0x81, 3, 8, 0, 8};              // interrupt in, every 8 ms
}

std::vector<std::string> SpaceNavigatorEmulator::strings() const {
  return {"Palpate", "Emulated SpaceNavigator"};
}

std::optional<Bytes> SpaceNavigatorEmulator::control(const Setup& setup,
                                                     std::span<const std::uint8_t> out) {
  constexpr std::uint8_t kGetDescriptor = 6, kSetReport = 9, kSetIdle = 10;
  if (setup.type == 0x81 && setup.request == kGetDescriptor && setup.value == 0x2200)
    return kMouseReports;
  if (setup.type != 0x21) return std::nullopt;
  if (setup.request == kSetReport && setup.value == 0x0204 && out.size() == 2 && out[0] == 4)
    lit_ = out[1] & 1;
  if (setup.request == kSetReport || setup.request == kSetIdle) return Bytes{};
  return std::nullopt;
}

void SpaceNavigatorEmulator::received(int /*endpoint*/, std::span<const std::uint8_t> /*bytes*/) {}

std::optional<Bytes> SpaceNavigatorEmulator::toSend(int /*endpoint*/, std::size_t /*room*/) {
  const std::scoped_lock lock{mutex_};
  if (reports_.empty()) return std::nullopt;
  Bytes report = std::move(reports_.front());
  reports_.pop_front();
  return report;
}

UhidSpaceMouse::UhidSpaceMouse()
    : port_{"Emulated SpaceMouse", 0x256F, 0xC635, kMouseReports,
            [this](std::span<const std::uint8_t> report) {
              if (report.size() == 2 && report[0] == 4) lit_ = report[1] & 1;
            }} {}

void UhidSpaceMouse::move(const CapAxes& axes) {
  report(axesReport(1, axes, 0));
  report(axesReport(2, axes, 3));
}

void UhidSpaceMouse::press(unsigned buttons) { report(buttonReport(buttons)); }

}  // namespace bus
