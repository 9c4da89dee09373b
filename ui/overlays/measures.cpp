// SPDX-License-Identifier: BSD-3-Clause
#include "ui/overlays/measures.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/controls/lengths.h"
#include "ui/props/picture.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr double kHandle = 5.0;     // radius, pixels
constexpr double kReach = 9.0;      // from the mouse to a handle, pixels
constexpr double kLabelGap = 10.0;  // from a place to its label, pixels
constexpr double kDragged = 6.0;    // a press that moves further is a drag, pixels
constexpr double kWidestLabel = 260.0, kNarrowLabel = 46.0;  // pixels, of one line, and of many
constexpr int kLabelPixels = 11;
constexpr std::size_t kMostSights = 200;  // handles that are sought behind the surface
constexpr std::size_t kMostRemoved = 100;

// light on a dark rim: seen on bone and on air
using style::kChosenMeasure, style::kMeasure, style::kMeasureGround, style::kMeasureRim;

void drawMarkHandle(QPainter& painter, QPointF at, const QColor& ink, bool hollow) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kMeasureRim, 4.5));
  painter.drawEllipse(at, kHandle, kHandle);
  painter.setPen(QPen(ink, 2.0));
  if (!hollow) painter.setBrush(ink);
  painter.drawEllipse(at, kHandle, kHandle);
  // the place itself, which a full disc would hide
  if (hollow) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(kMeasureRim);
  painter.drawEllipse(at, 1.2, 1.2);
}

QPointF nearestOf(const QRectF& box, QPointF p) {
  return {std::clamp(p.x(), box.left(), box.right()), std::clamp(p.y(), box.top(), box.bottom())};
}

/// Whether a handle of the 3-D view is in it: behind the eye nothing is seen, though it is
/// projected.
bool isBefore(const ViewGeometry& view, const Eigen::Vector3d& p_mm, QPointF at) {
  Eigen::Vector3d from, along;
  view.sight(at, from, along);
  return view.axes().col(2).dot(p_mm - from) < 0.0 && view.widget().rect().contains(at.toPoint());
}

/// The share of a line's length that lies in a box.
double shareInside(const QPolygonF& line, const QRectF& box) {
  constexpr int kSteps = 24;
  int inside = 0, all = 0;
  for (int i = 1; i < line.size(); ++i)
    for (int s = 0; s <= kSteps; ++s, ++all)
      inside += box.contains(line[i - 1] + (line[i] - line[i - 1]) * (double(s) / kSteps));
  return all == 0 ? 0.0 : double(inside) / all;
}

constexpr double kOverBody = 3e3, kOverWords = 1e4;  // how bad that is for a label
constexpr double kSmallView = 350.0;                 // px, of height

/// Where a label of this size goes, and how bad that is: near its anchor, within the view, on no
/// handle, clear of other labels and of the body as far as there is room. Without a search only
/// places beside the anchor and in the corners are tried.
std::pair<QRectF, double> labelPlace(QSizeF size, QPointF anchor, const QPolygonF& line,
                                     const QPolygonF& handles, const ViewGeometry& view,
                                     const QRectF& seen, const std::vector<QRectF>& taken,
                                     bool search) {
  constexpr double kStep = 6.0;  // px
  const double w = size.width(), h = size.height();
  std::vector<QPointF> corners{anchor + QPointF{kLabelGap, -kLabelGap - h},
                               anchor + QPointF{kLabelGap, kLabelGap},
                               anchor + QPointF{-kLabelGap - w, -kLabelGap - h},
                               anchor + QPointF{-kLabelGap - w, kLabelGap}};
  const QRectF room = seen.adjusted(2.0, 2.0, -2.0 - w, -2.0 - h);
  const double last = search ? room.bottom() : -INFINITY;
  for (double y = room.top(); y <= last; y += kStep)
    for (double x = room.left(); x <= room.right(); x += kStep) corners.emplace_back(x, y);
  for (const double y : {room.top(), room.bottom()})
    for (const double x : {room.left(), room.right()}) corners.emplace_back(x, y);
  QRectF best;
  double least = std::numeric_limits<double>::infinity();
  for (const QPointF& corner : corners) {
    const QRectF box(corner, size);
    double cost = QLineF(nearestOf(box, anchor), anchor).length();
    if (!seen.contains(box)) cost += 1e6;
    if (cost >= least) continue;
    for (const QPointF& p : handles)
      if (box.adjusted(-kReach, -kReach, kReach, kReach).contains(p)) cost += 1e5;
    if (cost >= least) continue;
    for (const QRectF& other : taken)
      if (other.adjusted(-2.0, -2.0, 2.0, 2.0).intersects(box)) cost += kOverWords;
    if (cost < least && view.showsBody(box.adjusted(-4.0, -4.0, 4.0, 4.0))) cost += kOverBody;
    if (cost < least) cost += 1e3 * shareInside(line, box);
    if (cost >= least) continue;
    least = cost;
    best = box;
  }
  return {best, least};
}

