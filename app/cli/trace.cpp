// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/trace.h"

#include <charconv>
#include <cmath>

#include "app/cli/sources.h"

namespace app::cli {
namespace {

using haptics::Error;

}  // namespace

haptics::Expected<TraceWriter> TraceWriter::open(const std::string& path) {
  auto file = haptics::OutputFile::open(path);
  if (!file) return tl::unexpected(file.error());
  file->write(
      "t_s,device_x_m,device_y_m,device_z_m,device_qw,device_qx,device_qy,device_qz,"
      "proxy_x_m,proxy_y_m,proxy_z_m,proxy_qw,proxy_qx,proxy_qy,proxy_qz,"
      "force_x_N,force_y_N,force_z_N,torque_x_Nm,torque_y_Nm,torque_z_Nm,contacts\n");
  return TraceWriter{std::move(*file)};
}

void TraceWriter::write(const haptics::TraceRow& row) {
  const haptics::Quat q_D = haptics::rotationOf(row.X_WD), q_P = haptics::rotationOf(row.X_WP);
  const haptics::Vec3 d = row.X_WD.translation(), p = row.X_WP.translation();
  const haptics::Vec3 &f = row.sent_W.force, &m = row.sent_W.torque;
  const double numbers[] = {row.time, d.x(), d.y(), d.z(), q_D.w(), q_D.x(), q_D.y(),
                            q_D.z(),  p.x(), p.y(), p.z(), q_P.w(), q_P.x(), q_P.y(),
                            q_P.z(),  f.x(), f.y(), f.z(), m.x(),   m.y(),   m.z()};
  char line[1024];
  char* at = line;
  for (const double number : numbers) {
    at = std::to_chars(at, line + sizeof line - 32, number).ptr;
    *at++ = ',';
  }
  at = std::to_chars(at, line + sizeof line - 1, row.contacts).ptr;
  *at++ = '\n';
  file_.write({line, static_cast<std::size_t>(at - line)});
}

haptics::Expected<void> TraceWriter::finish() {
  if (auto closed = file_.close(); !closed) return closed;
  if (auto finished = file_.finish(); !finished) return tl::unexpected(finished.error());
  return {};
}

haptics::Expected<haptics::Hand> readHand(const std::string& path) {
  auto rows = readNumbers(path, 8);
  if (!rows) return tl::unexpected(rows.error());
  std::vector<double> times;
  std::vector<haptics::Pose> poses;
  for (const std::vector<double>& row : *rows) {
    const haptics::Quat q{row[4], row[5], row[6], row[7]};
    if (!(q.norm() > 0.5 && q.norm() < 2.0))
      return tl::unexpected(Error{Error::Kind::Malformed, {"poses-no-rotation", {path}}});
    constexpr double kFarthest = 100.0;  // m
    for (std::size_t c = 1; c < 4; ++c)
      if (!(std::abs(row[c]) <= kFarthest))
        return tl::unexpected(Error{Error::Kind::Malformed, {"poses-too-far", {path}}});
    times.push_back(row[0]);
    poses.push_back(haptics::poseOf({row[1], row[2], row[3]}, q));
  }
  return haptics::Hand::along(std::move(times), std::move(poses));
}

}  // namespace app::cli
