// SPDX-License-Identifier: BSD-3-Clause
// The udev rules let the user have what the drivers claim, and no mouse, keyboard or pad besides.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "haptics/devices/space_mouse.h"
#include "haptics/devices/wooden_haptics.h"
#include "tests/support/places.h"

namespace {

/// A rule: what it compares, by key, and whether it lets the user in.
struct Rule {
  std::map<std::string, std::string> matches;
  bool lets_in = false;
};

/// The rules as udev reads them; a line that is not of this form fails the test.
std::vector<Rule> rules() {
  std::ifstream file{places::source("packaging/70-palpate.rules")};
  EXPECT_TRUE(file.is_open());
  std::vector<Rule> all;
  std::string line;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    Rule rule;
    std::size_t at = 0;
    while (at < line.size()) {
      const std::size_t quote = line.find('"', at), end = line.find('"', quote + 1);
      if (quote == line.npos || end == line.npos) {
        ADD_FAILURE() << line;
        break;
      }
      const std::string key = line.substr(at, quote - at);
      const std::string value = line.substr(quote + 1, end - quote - 1);
      if (key == "TAG+=")
        rule.lets_in = value == "uaccess";
      else if (key.ends_with("=="))
        rule.matches[key.substr(0, key.size() - 2)] = value;
      else
        ADD_FAILURE() << "not understood: " << key;
      at = end + 1;
      if (at < line.size()) {
        EXPECT_EQ(line.substr(at, 2), ", ") << line;
        at += 2;
      }
    }
    EXPECT_TRUE(rule.lets_in) << line;
    all.push_back(rule);
  }
  return all;
}

/// udev's: patterns of the shell, alternatives between bars.
bool like(const std::string& patterns, const std::string& value) {
  std::size_t at = 0;
  while (true) {
    const std::size_t bar = patterns.find('|', at);
    const std::string pattern = patterns.substr(at, bar == patterns.npos ? bar : bar - at);
    if (::fnmatch(pattern.c_str(), value.c_str(), 0) == 0) return true;
    if (bar == patterns.npos) return false;
    at = bar + 1;
  }
}

std::string hex(int id) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "%04x", static_cast<unsigned>(id));
  return text.data();
}

/// Whether a USB device with these ids is let in, at a hidraw node or as a whole.
bool letIn(const std::vector<Rule>& all, const std::string& subsystem, int vendor, int product) {
  const std::string s = subsystem == "hidraw" ? "ATTRS" : "ATTR";
  for (const Rule& rule : all) {
    bool matched = true;
    for (const auto& [key, pattern] : rule.matches) {
      if (key == "SUBSYSTEM")
        matched = matched && like(pattern, subsystem);
      else if (key == s + "{idVendor}")
        matched = matched && like(pattern, hex(vendor));
      else if (key == s + "{idProduct}")
        matched = matched && like(pattern, hex(product));
      else if (key == "ENV{DEVTYPE}")
        matched = matched && pattern == "usb_device";
      else
        matched = false;  // KERNELS: by another bus
    }
    if (matched) return true;
  }
  return false;
}

TEST(UdevRules, LetInWhatTheDriversClaim) {
  const std::vector<Rule> all = rules();
  EXPECT_GE(all.size(), 6u);
  for (const haptics::SpaceMouseModel& model : haptics::spaceMouseModels())
    EXPECT_TRUE(letIn(all, "hidraw", model.vendor, model.product)) << model.name;
  for (const haptics::BoardIds& board : haptics::woodenHaptics().boards)  // and Polhem's
    EXPECT_TRUE(letIn(all, "hidraw", board.vendor, board.product));
  EXPECT_TRUE(letIn(all, "hidraw", 0x2988, 0x0302));  // Touch
  EXPECT_TRUE(letIn(all, "usb", 0x0403, 0xcb48));     // Falcon
  EXPECT_TRUE(letIn(all, "usb", 0x1451, 0x0402));     // Force Dimension
}

TEST(UdevRules, LetNothingElseIn) {
  const std::vector<Rule> all = rules();
  std::map<std::pair<int, int>, bool> claimed;
  for (const haptics::SpaceMouseModel& model : haptics::spaceMouseModels())
    claimed[{model.vendor, model.product}] = true;
  // CadMouse, keyboards, pads, receivers of mice: every product of these vendors that is not ours
  for (const int vendor : {0x046d, 0x256f})
    for (int product = 0; product < 0x10000; ++product) {
      ASSERT_EQ(letIn(all, "hidraw", vendor, product), claimed.contains({vendor, product}))
          << hex(vendor) << ':' << hex(product);
      ASSERT_FALSE(letIn(all, "usb", vendor, product));
    }
  for (int product = 0; product < 0x10000; ++product) {
    ASSERT_EQ(letIn(all, "usb", 0x0403, product), product == 0xcb48);  // a maker of serial chips
    ASSERT_EQ(letIn(all, "hidraw", 0x16c0, product), product == 0x0486);
    ASSERT_EQ(letIn(all, "hidraw", 0x1234, product), product == 0x0006);
  }
}

}  // namespace
