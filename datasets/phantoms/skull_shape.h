// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// The demo head as formulas, in millimetres of its own: x towards the patient's left, y back,
/// z up; the braincase about (0, 12, 32). Distances are signed, positive outside, right near
/// their surface and only a bound far from it.
namespace datasets::skull {

using Vec3f = Eigen::Vector3f;

/// Where the grid's middle, W's origin, lies in the head's coordinates.
inline const Vec3f kMiddle{0.0f, -9.0f, -6.0f};

/// A solid with few parameters. Its box and blend bound the region that it can affect.
struct Primitive {
  enum class Kind : std::uint8_t { Ellipsoid, Cone, Arch };
  Kind kind = Kind::Ellipsoid;
  Vec3f a = Vec3f::Zero();     ///< centre; start of a cone
  Vec3f b = Vec3f::Ones();     ///< radii; end of a cone
  float ra = 1.0f, rb = 1.0f;  ///< radii at the ends of a cone; half width and height of an arch
  float yaw_cos = 1.0f, yaw_sin = 0.0f;  ///< an ellipsoid's turn about z
  Vec3f squash = Vec3f::Ones();          ///< a cone's scale by axis: less than 1 stretches it
  float blend = 0.0f;                    ///< mm over which it melts into what came before

  float distance(const Vec3f& p) const;
  /// The box beyond which it is further than `margin` away: its middle and half extent.
  void bounds(Vec3f& middle, Vec3f& half) const;
};

/// The united primitives; later ones melt into earlier ones.
using Solid = std::vector<Primitive>;
float distanceTo(const Solid& solid, const Vec3f& p);

/// Primitives within `margin` of a box.
Solid near(const Solid& solid, const Vec3f& middle, const Vec3f& half, float margin);

/// What lies within a radius of the line between two places; a ball if they are one.
struct Rod {
  Vec3f from, to;
  float radius;
};
/// The parts of the head that are rods. Those of the left side have a mirror image.
struct Rods {
  Rod left_eye{{33, -77, -4}, {33, -77, -4}, 12.0f};
  Rod left_carotid{{20, 2, -10}, {20, 2, -50}, 3.0f};
  Rod left_jugular{{29, 18, -10}, {29, 22, -50}, 4.0f};
  Rod spine{{0, 36, -50}, {0, 42, -130}, 8.0f};
  Rod burr_hole{{48, 16, 100}, {34, 14, 60}, 5.5f};  // on the left alone
};

/// The parts of the head. Bone is `bone` and `teeth` minus the hollows.
struct Anatomy {
  Solid bone, teeth;
  Solid septa;  ///< thin bone that stands within the hollows
  Solid fat;    ///< hollows that hold soft tissue: orbits, foramina
  Solid air;    ///< hollows that hold air
  Solid eyes;
  Solid skin;       ///< the head's outer surface
  Solid skin_cuts;  ///< eye sockets, nostrils and the like, taken from the skin
};
Anatomy anatomy();

/// The cranial cavity: negative within the brain's space.
float cavityDistance(const Vec3f& p);

/// Depth of the sutures and the unevenness of the vault at p: added to the distance to bone [mm].
float relief(const Vec3f& p);

}  // namespace datasets::skull
