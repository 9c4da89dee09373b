// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "app/fetch/multipart.h"
#include "app/fetch/qido.h"

namespace {

using namespace app::fetch;

/// The parts of a body that comes in pieces of some size; nothing if it is refused or not whole.
std::optional<std::vector<std::string>> partsOf(const std::string& body, std::size_t piece,
                                                std::vector<std::string>* ended = nullptr) {
  std::vector<std::string> parts;
  std::string open;
  Multipart reader{"edge",
                   {.began =
                        [&] {
                          open.clear();
                          return haptics::Expected<void>{};
                        },
                    .bytes =
                        [&](std::span<const char> bytes) {
                          open.append(bytes.data(), bytes.size());
                          return haptics::Expected<void>{};
                        },
                    .ended =
                        [&] {
                          parts.push_back(open);
                          return haptics::Expected<void>{};
                        }}};
  bool sound = true;
  for (std::size_t at = 0; sound && at < body.size(); at += piece)
    sound = reader.feed(std::string_view(body).substr(at, piece)).has_value();
  if (ended != nullptr) *ended = parts;
  if (!sound || !reader.finish()) return {};
  return parts;
}

TEST(Multipart, HasTheSamePartsInPiecesOfAnySize) {
  // a part that nearly holds the boundary, an empty one, and one without header fields
  const std::string near = "a\r\n--edg\r\n-\r\n--\r\n\r\n--edgf";
  const std::string body =
      "preamble\r\n--edge\r\nContent-Type: application/dicom\r\nMIME: 1\r\n\r\n" + near +
      "\r\n--edge  \r\nContent-Length: 12345\r\n\r\n\r\n--edge\r\n\r\nlast" +
      "\r\n--edge--\r\nepilogue\r\n--edge\r\n\r\nno part";
  for (std::size_t piece = 1; piece <= body.size(); ++piece) {
    SCOPED_TRACE(piece);
    const auto parts = partsOf(body, piece);
    ASSERT_TRUE(parts);
    EXPECT_EQ(*parts, (std::vector<std::string>{near, "", "last"}));
  }
}

TEST(Multipart, TakesPartsThatAreLargerThanWhatComesAtOnce) {
  const std::string large(300'000, 'x');
  const std::string body = "--edge\r\n\r\n" + large + "\r\n--edge\r\n\r\n" + large + "\r\n--edge--";
  for (const std::size_t piece : {std::size_t{1000}, std::size_t{65536}, body.size()})
    EXPECT_EQ(partsOf(body, piece), (std::vector<std::string>{large, large})) << piece;
}

TEST(Multipart, NeverEndsAPartThatWasCutOff) {
  const std::string body = "--edge\r\n\r\none\r\n--edge\r\n\r\ntwo\r\n--edge--";
  for (std::size_t length = 0; length < body.size(); ++length) {
    SCOPED_TRACE(length);
    std::vector<std::string> ended;
    EXPECT_FALSE(partsOf(body.substr(0, length), 7, &ended));
    for (const std::string& part : ended) EXPECT_TRUE(part == "one" || part == "two") << part;
    EXPECT_LE(ended.size(), length < 36 ? 1U : 2U);
  }
}

TEST(Multipart, RefusesWhatWouldFillTheMemory) {
  EXPECT_FALSE(partsOf(std::string(100'000, 'x') + "\r\n--edge\r\n\r\na\r\n--edge--", 1000));
  std::string header = "--edge\r\n";
  for (int n = 0; n < 2000; ++n) header += "Name: value\r\n";
  EXPECT_FALSE(partsOf(header + "\r\na\r\n--edge--", 1000));
  // nobody reads what comes behind the last part
  const std::string whole = "--edge\r\n\r\na\r\n--edge--";
  EXPECT_TRUE(partsOf(whole + std::string(60'000, 'x'), 1000));
  EXPECT_FALSE(partsOf(whole + std::string(100'000, 'x'), 1000));
  EXPECT_FALSE(partsOf(whole + std::string(100'000, 'x'), 200'000));
  EXPECT_FALSE(partsOf("--edgeless\r\n\r\na\r\n--edge--", 1000));
}

TEST(Multipart, TakesTheBoundaryFromTheContentType) {
  EXPECT_EQ(boundaryOf("multipart/related; type=\"application/dicom\"; boundary=\"a b\""), "a b");
  EXPECT_EQ(boundaryOf("Multipart/Related;BOUNDARY=xY_1;type=application/dicom"), "xY_1");
  EXPECT_EQ(boundaryOf("application/dicom"), "");
  EXPECT_EQ(boundaryOf("application/dicom; transfer-syntax=1.2"), "");
  for (const char* none : {"", "text/html", "application/dicom+json", "multipart/related",
                           "multipart/related; boundary=", "multipart/related; boundary=\"a"})
    EXPECT_FALSE(boundaryOf(none)) << none;
  EXPECT_FALSE(boundaryOf("multipart/related; boundary=" + std::string(71, 'x')));
}

std::string study(const std::string& uid) {
  return R"({"0020000D":{"vr":"UI","Value":[")" + uid + R"("]}})";
}

TEST(Qido, LeavesOutWhatHasNoIdentifier) {
  const auto found = findingsFrom("[" + study("1.2.3") + "," + study("../../etc") + "," +
                                      study("1..2") + "," + study("") + "," + study("1.2/3") + "," +
                                      study(std::string(65, '1')) + ",{},{\"0020000D\":7}]",
                                  Level::Study);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->series.size(), 1U);
  EXPECT_EQ(found->series[0].study_uid, "1.2.3");
  EXPECT_EQ(found->refused, 7U);
}

TEST(Qido, ReadsWhatAListShows) {
  const auto found = findingsFrom(
      R"([{"0020000D":{"vr":"UI","Value":["1.2"]},"0020000E":{"vr":"UI","Value":["1.2.3"]},
      "00080060":{"vr":"CS","Value":["MR"]},"00200011":{"vr":"IS","Value":[7]},
      "00201209":{"vr":"IS","Value":["120"]},"0008103E":{"vr":"LO","Value":["thin"]},
      "00100010":{"vr":"PN","Value":[{"Alphabetic":"A^B"}]},"00080020":{"vr":"DA","Value":["20240305"]}}])",
      Level::Series);
  ASSERT_TRUE(found && found->series.size() == 1);
  FoundSeries expected;
  expected.study_uid = "1.2", expected.series_uid = "1.2.3", expected.modality = "MR";
  expected.number = 7, expected.images = 120, expected.series_description = "thin";
  expected.patient_name = "A^B", expected.study_date = "20240305";
  EXPECT_EQ(found->series[0], expected);
}

TEST(Qido, RefusesWhatIsNoList) {
  for (const char* text : {"{}", "7", "[", "[7]", "[\"1.2\"]", "<html>", "[{\"0020000D\":"})
    EXPECT_FALSE(findingsFrom(text, Level::Study)) << text;
  EXPECT_FALSE(findingsFrom(std::string(1'000'000, '['), Level::Study));
  EXPECT_TRUE(findingsFrom("", Level::Study));
  const auto images =
      imagesFrom(R"([{"00080018":{"vr":"UI","Value":["1.2"]}},{"00080018":{"Value":["x"]}}])");
  ASSERT_TRUE(images);
  EXPECT_EQ(*images, std::vector<std::string>{"1.2"});
}

TEST(Qido, AModalityNamesNobody) {
  EXPECT_EQ(modalityOf("CT"), "CT");
  EXPECT_EQ(modalityOf("MR "), "MR");
  EXPECT_EQ(modalityOf("SMITH"), "OT");
  EXPECT_EQ(modalityOf(""), "OT");
}

TEST(FoundSeries, HaveAnOrderThatDoesNotDependOnTheServers) {
  std::vector<FoundSeries> series;
  for (int n = 0; n < 60; ++n) {
    FoundSeries one;
    one.study_uid = "1.2." + std::to_string(n % 4 + 1);
    one.series_uid = one.study_uid + "." + std::to_string(n % 20 + 1);
    one.study_date = n % 4 < 2 ? "20240305" : "20230101";
    if (n % 3 != 0) one.number = n % 5;
    one.number = one.series_uid.size() % 3;
    series.push_back(one);
  }
  std::vector<FoundSeries> once = series;
  sortSeries(once);
  EXPECT_EQ(once.size(), 20U);
  EXPECT_EQ(once.front().study_date, "20240305");
  std::mt19937 dice{7};
  for (int trial = 0; trial < 100; ++trial) {
    std::ranges::shuffle(series, dice);
    std::vector<FoundSeries> again = series;
    sortSeries(again);
    ASSERT_EQ(once, again);
  }
  EXPECT_NE(checkOf(once[0]), checkOf(once[1]));
}

}  // namespace
