// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/opening/opening_controller.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/view_file/view_file.h"
#include "app/window/program/recent_places.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "app/window/scan/touched_surface.h"
#include "datasets/phantoms/phantoms.h"
#include "ui/window/start_page.h"

namespace app {
namespace {

/// What was refused, why, and what is shown or held as before.
QString refusalOf(const LoadRequest& request, const QString& why,
                  const std::optional<Loaded>& shown) {
  if (request.keep) {
    const QString tool = request.tool ? labelOf(*request.tool) : QString{};
    const QString stays =
        shown ? OpeningController::tr(" The tool is still %1.").arg(labelOf(shown->tool)) : "";
    // another field with the same tool
    if (!request.tool || (shown && tool == labelOf(shown->tool))) return why + stays;
    return OpeningController::tr("The tool \"%1\" was not taken. %2").arg(tool, why) + stays;
  }
  const QString name = nameOf(request);
  const QString what =
      name.isEmpty() ? why : OpeningController::tr("\"%1\" was not opened. %2").arg(name, why);
  return shown ? OpeningController::tr("%1 Still shown: %2.").arg(what, shown->title) : what;
}

}  // namespace

OpeningController::OpeningController(ui::MainWindow& window, SharedState& shared,
                                     PreferencesController& preferences,
                                     std::function<double()> free_memory, bool asks)
    : window_(window),
      views_(window.views()),
      messages_(window.messages()),
      loading_(window.loading()),
      menus_(window.menus()),
      start_(window.startPage()),
      shared_(shared),
      preferences_(preferences),
      asks_(asks),
      loader_(free_memory),
      choice_(messages_, menus_, free_memory) {
  QList<std::pair<QString, QString>> phantoms;
  for (const std::string& name : datasets::phantomNames())
    phantoms.append({QString::fromStdString(name), phantomTitle(name)});
  window.menus().setPhantoms(phantoms);
  connect(&window, &ui::MainWindow::closing, &choice_, &SeriesChoice::close);
  connect(&window.menus(), &ui::Menus::phantomWanted, this, [this](const QString& name) {
    load({.phantom = name.toStdString()}, tr("Making the phantom"));
  });
  connect(&window.loading(), &ui::Loading::cancelWanted, &loader_, &Loader::cancel);
  connect(&window.menus(), &ui::Menus::recentPlacesSought, this, &OpeningController::showPlaces);
  const auto remember = [this](bool remembered) {
    preferences_.present().places_remembered = remembered;
    forgetPlaces();
    if (shared_.shown) keepPlace(shared_.shown->place);
  };
  connect(&window.menus(), &ui::Menus::rememberPlacesChanged, this, remember);
  connect(&preferences, &PreferencesController::rememberPlacesChosen, this, remember);
  connect(&window.menus(), &ui::Menus::forgetPlacesWanted, this, &OpeningController::forgetPlaces);
  connect(&preferences, &PreferencesController::forgetPlacesWanted, this,
          &OpeningController::forgetPlaces);
  connect(&loader_, &Loader::progressed, this, [this](double fraction) {
    // an edit that ended meanwhile has put the bar away
    loading_.begin(what_);
    loading_.advance(fraction);
  });
  connect(&loader_, &Loader::surveyed, &choice_, &SeriesChoice::take);
  connect(&loader_, &Loader::surveyed, this, &OpeningController::surveyed);
  connect(&choice_, &SeriesChoice::structuresWanted, this, &OpeningController::structuresWanted);
  connect(&loader_, &Loader::loaded, this, &OpeningController::take);
  connect(&loader_, &Loader::failed, this, &OpeningController::refuse);
  connect(&choice_, &SeriesChoice::wanted, this,
          [this](const LoadRequest& request) { load(request, tr("Reading")); });
  showPlaces();
}

void OpeningController::load(LoadRequest request, const QString& what) {
  messages_.clear();
  ++asked_;
  what_ = what;
  loading_.begin(what);
  emit loading();
  if (!request.keep) choice_.close();
  request.options = shared_.options;
  if (request.path && !request.tool) request.tool = rememberedTool();
  if (shared_.shown) request.previous = shared_.shown->seenScene();
  loader_.start(std::move(request));
}

/// The tool that the user chose last, also before this start.
std::optional<ToolSource> OpeningController::rememberedTool() const {
  std::error_code error;
  if (tool_ && (!tool_->file || std::filesystem::exists(*tool_->file, error))) return tool_;
  const std::string name = preferences_.present().tool.toStdString();
  return name.empty() ? std::nullopt : std::optional{ToolSource{.name = name}};
}

void OpeningController::open(const QString& path, LoadRequest request) {
  const auto endsIn = [&](const char* ending) {
    return path.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
  };
  if (endsIn(".palpate")) return emit recordingWanted(path.toStdString());
  if (endsIn(kViewEnding)) return emit viewWanted(path.toStdString());
  request.path = path.toStdString();
  load(std::move(request), tr("Reading"));
}

void OpeningController::replace(const Loaded& loaded) {
  const bool placed = shared_.snapshot.scene == shared_.shown->scene->id;
  shared_.shown = loaded;
  emit this->loaded(false, placed);
  views_.setTouched(touchedSurfaceOf(loaded.seenScene()));
  emit shown(false);
}

void OpeningController::renew(const Loaded& loaded) {
  shared_.shown = loaded;
  shared_.session.renew(loaded.scene);
  views_.setTouched(touchedSurfaceOf(loaded.seenScene()));
  emit shown(false);
}

void OpeningController::replacePicture(const ui::Picture& picture, bool seen) {
  shared_.shown->picture = picture;
  if (shared_.replaying) return;  // it shows the picture when it ends, or when it comes to it
  if (seen)
    views_.renew(picture);
  else
    views_.replace(picture);
  emit pictureReplaced(seen);
}

/// Asks first if another scan would take something with it.
void OpeningController::take(const Loaded& loaded) {
  const bool other = shared_.shown && scanOf(shared_.shown->volume()) != scanOf(loaded.volume());
  if (!other || !guard_) return adopt(loaded);
  loading_.end();
  guard_([this, loaded, asked = ++asked_](bool may_go) {
    if (asked != asked_) return;  // something else was opened meanwhile
    if (may_go) return adopt(loaded);
    emit failed({haptics::Error::Kind::Cancelled, {}});
  });
}

void OpeningController::adopt(const Loaded& loaded) {
  // an edit came while another tool or field was prepared: the same with the edited volume
  if (shared_.shown && shared_.shown->volume() != loaded.volume() &&
      scanOf(shared_.shown->volume()) == scanOf(loaded.volume()))
    return load(
        {.keep = std::make_shared<const Kept>(Kept{shared_.shown->volume(), shared_.shown->picture,
                                                   loaded.title, loaded.place, loaded.greys}),
         .tool = loaded.tool,
         .isovalue = shared_.settings.isovalue},
        tr("Preparing the tool"));
  const bool new_volume = !shared_.shown || shared_.shown->volume() != loaded.volume();
  const bool placed = !new_volume && shared_.snapshot.scene == shared_.shown->scene->id;
  if (!new_volume && (loaded.tool.name != shared_.shown->tool.name ||
                      loaded.tool.file != shared_.shown->tool.file)) {
    tool_ = loaded.tool;  // one that can be read
    if (!tool_->file) preferences_.present().tool = QString::fromStdString(tool_->name);
  }
  // an edit's picture may have come while another tool was prepared
  const ui::Picture picture = new_volume ? loaded.picture : shared_.shown->picture;
  shared_.shown = loaded;
  shared_.shown->picture = picture;
  loading_.end();
  if (new_volume) keepPlace(loaded.place);
  if (!loaded.place.empty()) menus_.setPlace(QString::fromStdString(loaded.place.string()));
  if (!loaded.note.isEmpty()) messages_.showMessage(loaded.note);
  // with another tool the isovalue is the slider's, which may have moved meanwhile
  if (new_volume) shared_.settings.isovalue = loaded.isovalue;
  emit this->loaded(new_volume, placed);
  if (new_volume)
    window_.show(loaded.picture, shared_.settings.isovalue, loaded.title, loaded.greys);
  views_.show(loaded.scene->tool.mesh);
  views_.setTouched(touchedSurfaceOf(loaded.seenScene()));
  emit shown(new_volume);
}

void OpeningController::refuse(const LoadRequest& request, const haptics::Error& error) {
  loading_.end();
  if (shared_.shown) shared_.options.field = shared_.shown->scene->field.kind();
  emit failed(error);
  if (asks_ && choice_.ask(request, error)) return;
  if (error.kind != haptics::Error::Kind::Cancelled)
    messages_.showMessage(refusalOf(request, sentenceOf(error), shared_.shown));
}

void OpeningController::openTogether(const QStringList& paths, const LoadRequest& request) {
  if (paths.size() == 1) return open(paths.first(), request);
  // the slices of a series, say, with whatever lies between them: their folder lists them all
  const QString folder = QFileInfo(paths.first()).absolutePath();
  if (std::ranges::all_of(paths, [&](const QString& path) {
        const QFileInfo file(path);
        return file.isFile() && file.absolutePath() == folder;
      }))
    return open(folder, request);
  open(paths.first(), request);
  messages_.showMessage(
      tr("The %1 items are not files of one folder: only the first, \"%2\", is opened; open the "
         "folder that contains them all to choose among its series.")
          .arg(paths.size())
          .arg(QDir(paths.first()).dirName()));
}

void OpeningController::keepPlace(const std::filesystem::path& place) {
  if (place.empty() || !preferences_.present().places_remembered) return;
  preferences_.present().places =
      withPlace(preferences_.present().places, QString::fromStdString(place.string()));
  preferences_.present().place_hashes =
      hashesOf(preferences_.present().place_hashes, preferences_.present().places);
  preferences_.save();
}

void OpeningController::forgetPlaces() {
  Preferences& kept = preferences_.present();
  for (QStringList* list : {&kept.places, &kept.place_hashes, &kept.structures, &kept.tools})
    list->clear();
  preferences_.save();
  emit placesForgotten();
  // not by showPlaces(): the menu's own action may be what brought us here
  start_.setPlaces({}, preferences_.present().places_remembered);
}

void OpeningController::showPlaces() {
  QList<ui::Place> places;
  for (const QString& path : preferences_.present().places)
    places.append({.path = path, .exists = QFileInfo::exists(path)});
  const bool remembered = preferences_.present().places_remembered;
  menus_.setRecentPlaces(places, remembered);
  if (!shared_.shown && !places.isEmpty()) menus_.setPlace(places.first().path);
  start_.setPlaces(places, remembered);
}

}  // namespace app
