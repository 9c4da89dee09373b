// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/side_panel.h"

#include <QButtonGroup>
#include <QMenu>
#include <QPainter>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controls/section.h"
#include "ui/panels/fitting_scroll.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kRail = 60;  // px wide at least
constexpr int kBesideButton = 4, kBesideWord = 4;
constexpr int kRailButton = 54;
constexpr Tab kFirstTab = Tab::Touch;
constexpr std::array<const char*, kTabs.size()> kNames{"scan", "touch", "device", "record"};

std::size_t indexOf(Tab tab) { return static_cast<std::size_t>(tab); }

/// A ground with a line at its right.
class Rail : public QWidget {
 public:
  using QWidget::QWidget;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), style::colours().ground);
    painter.fillRect(QRect(width() - 1, 0, 1, height()), style::colours().line);
  }
};

}  // namespace

RailButton::RailButton(const QString& word, const char* icon, QWidget* parent)
    : QAbstractButton(parent) {
  offerSpoken();
  setText(word);
  setIcon(style::icon(icon));
  setCheckable(true);
  setFont(style::font(style::Type::Small));
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
}

void RailButton::spokenState(QAccessible::State& state) const {
  state.selectable = true;
  state.selected = isChecked();
}

QSize RailButton::sizeHint() const {
  const int word = fontMetrics().horizontalAdvance(text()) + 2 * kBesideWord;
  return {std::max(kRail - 2 * kBesideButton, word), kRailButton};
}

void RailButton::paintEvent(QPaintEvent*) {
  const style::Colours& c = style::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF inner = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
  if (isChecked() || underMouse() || hasFocus()) {
    painter.setPen(hasFocus() ? QPen(c.accent, 2.0) : QPen(Qt::NoPen));
    painter.setBrush(isChecked() ? c.chosen : underMouse() ? c.hover : c.ground);
    painter.drawRoundedRect(inner, style::kCorner, style::kCorner);
  }
  // also without colour: a bar at the side of the one that is open
  if (isChecked()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.accent);
    painter.drawRoundedRect(QRectF(0.0, 14.0, 3.0, height() - 28.0), 1.5, 1.5);
  }
  const QRect symbol((width() - style::kIcon) / 2, 9, style::kIcon, style::kIcon);
  icon().paint(&painter, symbol, Qt::AlignCenter, QIcon::Normal,
               isChecked() ? QIcon::On : QIcon::Off);
  painter.setPen(isChecked() ? c.text : c.dim);
  painter.drawText(rect().adjusted(0, symbol.bottom() + 1, 0, -5), Qt::AlignCenter, text());
}

SidePanel::SidePanel(QMenu& entries, QWidget* parent)
    : QWidget(parent), entries_(entries), rail_(new Rail), pages_(new QStackedWidget) {
  setObjectName("sidePanel");
  rail_->setObjectName("rail");
  rail_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  auto* column = new QVBoxLayout(rail_);
  column->setContentsMargins(kBesideButton, style::kGap, kBesideButton, style::kGap);
  column->setSpacing(style::kStep);
  auto* group = new QButtonGroup(this);
  const std::array<QString, kTabs.size()> words{tr("Scan"), tr("Touch"), tr("Device"),
                                                tr("Record")};
  const std::array<QString, kTabs.size()> tips{tr("Measures and marks"),
                                               tr("Surface, tool and hand, remove parts"),
                                               tr("The haptic device"), tr("Recordings")};
  for (std::size_t n = 0; n < kTabs.size(); ++n) {
    auto* button = new RailButton(words[n], kNames[n]);
    button->setObjectName(QString(kNames[n]) + "Tab");
    button->setToolTip(tips[n]);
    buttons_[n] = button;
    group->addButton(button);
    column->addWidget(button);
    connect(button, &QAbstractButton::clicked, this, [this, n] {
      setTab(kTabs[n]);
      emit changed();
    });
    auto* page = new QWidget;
    columns_[n] = new QVBoxLayout(page);
    columns_[n]->setContentsMargins(0, 0, 0, 0);
    columns_[n]->setSpacing(0);
    columns_[n]->addStretch(1);
    pages_->addWidget(new FittingScroll(page));
  }
  column->addStretch(1);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(pages_);
  setTab(kFirstTab);
}

void SidePanel::add(QWidget* panel, const QString& title, const QString& entry, const char* name,
                    Tab tab, Fold fold) {
  auto* section = new Section(title, panel, fold == Fold::Folded);
  section->setObjectName(name);
  QVBoxLayout* column = columns_[indexOf(tab)];
  column->insertWidget(column->count() - 1, section);  // above what stretches
  sections_.push_back(section);
  connect(section, &Section::foldedChanged, this, &SidePanel::changed);
  if (entry.isEmpty()) return;
  entries_.addAction(entry, panel, [this, panel] {
    reveal(panel);
    panel->setFocus();
  });
}

void SidePanel::reveal(const QWidget* panel) {
  const auto found =
      std::ranges::find_if(sections_, [&](Section* one) { return &one->panel() == panel; });
  if (found == sections_.end()) return;
  Section& section = **found;
  for (std::size_t n = 0; n < kTabs.size(); ++n)
    if (columns_[n]->indexOf(&section) >= 0) setTab(kTabs[n]);
  const bool folded = section.folded();
  section.setFolded(false);
  if (folded) emit changed();
  auto* scroll = static_cast<QScrollArea*>(pages_->currentWidget());
  scroll->widget()->layout()->activate();
  scroll->ensureWidgetVisible(&section, 0, 0);
}

Tab SidePanel::tab() const { return kTabs[static_cast<std::size_t>(pages_->currentIndex())]; }

void SidePanel::setTab(Tab tab) {
  pages_->setCurrentIndex(static_cast<int>(tab));
  buttons_[indexOf(tab)]->setChecked(true);
}

PanelState SidePanel::state() const {
  PanelState state{.tab = kNames[indexOf(tab())]};
  for (const Section* section : sections_)
    (section->folded() ? state.folded : state.unfolded) << section->objectName();
  return state;
}

void SidePanel::restore(const PanelState& state) {
  for (std::size_t n = 0; n < kTabs.size(); ++n)
    if (state.tab == QLatin1String(kNames[n])) setTab(kTabs[n]);
  for (Section* section : sections_) {
    if (state.folded.contains(section->objectName())) section->setFolded(true);
    if (state.unfolded.contains(section->objectName())) section->setFolded(false);
  }
}

void SidePanel::reset() {
  setTab(kFirstTab);
  for (Section* section : sections_) section->reset();
}

}  // namespace ui
