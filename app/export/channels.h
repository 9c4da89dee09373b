// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/recording/recording.h"

namespace app::exporting {

inline constexpr const char* kMissing = "n/a";
inline constexpr const char* kFrame = "scan";

/// Shortest digits; kMissing for what is not finite.
void append(std::string& line, double number);
void append(std::string& line, float number);
void append(std::string& line, std::int64_t number);
/// Seconds with all nine decimals: as exact as the ns.
void appendSeconds(std::string& line, std::int64_t ns);

/// What is told of the distance to a structure, by its number from 1.
struct NearnessColumn {
  std::uint8_t structure;  ///< from 0
  float haptics::Nearness::*distance;
  std::string name;     ///< "tip_to_3"
  std::string path;     ///< "structures/3/tip"
  std::string meaning;  ///< a clause
  /// m; not a number: the structure was not watched.
  float of(const haptics::Step& step) const;
};
/// Of the structures that the recording watched; none if it watched none.
std::vector<NearnessColumn> nearnessColumns(const Recording& recording);

inline constexpr const char* kRemovedMeaning =
    "volume that the burr has removed within the isosurface since the first row";

/// A column of the tables of text: of CSV and of Motion-BIDS.
struct Channel {
  std::string name, component, type, point, unit, frame, description;
  /// `first_ns`: time of the first row.
  std::function<void(std::string&, const RecordedStep&, std::int64_t first_ns)> append;
};

/// In the order of Motion-BIDS.
std::vector<Channel> motionChannels(const Recording& recording);

/// The frame of poses and vectors, as Motion-BIDS describes it.
nlohmann::ordered_json frameOf(const Recording& recording);
/// What each kind of event means.
nlohmann::ordered_json kindsOfEvents();

}  // namespace app::exporting
