// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/view_layout.h"

#include <QApplication>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr int kGap = 4;  // px
constexpr std::size_t kVolume = 0, kAxial = 1, kCoronal = 2, kSagittal = 3, kOblique = 4;
constexpr std::array<std::pair<Arrangement, const char*>, 4> kNames{
    {{Arrangement::One, "one"},
     {Arrangement::FourUp, "four_up"},
     {Arrangement::VolumeLarge, "volume_large"},
     {Arrangement::SlicesLarge, "slices_large"}}};

/// Where shares of a length begin and end, with gaps between them.
template <class Part>
std::vector<std::pair<int, int>> rangesOf(const std::vector<Part>& parts, int length) {
  const double room = length - kGap * (static_cast<double>(parts.size()) - 1.0);
  double sum = 0.0;
  for (const Part& part : parts) sum += part.share;
  std::vector<std::pair<int, int>> ranges;
  double at = 0.0;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const double end = at + room * parts[n].share / sum;
    const int gaps = kGap * static_cast<int>(n);
    ranges.emplace_back(static_cast<int>(std::lround(at)) + gaps,
                        static_cast<int>(std::lround(end)) + gaps);
    at = end;
  }
  return ranges;
}

/// Moves the border between part n and the next by a fraction of the whole.
template <class Part>
void moveShare(std::vector<Part>& parts, std::size_t n, double by, double least) {
  const double sum = parts[n].share + parts[n + 1].share;
  if (sum < 2.0 * least) return;
  const double first = std::clamp(parts[n].share + by, least, sum - least);
  parts[n].share = first;
  parts[n + 1].share = sum - first;
}

}  // namespace

QString ViewLayout::nameOf(Arrangement arrangement) {
  for (const auto& [known, name] : kNames)
    if (known == arrangement) return name;
  return {};
}

std::optional<Arrangement> ViewLayout::arrangementOf(const QString& name) {
  for (const auto& [arrangement, known] : kNames)
    if (name == known) return arrangement;
  return {};
}

ViewLayout::ViewLayout(const Frames& frames, QWidget* parent) : QWidget(parent), frames_(frames) {
  setObjectName("views");
  for (std::size_t n = 0; n < frames_.size(); ++n) {
    frames_[n]->setParent(this);
    connect(frames_[n], &ViewFrame::maximiseWanted, this, [this, n] {
      setActive(n);
      toggleMaximised();
    });
  }
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, const QWidget* now) {
    for (std::size_t n = 0; now != nullptr && n < frames_.size(); ++n)
      if (frames_[n]->isAncestorOf(now)) setActive(n);
  });
  makeColumns();
}

void ViewLayout::setActive(std::size_t view) { active_ = view; }

void ViewLayout::arrange(Arrangement arrangement) {
  arrangement_ = arrangement;
  if (arrangement != Arrangement::One) several_ = arrangement;
  alone_ = false;
  makeColumns();
  emit arranged(arrangement);
}

void ViewLayout::setObliqueShown(bool shown) {
  oblique_ = shown;
  if (!shown && active_ == kOblique) active_ = kVolume;
  makeColumns();
}

void ViewLayout::toggleMaximised() {
  if (arrangement_ == Arrangement::One) return arrange(several_);
  alone_ = !alone_;
  makeColumns();
}

void ViewLayout::nextView() {
  const std::size_t views = oblique_ ? frames_.size() : frames_.size() - 1;
  setActive((active_ + 1) % views);
  makeColumns();
  frames_[active_]->view().setFocus(Qt::OtherFocusReason);
}

