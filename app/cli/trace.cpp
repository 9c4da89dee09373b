// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/trace.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "app/cli/sources.h"

namespace app::cli {
namespace {

using haptics::Error;

/// A column of a hand: its name in a trace, and other names that mean the same.
struct HandColumn {
  const char* name;
  std::array<std::string_view, 4> others;
};
constexpr std::array<HandColumn, 8> kHandColumns{{
    {"t_s", {"t", "time", "time_s", "seconds"}},
    {"device_x_m", {"x", "x_m", "device_x", "px"}},
    {"device_y_m", {"y", "y_m", "device_y", "py"}},
    {"device_z_m", {"z", "z_m", "device_z", "pz"}},
    {"device_qw", {"qw", "w", "quat_w", "device_quat_w"}},
    {"device_qx", {"qx", "i", "quat_x", "device_quat_x"}},
    {"device_qy", {"qy", "j", "quat_y", "device_quat_y"}},
    {"device_qz", {"qz", "k", "quat_z", "device_quat_z"}},
}};

bool isCalled(const std::string& name, const HandColumn& column) {
  const auto same = [&](std::string_view other) {
    return std::ranges::equal(
        name, other, [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
  };
  return same(column.name) || std::ranges::any_of(column.others, same);
}

}  // namespace

haptics::Expected<TraceWriter> TraceWriter::open(const std::string& path,
                                                 const haptics::Watch* watch) {
  auto file = haptics::OutputFile::open(path);
  if (!file) return tl::unexpected(file.error());
  file->write(
      "t_s,device_x_m,device_y_m,device_z_m,device_qw,device_qx,device_qy,device_qz,"
      "proxy_x_m,proxy_y_m,proxy_z_m,proxy_qw,proxy_qx,proxy_qy,proxy_qz,"
      "force_x_N,force_y_N,force_z_N,torque_x_Nm,torque_y_Nm,torque_z_Nm,contacts");
  if (watch != nullptr)
    for (const haptics::Watch::Watched& watched : watch->structures) {
      const std::string number = std::to_string(watched.structure + 1);
      file->write(",tip_to_" + number + "_m,nearest_to_" + number + "_m");
    }
  file->write("\n");
  return TraceWriter{std::move(*file)};
}

void TraceWriter::write(const haptics::TraceRow& row) {
  const haptics::Quat q_D = haptics::rotationOf(row.X_WD), q_P = haptics::rotationOf(row.X_WP);
  const haptics::Vec3 d = row.X_WD.translation(), p = row.X_WP.translation();
  const haptics::Vec3 &f = row.sent_W.force, &m = row.sent_W.torque;
  const double numbers[] = {row.time, d.x(), d.y(), d.z(), q_D.w(), q_D.x(), q_D.y(),
                            q_D.z(),  p.x(), p.y(), p.z(), q_P.w(), q_P.x(), q_P.y(),
                            q_P.z(),  f.x(), f.y(), f.z(), m.x(),   m.y(),   m.z()};
  char line[2048];
  char* at = line;
  for (const double number : numbers) {
    at = std::to_chars(at, line + sizeof line - 32, number).ptr;
    *at++ = ',';
  }
  at = std::to_chars(at, line + sizeof line - 1, row.contacts).ptr;
  for (const haptics::Nearness& near : row.near)
    for (const float distance : {near.tip, near.nearest}) {
      *at++ = ',';
      at = std::to_chars(at, line + sizeof line - 1, distance).ptr;
    }
  *at++ = '\n';
  file_.write({line, static_cast<std::size_t>(at - line)});
}

haptics::Expected<void> TraceWriter::finish() {
  if (auto closed = file_.close(); !closed) return closed;
  if (auto finished = file_.finish(); !finished) return tl::unexpected(finished.error());
  return {};
}

haptics::Expected<RecordedHand> readHand(const std::string& path) {
  auto table = readNumbers(path, kHandColumns.size());
  if (!table) return tl::unexpected(table.error());
  const auto refused = [](haptics::Message why) {
    return tl::unexpected(Error{Error::Kind::Malformed, std::move(why)});
  };
  for (std::size_t c = 0; c < kHandColumns.size(); ++c)
    if (!isCalled(table->names[c], kHandColumns[c])) {
      std::string all;
      for (const HandColumn& column : kHandColumns)
        all += (all.empty() ? "" : ", ") + std::string{column.name};
      return refused({"poses-names",
                      {path, std::to_string(c + 1), table->names[c], kHandColumns[c].name, all}});
    }
  std::vector<double> times;
  std::vector<haptics::Pose> poses;
  for (std::size_t n = 0; n < table->rows.size(); ++n) {
    const std::vector<double>& row = table->rows[n];
    const std::string line = std::to_string(table->lines[n]);
    const haptics::Quat q{row[4], row[5], row[6], row[7]};
    if (!(q.norm() > 0.5 && q.norm() < 2.0)) return refused({"poses-no-rotation", {path, line}});
    constexpr double kFarthest = 100.0;  // m
    for (std::size_t c = 1; c < 4; ++c)
      if (!(std::abs(row[c]) <= kFarthest)) return refused({"poses-too-far", {path, line}});
    // whatever its clock says, the hand starts with its first row
    const double time = row[0] - table->rows.front()[0];
    if (!times.empty() && !(time > times.back())) return refused({"poses-time", {path, line}});
    times.push_back(time);
    poses.push_back(haptics::poseOf({row[1], row[2], row[3]}, q));
  }
  const double seconds = times.back();
  auto hand = haptics::Hand::along(std::move(times), std::move(poses));
  if (!hand) return tl::unexpected(hand.error());
  return RecordedHand{std::move(*hand), seconds};
}

}  // namespace app::cli
