// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/style.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QHeaderView>
#include <QIconEngine>
#include <QLabel>
#include <QPainter>
#include <QSvgRenderer>
#include <QTableWidget>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/style/controls.h"

// of a static library, whose resources nobody else asks for
static void initResources() {
  Q_INIT_RESOURCE(resources);
  Q_INIT_RESOURCE(help);
}

namespace ui::style {
namespace {

constexpr double kPointsPerPixel = 72.0 / 96.0;
constexpr std::array<std::pair<Theme, const char*>, 4> kNames{{{Theme::System, "system"},
                                                               {Theme::Dark, "dark"},
                                                               {Theme::Light, "light"},
                                                               {Theme::HighContrast, "contrast"}}};

Theme worn = Theme::Dark;

/// The desktop's own, before any theme was applied.
struct Desktop {
  bool dark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
  QFont font = QApplication::font();
};

const Desktop& desktop() {
  static const Desktop before;
  return before;
}

int pixelsOf(Type type) {
  switch (type) {
    case Type::Small:
      return kSmall;
    case Type::Section:
      return kSection;
    case Type::Figure:
      return kFigure;
    case Type::Force:
      return kForce;
    case Type::Body:
      break;
  }
  return kBody;
}

/// Draws one symbol in the colours of the theme.
class SymbolEngine : public QIconEngine {
 public:
  explicit SymbolEngine(QString path) : path_(std::move(path)) {}
  QIconEngine* clone() const override { return new SymbolEngine(*this); }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const qreal scale = painter->device() ? painter->device()->devicePixelRatioF() : 1.0;
    painter->drawPixmap(rect, drawn(rect.size() * scale, mode, state));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return drawn(size, mode, state);
  }
  QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal) override {
    return drawn(size, mode, state);
  }

 private:
  QPixmap drawn(const QSize& size, QIcon::Mode mode, QIcon::State state) const {
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    QSvgRenderer symbol(path_);
    symbol.render(&painter, QRectF(QPointF(), QSizeF(size)));
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    const Colours& c = colours();
    painter.fillRect(image.rect(), mode == QIcon::Disabled ? c.off
                                   : state == QIcon::On    ? c.accent
                                                           : c.text);
    return QPixmap::fromImage(image);
  }
  QString path_;
};

}  // namespace

QString nameOf(Theme theme) {
  for (const auto& [known, name] : kNames)
    if (known == theme) return name;
  return {};
}

Theme themeOf(const QString& name) {
  for (const auto& [theme, known] : kNames)
    if (name == QLatin1String(known)) return theme;
  return Theme::Dark;
}

Theme theme() { return worn; }

const Colours& coloursOf(Theme theme) {
  if (theme == Theme::HighContrast) return kHighContrast;
  const bool light = theme == Theme::Light || (theme == Theme::System && !desktop().dark);
  return light ? kLight : kDark;
}

const Colours& colours() { return coloursOf(worn); }

QPalette paletteOf(const Colours& c) {
  QPalette palette;
  const auto set = [&](QPalette::ColorRole role, const QColor& colour, const QColor& off) {
    palette.setColor(QPalette::Active, role, colour);
    palette.setColor(QPalette::Inactive, role, colour);
    palette.setColor(QPalette::Disabled, role, off);
  };
  const auto ground = [&](QPalette::ColorRole role, const QColor& colour) {
    set(role, colour, colour);
  };
  ground(QPalette::Window, c.panel);
  ground(QPalette::Base, c.control);
  ground(QPalette::AlternateBase, c.panel);
  ground(QPalette::Button, c.control);
  ground(QPalette::ToolTipBase, c.control);
  ground(QPalette::Light, c.hover);
  ground(QPalette::Midlight, c.hover);
  ground(QPalette::Mid, c.line);
  ground(QPalette::Dark, c.edge);
  ground(QPalette::Shadow, c.ground);
  set(QPalette::WindowText, c.text, c.off);
  set(QPalette::Text, c.text, c.off);
  set(QPalette::ButtonText, c.text, c.off);
  set(QPalette::BrightText, c.text, c.off);
  set(QPalette::ToolTipText, c.text, c.off);
  set(QPalette::PlaceholderText, c.dim, c.off);
  ground(QPalette::Highlight, c.chosen);
  set(QPalette::HighlightedText, c.text, c.off);
  set(QPalette::Link, c.accent, c.off);
  set(QPalette::LinkVisited, c.accent, c.off);
  return palette;
}

void applyTheme(QApplication& application, Theme theme) {
  desktop();  // before it is changed
  initResources();
  worn = theme;
  application.setFont(font(Type::Body));
  const QPalette palette = paletteOf(colours());
  application.setPalette(palette);
  QToolTip::setPalette(palette);
  // a new one, so that every widget is told
  application.setStyle(new ControlStyle);
}

QFont font(Type type) {
  QFont made = desktop().font;
  const double body = std::max(kBody * kPointsPerPixel, made.pointSizeF());
  made.setPointSizeF(body * pixelsOf(type) / kBody);
  if (type == Type::Section || type == Type::Force) made.setWeight(QFont::DemiBold);
  if (type == Type::Section) {
    made.setCapitalization(QFont::AllUppercase);
    made.setLetterSpacing(QFont::AbsoluteSpacing, 0.6);
  }
  return tabular(made);
}

QFont tabular(const QFont& font) {
  const QFontMetricsF metrics(font);
  const double wide = metrics.horizontalAdvance('0');
  for (char digit = '1'; digit <= '9'; ++digit)
    if (std::abs(metrics.horizontalAdvance(digit) - wide) > 0.01) {
      QFont other = font;
      other.setFamily(QFontDatabase::systemFont(QFontDatabase::FixedFont).family());
      return other;
    }
  return font;
}

void setType(QLabel& label, Type type) { label.setFont(font(type)); }

void setDim(QWidget& widget) { widget.setForegroundRole(QPalette::PlaceholderText); }

void makeLines(QTableWidget& table, const QString& empty) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setTabKeyNavigation(false);
  table.setShowGrid(false);
  table.setWordWrap(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().lineSpacing() + 6);
  table.horizontalHeader()->setHighlightSections(false);
  if (empty.isEmpty()) return;
  auto* words = new QLabel(empty);
  words->setAlignment(Qt::AlignCenter);
  words->setWordWrap(true);
  setDim(*words);
  auto* over = new QVBoxLayout(table.viewport());
  over->addWidget(words);
  const auto show = [words, &table] { words->setVisible(table.rowCount() == 0); };
  QObject::connect(table.model(), &QAbstractItemModel::rowsInserted, words, show);
  QObject::connect(table.model(), &QAbstractItemModel::rowsRemoved, words, show);
}

QIcon icon(const char* name) {
  initResources();
  return QIcon(new SymbolEngine(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))));
}

}  // namespace ui::style
