// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <string>

#include "app/fetch/input.h"

namespace {

using namespace app::fetch;

TEST(FetchInput, IsTakenWhole) {
  const auto input = inputFrom(
      R"({"query": {"patient_name": "A*", "study_date": "20240101-", "modality": "CT"}, "index": 3,
          "check": "0badcafe", "login": {"user": "u", "password": "p:\"q"}, "key_passphrase": "k"})");
  ASSERT_TRUE(input);
  EXPECT_EQ(input->query.patient_name, "A*");
  EXPECT_EQ(input->query.study_date, "20240101-");
  EXPECT_EQ(input->index, 3U);
  EXPECT_EQ(input->check, "0badcafe");
  EXPECT_EQ(input->password, "p:\"q");
  EXPECT_FALSE(input->query.isEmpty());
}

TEST(FetchInput, RefusesWhatNoSearchHas) {
  for (const char* text :
       {"", "[]", "{\"query\": 7}", "{\"quarry\": {}}", "{\"query\": {\"patient\": \"x\"}}",
        "{\"query\": {\"patient_id\": 7}}", "{\"query\": {\"patient_id\": \"a\\\\b\"}}",
        "{\"query\": {\"patient_id\": \"a\\u0000b\"}}", "{\"query\": {\"study_date\": \"2024\"}}",
        "{\"query\": {\"study_date\": \"-\"}}", "{\"query\": {\"study_date\": \"20240101-2024\"}}",
        "{\"index\": -1}", "{\"index\": 1.5}", "{\"index\": 5000}",
        "{\"login\": {\"user\": \"a:b\"}}", "{\"login\": {\"token\": \"a\\r\\nHost: b\"}}"}) {
    const auto input = inputFrom(text);
    ASSERT_FALSE(input) << text;
    EXPECT_EQ(input.error().reason, "usage") << text;
  }
  EXPECT_FALSE(inputFrom("{\"query\": {\"patient_id\": \"" + std::string(65, 'x') + "\"}}"));
}

TEST(FetchInput, IsEmptyWhereItMatchesEverything) {
  for (const char* text : {"{}", "{\"query\": {}}", "{\"query\": {\"patient_name\": \"*\"}}",
                           "{\"query\": {\"patient_id\": \"?* \", \"study_date\": \"\"}}"})
    EXPECT_TRUE(inputFrom(text)->query.isEmpty()) << text;
}

TEST(FetchInput, DoesNotWaitForTheEndOfTheStream) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const std::string text = "{\"query\":\n {\"patient_id\": \"}\"}}\n";
  ASSERT_EQ(write(ends[1], text.data(), text.size()), ssize_t(text.size()));
  const auto input = readInput(ends[0]);  // would wait for ever
  ASSERT_TRUE(input);
  EXPECT_EQ(input->query.patient_id, "}");
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
