// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/phantoms/phantoms.h"

#include "datasets/phantoms/analytic.h"
#include "datasets/phantoms/skull.h"

namespace datasets {
namespace {

struct Entry {
  const char* name;
  haptics::Expected<Phantom> (*make)(const std::atomic<bool>* cancel);
};

constexpr Entry kPhantoms[] = {
    {"demo", skullPhantom},    {"sphere", spherePhantom}, {"halfspace", halfSpacePhantom},
    {"torus", torusPhantom},   {"gyroid", gyroidPhantom}, {"wedge", wedgePhantom},
    {"hole", holePhantom},     {"slot", slotPhantom},     {"cylinder", cylinderPhantom},
    {"marker", markerPhantom},
};

}  // namespace

std::vector<std::string> phantomNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kPhantoms) names.emplace_back(entry.name);
  return names;
}

haptics::Expected<Phantom> makePhantom(const std::string& name, const std::atomic<bool>* cancel) {
  std::string known;
  for (const Entry& entry : kPhantoms) {
    if (name == entry.name) return entry.make(cancel);
    known += (known.empty() ? "" : ", ") + std::string{entry.name};
  }
  return tl::unexpected(haptics::Error{.kind = haptics::Error::Kind::NotFound,
                                       .message = {"name-unknown", {name, known}},
                                       .reason = "unknown-name"});
}

}  // namespace datasets