QFont labelFont(const ViewGeometry& view) {
  QFont font = view.widget().font();
  font.setPixelSize(kLabelPixels);
  return font;
}

/// The part of a view in which something is seen.
QRectF seenPart(const ViewGeometry& view) {
  return view.isSlice() ? view.room() : QRectF(view.widget().rect());
}

}  // namespace

Measures::Measures(QObject* parent) : Overlay(parent) {
  whenLengthUnitChanges(*this, [this] {
    emit listChanged();
    emit changed();
  });
}

void Measures::setScan(const MeasuredScan& scan) {
  scan_ = scan;
  sights_.clear();
  emit listChanged();
  emit changed();
}

void Measures::surfaceChanged() {
  sights_.clear();
  if (!all_.empty()) emit changed();
}

void Measures::replace(std::vector<Measure> measures) {
  Removed removed;
  for (std::size_t i = 0; i < all_.size(); ++i)
    removed.measures.emplace_back(static_cast<int>(i), std::move(all_[i]));
  if (!removed.measures.empty()) removed_.push_back(std::move(removed));
  all_ = std::move(measures);
  setPlacing({});
  select(-1);
  emit listChanged();
  emit changed();
}

void Measures::clear() {
  setPlacing({});
  select(-1);
  all_.clear();
  removed_.clear();
  travel_.reset();
  emit listChanged();
  emit changed();
}

void Measures::rename(int index, const QString& text) {
  if (index < 0 || index >= static_cast<int>(all_.size())) return;
  const QString line = plainLine(text);
  Measure& measure = all_[static_cast<std::size_t>(index)];
  if (!line.isEmpty()) measure.text = line.toStdString();
  emit listChanged();
  emit changed();
}

void Measures::remove(int index) {
  if (index < 0 || index >= static_cast<int>(all_.size())) return;
  removed_.push_back({{{index, std::move(all_[static_cast<std::size_t>(index)])}}});
  if (removed_.size() > kMostRemoved) removed_.erase(removed_.begin());
  all_.erase(all_.begin() + index);
  dragged_.reset();
  over_ = false;
  select(-1);
  emit listChanged();
  emit changed();
}

void Measures::restore() {
  if (removed_.empty()) return;
  int last = -1;
  for (auto& [index, measure] : removed_.back().measures) {
    if (all_.size() >= kMost) break;
    last = std::min(index, static_cast<int>(all_.size()));
    all_.insert(all_.begin() + last, std::move(measure));
  }
  removed_.pop_back();
  emit listChanged();
  select(last);
  emit changed();
}

void Measures::select(int index) {
  if (selected_ == index) return;
  selected_ = index;
  emit selectionChanged(index);
  emit changed();
}

void Measures::setPlacing(std::optional<MeasureKind> kind) {
  if (kind && (all_.size() >= kMost || scan_.grid.dims[0] == 0)) kind.reset();
  const bool other = !begun_.places_mm.empty() || kind != placing_;
  begun_ = {};
  next_mm_.reset();
  placing_ = kind;
  if (kind) begun_.kind = *kind;
  emit placingChanged(kind ? static_cast<int>(*kind) : -1);
  if (other) emit changed();  // the hint, too
}

void Measures::setTravel(const std::optional<Travel>& travel) {
  if (!travel && !travel_) return;
  travel_ = travel;
  emit changed();
}

Eigen::Vector3d Measures::inScan(const Eigen::Vector3d& p_mm) const {
  const haptics::Grid& grid = scan_.grid;
  haptics::Vec3 index = grid.indexOf(p_mm / kMmPerM);
  for (int a = 0; a < 3; ++a)
    index[a] = std::clamp(index[a], 0.0, std::max(0.0, double(grid.dims[std::size_t(a)]) - 1.0));
  return grid.worldOf(index) * kMmPerM;
}

