// SPDX-License-Identifier: BSD-3-Clause
#include "resources/messages/messages.h"

#include <gtest/gtest.h>

#include <string>

namespace resources {
namespace {

using haptics::Error;
using haptics::Message;

TEST(Messages, FillTheirRow) {
  EXPECT_EQ(
      sentence(Message{"header-field-wrong", {"\"a.nrrd\"", "sizes"}}),
      "The header of \"a.nrrd\" states a \"sizes\" that makes no sense; correct it or export it "
      "again.");
  const Error error{Error::Kind::Cancelled, {"measurement-cancelled", {}}, "cancelled"};
  EXPECT_EQ(sentence(error), "The measurement was cancelled.");
}

TEST(Messages, OfPlainTextAreTheText) {
  EXPECT_EQ(sentence(Message{"50 % of %1"}), "50 % of %1");
  EXPECT_EQ(sentence(Message{}), "");
  EXPECT_TRUE(Message{}.empty());
  EXPECT_FALSE(Message{"a"}.empty());
  EXPECT_FALSE((Message{"disk-full", {}}).empty());
}

TEST(Messages, DoNotTouchTheNamesOfFiles) {
  EXPECT_EQ(sentence(Message{"table-row-short", {"%2 %1 %(3).csv", "3", "7"}}),
            "\"%2 %1 %(3).csv\" needs 3 numbers, separated by commas, in line 7.");
}

TEST(Messages, AreArgumentsOfOthers) {
  const Message full{"disk-full", {}};
  EXPECT_EQ(sentence(Message{"output-unwritable", {"/out/%2", full}}),
            "\"/out/%2\" cannot be written (the disk is full); choose a folder that can be written "
            "and has room.");
}

// where the sentence goes on behind another one
TEST(Messages, LoseTheirFullStop) {
  const Message stack{"dicom-one-stack", {"9"}};
  EXPECT_EQ(sentence(Message{"dicom-copies-left-out", {stack, "2"}}),
            "One evenly spaced stack of 9 slices; copies of its slices in the folder are left out: "
            "2.");
  EXPECT_EQ(sentence(Message{"dicom-fault-shared", {"No full stop", "1", "2"}}),
            "No full stop (1 of 2 files).");
}

TEST(Messages, WithoutARowSayTheirId) {
  EXPECT_EQ(sentence(Message{"no-such-row", {}}), "no-such-row");
  EXPECT_EQ(sentence(Message{"no-such-row", {"a", {"disk-full", {}}}}),
            "no-such-row: a, the disk is full");
}

TEST(Messages, WithTooFewArgumentsKeepThePlaces) {
  EXPECT_EQ(sentence(Message{"output-unwritable", {"/out"}}),
            "\"/out\" cannot be written (%2); choose a folder that can be written and has room.");
}

TEST(Messages, ArePutIntoAnotherLanguage) {
  const Wording other{
      .row = [](std::string_view english) { return "«" + std::string{english} + "»"; },
      .decimal_mark = ","};
  const Message aside{"dicom-slice-aside", {Message::numbers("0.5")}};
  EXPECT_EQ(sentence(aside),
            "A slice of the series lies 0.5 mm beside the others; ask for a reconstruction as one "
            "straight stack.");
  EXPECT_EQ(sentence(aside, other),
            "«A slice of the series lies 0,5 mm beside the others; ask for a reconstruction as one "
            "straight stack.»");
  const Row* row = rowIn(sentence(aside, other), other);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->id, "dicom-slice-aside");
  EXPECT_EQ(row->reason, "sheared");
  EXPECT_EQ(rowIn("The view was saved."), nullptr);
  // the name of a file is no number
  EXPECT_EQ(sentence(Message{"table-empty", {"a.1.csv"}}, other), "«\"a.1.csv\" holds no rows.»");
}

TEST(Messages, AreListed) {
  EXPECT_GT(rows().size(), 300u);
  for (const Row& row : rows()) {
    EXPECT_FALSE(row.id.empty() || row.english.empty()) << row.id;
    EXPECT_EQ(sentence(Message{std::string{row.id}.c_str(), {}}).empty(), false) << row.id;
  }
}

}  // namespace
}  // namespace resources
