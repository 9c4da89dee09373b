// SPDX-License-Identifier: BSD-3-Clause
// bus_test: the tests, or with a word what a test starts as a process of its own (child.h)
#include <gtest/gtest.h>

#include <string>

#include "tests/bus/child.h"

int main(int count, char** words) {
  testing::InitGoogleTest(&count, words);
  if (count == 2) return bus::childMain(words[1]);
  if (count == 3) return bus::childMain(words[1], words[2]);
  return RUN_ALL_TESTS();
}
