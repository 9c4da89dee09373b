// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/tool_tiles.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionToolButton>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "ui/panels/tool_picture.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 3> kUsualTools{
    {{"burr-4", QT_TRANSLATE_NOOP("ui::ToolTiles", "Burr 4 mm")},
     {"probe", QT_TRANSLATE_NOOP("ui::ToolTiles", "Probe")},
     {"hook", QT_TRANSLATE_NOOP("ui::ToolTiles", "Hook")}}};
constexpr QSize kTilePicture{60, 24};  // px
constexpr int kTileInside = 5;

/// A picture above its title.
class Tile : public QToolButton {
 public:
  explicit Tile(QWidget* parent) : QToolButton(parent) {
    setCheckable(true);
    setFont(style::font(style::Type::Small));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  void setPicture(const ToolPicture& picture) {
    picture_ = picture;
    update();
  }
  QSize sizeHint() const override {
    return {kTilePicture.width() + 2 * kTileInside,
            kTilePicture.height() + fontMetrics().lineSpacing() + 3 * kTileInside};
  }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.text.clear();
    style()->drawComplexControl(QStyle::CC_ToolButton, &option, &painter, this);
    const QColor ink = palette().color(QPalette::ButtonText);
    painter.drawPixmap(QPoint((width() - kTilePicture.width()) / 2, kTileInside),
                       picture_.pixmap(kTilePicture, devicePixelRatioF(), ink));
    painter.setPen(ink);
    painter.drawText(rect().adjusted(0, 0, 0, -kTileInside), Qt::AlignHCenter | Qt::AlignBottom,
                     text());
  }

 private:
  ToolPicture picture_;
};

}  // namespace

ToolTiles::ToolTiles(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(style::kStep);
  for (QToolButton*& tile : tiles_) {
    tile = new Tile(this);
    row->addWidget(tile);
    connect(tile, &QToolButton::clicked, this, [this, tile = tile] {
      tile->setChecked(!tile->isChecked());  // until the tool is there
      emit toolChosen(tile->property("tool").toString());
    });
  }
}

void ToolTiles::put(QToolButton& tile, const ToolEntry& tool, const QString& words) {
  tile.setObjectName("tile-" + tool.id);
  tile.setProperty("tool", tool.id);
  tile.setText(
      tile.fontMetrics().elidedText(words, Qt::ElideRight, kTilePicture.width() + 2 * kTileInside));
  tile.setToolTip(tool.title);
  static_cast<Tile&>(tile).setPicture(ToolPicture(tool.mesh));
}

void ToolTiles::setTools(const QList<ToolEntry>& tools) {
  for (std::size_t n = 0; n < tiles_.size(); ++n)
    for (const ToolEntry& tool : tools)
      if (tool.id == QLatin1String(kUsualTools[n].first))
        put(*tiles_[n], tool, tr(kUsualTools[n].second));
}

void ToolTiles::showTool(const ToolEntry& tool) {
  const auto has = [&](const QToolButton* tile) { return tile->property("tool") == tool.id; };
  if (std::ranges::none_of(tiles_, has)) put(*tiles_.back(), tool, tool.title);
  for (QToolButton* tile : tiles_) tile->setChecked(has(tile));
}

}  // namespace ui
