// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QIcon>
#include <QList>
#include <QString>
#include <QStringList>
#include <array>
#include <cstdint>

#include "ui/controls/small_picture.h"

class QPlainTextEdit;
class QTableWidget;

namespace ui {

/// Whether a series can be loaded.
enum class Verdict {
  Sound,
  Correctable,  ///< resampled, if the user agrees
  InPart,       ///< slices are missing: the largest part without a gap, if the user agrees
  Structures,   ///< no scan: structures, which are opened in their scan
  Refused
};

/// One line of the browser. A text is empty if the file does not state it.
struct SeriesRow {
  QString patient, study, series, modality;
  std::array<std::int64_t, 3> dims{};  ///< voxels of the series, or of its part; zeros: unknown
  std::int64_t slices_there =
      0;  ///< for InPart: slices in the series; its largest part has dims[2]
  std::array<double, 3> spacing_mm{};  ///< not shown for a refused series
  Verdict verdict = Verdict::Refused;
  QString sentence;         ///< the message for the verdict
  QStringList faults = {};  ///< a sentence for each file that cannot be used
  std::int64_t bytes = 0;   ///< size in memory; 0: unknown
};

/// Lists the series in a folder, an archive or a file of several volumes, and lets the user choose
/// one. Patients' names are hidden until the user asks for them; they are hidden again in each
/// list.
class SeriesBrowser : public QDialog {
  Q_OBJECT
 public:
  SeriesBrowser(const QString& place, const QList<SeriesRow>& rows, QWidget* parent = nullptr);

  /// The middle slice of a row; a null image if there is none.
  void showThumbnail(int row, const SmallPicture& picture);

  static constexpr int kThumbnail = 72;  ///< pixels to a side, before the screen's own scale

 signals:
  /// Never emitted for a refused row.
  void loadWanted(int row);

 private:
  void fill();
  void fillRow(int row, const QIcon& verdict, const QIcon& no_picture_yet);
  int seriesCount() const;
  void addLoadButtons();
  void addLoadButton(int row);
  void showPatients(bool shown);
  void showDetails();
  void choose(int row);
  int columnOf(int column) const;

  QList<SeriesRow> rows_;
  QTableWidget* table_;
  QPlainTextEdit* details_;
  bool patients_shown_ = false;
};

}  // namespace ui
