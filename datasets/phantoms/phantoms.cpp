// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/phantoms/phantoms.h"

#include <span>

#include "datasets/phantoms/analytic.h"
#include "datasets/phantoms/mastoid.h"
#include "datasets/phantoms/skull.h"

namespace datasets {
namespace {

struct Entry {
  const char* name;
  haptics::Expected<Phantom> (*make)(const std::atomic<bool>* cancel);
};

constexpr Entry kPhantoms[] = {
    {"demo", skullPhantom},          {"mastoid", mastoidPhantom}, {"sphere", spherePhantom},
    {"halfspace", halfSpacePhantom}, {"torus", torusPhantom},     {"gyroid", gyroidPhantom},
    {"wedge", wedgePhantom},         {"hole", holePhantom},       {"slot", slotPhantom},
    {"cylinder", cylinderPhantom},   {"marker", markerPhantom},
};

/// Up to 190 MB, and seconds to make.
constexpr Entry kPaperScenes[] = {
    {"bunny", bunnyPhantom}, {"engine", enginePhantom}, {"bone", bonePhantom}};

std::vector<std::string> namesOf(std::span<const Entry> entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

}  // namespace

std::vector<std::string> phantomNames() { return namesOf(kPhantoms); }
std::vector<std::string> paperSceneNames() { return namesOf(kPaperScenes); }

haptics::Expected<Phantom> makePhantom(const std::string& name, const std::atomic<bool>* cancel) {
  std::string known;
  for (const std::span<const Entry> entries : {std::span<const Entry>{kPhantoms}, {kPaperScenes}})
    for (const Entry& entry : entries) {
      if (name == entry.name) return entry.make(cancel);
      known += (known.empty() ? "" : ", ") + std::string{entry.name};
    }
  return tl::unexpected(haptics::Error{.kind = haptics::Error::Kind::NotFound,
                                       .message = {"name-unknown", {name, known}},
                                       .reason = "unknown-name"});
}

}  // namespace datasets
