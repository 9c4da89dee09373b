// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/views/journal_controller.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "app/log/log.h"
#include "app/window/program/recent_places.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"
#include "haptics/process/input_file.h"

namespace app {
namespace {

// what is done is written within the second: seen after 0.2 s, written 0.8 s after the last time
constexpr int kSeenMs = 200;
constexpr qint64 kWrittenMs = 800;
// of the tool: what a hand at rest does is no change, and a first touch is no work yet
constexpr double kRest = 1e-4, kRestTurn = 0.004;   // m, rad
constexpr double kBegun = 5e-3, kBegunTurn = 0.09;  // m, rad

bool toolMoved(const ViewFile& a, const ViewFile& b, double metres, double radians) {
  if (!a.X_WP || !b.X_WP) return false;
  const haptics::Quat turn =
      haptics::rotationOf(*a.X_WP).conjugate() * haptics::rotationOf(*b.X_WP);
  return (a.X_WP->translation() - b.X_WP->translation()).norm() > metres ||
         2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w())) > radians;
}

/// All but marks, edits and the tool's place.
std::string restOf(ViewFile view) {
  view.marks.clear();
  view.edits.clear();
  view.X_WP.reset();
  return textOf(view);
}

bool differ(const ViewFile& a, const ViewFile& b) {
  const auto same = [](const datasets::Edit& one, const datasets::Edit& other) {
    return datasets::textOf(one) == datasets::textOf(other);
  };
  return a.marks != b.marks || toolMoved(a, b, kRest, kRestTurn) || restOf(a) != restOf(b) ||
         !std::ranges::equal(a.edits, b.edits, same);
}

/// Whether the user did something with the scan, besides looking at it.
bool isWork(const ViewFile& first, const ViewFile& now) {
  return !now.marks.empty() || !now.edits.empty() || now.isovalue != first.isovalue ||
         now.tool != first.tool || now.tool_file != first.tool_file ||
         toolMoved(first, now, kBegun, kBegunTurn);
}

haptics::Expected<ViewFile> readWork(const std::filesystem::path& path) {
  const auto text = haptics::readInput(path, kMostViewBytes);
  if (!text) return tl::unexpected(text.error());
  return viewFileFrom(*text, path.extension().string());
}

}  // namespace

JournalController::JournalController(ui::Messages& messages, SharedState& shared,
                                     PreferencesController& preferences, ViewFileController& files,
                                     std::filesystem::path folder)
    : messages_(messages),
      shared_(shared),
      preferences_(preferences),
      files_(files),
      journal_(std::move(folder)) {
  if (!journal_.isOn()) return;
  connect(&shared.identity, &VolumeIdentity::sought, this, &JournalController::takeHash);
  connect(&files, &ViewFileController::finished, this, [this](bool done) {
    const auto resumed = std::exchange(resuming_, {});
    if (!resumed || !done) return;
    log::write(log::Level::Info, "work-resumed");
    taken_ = resumed;
    written_.reset();
    in_journal_ = false;
    const QString file =
        placeWith(preferences_.present().structures, QString::fromStdString(hexOf(resumed->hash)));
    if (!file.isEmpty()) emit structuresWanted(file.toStdString());
  });
  connect(&files, &ViewFileController::saved, this, &JournalController::endKept);
  connect(&timer_, &QTimer::timeout, this, [this] { check(false); });
  timer_.start(kSeenMs);
}

bool JournalController::isOn() const {
  return journal_.isOn() && preferences_.present().places_remembered;
}

void JournalController::look() {
  if (isOn()) search({});
}

void JournalController::search(const std::optional<VolumeHash>& hash) {
  const QStringList hashes = preferences_.present().place_hashes;
  searcher_.start(
      [this, hash, hashes](const background::Watch&) -> haptics::Expected<Search> {
        Search search;
        std::error_code error;
        if (!hash) journal_.sweep();
        for (const Journal::Left& left : journal_.left()) {
          if (hash && left.hash != *hash) continue;
          const QString place = placeWith(hashes, QString::fromStdString(hexOf(left.hash)));
          if (!hash && (place.isEmpty() || !std::filesystem::exists(place.toStdString(), error)))
            continue;
          auto view = readWork(left.path);
          if (view) {
            search.work = Work{left, std::move(*view)};
            break;
          }
          if (hash) search.damage = view.error();
        }
        return search;
      },
      [this, hash](const haptics::Expected<Search>& found) {
        if (!found || !isOn()) return;
        if (found->damage)
          messages_.showMessage(tr("Work on this scan was kept, but it cannot be read and was left "
                                   "out: %1")
                                    .arg(sentenceOf(*found->damage)));
        if (found->work) return offer(*found->work, hash.has_value());
        if (hash) messages_.hideWork();
      });
}

void JournalController::offer(const Work& work, bool on_view) {
  log::write(log::Level::Info, "work-offered",
             {{"marks", work.view.marks.size()}, {"edits", work.view.edits.size()}});
  messages_.showWork(
      on_view ? tr("Your work on this scan was not saved when Palpate ended.")
              : tr("Your work on a scan that was open before was not saved when Palpate ended."),
      tr("&Continue where you were"),
      [this, work] {
        resuming_ = work.left;
        files_.resume(work.view);
      },
      [this, work, on_view] {
        if (!messages_.askWhether(tr("Discard the work that was kept?"),
                                  tr("Its marks, notes and edits cannot be brought back."),
                                  tr("&Discard")))
          return offer(work, on_view);
        std::error_code error;
        std::filesystem::remove(work.left.path, error);
      });
}

