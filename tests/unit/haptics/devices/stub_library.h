// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/places.h"
#include "tests/support/scratch_folder.h"

/// What tests of drivers over makers' libraries share: the stub's control, copies of it that lack a
/// function, and patience.
namespace stubs {

/// The stand-ins for Force Dimension's library and for OpenHaptics' HD.
inline std::string dhd() { return places::built("tests/unit/haptics/devices/libstub_dhd.so"); }
inline std::string hd() { return places::built("tests/unit/haptics/devices/libstub_hd.so"); }

/// What the library at `path` exports to steer it by.
template <class Control>
Control& control(const std::string& path, const char* symbol) {
  void* const handle = dlopen(path.c_str(), RTLD_NOW);
  EXPECT_NE(handle, nullptr) << dlerror();
  return *reinterpret_cast<Control* (*)()>(dlsym(handle, symbol))();
}

/// A copy of the library in which one exported name is misspelt, so that the loader does not find
/// it.
inline std::string without(const std::string& path, const std::string& symbol) {
  std::ifstream in{path, std::ios::binary};
  std::vector<char> bytes{std::istreambuf_iterator<char>{in}, {}};
  const std::string name = '\0' + symbol + '\0';
  for (auto at = bytes.begin();;) {
    at = std::search(at, bytes.end(), name.begin(), name.end());
    if (at == bytes.end()) break;
    *++at = 'X';
  }
  static const support::ScratchFolder folder;
  return folder.write("without-" + symbol + ".so", {bytes.data(), bytes.size()}).string();
}

/// Waits for what another thread is to bring about: half a minute, which no machine needs.
template <class Condition>
bool comes(Condition&& condition) {
  for (int n = 0; n < 30'000; ++n) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return false;
}

}  // namespace stubs
