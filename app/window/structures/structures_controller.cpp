// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/structures/structures_controller.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <utility>

#include "app/log/log.h"
#include "app/recording/felt_words.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "datasets/edits/edited.h"
#include "datasets/labels/distances.h"
#include "datasets/labels/label_file.h"
#include "datasets/labels/phantom_labels.h"
#include "datasets/labels/segments.h"
#include "datasets/labels/tissues.h"
#include "datasets/readers/volume_header.h"
#include "datasets/readers/volume_reader.h"
#include "ui/panels/structures_panel.h"
#include "ui/views/volume_view.h"

namespace app {
namespace {

// of all structures together, and of one
constexpr double kMm3PerM3 = 1e9;
constexpr std::int64_t kAllTriangles = 600'000, kLeastTriangles = 4'000, kMostTriangles = 60'000;

/// What a file is, as far as its header tells beside the scan on view, which is at `place`. Cancel:
/// the user knows.
ui::OpenedAs kindOf(const std::filesystem::path& path, const haptics::Volume& scan,
                    const std::filesystem::path& place) {
  if (path == place) return ui::OpenedAs::Scan;
  if (datasets::isStructures(path)) return ui::OpenedAs::Structures;
  if (!datasets::isVolumeFile(path)) return ui::OpenedAs::Scan;
  const auto survey = datasets::survey(path);
  const auto isLike = [&](const datasets::SeriesVerdict& series) {
    return series.dims == scan.grid.dims &&
           (series.spacing_mm - scan.grid.spacing * ui::kMmPerM).norm() < 1e-3;
  };
  return survey && std::ranges::all_of(survey->series, isLike) ? ui::OpenedAs::Cancel
                                                               : ui::OpenedAs::Scan;
}

/// The map as views have it; the voxels' codes are shared.
ui::StructureMap seenMapOf(const datasets::LabelMap& map) {
  ui::StructureMap seen{.grid = map.grid(), .codes = map.sharedCodes(), .sets = {}};
  for (int code = 0; code < map.codeCount(); ++code)
    seen.sets.push_back(map.structuresOf(static_cast<std::uint8_t>(code)));
  return seen;
}

/// As all of the program says it.
QString sizeWords(double bytes) {
  return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

QString nameOf(const datasets::StructuresFound& found) {
  return QString::fromStdString(datasets::shownName(found.name));
}

/// As the servo loop takes it. `told`: how far distances are [m].
haptics::Feel feelOf(const ui::StructureFeel& feel, double told) {
  using Kind = haptics::Feel::Kind;
  switch (feel.kind) {
    case ui::StructureFeel::Kind::Softer:
      return {.kind = Kind::Softer, .stiffness = feel.stiffness};
    case ui::StructureFeel::Kind::Guarded:
      return {.kind = Kind::Guarded,
              .margin = std::min(feel.margin_mm / ui::kMmPerM, 0.9 * told),
              .most = feel.most};
    case ui::StructureFeel::Kind::Solid:
      return {.kind = Kind::Solid};
    case ui::StructureFeel::Kind::NotThere:
      return {.kind = Kind::NotThere};
    case ui::StructureFeel::Kind::AsScan:
      break;
  }
  return {};
}

/// Whether two watches are the same to the servo loop; null: nothing is watched.
bool isSame(const haptics::Watch* one, const haptics::Watch* other) {
  if (one == nullptr || other == nullptr) return one == other;
  return std::ranges::equal(one->structures, other->structures,
                            [](const auto& a, const auto& b) {
                              return a.structure == b.structure &&
                                     a.distances.samples == b.distances.samples;
                            }) &&
         wordsOf(*one) == wordsOf(*other);
}

}  // namespace

StructuresController::StructuresController(ui::Views& views, ui::Messages& messages,
                                           ui::Loading& loading, ui::Menus& menus,
                                           ui::SidePanel& panels, SharedState& shared,
                                           PreferencesController& preferences,
                                           std::function<double()> free_memory)
    : views_(views),
      messages_(messages),
      loading_(loading),
      panels_(panels),
      shared_(shared),
      free_memory_(std::move(free_memory)),
      panel_(new ui::StructuresPanel),
      reader_([this](double fraction) { loading_.advance(fraction); }) {
  panels.add(panel_, tr("Structures"), tr("Structures"), "structuresSection", ui::Tab::Scan);
  connect(&menus, &ui::Menus::structuresWanted, this,
          [this](const QString& path) { open(path.toStdString()); });
  connect(&loading, &ui::Loading::cancelWanted, this, [this] { reader_.cancel(); });
  connect(panel_, &ui::StructuresPanel::openWanted, &menus, &ui::Menus::askForStructures);
  limits_ = preferences.present().near;
  limits_.close_mm = std::min(limits_.close_mm, limits_.near_mm);
  feel_ = preferences.present().feel;
  panel_->setLimits(limits_);
  connect(&preferences, &PreferencesController::saving, this, [this](Preferences& saved) {
    saved.near = limits_;
    saved.feel = feel_;
  });
  connectPanel();
  views.volume().addOverlay(near_line_);
}

void StructuresController::connectPanel() {
  using ui::StructureLook;
  using Panel = ui::StructuresPanel;
  connect(panel_, &Panel::foundWanted, this, [this](int number) {
    if (number < static_cast<int>(found_.size()))
      openFound(found_[static_cast<std::size_t>(number)]);
  });
  connect(panel_, &Panel::closeWanted, this, &StructuresController::close);
  connect(panel_, &Panel::goToWanted, this, &StructuresController::goTo);
  connect(panel_, &Panel::visibleChosen, this, [this](int number, bool visible) {
    before_alone_.clear();
    change(number, [&](StructureLook& look) { look.visible = visible; });
  });
  connect(panel_, &Panel::colourChosen, this, [this](int number, const QColor& colour) {
    change(number, [&](StructureLook& look) { look.colour = colour; });
  });
  connect(panel_, &Panel::opacityChosen, this, [this](int number, double opacity) {
    change(number, [&](StructureLook& look) { look.opacity = opacity; });
  });
  connect(panel_, &Panel::watchChosen, this, &StructuresController::watch);
  connect(panel_, &Panel::feelChosen, this, &StructuresController::feel);
  connect(panel_, &Panel::cuttingChosen, this, &StructuresController::chooseCutting);
  connect(panel_, &Panel::limitsChosen, this,
          [this](const ui::NearLimits& limits) { limits_ = limits; });
  panel_->setSoundPossible(NearSound::isPossible());
  connect(panel_, &Panel::soundChosen, &sound_, &NearSound::setOn);
  connect(panel_, &Panel::renamed, this, [this](int number, const QString& name) {
    const std::string shown = datasets::shownName(name.toStdString());
    change(number, [&](StructureLook& look) {
      if (shown.empty() || look.name.toStdString() == shown) return;
      look.name = QString::fromStdString(shown);
      look.own_name = true;
    });
  });
  connect(panel_, &Panel::aloneWanted, this, [this](int number) {
    const auto count = std::ranges::count_if(shown_.looks, &StructureLook::visible);
    const bool alone = count == 1 && shown_.looks[static_cast<std::size_t>(number)].visible;
    std::vector<bool> before;
    for (const StructureLook& look : shown_.looks) before.push_back(look.visible);
    for (std::size_t n = 0; n < shown_.looks.size(); ++n)
      shown_.looks[n].visible =
          alone ? before_alone_.empty() || before_alone_[n] : static_cast<int>(n) == number;
    // another one alone comes back to the same
    if (alone)
      before_alone_.clear();
    else if (before_alone_.empty())
      before_alone_ = std::move(before);
    show();
  });
  connect(panel_, &Panel::allWanted, this, [this](bool visible) {
    before_alone_.clear();
    for (StructureLook& look : shown_.looks) look.visible = visible;
    show();
  });
  connect(panel_, &Panel::throughChosen, this, [this](bool on) {
    shown_.through = on;
    show();
  });
  connect(panel_, &Panel::filledChosen, this, [this](bool on) {
    shown_.filled = on;
    show();
  });
}

template <class Change>
void StructuresController::change(int number, Change&& change) {
  if (number < 0 || number >= static_cast<int>(shown_.looks.size())) return;
  change(shown_.looks[static_cast<std::size_t>(number)]);
  show();
}

void StructuresController::show() {
  views_.show(shown_);
  panel_->show(shown_);
}

void StructuresController::sort(const QStringList& paths) {
  if (!shared_.shown || paths.size() != 1) return emit scanWanted(paths);
  const std::filesystem::path path = paths.first().toStdString();
  sorted_ = paths;
  // what is asked about the file waits for no disk here
  sorter_.start(
      [path, scan = scanOf(shared_.shown->volume()),
       place = shared_.shown->place](const background::Watch&) -> haptics::Expected<ui::OpenedAs> {
        return kindOf(path, *scan, place);
      },
      [this, paths, path](haptics::Expected<ui::OpenedAs> kind) {
        sorted_.clear();
        ui::OpenedAs as = kind.value_or(ui::OpenedAs::Scan);
        if (as == ui::OpenedAs::Cancel)
          as = messages_.askHowToOpen(QFileInfo(paths.first()).fileName());
        if (as == ui::OpenedAs::Structures) return open(path);
        if (as == ui::OpenedAs::Scan) emit scanWanted(paths);
      });
}

void StructuresController::open(const std::filesystem::path& path) {
  if (!shared_.shown)
    return messages_.showMessage(
        tr("There is no scan yet; open the scan of the structures first."));
  read(path, {.of = shared_.shown->identity});
}

void StructuresController::openFound(const datasets::StructuresFound& found) {
  if (!shared_.shown)
    return messages_.showMessage(
        tr("There is no scan yet; open the scan of the structures first."));
  read(found.path, {.of = shared_.shown->identity}, found.place);
}

void StructuresController::know(const Surveyed& surveyed) {
  found_at_ = surveyed.place;
  found_ = surveyed.survey.structures;
}

/// Says what was found with the scan on view.
void StructuresController::offerFound() {
  QStringList names;
  if (!found_.empty() && shared_.shown->place == found_at_)
    for (const datasets::StructuresFound& found : found_) names << nameOf(found);
  panel_->showFound(names);
  if (std::exchange(offered_, !names.isEmpty())) messages_.hideOffer();
  if (names.isEmpty()) return;
  messages_.showOffer(
      names.size() == 1 ? tr("Structures lie with the scan: \"%1\".").arg(names.front())
                        : tr("%n files of structures lie with the scan.", nullptr,
                             static_cast<int>(names.size())),
      names.size() == 1 ? tr("Open structures") : tr("Show the list"), [this, names] {
        if (names.size() == 1) return openFound(found_.front());
        panels_.reveal(panel_);
      });
}

bool StructuresController::mayTake(double bytes, const QString& what) {
  const double there = free_memory_();
  if (bytes <= there) return true;
  const QString why = tr("%1: %2 of memory are needed and %3 are free; close other programs.")
                          .arg(what, sizeWords(bytes), sizeWords(there));
  messages_.showMessage(why);
  emit refused(why);
  return false;
}

void StructuresController::read(const std::filesystem::path& path,
                                const datasets::LabelReading& reading,
                                const std::shared_ptr<const void>& kept) {
  file_ = path;
  read(
      [path, reading, kept,
       scan = scanOf(shared_.shown->volume())](const background::Watch& watch) {
        return datasets::readLabels(
            path, *scan,
            {.advanced = [&](double done) { watch.advanced(done); }, .cancel = &watch.cancel},
            reading);
      },
      [this, path, reading, kept](const haptics::Error& error) {
        return ask(path, reading, kept, error);
      });
}

bool StructuresController::ask(const std::filesystem::path& path, datasets::LabelReading reading,
                               const std::shared_ptr<const void>& kept,
                               const haptics::Error& error) {
  const QString why = sentenceOf(error);
  if (error.reason == "surface-space" && !reading.space) {
    if (const auto left = messages_.askIfLeft(why)) {
      reading.space = *left ? datasets::SurfaceSpace::Lps : datasets::SurfaceSpace::Ras;
      read(path, reading, kept);
    }
    return true;
  }
  if (error.kind != haptics::Error::Kind::Correctable) return false;
  // the file may be of another patient, or placed otherwise: the user knows
  reading.agreed = messages_.askWhether(
      why, tr("Structures of another patient, or of another place, mislead."), tr("Open anyway"));
  if (reading.agreed) read(path, reading, kept);
  return true;
}

void StructuresController::read(
    std::function<haptics::Expected<datasets::LabelMap>(const background::Watch&)> reading,
    std::function<bool(const haptics::Error&)> answer) {
  messages_.clear();
  const auto bytes = static_cast<double>(scanOf(shared_.shown->volume())->grid.voxelCount());
  if (!mayTake(bytes, tr("Structures"))) return;
  loading_.begin(tr("Reading the structures, %1 of memory").arg(sizeWords(bytes)));
  reader_.start(
      [reading = std::move(reading)](const background::Watch& watch) -> haptics::Expected<Read> {
        auto map = reading(watch);
        if (!map) return tl::unexpected(map.error());
        auto seen = std::make_shared<const ui::StructureMap>(seenMapOf(*map));
        auto boxes = ui::boxesOf(*seen, map->structures().size());
        return Read{map->structures(), map->notes(), std::move(seen), std::move(boxes),
                    std::make_shared<const datasets::LabelMap>(std::move(*map))};
      },
      [this, answer = std::move(answer)](haptics::Expected<Read> read) {
        loading_.end();
        if (read) return take(std::move(*read));
        if (read.error().kind == haptics::Error::Kind::Cancelled) return;
        if (answer && answer(read.error())) return;
        const QString why = sentenceOf(read.error());
        messages_.showMessage(why);
        emit refused(why);
      });
}

void StructuresController::take(Read read) {
  close();
  labels_ = std::move(read.labels);
  emit fileChanged(file_);
  shown_.map = std::move(read.map);
  const bool names_known = file_.empty();
  const datasets::DistanceOptions options = datasets::distancesOf(haptics::kMostWatched);
  for (std::size_t n = 0; n < read.structures.size(); ++n) {
    const datasets::Structure& structure = read.structures[n];
    const auto& [red, green, blue] = structure.colour;
    shown_.looks.push_back(
        {.name = structure.name.empty() ? tr("Structure %1").arg(n + 1)
                 : names_known
                     ? QCoreApplication::translate("app::structureTitle", structure.name.c_str())
                     : QString::fromStdString(structure.name),
         .colour = QColor::fromRgbF(static_cast<float>(red), static_cast<float>(green),
                                    static_cast<float>(blue)),
         .feel = feel_,
         .distance_bytes =
             structure.voxels == 0
                 ? 0
                 : datasets::distanceSamples(shown_.map->grid, read.boxes[n], options) *
                       static_cast<std::int64_t>(sizeof(std::int16_t)),
         .own_name = names_known});
  }
  log::write(log::Level::Info, "structures-opened", {{"structures", shown_.looks.size()}});
  show();
  showCutting();
  panels_.reveal(panel_);
  QStringList notes;
  for (const haptics::Message& note : read.notes) notes << sentenceOf(note);
  if (!notes.isEmpty()) messages_.showMessage(notes.join(' '));
  makeShapes(std::move(read.boxes));
}

void StructuresController::makeShapes(std::vector<haptics::VoxelBox> boxes) {
  places_mm_.assign(boxes.size(), {});
  maker_.start(
      [this, map = shown_.map,
       boxes = std::move(boxes)](const background::Watch& watch) -> haptics::Expected<bool> {
        background::goLast();  // an edit or another scan comes first
        const std::int64_t most =
            std::clamp(kAllTriangles / static_cast<std::int64_t>(boxes.size()), kLeastTriangles,
                       kMostTriangles);
        for (std::size_t n = 0; n < boxes.size() && !watch.cancelled(); ++n) {
          ui::StructureShape shape =
              ui::shapeOf(*map, static_cast<std::uint8_t>(n), boxes[n], most, watch.cancel);
          watch.tell([this, n, shape = std::move(shape)] {
            places_mm_[n] = shape.places_mm;
            if (shape.mesh) views_.volume().showShape(n, shape.mesh);
          });
        }
        return true;
      },
      [this](const haptics::Expected<bool>&) { emit opened(); });
}

void StructuresController::close() {
  maker_.abandon();
  places_mm_.clear();
  measurer_.abandon();
  tissue_maker_.abandon();
  chosen_.reset();
  if (std::exchange(labels_, nullptr)) emit fileChanged({});
  distances_.clear();
  before_alone_.clear();
  // how all of them are drawn stays
  shown_.map.reset();
  shown_.looks.clear();
  show();
  giveWatch();
}

bool StructuresController::mayWatch(int number) {
  if (number < 0 || number >= static_cast<int>(shown_.looks.size())) return false;
  const auto count = std::ranges::count_if(shown_.looks, &ui::StructureLook::watched);
  if (shown_.looks[static_cast<std::size_t>(number)].watched ||
      count < static_cast<std::ptrdiff_t>(haptics::kMostWatched))
    return true;
  messages_.showMessage(
      tr("Distances to %1 structures are told at a time; tell fewer of the others.")
          .arg(haptics::kMostWatched));
  return false;
}

void StructuresController::watch(int number, bool watched) {
  const bool told = watched && mayWatch(number);
  change(number, [&](ui::StructureLook& look) {
    look.watched = told;
    // nothing else is known of one that is not
    if (!told) look.feel.kind = ui::StructureFeel::Kind::AsScan;
  });
  makeDistances();
  giveWatch();
}

void StructuresController::feel(int number, const ui::StructureFeel& feel) {
  feel_ = feel;
  feel_.kind = ui::StructureFeel::Kind::AsScan;
  const bool felt = feel.kind != ui::StructureFeel::Kind::AsScan && mayWatch(number);
  change(number, [&](ui::StructureLook& look) {
    look.feel = felt ? feel : feel_;
    look.watched = look.watched || felt;
  });
  makeDistances();
  giveWatch();
}

void StructuresController::chooseCutting(int number, const ui::StructureCutting& cutting) {
  change(number, [&](ui::StructureLook& look) { look.cutting = cutting; });
  std::vector<datasets::TissueWanted> wanted;
  for (std::size_t n = 0; n < shown_.looks.size(); ++n) {
    const ui::StructureCutting& now = shown_.looks[n].cutting;
    if (now.kind == ui::StructureCutting::Kind::ByValue || labels_->structures()[n].voxels == 0)
      continue;
    wanted.push_back({static_cast<int>(n), now.kind == ui::StructureCutting::Kind::Never
                                               ? haptics::Tissues::kNever
                                               : now.energy_J_mm3 * kMm3PerM3});
  }
  // of another file's structures: they stay what they are
  std::vector<datasets::TissueTable::Part> others;
  const datasets::TissueTable* now = tissues();
  if (now != nullptr)
    std::ranges::copy_if(now->parts(), std::back_inserter(others),
                         [this](const auto& part) { return !isListed(part); });
  if (wanted.empty() && now == nullptr) return;
  tissue_maker_.start(
      [labels = labels_, wanted = std::move(wanted), others = std::move(others)](
          const background::Watch&) -> haptics::Expected<datasets::TissueTable> {
        const datasets::TissueTable made = tissuesOf(*labels, wanted);
        std::vector<datasets::TissueTable::Part> parts = made.parts();
        parts.insert(parts.end(), others.begin(), others.end());
        return datasets::TissueTable{made.dims(), std::move(parts)};
      },
      [this](const haptics::Expected<datasets::TissueTable>& table) {
        if (!table) return messages_.showMessage(sentenceOf(table.error()));
        chosen_ = *table;
        emit tissuesWanted(*table);
      });
}

void StructuresController::forgetChoice() {
  chosen_.reset();
  showCutting();
}

const datasets::TissueTable* StructuresController::tissues() const {
  return chosen_ ? &*chosen_ : datasets::tissuesIn(*shared_.shown->volume());
}

bool StructuresController::isListed(const datasets::TissueTable::Part& part) const {
  const auto number = static_cast<std::size_t>(part.structure);
  return number < shown_.looks.size() &&
         datasets::voxelsOf(part) == labels_->structures()[number].voxels;
}

void StructuresController::showCutting() {
  if (!shared_.shown || !labels_ || tissue_maker_.isRunning()) return;
  const datasets::TissueTable* made = datasets::tissuesIn(*shared_.shown->volume());
  if (chosen_ && made != nullptr && *made == *chosen_) chosen_.reset();
  const std::vector<ui::StructureLook> before = shown_.looks;
  for (ui::StructureLook& look : shown_.looks)
    look.cutting.kind = ui::StructureCutting::Kind::ByValue;
  if (const datasets::TissueTable* table = tissues())
    for (const datasets::TissueTable::Part& part : table->parts()) {
      if (!isListed(part)) continue;
      ui::StructureCutting& cutting =
          shown_.looks[static_cast<std::size_t>(part.structure)].cutting;
      cutting.kind = ui::StructureCutting::Kind::Never;
      if (part.energy == haptics::Tissues::kNever) continue;
      cutting.kind = ui::StructureCutting::Kind::Energy;
      cutting.energy_J_mm3 = part.energy / kMm3PerM3;
    }
  if (shown_.looks != before) show();
}

void StructuresController::makeDistances() {
  if (measurer_.isRunning() || !labels_) return;
  const auto isDue = [&](int n) {
    const auto number = static_cast<std::size_t>(n);
    return shown_.looks[number].watched && !distances_.contains(n) &&
           labels_->structures()[number].voxels > 0;
  };
  int number = 0;
  while (number < static_cast<int>(shown_.looks.size()) && !isDue(number)) ++number;
  if (number == static_cast<int>(shown_.looks.size())) return;
  const ui::StructureLook& due = shown_.looks[static_cast<std::size_t>(number)];
  const auto work = static_cast<double>(due.distance_bytes / 2 * datasets::kDistanceWork);
  if (!mayTake(work, tr("Distances to \"%1\"").arg(due.name))) return watch(number, false);
  measurer_.start(
      [labels = labels_, number](const background::Watch& watch) {
        background::goLast();  // an edit or another scan comes first
        // each of those that can be watched may have its share
        return datasets::distancesTo(*labels, static_cast<std::uint8_t>(number),
                                     datasets::distancesOf(haptics::kMostWatched),
                                     [&](double) { return !watch.cancelled(); });
      },
      [this, number](haptics::Expected<haptics::DistanceMap> map) {
        if (map) {
          distances_[number] = std::move(*map);
          giveWatch();
        } else {
          messages_.showMessage(sentenceOf(map.error()));
          return watch(number, false);
        }
        makeDistances();
      });
}

void StructuresController::giveWatch() {
  auto watch = std::make_shared<haptics::Watch>();
  for (const auto& [number, map] : distances_)
    if (const ui::StructureLook& look = shown_.looks[static_cast<std::size_t>(number)];
        look.watched)
      watch->structures.push_back(
          {static_cast<std::uint8_t>(number), map, feelOf(look.feel, map.told())});
  if (watch->structures.empty()) watch.reset();
  if (isSame(watch.get(), watch_.get())) return;
  const QString felt = watch ? QString::fromStdString(wordsOf(*watch)) : QString{};
  // a recording has one event for each change of the servo loop in which something is felt
  const bool told = !felt.isEmpty() || !felt_.isEmpty();
  felt_ = felt;
  if (told) emit feltChanged(felt_);
  watch_ = watch;
  shared_.session.watch(watch_);
  emit watchGiven(watch_);
  showNear({});
}

void StructuresController::refresh() {
  if (near_shown_ && !shared_.session.isOpen() && !shared_.replaying) showNear({});
}

void StructuresController::showNear(const haptics::Snapshot& snapshot) {
  std::vector<ui::StructureNear> lines;
  std::vector<std::pair<int, ui::StructureNear>> rows;
  for (const haptics::Nearness& near : snapshot.near) {
    const auto known = distances_.find(near.structure);
    if (near.structure >= shown_.looks.size() || known == distances_.end()) continue;
    const ui::StructureLook& look = shown_.looks[near.structure];
    lines.push_back({look.name, look.colour, double(near.nearest) * ui::kMmPerM,
                     near.nearest >= float(known->second.told())});
    rows.emplace_back(near.structure, lines.back());
  }
  if (lines.empty() && !near_shown_) return;
  near_shown_ = !lines.empty();
  panel_->showNear(rows);
  sound_.show(lines, limits_);
  near_line_.show(wayToNearest(snapshot));
  emit nearChanged(lines, limits_);
}

std::optional<ui::NearLine::Way> StructuresController::wayToNearest(
    const haptics::Snapshot& snapshot) const {
  const auto* const nearest =
      std::ranges::min_element(snapshot.near, {}, [](const auto& near) { return near.tip; });
  if (nearest == snapshot.near.end() || !shared_.shown) return {};
  const auto known = distances_.find(nearest->structure);
  if (known == distances_.end() || !(nearest->tip > 0.0F) ||
      nearest->tip >= float(known->second.told()))
    return {};
  const haptics::Vec3 tip = snapshot.X_WP * shared_.shown->scene->tool.shell.tip;
  // down the slope of the distance, which is as long as the distance
  haptics::Vec3 place = tip;
  for (int n = 0; n < 4; ++n) {
    const haptics::Vec3 slope = known->second.gradientAt(place);
    if (!(slope.squaredNorm() > 0.0)) break;
    place -= known->second.at(place) / slope.squaredNorm() * slope;
  }
  return ui::NearLine::Way{tip * ui::kMmPerM, place * ui::kMmPerM,
                           ui::distanceWords({.distance_mm = double(nearest->tip) * ui::kMmPerM})};
}

QString StructuresController::solidAt(const Eigen::Vector3d& p_W_mm) const {
  if (shown_.map == nullptr) return {};
  // contacts lie on the surface, which is half a voxel off
  const Eigen::Vector3d beside_mm = shown_.map->grid.spacing * ui::kMmPerM;
  for (const double by : {0.0, -1.0, 1.0})
    for (int axis = 0; axis < (by == 0.0 ? 1 : 3); ++axis) {
      const Eigen::Vector3d at_mm =
          p_W_mm + shown_.map->grid.direction.col(axis) * (by * beside_mm[axis]);
      for (const std::uint8_t number : shown_.map->sets[shown_.map->codeAt(at_mm)])
        if (const ui::StructureLook& look = shown_.looks[number];
            look.feel.kind == ui::StructureFeel::Kind::Solid)
          return look.name;
    }
  return {};
}

void StructuresController::showScene() {
  panel_->setReady(shared_.shown.has_value());
  if (!shared_.shown) return;
  const auto scan = scanOf(shared_.shown->volume());
  if (scan_.lock() == scan) return showCutting();
  scan_ = scan;
  reader_.abandon();
  close();
  if (!sorted_.isEmpty()) sort(sorted_);  // it may be of this scan, or the next
  offerFound();
  const std::string phantom = std::exchange(awaited_, {});
  if (phantom.empty() || !shared_.shown->place.empty()) return;
  file_.clear();
  read([phantom, scan](const background::Watch& watch) {
    return datasets::phantomLabels(phantom, scan->grid, &watch.cancel);
  });
}

void StructuresController::goTo(int number) {
  if (number < 0 || number >= static_cast<int>(places_mm_.size())) return;
  const auto& places = places_mm_[static_cast<std::size_t>(number)];
  if (places.empty()) return;  // nothing of it lies in the scan, or its shape is being made
  views_.setCross(places.front());
  views_.volume().lookAtPlaces(places);
}

}  // namespace app