void JournalController::showScene() {
  if (!journal_.isOn() || !shared_.shown) return;
  const Loaded& shown = *shared_.shown;
  if (shown.tool.file && isOn()) {
    QStringList& tools = preferences_.present().tools;
    const QStringList before =
        std::exchange(tools, withPlace(tools, QString::fromStdString(shown.tool.file->string())));
    if (tools != before) preferences_.save();
  }
  const auto scan = scanOf(shown.volume());
  if (scan == scan_) return;
  leaveScan();
  scan_ = scan;
  if (isOn()) shared_.identity.seek(scan);
}

/// Its marks come back when it is opened again; its edits were given up.
void JournalController::leaveScan() {
  const auto left = std::exchange(seen_, {});
  first_.reset();
  structures_.reset();
  taken_.reset();
  written_.reset();
  if (!std::exchange(in_journal_, false) || !left || !left->hash || !isOn()) return;
  ViewFile view = *left;
  view.edits.clear();
  if (!view.marks.empty()) return write(view);
  writer_.wait();
  journal_.remove(*view.hash);
}

void JournalController::takeHash(const std::shared_ptr<const haptics::Volume>& scan) {
  const auto hash = shared_.identity.of(scan);
  if (!shared_.shown || scan != scan_ || !hash || !isOn()) return;
  if ((!seen_ || !seen_->hash) && !resuming_ && !taken_) search(hash);
  Preferences& kept = preferences_.present();
  const QString place = QString::fromStdString(shared_.shown->place.string());
  if (!kept.places.contains(place)) return;
  QStringList hashes = withHash(kept.place_hashes, QString::fromStdString(hexOf(*hash)), place);
  if (hashes == kept.place_hashes) return;
  kept.place_hashes = std::move(hashes);
  preferences_.save();
}

void JournalController::check(bool last) {
  if (!isOn() || !scan_ || !shared_.shown || shared_.replaying) return;
  if (scanOf(shared_.shown->volume()) != scan_) return;
  ViewFile now = files_.present();
  now.hash = shared_.identity.of(scan_);
  if (!now.X_WP) now.X_WP = seen_ ? seen_->X_WP : std::nullopt;
  if (!first_) first_ = now;
  if (!first_->X_WP) first_->X_WP = now.X_WP;
  seen_ = now;
  if (!now.hash) return;
  if (in_journal_ && structures_) keepStructures(*now.hash);
  if (!last &&
      (writer_.isRunning() || (since_written_.isValid() && since_written_.elapsed() < kWrittenMs)))
    return;
  if (written_ ? !differ(*written_, now) : !taken_ && !isWork(*first_, now)) return;
  since_written_.start();
  in_journal_ = true;
  written_ = now;
  write(now);
}

void JournalController::keepStructures(const VolumeHash& hash) {
  QStringList& kept = preferences_.present().structures;
  const QString hex = QString::fromStdString(hexOf(hash));
  const QString path = QString::fromStdString(structures_->string());
  const QString file = isTemporary(path) ? QString{} : path;
  if (placeWith(kept, hex) == file) return;
  kept.removeIf([&](const QString& entry) { return entry.startsWith(hex); });
  if (!file.isEmpty()) kept = withHash(kept, hex, file).mid(0, kMostPlaces);
  preferences_.save();
}

void JournalController::write(const ViewFile& view) {
  writer_.wait();
  const auto taken = taken_ && taken_->hash == view.hash ? std::exchange(taken_, {}) : std::nullopt;
  writer_.start(
      [this, view, taken](const background::Watch&) -> haptics::Expected<void> {
        const auto written = journal_.write(view);
        std::error_code error;
        if (written && taken) std::filesystem::remove(taken->path, error);
        return written;
      },
      [this](const haptics::Expected<void>& written) {
        if (written) return emit kept();
        if (std::exchange(told_, true)) return;
        messages_.showMessage(tr("Your work is not kept while you work: %1 Save the view instead.")
                                  .arg(sentenceOf(written.error())));
      });
}

void JournalController::forget() {
  if (!journal_.isOn()) return;
  writer_.wait();
  journal_.forget();
  messages_.hideWork();
  // what is done from now on is kept, if it may be
  first_ = written_ = seen_;
  in_journal_ = false;
  taken_.reset();
  if (scan_ && isOn()) shared_.identity.seek(scan_);  // it may have come while nothing was kept
}

/// The view of the scan was saved, so it is no longer kept.
void JournalController::endKept() {
  if (!std::exchange(in_journal_, false) || !seen_ || !seen_->hash) return;
  writer_.wait();
  journal_.remove(*seen_->hash);
  first_ = written_ = seen_;
}

void JournalController::close(bool asked) {
  timer_.stop();
  writer_.wait();
  if (asked) return journal_.clear();
  check(true);
  writer_.wait();
}

}  // namespace app
