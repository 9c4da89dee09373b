// SPDX-License-Identifier: BSD-3-Clause
#include "app/loader.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

#include "app/start_pose.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/tool_mesh.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/tool/point_shell.h"
#include "resources/named_tools.h"
#include "ui/panels/isosurface_panel.h"

namespace app {
namespace {

using haptics::Error;
using haptics::Expected;

tl::unexpected<Error> refused(Error::Kind kind, const QString& what, const char* reason) {
  return tl::unexpected(Error{kind, what.toStdString(), reason});
}

tl::unexpected<Error> cancelled() {
  return refused(Error::Kind::Cancelled, Loader::tr("Loading was cancelled."), "cancelled");
}

void addTo(QString& note, const QString& sentence) {
  if (!note.isEmpty()) note += QLatin1Char(' ');
  note += sentence;
}

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
    auto volume = datasets::readVolume(*request.path, request.series, request.geometry, progress);
    if (!volume) return tl::unexpected(volume.error());
    source.title = QString::fromStdString(request.path->filename().string());
    if (volume->resampled) source.title = Loader::tr("%1 (resampled)").arg(source.title);
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
    return refused(Error::Kind::NotFound, Loader::tr("There is nothing to load."), "nothing");
  }
  return source;
}

Expected<haptics::Tool> readTool(const ToolSource& source, QString& note) {
  if (!source.file) {
    auto mesh = resources::namedToolMesh(source.name);
    if (!mesh) return tl::unexpected(mesh.error());
    return haptics::makeTool(source.name, std::move(*mesh));
  }
  const auto unit = datasets::meshUnitNamed(source.unit);
  if (!unit)
    return refused(Error::Kind::Unsupported,
                   Loader::tr("There is no unit \"%1\"; choose one of m, mm, cm, in.")
                       .arg(QString::fromStdString(source.unit)),
                   "unit");
  auto file = datasets::readToolMesh(*source.file, *unit);
  if (!file) return tl::unexpected(file.error());
  for (const std::string& warning : file->warnings) addTo(note, QString::fromStdString(warning));
  return haptics::makeTool(source.file->stem().string(), std::move(file->mesh));
}

}  // namespace

Expected<Loaded> load(const LoadRequest& request, const std::function<void(double)>& advanced,
                      const std::atomic<bool>& cancel) {
  auto source = readSource(request, advanced, cancel);
  if (!source) return tl::unexpected(source.error());
  if (cancel) return cancelled();
  advanced(0.85);

  Loaded loaded;
  loaded.picture = std::move(source->picture);
  loaded.title = source->title;
  const haptics::Volume& volume = *loaded.picture.volume;
  const double wanted = request.isovalue.value_or(source->isovalue.value_or(firstIsovalue(volume)));
  loaded.isovalue =
      ui::allowedIsovalue(volume, std::isfinite(wanted) ? wanted : firstIsovalue(volume));
  if (request.isovalue && loaded.isovalue != wanted)
    addTo(loaded.note,
          Loader::tr("The isovalue is %1 instead of %2: this volume goes from %3 to %4.")
              .arg(loaded.isovalue)
              .arg(wanted)
              .arg(volume.least)
              .arg(volume.greatest));
  if (volume.replaced > 0)
    addTo(loaded.note,
          Loader::tr("%1 voxels were not numbers and count as background.").arg(volume.replaced));
  if (volume.padded > 0)
    addTo(loaded.note, Loader::tr("%1 voxels are padding, where nothing was measured, and count "
                                  "as air.")
                           .arg(volume.padded));
  loaded.tool = request.tool.value_or(ToolSource{.name = source->tool});
  auto tool = readTool(loaded.tool, loaded.note);
  if (!tool) return tl::unexpected(tool.error());
  if (cancel) return cancelled();
  advanced(0.9);
  auto scene = haptics::makeScene(loaded.picture.volume, std::move(*tool), request.options,
                                  request.previous.get());
  if (!scene) return tl::unexpected(scene.error());
  if (cancel) return cancelled();
  advanced(0.98);
  const auto start = startPose(**scene, loaded.isovalue);
  if (!start)
    return refused(Error::Kind::Unsupported,
                   Loader::tr("There is no room for the tool near this volume at this isovalue; "
                              "try a smaller tool or another isovalue."),
                   "no-start");
  loaded.start = *start;
  loaded.scene = std::move(*scene);
  return loaded;
}

Loader::Loader(QObject* parent) : QObject(parent) {}

Loader::~Loader() {
  for (Job& job : jobs_) job.cancel = true;
  for (Job& job : jobs_) job.thread.join();
}

void Loader::cancel() {
  if (!jobs_.empty()) jobs_.back().cancel = true;
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
  for (Job& job : jobs_) job.cancel = true;
  // a job that cannot stop at once ends beside the new one
  jobs_.remove_if([](Job& job) {
    if (job.done) job.thread.join();
    return !job.thread.joinable();
  });
  const std::uint64_t number = ++number_;
  Job& job = jobs_.emplace_back();
  job.thread = std::thread([this, &job, number, request = std::move(request)] {
    work(job, number, request);
    job.done = true;
  });
}

void Loader::work(Job& job, std::uint64_t number, const LoadRequest& request) {
  const auto advanced = [&](double fraction) {
    onThisThread(number, [this, fraction] { emit progressed(fraction); });
  };
  Expected<Loaded> result;
  datasets::Survey survey;
  try {
    result = load(request, advanced, job.cancel);
    if (!result && result.error().reason == "which-series" && request.path)
      if (auto found = datasets::survey(*request.path)) survey = std::move(*found);
  } catch (const std::bad_alloc&) {
    result = refused(Error::Kind::Unsupported,
                     Loader::tr("There is not enough memory for this volume and tool; close other "
                                "programs or take a smaller one."),
                     "no-memory");
  } catch (const std::exception& thrown) {
    result =
        refused(Error::Kind::Malformed,
                Loader::tr("It could not be loaded: %1").arg(QString(thrown.what())), "exception");
  }
  if (result)
    onThisThread(number, [this, loaded = std::move(*result)] { emit this->loaded(loaded); });
  else
    onThisThread(number, [this, request, error = result.error(), survey = std::move(survey)] {
      emit failed(request, error, survey);
    });
}

}  // namespace app
