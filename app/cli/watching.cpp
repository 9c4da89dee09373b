// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/watching.h"

#include <cmath>
#include <set>

#include "app/cli/interrupts.h"
#include "app/cli/options.h"
#include "datasets/labels/distances.h"
#include "datasets/labels/label_file.h"

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

}  // namespace

void addWatching(CLI::App& command, WatchChoice& choice) {
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
}

Expected<std::shared_ptr<const Watch>> watchOver(const WatchChoice& choice,
                                                 const haptics::Volume& scan) {
  if (choice.labels.empty()) return nullptr;
  const auto labels = datasets::readLabels(choice.labels, scan, {.cancel = &interruption()});
  if (!labels) return tl::unexpected(labels.error());
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
    if (number > count || labels->structures()[std::size_t(number - 1)].voxels == 0)
      return notThere({"watch-no-structure", {std::to_string(number), std::to_string(count)}});
    const auto structure = std::uint8_t(number - 1);
    auto map =
        datasets::distancesTo(*labels, structure, options, [](double) { return !interrupted(); });
    if (!map) return tl::unexpected(map.error());
    watch->structures.push_back({structure, std::move(*map)});
  }
  return watch;
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
