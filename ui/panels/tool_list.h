// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QPushButton>
#include <QString>
#include <vector>

#include "haptics/core/triangle_mesh.h"
#include "ui/panels/tool_picture.h"

class QFrame;
class QListWidget;

namespace ui {

/// A tool that can be chosen.
struct ToolEntry {
  QString id;                       ///< its name in the program
  QString use;                      ///< title of its group
  QString title;                    ///< for the user
  double length = 0.0;              ///< m
  double tip = 0.0;                 ///< m, across its tip; 0: not known
  haptics::TriangleMesh mesh = {};  ///< m, its tip along -z
};

/// A button that shows the present tool with its picture, length and tip, and opens the list of all
/// tools by use.
class ToolList : public QPushButton {
  Q_OBJECT
 public:
  explicit ToolList(QWidget* parent = nullptr);

  void setTools(const QList<ToolEntry>& tools);
  /// Shows the present tool, one of the list. Emits no signal.
  void showTool(const QString& id);
  /// Shows a tool that is not in the list as the present one; it stands there until another is.
  void showOther(const ToolEntry& tool);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void toolChosen(const QString& id);
  void fileWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Tool {
    ToolEntry entry;
    ToolPicture picture;
  };
  class Delegate;
  friend class Delegate;

  void open();
  void choose(int row);
  /// The lines of the list: groups, tools, the file.
  void list();
  void markPresent();
  const Tool* present() const;

  std::vector<Tool> tools_;  ///< one that is not of the list is the last
  std::size_t listed_ = 0;   ///< how many of them are of the list
  QString present_;
  QFrame* popup_;
  QListWidget* lines_;
};

}  // namespace ui