QPolygonF Measures::markHandlesIn(const ViewGeometry& view) const {
  QPolygonF handles;
  for (const Measure& measure : all_)
    for (const Eigen::Vector3d& p_mm : measure.places_mm)
      if (const QPointF at = view.projected(p_mm);
          view.isSlice() ? std::abs(view.offset_mm(p_mm)) <= kFaint_mm : isBefore(view, p_mm, at))
        handles << at;
  return handles;
}

Measures::Handle Measures::handleOf(const ViewGeometry& view, const Eigen::Vector3d& p_mm) const {
  Handle handle{.at = view.projected(p_mm)};
  const Eigen::Vector3d towards = view.axes().col(2);
  if (view.isSlice()) {
    const double off = std::abs(view.offset_mm(p_mm));
    const haptics::Grid& grid = scan_.grid;
    const double voxel_mm =
        (grid.spacing.cwiseProduct(grid.direction.transpose() * towards)).norm() * kMmPerM;
    handle.hollow = off > 0.5 * voxel_mm + 1e-6;
    handle.shown = !handle.hollow || off <= kFaint_mm;
    return handle;
  }
  handle.shown = isBefore(view, p_mm, handle.at);
  handle.hollow = handle.shown && isBehindSurface(view, p_mm, handle.at);
  return handle;
}

bool Measures::isBehindSurface(const ViewGeometry& view, const Eigen::Vector3d& p_mm,
                               QPointF at) const {
  Eigen::Vector3d from, along;
  view.sight(at, from, along);
  const auto known = std::find_if(sights_.begin(), sights_.end(),
                                  [&](const Sight& sight) { return sight.p == p_mm; });
  if (known != sights_.end() && known->from == from && known->along == along) return known->behind;
  if (known == sights_.end() && sights_.size() >= kMostSights) return false;
  const auto met = view.placeUnder(at);
  const double room = scan_.grid.spacing.norm() * kMmPerM;
  const bool behind = met && along.dot(p_mm - *met) > room;
  if (known != sights_.end())
    *known = {from, along, p_mm, behind};
  else
    sights_.push_back({from, along, p_mm, behind});
  return behind;
}

QStringList Measures::labelsOf(const Measure& measure, const QFontMetricsF& metrics,
                               double widest) const {
  const QString text = QString::fromStdString(measure.text);
  const auto elided = [&](double width) {
    return metrics.elidedText(text, Qt::ElideRight, std::min(width, widest));
  };
  const QString value = valueOf(measure, scan_);
  if (value.isEmpty()) return {elided(kWidestLabel), elided(kNarrowLabel)};
  if (text.isEmpty()) return {value};
  QString broken = value;
  broken.replace(QString(QChar(QChar::Nbsp)) + QChar(0xb1), QStringLiteral("\n\u00b1"));
  return {metrics.elidedText(tr("%1: %2").arg(text, value), Qt::ElideRight,
                             std::min(kWidestLabel, widest)),
          elided(kWidestLabel) + '\n' + value, elided(kNarrowLabel) + '\n' + broken};
}

Measures::Drawn Measures::drawnOf(const ViewGeometry& view, const Measure& measure) const {
  Drawn drawn;
  for (const Eigen::Vector3d& p : measure.places_mm) {
    const Handle handle = handleOf(view, p);
    drawn.handles.push_back(handle);
    drawn.dashed = drawn.dashed || handle.hollow || !handle.shown;
    drawn.line << handle.at;
    drawn.any = drawn.any || handle.shown;
  }
  return drawn;
}

void Measures::paintMeasure(QPainter& painter, const ViewGeometry& view, const Measure& measure,
                            bool chosen, bool whole) const {
  Drawn drawn = drawnOf(view, measure);
  if (!drawn.any) return;
  const QColor ink = chosen ? kChosenMeasure : kMeasure;
  if (!whole && next_mm_) drawn.line << view.projected(*next_mm_);
  if (drawn.line.size() > 1) drawLine(painter, drawn.line, ink, chosen ? 2.2 : 1.6, drawn.dashed);
  if (whole) {
    QPolygonF arc;
    for (const Eigen::Vector3d& p : arcOf(measure)) arc << view.projected(p);
    if (!arc.isEmpty()) drawLine(painter, arc, ink, 1.2, drawn.dashed);
  }
  for (const Handle& handle : drawn.handles)
    if (handle.shown) drawMarkHandle(painter, handle.at, ink, handle.hollow);
}

