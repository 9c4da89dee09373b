// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/scan/loader.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <future>
#include <variant>

#include "app/build_info/build_info.h"
#include "app/recording/volume_hash.h"
#include "app/window/scan/kept_phantom.h"
#include "app/window/scan/sentence.h"
#include "app/window/scan/start_pose.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/found.h"
#include "datasets/readers/meshes/tool_mesh.h"
#include "datasets/readers/volume_file.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/process/output_file.h"
#include "haptics/tool/point_shell.h"
#include "resources/named_tools.h"
#include "ui/dialogs/part_question.h"
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

constexpr const char* kDemo = "demo";  // the phantom that is kept

struct Source {
  std::shared_ptr<const haptics::Volume> volume;
  std::optional<ui::Picture> picture = {};           ///< one that was made already
  std::shared_ptr<const haptics::Scene> scene = {};  ///< one of this volume; null: none
  std::optional<double> isovalue = {};
  std::string tool = "probe";
  std::vector<ui::GreyPreset> greys = {};  ///< as in Loaded
  QString title;
  std::filesystem::path place = {};
  datasets::ScanIdentity identity = {};
};

// bone where the unit tells, else halfway up: something to see and touch at once
double firstIsovalue(const haptics::Volume& volume) {
  if (volume.unit == "HU" && volume.least < 300.0 && volume.greatest > 300.0) return 300.0;
  return volume.least + 0.5 * (volume.greatest - volume.least);
}

/// What a job is watched and stopped with.
struct Watch {
  std::function<void(double)> advanced;
  std::function<void(Surveyed)> surveyed;
  std::function<void(const datasets::Phantom&)> made;  ///< one that is to be kept
  std::function<double()> free_memory;
  const std::atomic<bool>& cancel;
};

// shares of the whole
constexpr double kSurveyed = 0.1, kRead = 0.8;

std::filesystem::path placeOf(const std::filesystem::path& path, const datasets::Survey& survey) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();
  // a file that is neither an archive nor a volume is one of a folder's slices
  const bool whole_file = survey.several || datasets::isVolumeFile(path);
  return std::filesystem::is_directory(whole, error) || whole_file ? whole : whole.parent_path();
}

// Whether one entry is not to be loaded without a word about another: that is larger, or could be
// loaded once it is corrected.
bool needsAWord(const datasets::SeriesVerdict& other, const datasets::SeriesVerdict& one) {
  const auto voxels = [](const datasets::SeriesVerdict& s) {
    return static_cast<double>(s.dims[0]) * static_cast<double>(s.dims[1]) *
           static_cast<double>(s.dims[2]);
  };
  return other.verdict == datasets::Verdict::Correctable || other.dims[2] > one.dims[2] ||
         voxels(other) > voxels(one);
}

/// Whether an entry is the scan of a request's grid, or could be.
bool fits(const LoadRequest& request, const datasets::SeriesVerdict& series) {
  std::array<std::int64_t, 3> dims = series.dims;
  haptics::Vec3 spacing_mm = series.spacing_mm;
  if (series.unbroken_part) {
    dims[2] = series.unbroken_part->slices;
    spacing_mm = series.unbroken_part->spacing_mm;
  } else if (series.verdict == datasets::Verdict::Refused) {
    return false;
  }
  return request.grid->dims == dims && spacing_mm.isApprox(request.grid->spacing * 1e3, 1e-6);
}

