// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "app/cli/commands.h"
#include "haptics/devices/catalogue.h"
#include "resources/messages/messages.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

ordered_json asJson(const haptics::DeviceRating& rating) {
  return {{"name", rating.name},
          {"force_N", rating.force},
          {"continuous_force_N", rating.continuous_force},
          {"torque_Nm", rating.torque},
          {"stiffness_N_m", rating.stiffness},
          {"angular_stiffness_Nm_rad", rating.angular_stiffness},
          {"damping_Ns_m", rating.damping},
          {"workspace_m", rating.workspace},
          {"resolution_m", rating.resolution},
          {"rate_Hz", rating.rate},
          {"source", rating.source}};
}

ordered_json asJson(const haptics::DeviceEntry& entry) {
  ordered_json json{{"id", entry.id},
                    {"name", entry.name},
                    {"sensed", entry.sensed},
                    {"actuated", entry.actuated},
                    {"present", entry.present},
                    {"trouble", haptics::wordOf(entry.trouble)},
                    {"why", resources::sentence(entry.why)}};
  const haptics::DeviceRating* rating = haptics::ratingOf(entry);
  json["rating"] = rating != nullptr ? asJson(*rating) : ordered_json{};
  return json;
}

/// The table for people: columns as wide as what is in them, and the sentences below their lines.
std::string asTable(const std::vector<haptics::DeviceEntry>& entries) {
  using Row = std::array<std::string, 6>;
  std::vector<Row> rows{{"id", "device", "sensed", "actuated", "force", "state"}};
  for (const haptics::DeviceEntry& entry : entries) {
    const haptics::DeviceRating* rating = haptics::ratingOf(entry);
    std::string force = "-";
    if (rating != nullptr && rating->force > 0.0) {
      char text[32];
      std::snprintf(text, sizeof text, "%.3g N", rating->force);
      force = text;
    }
    std::string state{haptics::wordOf(entry.trouble)};
    if (entry.trouble == haptics::Trouble::None) state = entry.present ? "ready" : "to-be-tried";
    rows.push_back({entry.id, entry.name, std::to_string(entry.sensed),
                    std::to_string(entry.actuated), force, state});
  }
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      text += rows[r][c];
      if (c + 1 < rows[r].size()) text.append(widths[c] - rows[r][c].size() + 2, ' ');
    }
    text += '\n';
    if (r > 0 && !entries[r - 1].why.empty())
      text += "    " + resources::sentence(entries[r - 1].why) + '\n';
  }
  // a device names itself: what would steer the terminal is not printed
  for (char& c : text)
    if (c != '\n' && (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)) c = '?';
  return text;
}

Outcome listDevices() {
  std::vector<haptics::DeviceEntry> entries = haptics::surveyDevices();
  std::ranges::stable_partition(entries, &haptics::DeviceEntry::present);
  Outcome outcome;
  outcome.json["drivers"] = ordered_json::array();
  for (const haptics::Driver& driver : haptics::drivers())
    outcome.json["drivers"].push_back(driver.name);
  outcome.json["devices"] = ordered_json::array();
  for (const haptics::DeviceEntry& entry : entries)
    outcome.json["devices"].push_back(asJson(entry));
  outcome.text = asTable(entries);
  return outcome;
}

}  // namespace

void addDevices(CLI::App& program, Chosen& chosen) {
  program.add_subcommand("devices", "List haptic devices: whether present, and why unusable")
      ->callback([&chosen] { chosen = listDevices; });
}

}  // namespace app::cli
