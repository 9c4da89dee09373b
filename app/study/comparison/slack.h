// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>

#include "app/study/comparison/measures.h"

namespace comparison {

/// Random displacements of a pose, normal in six directions.
class Nudge {
 public:
  explicit Nudge(std::uint32_t seed) : random_{seed} {}
  Pose operator()(const Pose& X, double linear, double angular);

 private:
  Vec3 triple() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

/// How far about a pose the local slack looks, in the mass metric [m].
inline constexpr double kSlackWithin = 5e-4;

/// The local slack of a pose: how much nearer to the device, in the mass metric [m], a legal pose
/// is that random legal steps reach within kSlackWithin. Every other of the `trials` steps is drawn
/// towards the device by as much as it is random; one that ends inside is taken out by the shortest
/// way; one that is nearer to the device, legal and takes no point through material is gone. Steps
/// begin at 0.05 mm, grow by 1.6 where they help and shrink by 0.93 where not, and stay between
/// 1e-7 m and 0.2 mm. At least what there is. None where the pose itself is not legal.
std::optional<double> localSlack(const Pose& X_WP, const Pose& X_WD,
                                 const haptics::PointShell& shell, const Judge& judge, int trials,
                                 std::uint32_t seed);

}  // namespace comparison
