// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/walls.h"

namespace app {

std::vector<datasets::StructureWall> wallsOf(const haptics::Watch* watch) {
  std::vector<datasets::StructureWall> walls;
  if (watch == nullptr) return walls;
  for (const haptics::Watch::Watched& watched : watch->structures)
    if (watched.feel.isWall())
      walls.push_back(
          {watched.structure, watched.feel.kind == haptics::Feel::Kind::Solid, watched.distances});
  return walls;
}

}  // namespace app
