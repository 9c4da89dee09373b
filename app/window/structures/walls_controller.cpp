// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/structures/walls_controller.h"

#include <algorithm>
#include <utility>

#include "app/recording/walls.h"
#include "app/window/scan/sentence.h"
#include "app/window/scan/start_pose.h"
#include "haptics/scene/legal_pose.h"

namespace app {
namespace {

constexpr int kRestMs = 300;  // without another isovalue, before walls are made at it

bool isSameWall(const datasets::StructureWall& one, const datasets::StructureWall& other) {
  return one.structure == other.structure && one.solid == other.solid &&
         one.distances.samples == other.distances.samples;
}

}  // namespace

WallsController::WallsController(ui::Messages& messages, SharedState& shared)
    : messages_(messages), shared_(shared) {
  soon_.setSingleShot(true);
  soon_.setInterval(kRestMs);
  connect(&soon_, &QTimer::timeout, this, &WallsController::showScene);
}

void WallsController::setWatch(const std::shared_ptr<const haptics::Watch>& watch) {
  std::vector<datasets::StructureWall> walls = wallsOf(watch.get());
  if (std::ranges::equal(walls, walls_, isSameWall)) return;
  walls_ = std::move(walls);
  maker_.abandon();
  showScene();
}

void WallsController::showIsovalue() {
  if (!walls_.empty()) soon_.start();
}

bool WallsController::isAsWanted() const {
  const datasets::Walled* now = datasets::walledOf(*shared_.shown->scene->volume);
  if (now == nullptr || walls_.empty()) return now == nullptr && walls_.empty();
  return now->isovalue == shared_.settings.isovalue &&
         std::ranges::equal(now->walls, walls_, [](const auto& wall, const auto& wanted) {
           return wall.structure == wanted.structure && wall.solid == wanted.solid;
         });
}

void WallsController::showScene() {
  if (!shared_.shown || shared_.replaying) return;
  if (isAsWanted()) return maker_.abandon();
  make();
}

void WallsController::make() {
  haptics::SceneOptions options = shared_.options;
  options.field = shared_.shown->scene->field.kind();
  maker_.start(
      [walls = walls_, seen = shared_.shown->seenScene(), before = shared_.shown->scene, options,
       isovalue = shared_.settings.isovalue](const background::Watch& watch) mutable
      -> haptics::Expected<std::shared_ptr<const haptics::Scene>> {
        const auto volume =
            datasets::walled(seen->volume, walls, isovalue, before->volume, &watch.cancel);
        if (!volume) return tl::unexpected(volume.error());
        if (*volume == seen->volume) return seen;
        options.cancel = &watch.cancel;
        return haptics::makeScene(*volume, seen->tool, options, before.get());
      },
      [this, seen = shared_.shown->seenScene()](
          haptics::Expected<std::shared_ptr<const haptics::Scene>> scene) {
        deliver(seen, std::move(scene));
      });
}

void WallsController::deliver(const std::shared_ptr<const haptics::Scene>& seen,
                              haptics::Expected<std::shared_ptr<const haptics::Scene>> scene) {
  if (!scene) {
    if (scene.error().kind != haptics::Error::Kind::Cancelled)
      messages_.showMessage(sentenceOf(scene.error()));
    return;
  }
  // an edit or another tool came meanwhile, and its scene asks for walls of its own
  if (!shared_.shown || shared_.replaying || shared_.shown->seenScene() != seen) return;
  if (*scene == shared_.shown->scene) return;
  Loaded loaded = *shared_.shown;
  loaded.scene = *scene;
  loaded.seen = *scene == seen ? nullptr : seen;
  loaded.note.clear();
  const double isovalue = shared_.settings.isovalue;
  if (const auto near = haptics::legalPoseNear(*loaded.scene, isovalue, loaded.start))
    loaded.start = *near;
  else
    loaded.start = startPose(*loaded.scene, isovalue).value_or(loaded.start);
  emit made(loaded);
}

}  // namespace app