std::vector<ViewLayout::Column> ViewLayout::firstColumns(const Kind& kind) const {
  const auto& [arrangement, oblique] = kind;
  std::vector<Column> columns;
  if (arrangement == Arrangement::One) {
    columns = {{1.0, {{active_, 1.0}}}};
  } else if (arrangement == Arrangement::FourUp) {
    if (oblique)
      columns = {{1.0, {{kAxial, 1.0}, {kCoronal, 1.0}}},
                 {1.0, {{kSagittal, 1.0}, {kOblique, 1.0}}},
                 {1.0, {{kVolume, 1.0}}}};
    else
      columns = {{1.0, {{kAxial, 1.0}, {kCoronal, 1.0}}},
                 {1.0, {{kVolume, 1.0}, {kSagittal, 1.0}}}};
  } else if (arrangement == Arrangement::VolumeLarge) {
    columns = {{0.68, {{kVolume, 1.0}}},
               {0.32, {{kAxial, 1.0}, {kCoronal, 1.0}, {kSagittal, 1.0}}}};
    if (oblique) columns[1].cells.push_back({kOblique, 1.0});
  } else {
    columns = {{0.5, {{kAxial, 1.0}}},
               {0.5, {{kCoronal, 1.0}, {kSagittal, 1.0}}},
               {0.32, {{kVolume, 1.0}}}};
    if (oblique) columns[2].cells.push_back({kOblique, 1.0});
  }
  return columns;
}

void ViewLayout::makeColumns() {
  const Kind kind{alone_ ? Arrangement::One : arrangement_, oblique_};
  const auto moved = moved_.find(kind);
  columns_ = moved == moved_.end() ? firstColumns(kind) : moved->second;
  makeBorders();
  place();
  updateGeometry();
}

void ViewLayout::resetBorders() {
  moved_.erase({arrangement_, oblique_});
  makeColumns();
}

void ViewLayout::reset() {
  moved_.clear();
  arrange(Arrangement::VolumeLarge);
}

void ViewLayout::makeBorders() {
  borders_.clear();
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    for (std::size_t n = 0; n + 1 < columns_[c].cells.size(); ++n) borders_.push_back({c, n});
    if (c + 1 < columns_.size()) borders_.push_back({c, {}});
  }
  while (gaps_.size() < borders_.size()) {
    auto* gap = new ViewGap(this);
    connect(gap, &ViewGap::moved, this,
            [this, n = gaps_.size()](int px) { moveBorder(borders_[n], px); });
    connect(gap, &ViewGap::resetWanted, this, &ViewLayout::resetBorders);
    gaps_.push_back(gap);
  }
}

void ViewLayout::setHintsShown(bool shown) {
  for (ViewFrame* frame : frames_) frame->setHintShown(shown);
  updateGeometry();
}

void ViewLayout::place() {
  std::array<bool, 5> shown{};
  const auto across = rangesOf(columns_, width());
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const auto down = rangesOf(columns_[c].cells, height());
    for (std::size_t n = 0; n < columns_[c].cells.size(); ++n) {
      ViewFrame* frame = frames_[columns_[c].cells[n].view];
      frame->setGeometry(across[c].first, down[n].first, across[c].second - across[c].first,
                         down[n].second - down[n].first);
      frame->setMaximised(columns_.size() == 1);
      shown[columns_[c].cells[n].view] = true;
    }
  }
  for (std::size_t n = 0; n < gaps_.size(); ++n) {
    gaps_[n]->setVisible(n < borders_.size());
    if (n >= borders_.size()) continue;
    const auto& [c, cell] = borders_[n];
    gaps_[n]->setUpright(!cell);
    const auto& [left, right] = across[c];
    if (!cell)
      gaps_[n]->setGeometry(right, 0, kGap, height());
    else
      gaps_[n]->setGeometry(left, rangesOf(columns_[c].cells, height())[*cell].second, right - left,
                            kGap);
  }
  // one that goes hands its focus to its neighbour, which nobody has used
  const std::size_t active = active_;
  for (std::size_t n = 0; n < frames_.size(); ++n) frames_[n]->setVisible(shown[n]);
  setActive(active);
  update();
}

ViewLayout::Shares ViewLayout::sharesOf(const std::vector<Column>& columns) {
  Shares shares;
  for (const Column& column : columns) {
    std::vector<double>& of_column = shares.emplace_back(1, column.share);
    for (const Cell& cell : column.cells) of_column.push_back(cell.share);
  }
  return shares;
}

