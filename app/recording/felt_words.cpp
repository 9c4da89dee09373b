// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/felt_words.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "haptics/process/input_file.h"

namespace app {
namespace {

using haptics::Feel;
using nlohmann::ordered_json;

/// A number of an object; none where it is not there or not above 0.
std::optional<double> positive(const ordered_json& object, const char* name) {
  if (!object.contains(name) || !object[name].is_number()) return {};
  const auto number = object[name].get<double>();
  if (!(number > 0.0 && number < 1e6)) return {};
  return number;
}

std::optional<Feel> feelFrom(const ordered_json& said) {
  if (!said.contains("feel")) return {};
  if (said["feel"] == "softer") {
    const auto stiffness = positive(said, "stiffness");
    if (!stiffness) return {};
    return Feel{.kind = Feel::Kind::Softer, .stiffness = *stiffness};
  }
  if (said["feel"] == "solid") return Feel{.kind = Feel::Kind::Solid};
  if (said["feel"] == "not-there") return Feel{.kind = Feel::Kind::NotThere};
  const auto margin = positive(said, "margin"), most = positive(said, "most");
  if (said["feel"] != "guarded" || !margin || !most) return {};
  return Feel{.kind = Feel::Kind::Guarded, .margin = *margin, .most = *most};
}

}  // namespace

haptics::Error structureMissing(std::uint8_t structure) {
  return {haptics::Error::Kind::NotFound,
          {"replay-structure-missing", {std::to_string(structure + 1)}},
          "no-structures"};
}

std::string wordsOf(const haptics::Watch& watch) {
  ordered_json all = ordered_json::array();
  for (const haptics::Watch::Watched& watched : watch.structures) {
    const Feel& feel = watched.feel;
    if (feel.kind == Feel::Kind::AsScan) continue;
    ordered_json one{{"number", watched.structure + 1}};
    switch (feel.kind) {
      case Feel::Kind::AsScan:
        break;
      case Feel::Kind::Softer:
        one.update({{"feel", "softer"}, {"stiffness", feel.stiffness}});
        break;
      case Feel::Kind::Guarded:
        one.update({{"feel", "guarded"}, {"margin", feel.margin}, {"most", feel.most}});
        break;
      case Feel::Kind::Solid:
        one["feel"] = "solid";
        break;
      case Feel::Kind::NotThere:
        one["feel"] = "not-there";
        break;
    }
    all.push_back(std::move(one));
  }
  return all.empty() ? std::string{} : all.dump();
}

haptics::Expected<haptics::Watch> feltAsSaid(const std::string& words,
                                             const haptics::Watch& watch) {
  haptics::Watch felt = watch;
  for (haptics::Watch::Watched& watched : felt.structures) watched.feel = {};
  if (words.empty()) return felt;
  const auto damaged = [] {
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Malformed, {"recording-damaged", {}}, "damaged"});
  };
  const ordered_json said = haptics::isNestedDeeper(words, 3)
                                ? ordered_json{}
                                : ordered_json::parse(words, nullptr, false);
  if (!said.is_array()) return damaged();
  for (const ordered_json& one : said) {
    if (!one.is_object() || !one.contains("number") || !one["number"].is_number_integer())
      return damaged();
    const auto feel = feelFrom(one);
    if (!feel) return damaged();
    const auto number = one["number"].get<std::int64_t>();
    if (number < 1 || number > 255) return damaged();
    const auto structure = static_cast<std::uint8_t>(number - 1);
    const auto at =
        std::ranges::find(felt.structures, structure, &haptics::Watch::Watched::structure);
    if (at == felt.structures.end()) return tl::unexpected(structureMissing(structure));
    at->feel = *feel;
  }
  return felt;
}

}  // namespace app
