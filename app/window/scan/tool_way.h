// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "haptics/core/geometry.h"

namespace app {

/// The way of a tool since it started, from its places as they are seen.
///
/// A place counts once it is kStep away from the last that counted: the tremor of a tool at rest,
/// some micrometres, would otherwise add up. A curve of radius r is measured short by
/// kStep^2/(24 r^2) of its length, which is nothing at 1 mm.
class ToolWay {
 public:
  static constexpr double kStep = 50e-6;  // m

  /// The tool is here; [m] W.
  void add(const haptics::Vec3& p_W) {
    if (!from_) from_ = last_ = p_W;
    here_ = p_W;
    if (jumped_) last_ = p_W;
    jumped_ = false;
    const double step = (p_W - last_).norm();
    if (step < kStep) return;
    length_ += step;
    last_ = p_W;
  }
  /// The tool was put elsewhere: what lies between is no way.
  void jump() { jumped_ = from_.has_value(); }

  bool begun() const { return from_.has_value(); }
  const haptics::Vec3& from() const { return *from_; }
  const haptics::Vec3& here() const { return here_; }
  double length() const { return length_; }  ///< m
  double straight() const { return (here_ - *from_).norm(); }

 private:
  std::optional<haptics::Vec3> from_;
  haptics::Vec3 last_ = haptics::Vec3::Zero(), here_ = haptics::Vec3::Zero();
  double length_ = 0.0;
  bool jumped_ = false;
};

}  // namespace app
