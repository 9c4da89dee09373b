// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/cut_words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

#include "haptics/process/input_file.h"

namespace app {
namespace {

using nlohmann::ordered_json;

std::optional<double> numberIn(const ordered_json& object, const char* name, double least,
                               double most) {
  if (!object.contains(name) || !object[name].is_number()) return {};
  const auto number = object[name].get<double>();
  if (!(number >= least && number <= most)) return {};
  return number;
}

}  // namespace

std::string wordsOf(const haptics::CutLaw& law) {
  ordered_json bands = ordered_json::array();
  for (std::size_t n = 0; n < law.material.count; ++n)
    bands.push_back(
        {{"from", law.material.bands[n].from}, {"energy", law.material.bands[n].energy}});
  const haptics::Vec3& c = law.burr.centre_P;
  return ordered_json{{"centre", {c.x(), c.y(), c.z()}},
                      {"radius", law.burr.radius},
                      {"speed", law.speed},
                      {"share", law.share},
                      {"vibration", law.vibration},
                      {"material", bands}}
      .dump();
}

haptics::Expected<haptics::CutLaw> lawFrom(const std::string& words) {
  const auto damaged = [] {
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Malformed, {"recording-damaged", {}}, "damaged"});
  };
  constexpr int kDeepest = 4;
  const ordered_json said = haptics::isNestedDeeper(words, kDeepest)
                                ? ordered_json{}
                                : ordered_json::parse(words, nullptr, false);
  if (!said.is_object()) return damaged();
  haptics::CutLaw law;
  const auto radius = numberIn(said, "radius", haptics::kSmallestBurr, haptics::kLargestBurr),
             speed = numberIn(said, "speed", 0.0, 1e6), share = numberIn(said, "share", 0.0, 10.0),
             vibration = numberIn(said, "vibration", 0.0, 1.0);
  if (!radius || !speed || !share || !vibration || !said.contains("centre") ||
      !said.contains("material"))
    return damaged();
  const ordered_json &centre = said["centre"], &bands = said["material"];
  if (!centre.is_array() || centre.size() != 3 || !bands.is_array() || bands.empty() ||
      bands.size() > haptics::Material::kBands)
    return damaged();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const ordered_json& number = centre[static_cast<std::size_t>(axis)];
    if (!number.is_number() || !(std::abs(number.get<double>()) <= 10.0)) return damaged();
    law.burr.centre_P[axis] = number.get<double>();
  }
  law.burr.radius = *radius;
  law.speed = *speed;
  law.share = *share;
  law.vibration = *vibration;
  law.material.count = bands.size();
  for (std::size_t n = 0; n < bands.size(); ++n) {
    if (!bands[n].is_object()) return damaged();
    const auto from = numberIn(bands[n], "from", -1e12, 1e12),
               energy = numberIn(bands[n], "energy", 1.0, 1e15);
    if (!from || !energy) return damaged();
    law.material.bands[n] = {*from, *energy};
  }
  return law;
}

std::uint64_t digestOfCuts(const haptics::Volume& before, const haptics::Volume& after) {
  constexpr std::size_t kPage = 4096, kWord = sizeof(std::uint64_t);
  const std::size_t bytes =
      static_cast<std::size_t>(before.grid.voxelCount()) * haptics::sizeOf(before.type);
  const auto* then = static_cast<const std::uint8_t*>(before.voxels.get());
  const auto* now = static_cast<const std::uint8_t*>(after.voxels.get());
  const auto scrambled = [](std::uint64_t x) {
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27) * 0x94d049bb133111ebU;
    return x ^ x >> 31;
  };
  std::uint64_t digest = 0;
  for (std::size_t page = 0; page < bytes; page += kPage) {
    const std::size_t end = std::min(bytes, page + kPage);
    if (std::memcmp(then + page, now + page, end - page) == 0) continue;
    for (std::size_t at = page; at < end; at += kWord) {
      std::uint64_t was = 0, is = 0;
      const std::size_t size = std::min(kWord, end - at);
      std::memcpy(&was, then + at, size);
      std::memcpy(&is, now + at, size);
      if (was != is) digest = scrambled(digest ^ scrambled(is) ^ scrambled(at + 1));
    }
  }
  return digest;
}

std::string wordOf(std::uint64_t digest) {
  char word[17];
  std::snprintf(word, sizeof word, "%016llx", static_cast<unsigned long long>(digest));
  return word;
}

}  // namespace app