void ViewLayout::keepShares(const Kind& kind, const Shares& shares) {
  if (kind.first == Arrangement::One) return;
  std::vector<Column> columns = firstColumns(kind);
  if (shares.size() != columns.size()) return;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (shares[c].size() != columns[c].cells.size() + 1) return;
    for (const double share : shares[c])
      if (!(share >= LayoutLook::kLeastShare && share <= LayoutLook::kMostShare)) return;
    columns[c].share = shares[c][0];
    for (std::size_t n = 0; n < columns[c].cells.size(); ++n)
      columns[c].cells[n].share = shares[c][n + 1];
  }
  moved_[kind] = std::move(columns);
}

QString ViewLayout::borders() const {
  QStringList all;
  for (const auto& [kind, moved] : moved_) {
    QStringList columns;
    for (const std::vector<double>& column : sharesOf(moved)) {
      QStringList words;
      for (const double share : column) words << QString::number(share, 'f', 4);
      columns << words.join(' ');
    }
    all << nameOf(kind.first) + (kind.second ? "+tool:" : ":") + columns.join('|');
  }
  return all.join(';');
}

void ViewLayout::restoreBorders(const QString& borders) {
  for (const QString& words : borders.split(';')) {
    const QString name = words.section(':', 0, 0);
    const auto arrangement = arrangementOf(name.section('+', 0, 0));
    if (!arrangement) continue;
    Shares shares;
    for (const QString& column : words.section(':', 1).split('|')) {
      std::vector<double>& of_column = shares.emplace_back();
      for (const QString& share : column.split(' ')) of_column.push_back(share.toDouble());
    }
    keepShares({*arrangement, name.section('+', 1) == QLatin1String("tool")}, shares);
  }
  makeColumns();
}

LayoutLook ViewLayout::look() const {
  const auto moved = moved_.find({arrangement_, oblique_});
  return {.arrangement = arrangement_,
          .tool_view = oblique_,
          .active = active_,
          .alone = alone_,
          .shares = moved == moved_.end() ? Shares{} : sharesOf(moved->second)};
}

void ViewLayout::look(const LayoutLook& look) {
  const Kind kind{look.arrangement, look.tool_view};
  moved_.erase(kind);
  keepShares(kind, look.shares);
  setObliqueShown(look.tool_view);
  if (look.tool_view || look.active != kOblique) active_ = look.active;
  arrange(look.arrangement);
  if (look.alone && look.arrangement != Arrangement::One) toggleMaximised();
}

QSize ViewLayout::minimumSizeHint() const {
  // of equal shares, so that no border has to move
  double sum = 0.0;
  int w = 0, h = 0;
  for (const Column& column : columns_) sum += column.share;
  for (const Column& column : columns_)
    for (const Cell& cell : column.cells) {
      const QSize least = frames_[cell.view]->minimumSizeHint();
      w = std::max(w, static_cast<int>(least.width() * sum / column.share) + 1);
      h = std::max(h, static_cast<int>(column.cells.size()) * (least.height() + kGap));
    }
  return {w + kGap * static_cast<int>(columns_.size()), h};
}

void ViewLayout::resizeEvent(QResizeEvent*) { place(); }

void ViewLayout::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), style::kBetweenViews); }

void ViewLayout::moveBorder(const Border& border, int px) {
  constexpr double kLeast = 0.12;  // of all
  double sum = 0.0;
  if (border.cell) {
    std::vector<Cell>& cells = columns_[border.column].cells;
    for (const Cell& cell : cells) sum += cell.share;
    moveShare(cells, *border.cell, static_cast<double>(px) / height() * sum, kLeast * sum);
  } else {
    for (const Column& column : columns_) sum += column.share;
    moveShare(columns_, border.column, static_cast<double>(px) / width() * sum, kLeast * sum);
  }
  moved_[{arrangement_, oblique_}] = columns_;
  place();
}

}  // namespace ui
