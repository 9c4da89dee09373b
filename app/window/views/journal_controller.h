// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/background/task.h"
#include "app/window/program/journal.h"
#include "app/window/program/preferences_controller.h"
#include "app/window/scan/shared_state.h"
#include "app/window/views/view_file_controller.h"
#include "ui/window/messages.h"

namespace app {

/// Keeps what the user does with a scan in the journal, at most a second after it was done, and
/// offers what a process left that ended without a question. It keeps nothing unless recent places
/// are remembered.
class JournalController : public QObject {
  Q_OBJECT
 public:
  /// `folder`: of the journal; empty: nothing is kept or offered.
  JournalController(ui::Messages& messages, SharedState& shared, PreferencesController& preferences,
                    ViewFileController& files, std::filesystem::path folder);

  /// At the start: offers work whose scan is found.
  void look();
  /// Call it when a scene is on view.
  void showScene();
  /// The file of the structures on view; empty: there are none any more, or they are of no file.
  void setStructures(const std::filesystem::path& file) { structures_ = file; }
  /// Removes everything that is kept.
  void forget();
  /// The window goes. `asked`: the user was asked about what is not saved.
  void close(bool asked);

 signals:
  /// The work on a scan goes on, in which these structures were open.
  void structuresWanted(const std::filesystem::path& file);
  /// The newest work is in the journal.
  void kept();

 private:
  struct Work {
    Journal::Left left;
    ViewFile view;
  };
  struct Search {
    std::optional<Work> work = {};
    std::optional<haptics::Error> damage = {};  ///< of work that was left out
  };

  bool isOn() const;
  void takeHash(const std::shared_ptr<const haptics::Volume>& scan);
  /// Looks for work on this scan; none: on any scan that was open before.
  void search(const std::optional<VolumeHash>& hash);
  void offer(const Work& work, bool on_view);
  /// Looks whether something is to be kept. `last`: the window goes.
  void check(bool last);
  void write(const ViewFile& view);
  /// Of the scan on view, beside its place.
  void keepStructures(const VolumeHash& hash);
  void leaveScan();
  void endKept();

  ui::Messages& messages_;
  SharedState& shared_;
  PreferencesController& preferences_;
  ViewFileController& files_;
  Journal journal_;
  std::shared_ptr<const haptics::Volume> scan_;      ///< on view
  std::optional<std::filesystem::path> structures_;  ///< as in setStructures(), of this scan
  std::optional<ViewFile> first_;                    ///< as the scan was when it came
  std::optional<ViewFile> seen_;                     ///< newest
  std::optional<ViewFile> written_;                  ///< when it was kept last, or need not be
  bool in_journal_ = false;                          ///< whether something of this scan is
  std::optional<Journal::Left> resuming_, taken_;
  bool told_ = false;  ///< that nothing can be kept
  QTimer timer_;
  QElapsedTimer since_written_;
  background::Task<void> writer_;
  background::Task<Search> searcher_;
};

}  // namespace app