// Which entry to load without asking: the one that was named, else the only sound one, else the
// only one that could be corrected, where no other needs a word. Of a single refused one the
// reader says why.
Expected<datasets::SeriesVerdict> entryOf(const LoadRequest& request,
                                          const std::vector<datasets::SeriesVerdict>& all) {
  using datasets::Verdict;
  const int count = static_cast<int>(all.size());
  if (request.series && (*request.series < 0 || *request.series >= count))
    return refused(
        Error::Kind::NotFound,
        Loader::tr("\"%2\" has %n series, and none of the number %1: the first is number 0.",
                   nullptr, count)
            .arg(*request.series)
            .arg(nameOf(request)),
        "no-such-series");
  if (request.series) return all[static_cast<std::size_t>(*request.series)];
  const bool correct = request.geometry == datasets::Geometry::Corrected;
  const auto sound = [&](const datasets::SeriesVerdict& s) {
    return s.verdict == Verdict::Sound || (correct && s.verdict == Verdict::Correctable);
  };
  const auto correctable = [](const datasets::SeriesVerdict& s) {
    return s.verdict == Verdict::Correctable;
  };
  if (count == 1) return all.front();
  auto only = all.end();
  if (std::ranges::count_if(all, sound) == 1)
    only = std::ranges::find_if(all, sound);
  else if (std::ranges::none_of(all, sound) && std::ranges::count_if(all, correctable) == 1)
    only = std::ranges::find_if(all, correctable);
  if (only != all.end() && std::ranges::none_of(all, [&](const datasets::SeriesVerdict& other) {
        return other.index != only->index && needsAWord(other, *only);
      }))
    return *only;
  if (std::ranges::all_of(all, [](const auto& s) { return s.verdict == Verdict::Refused; }))
    return refused(Error::Kind::Unsupported,
                   Loader::tr("None of the %n series in \"%1\" can be loaded.", nullptr, count)
                       .arg(nameOf(request)),
                   kWhichSeries);
  return refused(Error::Kind::Unsupported,
                 Loader::tr("\"%1\" has %n series; choose one that can be loaded.", nullptr, count)
                     .arg(nameOf(request)),
                 kWhichSeries);
}

Expected<void> choose(LoadRequest& request, const Watch& watch) {
  const datasets::ReadProgress progress{
      .advanced = [&](double f) { watch.advanced(kSurveyed * f); }, .cancel = &watch.cancel};
  auto survey = datasets::survey(*request.path, progress);
  if (!survey) return tl::unexpected(survey.error());
  if (watch.cancel) return cancelled();
  const auto fitting = [&](const datasets::SeriesVerdict& s) { return fits(request, s); };
  if (request.grid && std::ranges::count_if(survey->series, fitting) == 1)
    request.series =
        static_cast<int>(std::ranges::find_if(survey->series, fitting) - survey->series.begin());
  auto entry = entryOf(request, survey->series);
  const std::filesystem::path place = placeOf(*request.path, *survey);
  const bool among_others = survey->series.size() > 1;
  watch.surveyed({*request.path, place, request.name, std::move(*survey)});
  if (!entry) return tl::unexpected(entry.error());
  request.chosen = ChosenSeries{std::move(*entry), among_others, place};
  return {};
}

// Before anything is read: by the estimate, what the memory holds with room to spare. A file of
// volumes is left to its reader, which maps what is large and refuses the rest as early.
Expected<void> checkMemory(const datasets::SeriesVerdict& series, bool in_part,
                           const Watch& watch) {
  if (std::holds_alternative<datasets::VolumeInFile>(series.found->source)) return {};
  double wanted = static_cast<double>(series.bytes) * ui::kMemoryPerVoxel;
  if (in_part)
    wanted *= static_cast<double>(series.unbroken_part->slices) /
              static_cast<double>(series.unbroken_part->of);
  const double there = watch.free_memory();
  if ((series.verdict == datasets::Verdict::Refused && !in_part) || wanted <= there) return {};
  const auto inWords = [](double bytes) {
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
  };
  return refused(Error::Kind::Unsupported,
                 Loader::tr("This series needs %1 of memory and %2 are free; close other programs.")
                     .arg(inWords(wanted), inWords(there)),
                 kTooLarge);
}

std::vector<ui::GreyPreset> greysOf(const datasets::SeriesVerdict& series) {
  std::vector<ui::GreyPreset> greys;
  for (const datasets::StatedWindow& window : series.windows)
    greys.push_back(
        {QString::fromStdString(window.name), {.level = window.level, .width = window.width}});
  return greys;
}

QString titleOf(const LoadRequest& request, const haptics::Volume& volume) {
  QString title = nameOf(request);
  if (request.chosen->among_others) {
    const QString series = QString::fromStdString(request.chosen->series.labels.series);
    title = Loader::tr("%1: %2").arg(
        title, series.isEmpty() ? Loader::tr("series %1").arg(request.chosen->series.index)
                                : series.simplified());
  }
  if (volume.slices_left_out > 0) {
    const datasets::UnbrokenPart& part = *request.chosen->series.unbroken_part;
    title = Loader::tr("%1 (%2 of %3 slices)").arg(title).arg(part.slices).arg(part.of);
  }
  if (volume.resampled) title = Loader::tr("%1 (resampled)").arg(title);
  if (request.part.step > 1)
    title = Loader::tr("%1 (every %2 voxel)").arg(title, ui::ordinal(request.part.step));
  if (request.part.box) title = Loader::tr("%1 (a box)").arg(title);
  return title;
}