std::vector<MeasureLabel> Measures::labelsIn(const ViewGeometry& view) const {
  const QFont font = labelFont(view);
  const QFontMetricsF metrics(font);
  const QRectF seen = seenPart(view);
  std::vector<Drawn> drawn;
  QPolygonF handles;
  for (const Measure& measure : all_) {
    drawn.push_back(drawnOf(view, measure));
    for (const Handle& handle : drawn.back().handles)
      if (handle.shown) handles << handle.at;
  }
  if (travel_) handles << view.projected(travel_->from_mm);
  std::vector<MeasureLabel> labels;
  std::vector<QRectF> taken = view.taken();
  constexpr int kMostSearched = 30;  // each takes up to a millisecond
  int searched = 0;
  // in more lines where it is then nearer by far, or over nothing
  const auto add = [&](const QStringList& texts, QPointF anchor, const QPolygonF& line,
                       bool chosen) {
    constexpr double kLineBreak = 100.0;  // as far as it is from the anchor, pixels
    MeasureLabel label;
    double least = std::numeric_limits<double>::infinity();
    ++searched;
    for (qsizetype n = 0; n < texts.size(); ++n) {
      const auto [box, cost] = labelPlace(labelSize(font, texts[n]), anchor, line, handles, view,
                                          seen, taken, searched < kMostSearched || chosen);
      if (cost + kLineBreak * static_cast<double>(n) >= least) continue;
      least = cost + kLineBreak * static_cast<double>(n);
      label = {texts[n], box, anchor};
    }
    // where only the body or other words have room, the list and a click on the mark have its
    // words; in 3-D a body may fill the view, and there is more room unless that is small
    const bool strict = view.isSlice() || seen.height() < kSmallView;
    if (least >= (strict ? kOverBody : kOverWords) && !chosen) return;
    taken.push_back(label.box);
    labels.push_back(std::move(label));
  };
  // the chosen one last, above the others
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (static_cast<int>(i) != selected_) order.push_back(i);
  if (selected_ >= 0 && selected_ < static_cast<int>(all_.size()))
    order.push_back(static_cast<std::size_t>(selected_));
  for (const std::size_t i : order) {
    if (!drawn[i].any) continue;
    const QPolygonF& line = drawn[i].line;
    QPointF anchor = line.first();
    if (all_[i].kind == MeasureKind::Distance) anchor = 0.5 * (line[0] + line[1]);
    if (all_[i].kind == MeasureKind::Angle) anchor = line[1];
    add(labelsOf(all_[i], metrics, seen.width() - 14.0), anchor, line,
        static_cast<int>(i) == selected_);
  }
  if (travel_) {
    const QPointF from = view.projected(travel_->from_mm), to = view.projected(travel_->to_mm);
    const QString length =
        numberWords(travel_->length_mm / mmPerLengthUnit(), lengthDecimals(1)) + ' ';
    add({tr("Travelled %1").arg(length + lengthUnitName())}, from, {from, to}, true);
  }
  return labels;
}

void Measures::paint(QPainter& painter, const ViewGeometry& view) const {
  if (all_.empty() && begun_.places_mm.empty() && !travel_) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(labelFont(view));
  const std::vector<MeasureLabel> labels = labelsIn(view);
  for (const MeasureLabel& label : labels) {
    const QPointF end = nearestOf(label.box, label.anchor);
    painter.setPen(QPen(kMeasureRim, 3.0));
    painter.drawLine(label.anchor, end);
    painter.setPen(QPen(kMeasure, 1.0));
    painter.drawLine(label.anchor, end);
  }
  const auto chosen = [&](std::size_t i) { return static_cast<int>(i) == selected_; };
  for (const bool last : {false, true})
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (chosen(i) == last) paintMeasure(painter, view, all_[i], last, true);
  if (!begun_.places_mm.empty()) paintMeasure(painter, view, begun_, true, false);
  if (travel_) {
    const QPointF from = view.projected(travel_->from_mm), to = view.projected(travel_->to_mm);
    drawLine(painter, {from, to}, kMeasure, 1.4, true);
    drawMarkHandle(painter, from, kMeasure, true);
  }
  for (const MeasureLabel& label : labels) drawLabel(painter, label.box, label.text);
}

QString Measures::note() const {
  return all_.empty() && !travel_ ? QString() : tr("Not for treatment");
}

