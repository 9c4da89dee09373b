// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/outcome.h"
#include "app/cli/sources.h"
#include "datasets/edits/edit.h"
#include "datasets/labels/label_map.h"
#include "haptics/scene/watch.h"

namespace app::cli {

/// The structures to which a run measures distances.
struct WatchChoice {
  std::string labels = {};           ///< a label map of the scan; empty: none is watched
  std::vector<int> structures = {};  ///< counted from 1, as info counts them; empty: all
  /// How a structure is felt: "3=softer:300" [N/m], "2=guarded:2:1.5" [mm, N], "1=solid",
  /// "4=not-there".
  std::vector<std::string> feels = {};
};
/// Adds --labels and --watch, and --feel where it is felt.
void addWatching(CLI::App& command, WatchChoice& choice, bool felt);

/// The label map of a choice; null: it has none. Refuses what readLabels() refuses.
using Labels = std::shared_ptr<const datasets::LabelMap>;
haptics::Expected<Labels> labelsOf(const WatchChoice& choice, const haptics::Volume& scan);

/// The structures with their distance maps; null where none is watched. Refuses a number that no
/// structure has, and more structures than a run can watch; and what is no --feel.
haptics::Expected<std::shared_ptr<const haptics::Watch>> watchOver(const WatchChoice& choice,
                                                                   const Labels& labels);

/// What it takes to cut structures, from the --tissue of a run. Refuses a number that no structure
/// has, and what is no --tissue.
haptics::Expected<datasets::TissueTable> tissuesFrom(const std::vector<std::string>& texts,
                                                     const datasets::LabelMap& labels);

/// The number by which the user knows a structure: from 1.
inline int numberOf(const haptics::Watch::Watched& watched) { return watched.structure + 1; }

/// How near the tool came to each structure.
class Nearest {
 public:
  explicit Nearest(std::shared_ptr<const haptics::Watch> watch);
  void add(double time, const haptics::Nearnesses& near);
  /// Of each structure the least distance of tip and tool, when it was, and how well it is known.
  nlohmann::ordered_json report() const;

 private:
  struct Least {
    float tip, nearest;  ///< m
    double at = 0.0;     ///< s: when the tool was nearest
  };
  std::shared_ptr<const haptics::Watch> watch_;
  std::vector<Least> least_;
};

}  // namespace app::cli
