// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/watching.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "app/cli/interrupts.h"
#include "app/cli/options.h"
#include "app/cli/terminal.h"
#include "datasets/labels/distances.h"
#include "datasets/labels/label_file.h"
#include "datasets/labels/tissues.h"
#include "resources/messages/messages.h"

namespace app::cli {

using haptics::Expected;
using haptics::Watch;

namespace {

tl::unexpected<haptics::Error> notThere(haptics::Message why) {
  return tl::unexpected(
      haptics::Error{haptics::Error::Kind::NotFound, std::move(why), "unknown-name"});
}

/// Metres as millimetres, to the nanometre.
double mm(double metres) { return std::round(metres * 1e9) / 1e6; }

bool hasVoxels(const datasets::LabelMap& labels, int number) {
  const auto& structures = labels.structures();
  return number >= 1 && std::size_t(number) <= structures.size() &&
         structures[std::size_t(number - 1)].voxels > 0;
}
tl::unexpected<haptics::Error> noStructure(const datasets::LabelMap& labels, int number) {
  return notThere(
      {"watch-no-structure", {std::to_string(number), std::to_string(labels.structures().size())}});
}

/// "3=softer:300" as the structure's number and how it is felt.
Expected<std::pair<int, haptics::Feel>> feelFrom(const std::string& text) {
  const auto wrong = [&] { return notThere({"feel-unreadable", {text}}); };
  std::vector<double> numbers;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return wrong();
  std::size_t at = text.find(':');
  const std::string kind = text.substr(equals + 1, at == std::string::npos ? at : at - equals - 1);
  while (at != std::string::npos) {
    const std::size_t next = text.find(':', at + 1);
    const auto number = numberIn<double>(text.substr(at + 1, std::min(next, text.size()) - at - 1));
    if (!number || !(*number > 0.0 && *number < 1e5)) return wrong();
    numbers.push_back(*number);
    at = next;
  }
  const auto number = numberIn<int>(text.substr(0, equals));
  if (!number) return wrong();
  const int structure = *number;
  if (kind == "solid" && numbers.empty())
    return std::pair{structure, haptics::Feel{.kind = haptics::Feel::Kind::Solid}};
  if (kind == "not-there" && numbers.empty())
    return std::pair{structure, haptics::Feel{.kind = haptics::Feel::Kind::NotThere}};
  if (kind == "softer" && numbers.size() == 1)
    return std::pair{structure,
                     haptics::Feel{.kind = haptics::Feel::Kind::Softer, .stiffness = numbers[0]}};
  if (kind == "guarded" && numbers.size() == 2 && numbers[0] <= 20.0)
    return std::pair{structure, haptics::Feel{.kind = haptics::Feel::Kind::Guarded,
                                              .margin = 1e-3 * numbers[0],
                                              .most = numbers[1]}};
  return wrong();
}

}  // namespace

void addWatching(CLI::App& command, WatchChoice& choice, bool felt) {
  CLI::Option* labels =
      command.add_option("--labels", choice.labels, "A label map of the scan, as info reads it")
          ->check(notEmpty());
  command
      .add_option("--watch", choice.structures,
                  "Numbers of its structures to which distances are measured in every tick, at "
                  "most 12; without it all")
      ->delimiter(',')
      ->needs(labels)
      ->check(wholeNumber(1, int(datasets::kMostStructures)));
  if (felt)
    command
        .add_option(
            "--feel", choice.feels,
            "How a structure that is watched is felt: N=softer:STIFFNESS [N/m], "
            "N=guarded:MARGIN:MOST [mm, N], N=solid or N=not-there; repeat it for more than one")
        ->allow_extra_args(false)
        ->needs(labels);
}

Expected<Labels> labelsOf(const WatchChoice& choice, const haptics::Volume& scan) {
  if (choice.labels.empty()) return nullptr;
  auto labels = datasets::readLabels(choice.labels, scan, {.cancel = &interruption()});
  if (!labels) return tl::unexpected(labels.error());
  for (const haptics::Message& note : labels->notes()) tell(resources::sentence(note));
  return std::make_shared<const datasets::LabelMap>(std::move(*labels));
}

Expected<std::shared_ptr<const Watch>> watchOver(const WatchChoice& choice, const Labels& labels) {
  if (labels == nullptr) return nullptr;
  const auto count = int(labels->structures().size());
  std::set<int> numbers(choice.structures.begin(), choice.structures.end());
  if (numbers.empty())
    for (int number = 1; number <= count; ++number)
      if (labels->structures()[std::size_t(number - 1)].voxels > 0) numbers.insert(number);
  if (numbers.size() > haptics::kMostWatched)
    return notThere({"watch-too-many",
                     {std::to_string(numbers.size()), std::to_string(haptics::kMostWatched)}});
  auto watch = std::make_shared<Watch>();
  const datasets::DistanceOptions options = datasets::distancesOf(numbers.size());
  for (const int number : numbers) {
    if (!hasVoxels(*labels, number)) return noStructure(*labels, number);
    const auto structure = std::uint8_t(number - 1);
    auto map =
        datasets::distancesTo(*labels, structure, options, [](double) { return !interrupted(); });
    if (!map) return tl::unexpected(map.error());
    watch->structures.push_back({structure, std::move(*map)});
  }
  for (const std::string& text : choice.feels) {
    const auto feel = feelFrom(text);
    if (!feel) return tl::unexpected(feel.error());
    const auto found = std::ranges::find_if(watch->structures, [&](const Watch::Watched& watched) {
      return numberOf(watched) == feel->first;
    });
    if (found == watch->structures.end()) return noStructure(*labels, feel->first);
    found->feel = feel->second;
  }
  return watch;
}

Expected<datasets::TissueTable> tissuesFrom(const std::vector<std::string>& texts,
                                            const datasets::LabelMap& labels) {
  std::vector<datasets::TissueWanted> wanted;
  for (const std::string& text : texts) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const auto number = numberIn<int>(text.substr(0, equals));
    const std::string kind = text.substr(std::min(equals + 1, text.size()));
    const auto energy = kind == "never" ? std::optional{haptics::Tissues::kNever} : energyIn(kind);
    if (!number || !energy) return notThere({"tissue-unreadable", {text}});
    if (!hasVoxels(labels, *number)) return noStructure(labels, *number);
    wanted.push_back({*number - 1, *energy});
  }
  return tissuesOf(labels, wanted);
}

Nearest::Nearest(std::shared_ptr<const Watch> watch) : watch_{std::move(watch)} {
  if (watch_)
    for (const Watch::Watched& one : watch_->structures) {
      const auto told = float(one.distances.told());
      least_.push_back({told, told});
    }
}

void Nearest::add(double time, const haptics::Nearnesses& near) {
  for (std::size_t n = 0; n < near.size(); ++n) {
    Least& least = least_[n];
    least.tip = std::min(least.tip, near[n].tip);
    if (near[n].nearest >= least.nearest) continue;
    least.nearest = near[n].nearest;
    least.at = time;
  }
}

nlohmann::ordered_json Nearest::report() const {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < least_.size(); ++n) {
    const Watch::Watched& watched = watch_->structures[n];
    const bool near = least_[n].nearest < float(watched.distances.told());
    nlohmann::ordered_json one{{"number", numberOf(watched)},
                               {"error_mm", mm(watched.distances.error)},
                               {"told_up_to_mm", mm(watched.distances.told())},
                               {"least_mm", mm(double(least_[n].nearest))},
                               {"least_of_tip_mm", mm(double(least_[n].tip))},
                               {"at_s", nullptr}};
    if (near) one["at_s"] = least_[n].at;
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace app::cli