Expected<Source> readChosen(const LoadRequest& request, const Watch& watch) {
  const datasets::SeriesVerdict& series = request.chosen->series;
  if (request.part.isWhole())
    if (const auto room = checkMemory(series, request.largest_part && series.unbroken_part, watch);
        !room)
      return tl::unexpected(room.error());
  const datasets::ReadProgress progress{
      .advanced = [&](double f) { watch.advanced(kSurveyed + (kRead - kSurveyed) * f); },
      .cancel = &watch.cancel};
  for (const auto& file : datasets::filesReadFor(series)) haptics::keepInput(file);
  haptics::keepInput(*request.path);  // an archive
  Source source;
  source.place = request.chosen->place;
  auto volume = datasets::readVolume(
      series,
      {.geometry = request.geometry, .largest_part = request.largest_part, .part = request.part},
      progress);
  if (!volume) return tl::unexpected(volume.error());
  source.volume = std::make_shared<const haptics::Volume>(std::move(*volume));
  source.greys = greysOf(series);
  source.identity = datasets::identityOf(series);
  source.title = titleOf(request, *source.volume);
  return source;
}

Expected<Source> readSource(const LoadRequest& request, const Watch& watch) {
  if (request.path) return readChosen(request, watch);
  Source source;
  if (request.phantom) {
    watch.advanced(kSurveyed);  // a bar without a fraction is in motion, beside the making
    std::optional<datasets::Phantom> kept;
    if (*request.phantom == kDemo) kept = keptPhantom(fileOfDemo(), buildHere());
    auto phantom = kept ? haptics::Expected<datasets::Phantom>(std::move(*kept))
                        : datasets::makePhantom(*request.phantom, &watch.cancel);
    if (!phantom) return tl::unexpected(phantom.error());
    if (*request.phantom == kDemo && !kept) watch.made(*phantom);
    source.isovalue = phantom->isovalue;
    source.tool = phantom->tool;
    source.title = nameOf(request);
    source.volume = std::make_shared<const haptics::Volume>(std::move(phantom->volume));
  } else if (request.keep) {
    source.volume = request.keep->volume;
    source.picture = request.keep->picture;
    source.greys = request.keep->greys;
    source.title = request.keep->title;
    source.place = request.keep->place;
    source.identity = request.keep->identity;
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
  haptics::keepInput(*source.file);
  auto file = datasets::readToolMesh(*source.file, *unit);
  if (!file) return tl::unexpected(file.error());
  for (const haptics::Message& warning : file->warnings) addTo(note, sentenceOf(warning));
  return haptics::makeTool(source.file->stem().string(), std::move(file->mesh));
}

Expected<Loaded> load(LoadRequest& request, const Watch& watch) {
  if (request.path && !request.chosen)
    if (const auto chosen = choose(request, watch); !chosen) return tl::unexpected(chosen.error());
  auto source = readSource(request, watch);
  if (!source) return tl::unexpected(source.error());
  if (watch.cancel) return cancelled();
  watch.advanced(0.85);

  // the picture beside tool and scene: each takes a core
  std::future<ui::Picture> picture;
  if (!source->picture)
    picture = std::async(std::launch::async, [volume = source->volume, &cancel = watch.cancel] {
      return ui::pictureOf(volume, &cancel);
    });

  Loaded loaded;
  loaded.greys = source->greys;
  loaded.title = source->title;
  loaded.place = source->place;
  loaded.identity = source->identity;
  const haptics::Volume& volume = *source->volume;
  const double wanted = request.isovalue.value_or(source->isovalue.value_or(firstIsovalue(volume)));
  loaded.isovalue =
      ui::allowedIsovalue(volume, std::isfinite(wanted) ? wanted : firstIsovalue(volume));
  if (request.isovalue && loaded.isovalue != wanted)
    addTo(loaded.note,
          Loader::tr(
              "The isovalue is %1 instead of %2: the values of this volume are between %3 and %4.")
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
  if (volume.beyond_bits > 0)
    addTo(loaded.note,
          Loader::tr("%1 voxels have bits beyond those that the files state as stored; their "
                     "values may be wrong.")
              .arg(volume.beyond_bits));
  loaded.tool = request.tool.value_or(ToolSource{.name = source->tool});
  auto tool = readTool(loaded.tool, loaded.note);
  if (!tool) return tl::unexpected(tool.error());
  if (loaded.tool.file)
    if (const auto key = installationKey()) loaded.tool.hash = hashOfFile(*loaded.tool.file, *key);
  if (watch.cancel) return cancelled();
  watch.advanced(0.9);
  haptics::SceneOptions options = request.options;
  options.cancel = &watch.cancel;
  auto scene = haptics::makeScene(source->volume, std::move(*tool), options,
                                  source->scene ? source->scene.get() : request.previous.get());
  if (!scene) return tl::unexpected(scene.error());
  if (watch.cancel) return cancelled();
  watch.advanced(0.98);
  const auto start = startPose(**scene, loaded.isovalue);
  if (!start)
    return refused(Error::Kind::Unsupported,
                   Loader::tr("There is no room for the tool near this volume at this isovalue; "
                              "try a smaller tool or another isovalue."),
                   "no-start");
  loaded.start = *start;
  loaded.scene = std::move(*scene);
  loaded.picture = picture.valid() ? picture.get() : std::move(*source->picture);
  if (watch.cancel) return cancelled();
  return loaded;
}

/// The error as the user reads it: exceptions know nothing of loading.
Error inWords(Error error) {
  if (error.reason == background::kNoMemory)
    error.message = Loader::tr(
                        "There is not enough memory for this volume and tool; close other "
                        "programs or take a smaller one.")
                        .toStdString();
  else if (error.reason == background::kThrew)
    error.message = Loader::tr("It could not be loaded: %1").arg(sentenceOf(error)).toStdString();
  return error;
}

}  // namespace

QString nameOf(const LoadRequest& request) {
  if (!request.path) return request.phantom ? phantomTitle(*request.phantom) : QString{};
  if (!request.name.isEmpty()) return request.name;
  const std::filesystem::path& path = *request.path;
  const auto name = path.has_filename() ? path.filename() : path.parent_path().filename();
  return QString::fromStdString(name.string());
}

QString labelOf(const ToolSource& tool) {
  if (tool.file) return QString::fromStdString(tool.file->filename().string());
  const resources::NamedTool* named = resources::findNamedTool(tool.name);
  return named == nullptr
             ? QString::fromStdString(tool.name)
             : QCoreApplication::translate("app::ToolController", named->title.c_str());
}

QString phantomTitle(const std::string& name) {
  return QCoreApplication::translate("app::phantomTitle", name.c_str());
}

Loader::Loader(std::function<double()> free_memory, QObject* parent)
    : QObject(parent),
      free_memory_(std::move(free_memory)),
      task_([this](double fraction) { emit progressed(fraction); }) {}

void Loader::start(LoadRequest request) {
  cancelled_ = false;
  // the work adds the entry that the survey chose; read once it has ended
  const auto wanted = std::make_shared<LoadRequest>(std::move(request));
  task_.start(
      [this, wanted, free_memory = free_memory_](const background::Watch& watch) {
        return load(*wanted,
                    {.advanced = [&](double fraction) { watch.advanced(fraction); },
                     .surveyed =
                         [&](Surveyed found) {
                           watch.tell([this, found = std::move(found)] { emit surveyed(found); });
                         },
                     .made =
                         [&](const datasets::Phantom& phantom) {
                           watch.tell([this, phantom] { keep(phantom); });
                         },
                     .free_memory = free_memory,
                     .cancel = watch.cancel});
      },
      [this, wanted](Expected<Loaded> result) {
        // its thread may have ended before the user cancelled
        if (cancelled_) result = cancelled();
        if (result) return emit loaded(*result);
        emit failed(*wanted, inWords(std::move(result.error())));
      });
}

void Loader::cancel() {
  cancelled_ = true;
  task_.cancel();
}

/// Beside the first picture, which does not wait for the disk.
void Loader::keep(const datasets::Phantom& phantom) {
  keeping_.start(
      [phantom](const background::Watch&) -> Expected<bool> {
        keepPhantom(fileOfDemo(), buildHere(), phantom);
        return true;
      },
      [](const Expected<bool>&) {});
}

}  // namespace app
