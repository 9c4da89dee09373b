// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/view_file_controller.h"

#include <QCheckBox>
#include <QCursor>
#include <QDateTime>
#include <QFileDialog>
#include <QGridLayout>
#include <QMenu>
#include <QMetaMethod>
#include <cmath>
#include <system_error>
#include <utility>

#include "app/recording/recording.h"
#include "app/recording/volume_hash.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "app/window/scan/volume_words.h"
#include "datasets/edits/edited.h"
#include "resources/named_tools.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/panels/isosurface_panel.h"

namespace app {
namespace {

QString inQuotes(const std::filesystem::path& path) {
  return "\"" + QString::fromStdString(path.filename().string()) + "\"";
}

std::vector<std::string> textsOf(const std::vector<datasets::Edit>& edits) {
  std::vector<std::string> texts;
  for (const datasets::Edit& edit : edits) texts.push_back(datasets::textOf(edit));
  return texts;
}

/// A view or a recording, by its name.
bool isOfPalpate(const std::filesystem::path& path) {
  const QString name = QString::fromStdString(path.string());
  return name.endsWith(QLatin1String(kViewEnding), Qt::CaseInsensitive) ||
         name.endsWith(QLatin1String(".palpate"), Qt::CaseInsensitive);
}

/// The kind of scan, and when the view is saved: nothing of the patient or the files.
QString proposedName(const haptics::Volume& volume) {
  const QString kind =
      volume.unit == "HU" ? ViewFileController::tr("CT") : ViewFileController::tr("Scan");
  return kind + QDateTime::currentDateTime().toString(" yyyy-MM-dd hh.mm.ss") + kViewEnding;
}

bool isNamedTool(const std::string& name) { return resources::findNamedTool(name) != nullptr; }

}  // namespace

ViewFileController::ViewFileController(ui::Views& views, ui::Messages& messages,
                                       ui::Loading& loading, ui::Menus& menus, SharedState& shared,
                                       MarksController& marks, bool asks)
    : views_(views),
      messages_(messages),
      loading_(loading),
      shared_(shared),
      marks_(marks),
      asks_(asks) {
  connect(&menus, &ui::Menus::viewWanted, this,
          [this](const QString& path) { open(path.toStdString()); });
  connect(&menus, &ui::Menus::viewSaveWanted, this, &ViewFileController::saveOrAsk);
  connect(&menus, &ui::Menus::viewSaveAsWanted, this, &ViewFileController::askAndSave);
  connect(&shared.identity, &VolumeIdentity::sought, this, &ViewFileController::takeHash);
  connect(&loading, &ui::Loading::cancelWanted, this, [this] {
    if (step_ != Step::Hash && !saving_) return;
    if (saving_) messages_.showMessage(tr("The view was not saved: it was cancelled."));
    step_ = Step::Nothing;
    saving_.reset();
    loading_.end();
    endSaving(false);
  });
}

bool ViewFileController::liesOnView() const {
  if (!shared_.shown) return false;
  haptics::Volume wanted;
  wanted.grid = opening_.grid;
  wanted.type = opening_.type;
  return liesLike(wanted, *shared_.shown->volume());
}

void ViewFileController::open(const std::filesystem::path& path) {
  auto read = readViewFile(path);
  if (!read) return refuse(sentenceOf(read.error()));
  begin(std::move(*read), path);
}

void ViewFileController::resume(ViewFile work) { begin(std::move(work), {}); }

void ViewFileController::begin(ViewFile view, const std::filesystem::path& path) {
  drop();  // one that is still being opened
  tool_seeker_.abandon();
  opening_ = std::move(view);
  opening_path_ = path;
  place_tried_ = known_tried_ = placing_ = false;
  if (shared_.replaying)
    return refuse(
        tr("%1 was not opened: a recording is on view; close it first.").arg(openingName()));
  compare();
}

QString ViewFileController::openingName() const {
  return opening_path_.empty() ? tr("The work that was kept") : inQuotes(opening_path_);
}

/// Over the scan on view, or else over the one that the file knows.
void ViewFileController::compare() {
  if (liesOnView()) {
    step_ = Step::Hash;
    messages_.clear();
    loading_.begin(tr("Comparing the scan"));
    shared_.identity.seek(scanOf(shared_.shown->volume()));
    return;
  }
  if (!seekScan()) refuseGeometry();
}

bool ViewFileController::seekScan() {
  if (!opening_.place.empty() && !std::exchange(place_tried_, true) &&
      openScan((opening_path_.parent_path() / opening_.place).lexically_normal()))
    return true;
  if (!opening_.hash || !known_.place || std::exchange(known_tried_, true)) return false;
  const std::filesystem::path known = known_.place(*opening_.hash);
  return !known.empty() && openScan(known);
}

bool ViewFileController::openScan(const std::filesystem::path& scan) {
  std::error_code error;
  if (!std::filesystem::exists(scan, error)) return false;
  if (isOfPalpate(scan)) {
    refuse(
        tr("%1 was not opened: it names %2 as its scan, but %2 is not a scan; open the scan first.")
            .arg(openingName(), inQuotes(scan)));
    return true;
  }
  step_ = Step::Scan;
  emit scanWanted(scan, opening_.grid);
  return true;
}

void ViewFileController::showScene(bool new_volume) {
  if (!shared_.shown) return;
  if (new_volume) {
    edits_in_file_.clear();
    saved_as_.clear();
    placing_ = false;
    tool_seeker_.abandon();
  }
  if (step_ == Step::Edits && liesOnView() && hasEdits()) return restoreRest();
  if (placing_) placeTool();
  if (!new_volume) return;
  switch (step_) {
    case Step::Nothing:
      break;
    case Step::Scan:
      compare();
      break;
    case Step::Hash:
    case Step::Edits:
      drop();  // another scan was opened meanwhile
      break;
  }
}

void ViewFileController::drop() {
  if (step_ == Step::Nothing) return;
  if (step_ == Step::Hash) loading_.end();
  step_ = Step::Nothing;
  emit finished(false);
}

void ViewFileController::takeHash(const std::shared_ptr<const haptics::Volume>& scan) {
  if (saving_ && scan == saved_scan_) write();
  if (step_ != Step::Hash || !shared_.shown || scan != scanOf(shared_.shown->volume())) return;
  loading_.end();
  switch (compared(opening_.hash, shared_.identity.of(scan))) {
    case SameVolume::Same:
      return restore();
    case SameVolume::Another:
      if (seekScan()) return;
      return offerChoice(
          tr("%1 was not opened: it belongs to another scan. The one on view has the same "
             "geometry, %2, but other voxels; open the other scan first.")
              .arg(openingName(), geometryWords(opening_.grid, opening_.type)));
    case SameVolume::Unknown:
      break;
  }
  const QString unknown =
      tr("It was saved by another installation, so its scan cannot be recognised. The geometry is "
         "the same: %1. Marks of another scan would lie in wrong places.")
          .arg(geometryWords(opening_.grid, opening_.type));
  if (!asks_) return refuse(unknown);
  const bool agreed = messages_.askWhether(tr("Is %1 a view of this scan?").arg(openingName()),
                                           unknown, tr("Open it over this scan"));
  // the scan may have changed while the question was open
  if (agreed && step_ == Step::Hash && liesOnView()) return restore();
  drop();
}

std::vector<std::string> ViewFileController::editsOnView() const {
  const datasets::Edited* edited =
      shared_.shown ? datasets::editedOf(*shared_.shown->volume()) : nullptr;
  return edited != nullptr ? textsOf(edited->edits) : std::vector<std::string>{};
}

bool ViewFileController::hasEdits() const { return editsOnView() == textsOf(opening_.edits); }

void ViewFileController::restore() {
  if (hasEdits()) return restoreRest();
  if (!isSignalConnected(QMetaMethod::fromSignal(&ViewFileController::editsWanted)))
    return refuse(tr("%1 was not opened: it has edits of the scan, which this Palpate cannot make.")
                      .arg(openingName()));
  const auto want = [this] {
    step_ = Step::Edits;
    emit editsWanted(opening_.edits);
  };
  const Leave answer = leave(Leaving::Edits, [this, want](bool saved) {
    // the scan may have changed while it was saved
    if (saved && liesOnView()) return want();
    emit finished(false);
  });
  if (answer == Leave::Now && liesOnView()) return want();
  step_ = Step::Nothing;
  if (answer != Leave::AfterSaving) emit finished(false);
}

void ViewFileController::restoreRest() {
  step_ = Step::Nothing;
  const Loaded& shown = *shared_.shown;
  const double isovalue = ui::allowedIsovalue(*shown.volume(), opening_.isovalue);
  emit isovalueWanted(isovalue);
  marks_.measures().replace(opening_.marks);
  if (!opening_path_.empty()) {
    marks_.setSaved(opening_.marks);
    edits_in_file_ = editsOnView();
    saved_as_ = opening_path_;
    saved_with_place_ = !opening_.place.empty();
  }
  views_.setLook(opening_.look);
  if (std::abs(isovalue - opening_.isovalue) > 1e-6 * std::abs(opening_.isovalue) + 1e-9)
    messages_.showMessage(tr("The isovalue of %1, %2, is outside this scan's range; %3 is shown.")
                              .arg(openingName())
                              .arg(opening_.isovalue)
                              .arg(isovalue));
  restoreTool();
  emit finished(true);
}

void ViewFileController::restoreTool() {
  const ToolSource& present = shared_.shown->tool;
  const std::string& tool = opening_.tool;
  placing_ = opening_.X_WP.has_value();
  const auto missing = [this](const QString& sentence) {
    placing_ = false;
    messages_.showMessage(sentence.arg(openingName()));
  };
  if (opening_.tool_file && present.hash != opening_.tool_file) {
    tool_seeker_.start(
        [files = known_.tools ? known_.tools() : std::vector<std::filesystem::path>{},
         sought = *opening_.tool_file](
            const background::Watch& watch) -> haptics::Expected<std::filesystem::path> {
          const auto key = installationKey();
          for (const std::filesystem::path& file : files)
            if (!watch.cancelled() && key && hashOfFile(file, *key) == sought) return file;
          return std::filesystem::path{};
        },
        [this, missing](const haptics::Expected<std::filesystem::path>& file) {
          if (file && !file->empty())
            return emit toolWanted(
                {.name = file->string(), .file = *file, .unit = opening_.tool_unit});
          missing(
              tr("The tool of %1 comes from a file that was not found; the present tool stays. "
                 "Load the tool, and open the view again."));
        });
  } else if (!tool.empty() && !isNamedTool(tool)) {
    missing(tr("The tool of %1 is not known here; the present tool stays."));
  } else if (!tool.empty() && (present.file || present.name != tool)) {
    emit toolWanted({.name = tool});
  } else {
    placeTool();
  }
}

/// Once the tool is the one of the view.
void ViewFileController::placeTool() {
  const ToolSource& present = shared_.shown->tool;
  const bool there = opening_.tool_file      ? present.hash == opening_.tool_file
                     : opening_.tool.empty() ? true
                                             : !present.file && present.name == opening_.tool;
  if (!there || !std::exchange(placing_, false)) return;
  emit poseWanted(*opening_.X_WP);
}

void ViewFileController::refuse(const QString& sentence) {
  step_ = Step::Nothing;
  messages_.showMessage(sentence);
  emit refused(sentence);
  emit finished(false);
}

void ViewFileController::offerChoice(const QString& sentence) {
  refuse(sentence);
  if (!asks_ || opening_path_.empty()) return;
  messages_.clear();
  messages_.showOffer(sentence, tr("Choose the scan…"),
                      [this, view = opening_, path = opening_path_] {
                        QMenu menu(messages_.window());
                        menu.setObjectName("scanChoice");
                        const QAction* folder = menu.addAction(tr("A &folder of slices…"));
                        menu.addAction(tr("A f&ile…"));
                        const QAction* chosen = menu.exec(QCursor::pos());
                        if (chosen == nullptr) return;
                        opening_ = view;
                        opening_path_ = path;
                        chooseScan(chosen == folder);
                      });
}

void ViewFileController::chooseScan(bool folder) {
  // Qt's own dialog: in a foreign one Escape would not reach the application
  QFileDialog dialog(messages_.window(), tr("Choose the scan of %1").arg(openingName()));
  dialog.setFileMode(folder ? QFileDialog::Directory : QFileDialog::ExistingFile);
  dialog.setOption(QFileDialog::DontUseNativeDialog);
  place_tried_ = known_tried_ = true;
  if (dialog.exec() == QDialog::Accepted) openScan(dialog.selectedFiles().value(0).toStdString());
}

void ViewFileController::refuseGeometry() {
  QString here = tr("Nothing is on view");
  if (shared_.shown) {
    const haptics::Volume& volume = *shared_.shown->volume();
    here = tr("The one on view has %1").arg(geometryWords(volume.grid, volume.type));
    if (volume.grid.dims == opening_.grid.dims && volume.type == opening_.type)
      here = tr("The one on view lies elsewhere or is turned");
  }
  offerChoice(tr("%1 was not opened: it belongs to a scan of %2. %3; open the other scan first.")
                  .arg(openingName(), geometryWords(opening_.grid, opening_.type), here));
}

ViewFileController::Leave ViewFileController::leave(Leaving what,
                                                    std::function<void(bool saved)> then) {
  const Leave answer = ask(what, strokes_.end());
  if (answer != Leave::AfterSaving) {
    strokes_.allow();
    return answer;
  }
  const auto settled = [this, then = std::move(then)](bool saved) {
    strokes_.allow();
    then(saved);
  };
  strokes_.whenEdits([this, settled] {
    if (!saveOrAsk()) return settled(false);
    then_ = settled;
  });
  return answer;
}

ViewFileController::Leave ViewFileController::ask(Leaving what, bool strokes) {
  const bool marks = what == Leaving::Window && marks_.areUnsaved();
  const int elsewhere = what == Leaving::Window ? marks_.scansUnsaved() : 0;
  const std::vector<std::string> present = editsOnView();
  const bool edits = strokes || (!present.empty() && present != edits_in_file_);
  if (!marks && !edits && elsewhere == 0) return Leave::Now;
  const QString consequence = what == Leaving::Window ? tr("They are lost when the window closes.")
                              : what == Leaving::Scan
                                  ? tr("They are lost when another scan is opened.")
                                  : tr("They are lost when a view with other edits is opened.");
  const QString of_others =
      elsewhere == 0 ? QString()
                     : tr("Marks of other scans that were on view are in no file (%1). To save "
                          "them, open the scan again.")
                           .arg(elsewhere);
  if (!marks && !edits)
    return messages_.askWhether(of_others, consequence, tr("&Discard")) ? Leave::Now : Leave::Stay;
  const QString present_words = marks && edits
                                    ? tr("The marks and edits of this scan are not saved.")
                                : marks ? tr("The marks of this scan are not saved.")
                                        : tr("The edits of this scan are not saved.");
  switch (messages_.askToSave(present_words, (consequence + ' ' + of_others).trimmed())) {
    case ui::Unsaved::Discard:
      return Leave::Now;
    case ui::Unsaved::Cancel:
      return Leave::Stay;
    case ui::Unsaved::Save:
      break;
  }
  return Leave::AfterSaving;
}

bool ViewFileController::saveOrAsk() {
  if (!shared_.shown || saved_as_.empty()) return askAndSave();
  save(saved_as_, saved_with_place_);
  return saving_.has_value();
}

bool ViewFileController::askAndSave() {
  if (!shared_.shown) {
    messages_.showMessage(tr("There is no view to save; open a scan first."));
    return false;
  }
  QFileDialog dialog(messages_.window(), tr("Save the view as"));
  dialog.setObjectName("saveViewDialog");
  ui::askForOutput(dialog, tr("Views (*.palpate-view)"), QString(kViewEnding).mid(1));
  dialog.selectFile(proposedName(*shared_.shown->volume()));
  ui::addNotesWarning(dialog);
  auto* place = new QCheckBox(tr("Remember where the scan lies, relative to this file"));
  place->setObjectName("rememberScan");
  place->setEnabled(!shared_.shown->place.empty());
  place->setToolTip(
      tr("The names of its folders are then in the file. Without it, the scan is sought among the "
         "recent places, or you choose it."));
  if (auto* grid = qobject_cast<QGridLayout*>(dialog.layout()))
    grid->addWidget(place, grid->rowCount(), 0, 1, -1);
  if (dialog.exec() != QDialog::Accepted) return false;
  save(dialog.selectedFiles().value(0).toStdString(), place->isChecked());
  return saving_.has_value();
}

ViewFile ViewFileController::present() const {
  const Loaded& shown = *shared_.shown;
  const auto scan = scanOf(shown.volume());
  ViewFile view;
  view.grid = scan->grid;
  view.type = scan->type;
  if (const auto* edited = datasets::editedOf(*shown.volume())) view.edits = edited->edits;
  view.isovalue = shared_.settings.isovalue;
  if (!shown.tool.file && isNamedTool(shown.tool.name)) view.tool = shown.tool.name;
  if (shown.tool.file && shown.tool.hash) {
    view.tool_file = shown.tool.hash;
    view.tool_unit = shown.tool.unit;
  }
  if (shared_.snapshot.scene == shown.scene->id) view.X_WP = shared_.snapshot.X_WP;
  view.marks = marks_.measures().all();
  view.look = views_.look();
  return view;
}

void ViewFileController::save(const std::filesystem::path& path, bool with_place) {
  if (!shared_.shown || saving_) return;
  const Loaded& shown = *shared_.shown;
  saved_scan_ = scanOf(shown.volume());
  saving_path_ = path;
  saving_with_place_ = with_place;
  ViewFile view = present();
  if (with_place && !shown.place.empty()) {
    std::error_code error;
    const auto folder = std::filesystem::absolute(path, error).parent_path();
    view.place = std::filesystem::relative(shown.place, folder, error).generic_string();
  }
  saving_ = std::move(view);
  loading_.begin(tr("Saving the view"));
  shared_.identity.seek(saved_scan_);
}

void ViewFileController::write() {
  ViewFile view = std::move(*saving_);
  saving_.reset();
  view.hash = shared_.identity.of(saved_scan_);
  const auto scan = std::exchange(saved_scan_, nullptr);
  loading_.end();
  const auto written = writeViewFile(saving_path_, view);
  if (!written) {
    messages_.showMessage(sentenceOf(written.error()));
    return endSaving(false);
  }
  if (shared_.shown && scanOf(shared_.shown->volume()) == scan) {
    marks_.setSaved(view.marks);
    edits_in_file_ = textsOf(view.edits);
    saved_as_ = saving_path_;
    saved_with_place_ = saving_with_place_;
    emit saved();
  }
  messages_.showDone(tr("The view was saved as %1.").arg(inQuotes(saving_path_)),
                     QString::fromStdString(saving_path_.parent_path().string()));
  endSaving(true);
}

void ViewFileController::endSaving(bool saved) {
  emit finished(saved);
  if (const auto then = std::exchange(then_, nullptr)) then(saved);
}

}  // namespace app
