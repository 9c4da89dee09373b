// SPDX-License-Identifier: BSD-3-Clause
#include "app/loader.h"

#include <algorithm>
#include <cmath>

#include "app/start_pose.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/tool_mesh.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/tool/point_shell.h"
#include "resources/named_tools.h"

namespace app {
namespace {

using haptics::Error;
using haptics::Expected;

Error cancelled() { return {Error::Kind::Cancelled, "Loading was cancelled.", "cancelled"}; }

struct Source {
  ui::Picture picture;
  std::optional<double> isovalue = {};
  std::string tool = "probe";
  QString title;
};

// bone where the unit tells, else halfway up: something to see and touch at once
double firstIsovalue(const haptics::Volume& volume) {
  if (volume.unit == "HU" && volume.least < 300.0 && volume.greatest > 300.0) return 300.0;
  return volume.least + 0.5 * (volume.greatest - volume.least);
}

Expected<Source> readSource(const LoadRequest& request, const std::function<void(double)>& advanced,
                            const std::atomic<bool>& cancel) {
  Source source;
  if (request.path) {
    const datasets::ReadProgress progress{.advanced = [&](double f) { advanced(0.8 * f); },
                                          .cancel = &cancel};
    auto volume = datasets::readVolume(*request.path, request.series, progress);
    if (!volume) return tl::unexpected(volume.error());
    source.title = QString::fromStdString(request.path->filename().string());
    source.picture = ui::pictureOf(std::make_shared<const haptics::Volume>(std::move(*volume)));
  } else if (request.phantom) {
    auto phantom = datasets::makePhantom(*request.phantom);
    if (!phantom) return tl::unexpected(phantom.error());
    source.isovalue = phantom->isovalue;
    source.tool = phantom->tool;
    source.title = QString::fromStdString(*request.phantom);
    source.picture =
        ui::pictureOf(std::make_shared<const haptics::Volume>(std::move(phantom->volume)));
  } else if (request.keep) {
    source.picture = *request.keep;
  } else {
    return tl::unexpected(Error{Error::Kind::NotFound, "There is nothing to load.", "nothing"});
  }
  return source;
}

Expected<haptics::Tool> readTool(const ToolSource& source, QString& note) {
  if (!source.file) {
    auto mesh = resources::namedToolMesh(source.name);
    if (!mesh) return tl::unexpected(mesh.error());
    return haptics::makeTool(source.name, std::move(*mesh));
  }
  using datasets::MeshUnit;
  const MeshUnit unit = source.unit == "m"    ? MeshUnit::Metre
                        : source.unit == "cm" ? MeshUnit::Centimetre
                        : source.unit == "in" ? MeshUnit::Inch
                                              : MeshUnit::Millimetre;
  auto file = datasets::readToolMesh(*source.file, unit);
  if (!file) return tl::unexpected(file.error());
  for (const std::string& warning : file->warnings)
    note += (note.isEmpty() ? "" : " ") + QString::fromStdString(warning);
  return haptics::makeTool(source.file->stem().string(), std::move(file->mesh));
}

}  // namespace

Expected<Loaded> load(const LoadRequest& request, const std::function<void(double)>& advanced,
                      const std::atomic<bool>& cancel) {
  auto source = readSource(request, advanced, cancel);
  if (!source) return tl::unexpected(source.error());
  if (cancel) return tl::unexpected(cancelled());
  advanced(0.85);

  Loaded loaded;
  loaded.picture = std::move(source->picture);
  loaded.title = source->title;
  const haptics::Volume& volume = *loaded.picture.volume;
  loaded.isovalue = request.isovalue.value_or(source->isovalue.value_or(firstIsovalue(volume)));
  if (!(loaded.isovalue > volume.least)) {
    loaded.note =
        QObject::tr("The isovalue must lie above the volume's least value, %1.").arg(volume.least);
    loaded.isovalue = firstIsovalue(volume);
  }
  if (volume.replaced > 0)
    loaded.note +=
        QObject::tr(" %1 voxels were not numbers and count as background.").arg(volume.replaced);
  loaded.tool = request.tool.value_or(ToolSource{.name = source->tool});
  auto tool = readTool(loaded.tool, loaded.note);
  if (!tool) return tl::unexpected(tool.error());
  if (cancel) return tl::unexpected(cancelled());
  advanced(0.9);
  auto scene = haptics::makeScene(loaded.picture.volume, std::move(*tool));
  if (!scene) return tl::unexpected(scene.error());
  if (cancel) return tl::unexpected(cancelled());
  advanced(0.98);
  const auto start = startPose(**scene, loaded.isovalue);
  if (!start)
    return tl::unexpected(
        Error{Error::Kind::Unsupported,
              "There is no room for the tool near this volume at this isovalue; try a smaller "
              "tool or another isovalue.",
              "no-start"});
  loaded.start = *start;
  loaded.scene = std::move(*scene);
  return loaded;
}

Loader::Loader(QObject* parent) : QObject(parent) {}

Loader::~Loader() {
  if (!job_) return;
  job_->cancel = true;
  job_->thread.join();
}

void Loader::cancel() {
  if (job_) job_->cancel = true;
}

void Loader::onThisThread(std::uint64_t number, std::function<void()> action) {
  QMetaObject::invokeMethod(
      this,
      [this, number, action = std::move(action)] {
        if (number == number_) action();
      },
      Qt::QueuedConnection);
}

void Loader::start(LoadRequest request) {
  if (job_) {
    job_->cancel = true;
    job_->thread.join();
  }
  const std::uint64_t number = ++number_;
  job_ = std::make_unique<Job>();
  Job* job = job_.get();
  job->thread = std::thread([this, job, number, request = std::move(request)] {
    const auto advanced = [&](double fraction) {
      onThisThread(number, [this, fraction] { emit progressed(fraction); });
    };
    auto result = load(request, advanced, job->cancel);
    if (result)
      onThisThread(number, [this, loaded = std::move(*result)] { emit this->loaded(loaded); });
    else
      onThisThread(number,
                   [this, request, error = result.error()] { emit failed(request, error); });
  });
}

}  // namespace app
