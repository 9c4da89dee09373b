// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/scan_ahead.h"

#include <exception>
#include <utility>

#include "app/background/task.h"
#include "haptics/tool/point_shell.h"
#include "resources/named_tools.h"

namespace app {

ScanAhead::ScanAhead(std::shared_ptr<ReadAhead> file) : file_(std::move(file)) {
  try {
    scan_ = std::async(std::launch::async, [this]() -> std::optional<Scan> {
      try {
        return make();
      } catch (const std::exception&) {  // no memory, say: the loader reads, and says so
        return {};
      }
    });
  } catch (const std::exception&) {
    // no thread: the loader reads
  }
}

ScanAhead::~ScanAhead() { cancel_ = true; }

std::optional<ScanAhead::Scan> ScanAhead::make() {
  auto read = file_->take({.advanced = [this](double f) { fraction_ = f; }, .cancel = &cancel_});
  if (!read) return {};
  background::goLast();  // the window's first drawing takes longer than this
  Scan scan{.volume = std::make_shared<const haptics::Volume>(std::move(*read))};
  auto picture = std::async(
      std::launch::async, [this, volume = scan.volume] { return ui::pictureOf(volume, &cancel_); });
  if (auto mesh = resources::namedToolMesh("probe"))
    if (auto tool = haptics::makeTool("probe", std::move(*mesh)))
      if (auto scene = haptics::makeScene(scan.volume, std::move(*tool), {.cancel = &cancel_}))
        scan.scene = std::move(*scene);
  scan.picture = picture.get();
  if (cancel_) return {};
  return scan;
}

std::optional<ScanAhead::Scan> ScanAhead::take(const datasets::ReadProgress& progress) {
  return takeWhenMade(scan_, fraction_, progress);
}

}  // namespace app
