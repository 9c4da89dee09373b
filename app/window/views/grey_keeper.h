// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <string>

#include "app/window/scan/shared_state.h"
#include "ui/views/slice_set.h"

namespace app {

/// Remembers for each scan the grey window that the user chose: it comes back when the same place
/// is opened again while the program runs. GUI thread.
class GreyKeeper : public QObject {
  Q_OBJECT
 public:
  GreyKeeper(ui::SliceSet& slices, SharedState& shared);

  /// After another volume is shown.
  void showScene();
  /// The window that is kept for the scan on view; none: it is the one at first.
  std::optional<ui::GreyWindow> kept() const;
  /// Keeps a window for the scan that is shown.
  void keep(const ui::GreyWindow& grey);

 private:
  /// Of the scan that is shown: where it lies, and which of a file it is.
  std::string name() const;

  ui::SliceSet& slices_;
  SharedState& shared_;
  std::map<std::string, ui::GreyWindow> kept_;
};

}  // namespace app