std::optional<std::pair<int, int>> Measures::handleAt(const ViewGeometry& view, QPointF at) const {
  std::optional<std::pair<int, int>> nearest;
  double least = kReach;
  const auto look = [&](int index) {
    const Measure& measure = all_[static_cast<std::size_t>(index)];
    for (std::size_t p = 0; p < measure.places_mm.size(); ++p) {
      const double away = QLineF(view.projected(measure.places_mm[p]), at).length();
      if (away >= least || !handleOf(view, measure.places_mm[p]).shown) continue;
      least = away;
      nearest = {index, static_cast<int>(p)};
    }
  };
  // of two at one place the chosen one, then the newer, as they are drawn
  if (selected_ >= 0 && selected_ < static_cast<int>(all_.size())) look(selected_);
  for (int i = static_cast<int>(all_.size()) - 1; i >= 0; --i)
    if (i != selected_) look(i);
  return nearest;
}

bool Measures::press(const ViewGeometry& view, const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  const QPointF at = event.position();
  if (placing_) {
    const auto p = view.placeUnder(at);
    if (!p) return false;  // beside the surface the view does what it does
    begun_.places_mm.push_back(inScan(*p));
    next_mm_.reset();
    pressed_ = at;
    emit changed();
    return true;
  }
  const auto handle = handleAt(view, at);
  if (!handle) return false;
  dragged_ = handle;
  const Measure& measure = all_[static_cast<std::size_t>(handle->first)];
  grab_ = view.projected(measure.places_mm[static_cast<std::size_t>(handle->second)]) - at;
  select(handle->first);
  return true;
}

bool Measures::drag(const ViewGeometry& view, const QMouseEvent& event) {
  const QPointF at = event.position();
  if (placing_ && !begun_.places_mm.empty()) {
    const auto p = view.placeUnder(at);
    if (!p) return true;
    // a distance may be drawn in one go
    const bool first = begun_.kind == MeasureKind::Distance && begun_.places_mm.size() == 1;
    if (first && QLineF(pressed_, at).length() < kDragged) return true;
    if (first)
      begun_.places_mm.push_back(inScan(*p));
    else
      begun_.places_mm.back() = inScan(*p);
    emit changed();
    return true;
  }
  if (!dragged_) return true;
  Measure& measure = all_[static_cast<std::size_t>(dragged_->first)];
  Eigen::Vector3d& place = measure.places_mm[static_cast<std::size_t>(dragged_->second)];
  if (view.isSlice())
    place = inScan(view.placeBeside(at + grab_, place));
  else if (const auto p = view.placeUnder(at + grab_))
    place = inScan(*p);
  emit listChanged();
  emit changed();
  return true;
}

bool Measures::release(const ViewGeometry&, const QMouseEvent&) {
  dragged_.reset();
  if (placing_ && begun_.places_mm.size() == placesOf(begun_.kind)) finish();
  return true;
}

bool Measures::hover(const ViewGeometry& view, const QMouseEvent& event) {
  over_ = false;
  if (placing_) {
    const auto p = view.placeUnder(event.position());
    if (p) next_mm_ = inScan(*p);
    if (p && !begun_.places_mm.empty()) emit changed();
    return p.has_value();
  }
  over_ = handleAt(view, event.position()).has_value();
  return over_;
}

bool Measures::key(const ViewGeometry&, const QKeyEvent& event) {
  const Binding* meaning = meaningOf(Where::View, event);
  if (meaning == nullptr) return false;
  const bool del = meaning->action == Action::DeleteMark;
  if (!del && meaning->action != Action::TakePlaceBack) return false;
  if (!begun_.places_mm.empty()) {
    begun_.places_mm.pop_back();
    emit changed();
    return true;
  }
  if (!del || selected_ < 0) return false;
  remove(selected_);
  return true;
}

QString Measures::hint() const {
  if (!placing_) return {};
  return tr("Click, or %1 at the crosshair: sets a place. %2: takes it back. Escape: ends.")
      .arg(keyOf(Action::SetPlace), keyOf(Action::TakePlaceBack));
}

Qt::CursorShape Measures::cursor() const {
  return placing_ ? Qt::CrossCursor : over_ ? Qt::SizeAllCursor : Qt::ArrowCursor;
}

QString Measures::freeName(MeasureKind kind) const {
  for (std::size_t number = 1;; ++number) {
    const QString name = tr("%1 %2").arg(nameOf(kind)).arg(number);
    const std::string text = name.toStdString();
    if (std::none_of(all_.begin(), all_.end(),
                     [&](const Measure& measure) { return measure.text == text; }))
      return name;
  }
}

void Measures::finish() {
  Measure made = std::move(begun_);
  made.text = freeName(made.kind).toStdString();
  setPlacing({});
  all_.push_back(std::move(made));
  const int index = static_cast<int>(all_.size()) - 1;
  emit listChanged();
  select(index);
  emit placed(index);
  emit changed();
}

}  // namespace ui
