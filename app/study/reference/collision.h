// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/study/reference/choices.h"
#include "app/study/reference/solid.h"
#include "haptics/tool/point_shell.h"

namespace reference {

/// A point of the shell that holds the proxy off the surface ([Chan 2011], 2.3).
struct Contact {
  int point = 0;                   ///< index into the shell
  Vec3 r_W = Vec3::Zero();         ///< m, from the proxy's centre to the point
  Vec3 position_W = Vec3::Zero();  ///< m
  Vec3 n_W = Vec3::Zero();         ///< unit, out of the solid
  double gap = 0.0;                ///< m, to first order; negative inside
};

/// The point of the shell as a contact of the proxy in this pose. Its normal is zero where the
/// gradient vanishes.
Contact contactOf(const Solid& solid, const haptics::PointShell& shell, const Pose& X_WP,
                  int point);

/// Step 2: the contacts that still lie between proxy and device. Each point is moved a distance
/// epsilon along `free`, not beyond its end, and dropped if it is outside there. One that does not
/// move is judged where it stands.
std::vector<Contact> prune(const Solid& solid, const haptics::PointShell& shell,
                           const std::vector<Contact>& contacts, const Pose& X_WP,
                           const Twist& free);

/// How far a motion goes until a point of the shell meets the solid.
struct FirstHit {
  bool met = false;
  double t = 1.0;  ///< fraction of the motion to make: 1 if nothing is met
  int point = -1;  ///< the point that meets the solid
};

/// Step 4: the path of every point is cut into ceil(s / f) equal times, the ends of the pieces are
/// tested in the order of their time over all points, and the first piece that leads from outside
/// to inside is bisected until it is shorter than epsilon. `t` is its outside end; with
/// AcceptInside its inside end. A point that starts inside meets nothing until it has come out.
FirstHit firstHit(const Solid& solid, const haptics::PointShell& shell, const Pose& X_WP,
                  const Twist& motion);

/// The contact set that belongs to a hit: all points within epsilon of the surface, by the static
/// first-order distance (s - F) / |grad F| <= epsilon, and the point that was met. Points without
/// a gradient give no constraint and are left out.
std::vector<Contact> contactsAt(const Solid& solid, const haptics::PointShell& shell,
                                const Pose& X_WP, int met_point);

}  // namespace reference
