// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>

#include "app/window/loader.h"
#include "app/window/thumbnails.h"
#include "ui/main_window.h"

namespace ui {
class SeriesBrowser;
}

namespace app {

/// Lets the user choose one of several series, and how much of it: the list of a survey, and the
/// questions before a series is resampled or read in part. GUI thread.
class SeriesChoice : public QObject {
  Q_OBJECT
 public:
  /// `free_memory`: bytes that may be filled.
  SeriesChoice(ui::MainWindow& window, std::function<double()> free_memory);

  /// What the list shows from now on.
  void take(const Surveyed& surveyed);
  void browse();
  void close();
  /// Asks what a request that failed needs to succeed. False if nothing would help.
  bool ask(const LoadRequest& request, const haptics::Error& error);

 signals:
  void wanted(const app::LoadRequest& request);

 private:
  void loadChosen(int row);
  void offerCorrection(LoadRequest request, const QString& why);
  /// False if no part of it is without a gap.
  bool offerLargestPart(LoadRequest request);
  /// False if no part of it can be read either.
  bool offerPart(LoadRequest request, const QString& why);

  ui::MainWindow& window_;
  std::function<double()> free_memory_;
  Thumbnails thumbnails_;
  std::optional<Surveyed> surveyed_;  ///< what was last found where there was something to find
  QPointer<ui::SeriesBrowser> browser_;
};

}  // namespace app
