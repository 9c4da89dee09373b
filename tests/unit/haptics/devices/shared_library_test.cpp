// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/shared_library.h"

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"
#include "tests/unit/haptics/devices/stub_library.h"

namespace {

using haptics::SharedLibrary;

TEST(SharedLibrary, TakesTheFirstNameThatIsThere) {
  const std::vector<std::string> names{"libpalpate-absent.so", stubs::dhd()};
  auto library = SharedLibrary::open(names, "Its product");
  ASSERT_TRUE(library) << sentence(library.error());
  EXPECT_EQ(library->name(), stubs::dhd());
}

TEST(SharedLibrary, NamesAllThatItLookedFor) {
  const std::vector<std::string> names{"libpalpate-absent.so.3", "libpalpate-absent.so"};
  const auto library = SharedLibrary::open(names, "Its product");
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().reason, "no-library");
  EXPECT_EQ(sentence(library.error()),
            "Its product is not installed (looked for libpalpate-absent.so.3, "
            "libpalpate-absent.so); install it from its maker's site, where the system looks for "
            "libraries.");
}

TEST(SharedLibrary, SaysOfOneThatIsThereWhyItCannotBeLoaded) {
  const support::ScratchFolder folder;
  const std::string broken = folder.write("broken.so", "no library").string();
  const std::vector<std::string> names{"libpalpate-absent.so", broken};
  const auto library = SharedLibrary::open(names, "Its product");
  ASSERT_FALSE(library);
  EXPECT_EQ(sentence(library.error()).find("Its product: " + broken + " cannot be loaded ("), 0u)
      << sentence(library.error());
}

TEST(SharedLibrary, KeepsTheFirstFunctionThatIsNotThere) {
  const std::vector<std::string> names{stubs::dhd()};
  auto library = SharedLibrary::open(names, "");
  ASSERT_TRUE(library);
  int (*there)() = nullptr;
  int (*absent)() = nullptr;
  library->find(absent, "dhdFindNone");
  library->need(there, "dhdGetDeviceCount");
  EXPECT_EQ(absent, nullptr);
  EXPECT_NE(there, nullptr);
  EXPECT_EQ(library->lacks(), "");
  library->need(absent, "dhdFirst");
  library->need(absent, "dhdSecond");
  EXPECT_EQ(library->lacks(), "dhdFirst");
}

}  // namespace
