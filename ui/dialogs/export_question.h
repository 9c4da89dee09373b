// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QRadioButton;

namespace ui {

class NumberBox;

/// Title and description of an export format.
struct ExportFormat {
  QString title, about;
};

/// Format and options of an export. Times are the recording's own, s.
struct ExportWish {
  struct Film {
    enum class Camera {
      AsRecorded,
      Fixed  ///< the camera of the view, as it is now
    };
    Camera camera = Camera::AsRecorded;
    int width = 1280, height = 720;  ///< pixels
    int frames_per_second = 30;
    bool figures = true;  ///< force and time are written into the picture
    bool slices = false;  ///< the three slices are beside it
  };
  std::optional<std::size_t> table = 0;  ///< index of the format; none: a film
  double from = 0.0, to = 0.0;
  std::optional<double> rate = {};  ///< Hz; none: every step. Not used for a film
  bool contacts = true;             ///< not used for a film
  Film film = {};
};

/// Asks for the options of an export. The initial range is the whole recording. An empty range
/// cannot be chosen.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  /// For a recording from `begin` to `end` [s]. The choices are `formats` (at least one) and a
  /// film.
  ExportDialog(double begin, double end, std::vector<ExportFormat> formats,
               QWidget* parent = nullptr);
  ExportWish wish() const;

 private:
  QWidget* buildSamples();
  QWidget* buildFilm();
  NumberBox* timeSpin(const char* name, double value);
  void showFormat();
  void showRange();

  double begin_, end_;
  std::vector<ExportFormat> tables_;
  QComboBox* formats_;  ///< the table formats, and a film
  QLabel* about_;
  NumberBox* from_;
  NumberBox* to_;
  QLabel* range_;
  QRadioButton* every_step_;
  QRadioButton* at_rate_;
  NumberBox* rate_;
  QCheckBox* contacts_;
  QComboBox* cameras_;
  QComboBox* sizes_;
  QComboBox* frame_rates_;
  QCheckBox* figures_;
  QCheckBox* slices_;
  QWidget* samples_ = nullptr;
  QWidget* film_ = nullptr;
  QPushButton* export_ = nullptr;
};

/// Asks until the user agrees or cancels. Empty if the user cancels.
std::optional<ExportWish> askForExport(QWidget* parent, double begin, double end,
                                       std::vector<ExportFormat> formats);

}  // namespace ui
