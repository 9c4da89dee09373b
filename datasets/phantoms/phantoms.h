// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// An analytic volume and the isovalue of its surface.
struct Phantom {
  haptics::Volume volume;
  double isovalue = 0.0;
  std::string tool;  ///< the named tool that fits it
};

/// demo, mastoid, sphere, halfspace, torus, gyroid, wedge, hole, …
std::vector<std::string> phantomNames();
/// bunny, engine, bone: rebuilds of scenes of [Chan 2011], Table 1; its fourth is the phantom hole.
/// makePhantom() knows them too.
std::vector<std::string> paperSceneNames();

/// Makes a named phantom; deterministic to the bit. An unknown name lists the known ones. Once
/// `cancel` is true, no further layer is made and the result is Error::Kind::Cancelled.
haptics::Expected<Phantom> makePhantom(const std::string& name,
                                       const std::atomic<bool>* cancel = nullptr);

}  // namespace datasets
