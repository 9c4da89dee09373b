// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>

#include "app/window/opening/thumbnails.h"
#include "app/window/scan/loader.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"

namespace ui {
class SeriesBrowser;
}

namespace app {

/// Lets the user choose one of several series, and how much of it: the list of a survey, and the
/// questions before a series is resampled or read in part. GUI thread.
class SeriesChoice : public QObject {
  Q_OBJECT
 public:
  /// `free_memory`: returns the free memory in bytes.
  SeriesChoice(ui::Messages& messages, ui::Menus& menus, std::function<double()> free_memory);

  /// Sets the survey that the list shows.
  void take(const Surveyed& surveyed);
  void browse();
  void close();
  /// After a failed request, asks the question whose answer would make it succeed. Returns false if
  /// there is none.
  bool ask(const LoadRequest& request, const haptics::Error& error);

 signals:
  void wanted(const app::LoadRequest& request);
  /// Structures of the scan on view, which lie with it.
  void structuresWanted(const datasets::StructuresFound& found);

 private:
  void loadChosen(int row);
  void offerCorrection(LoadRequest request, const QString& why, const std::string& reason);
  /// Returns false if there is no part without a gap.
  bool offerLargestPart(LoadRequest request);
  /// Returns false if no part can be read either.
  bool offerPart(LoadRequest request, const QString& why);

  ui::Messages& messages_;
  ui::Menus& menus_;
  std::function<double()> free_memory_;
  Thumbnails thumbnails_;
  std::optional<Surveyed> surveyed_;  ///< the last survey with a choice
  QPointer<ui::SeriesBrowser> browser_;
};

}  // namespace app
