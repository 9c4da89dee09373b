// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QScrollArea>
#include <QString>

#include "ui/controls/small_picture.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QToolButton;

namespace ui {

/// A file or folder that was opened before.
struct Place {
  QString path;
  bool exists = true;
  bool operator==(const Place&) const = default;
};

/// The last scans as tiles in one row, as many as the row has room for.
class PlaceTiles : public QWidget {
  Q_OBJECT
 public:
  explicit PlaceTiles(QWidget* parent = nullptr);

  void setPlaces(const QList<Place>& places);
  void setThumbnail(const QString& path, const SmallPicture& picture);
  QSize minimumSizeHint() const override;

 signals:
  void wanted(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showThoseThatFit();

  QHBoxLayout* row_;
  QList<QToolButton*> tiles_;
};

/// What stands in place of the views while the window is empty: three cards, which begin with a
/// scan, with the demo skull or with a haptic device, and the last scans. While the first volume is
/// loading, its progress stands there instead.
class StartPage : public QScrollArea {
  Q_OBJECT
 public:
  /// Longest side of a thumbnail [px of the widget].
  static constexpr int kThumbnail = 96;

  explicit StartPage(QWidget* parent = nullptr);

  /// The last scans, newest first, and whether new ones are remembered. Thumbnails are dropped if
  /// the scans are others.
  void setPlaces(const QList<Place>& places, bool remembered);
  /// Shows a picture on the tile of a place; a null image leaves the tile as it is.
  void setThumbnail(const QString& path, const SmallPicture& picture);
  /// Shows what is being loaded; empty: the cards.
  void setLoading(const QString& what);
  /// 0 to 1.
  void setProgress(double fraction);

 signals:
  void fileWanted();
  void folderWanted();
  void demoWanted();
  void deviceWanted();
  void placeWanted(const QString& path);
  void cancelWanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeCards();
  /// Cards side by side; the others stand below.
  void arrange(int columns);
  QWidget* makeLoading();

  QList<Place> places_;
  QHBoxLayout* row_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QList<QWidget*> all_;
  int columns_ = 0;
  QWidget* cards_;
  QLabel* last_;
  PlaceTiles* tiles_;
  QLabel* loading_what_;
  QProgressBar* progress_;
  QWidget* loading_;
};

}  // namespace ui
