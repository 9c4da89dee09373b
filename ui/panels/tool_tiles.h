// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>

#include "ui/panels/tool_list.h"

class QToolButton;

namespace ui {

/// The usual tools as tiles, a click each: a burr, a probe, a hook. Another tool that is
/// present takes the last tile.
class ToolTiles : public QWidget {
  Q_OBJECT
 public:
  explicit ToolTiles(QWidget* parent = nullptr);

  void setTools(const QList<ToolEntry>& tools);
  /// Shows the present tool. Emits no signal.
  void showTool(const ToolEntry& tool);

 signals:
  void toolChosen(const QString& id);

 private:
  void put(QToolButton& tile, const ToolEntry& tool, const QString& words);

  std::array<QToolButton*, 3> tiles_{};
};

}  // namespace ui
