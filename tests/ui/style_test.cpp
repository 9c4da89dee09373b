// SPDX-License-Identifier: BSD-3-Clause
// The look of the window: what can be read, and what stays where it is.
#include "ui/style/style.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFontMetricsF>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cmath>
#include <string>
#include <vector>

#include "tests/ui/window_support.h"
#include "ui/style/scene_colours.h"

namespace {

using ui::style::Colours;
using ui::style::Theme;
using ui::style::Type;

double luminanceOf(const QColor& colour) {
  const auto linear = [](double part) {
    return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}

/// As WCAG computes it: 1 to 21.
double contrastOf(const QColor& a, const QColor& b) {
  const double x = luminanceOf(a), y = luminanceOf(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

struct Pair {
  const char* name;
  QColor front, ground;
};

// where each is written or drawn on what
std::vector<Pair> wordsOf(const Colours& c) {
  return {
      {"text on the panel", c.text, c.panel},
      {"text on a control", c.text, c.control},
      {"text on a control under the pointer", c.text, c.hover},
      {"text on a control that is on", c.text, c.chosen},
      {"text on the rail", c.text, c.ground},
      {"text on a notice", c.text, c.attention_ground},
      {"text on a fault", c.text, c.fault_ground},
      {"dim on the panel", c.dim, c.panel},
      {"dim on a control", c.dim, c.control},
      {"dim on the rail", c.dim, c.ground},
      {"dim under the pointer", c.dim, c.hover},
      {"links", c.accent, c.panel},
      {"dim on what is chosen", c.dim, c.chosen},
      {"stop on the bar", c.stop_words, c.panel},
      {"stop under the pointer, without a force", c.stop_words, c.hover},
      {"stop, filled", c.on_stop, c.stop_fill},
      {"the force", c.text, c.panel},
      {"torque in the card", ui::style::kDark.dim, ui::style::kDark.panel},
      {"readouts of a slice", ui::style::kReadout, ui::style::kSliceGround},
      {"hints below a view", ui::style::kViewDim, ui::style::kViewGround},
      {"axial", ui::style::kAxial, ui::style::kSliceGround},
      {"coronal", ui::style::kCoronal, ui::style::kSliceGround},
      {"sagittal", ui::style::kSagittal, ui::style::kSliceGround},
      {"with the tool", ui::style::kOblique, ui::style::kSliceGround},
      {"left/right unknown", ui::style::kViewAttention, ui::style::kSliceGround},
      {"sides of the patient", ui::style::kLetter, ui::style::kViewGround},
  };
}

std::vector<Pair> marksOf(const Colours& c) {
  return {
      {"edge of a field", c.edge, c.panel},
      {"edge of a field in a list", c.edge, c.control},
      {"the accent on the panel", c.accent, c.panel},
      {"the accent on a control", c.accent, c.control},
      {"the accent on a control that is on", c.accent, c.chosen},
      {"the accent on the rail", c.accent, c.ground},
      {"force on", c.on, c.control},
      {"what was written, on its bar", c.on, c.panel},
      {"attention on a chip", c.attention, c.control},
      {"attention on a notice", c.attention, c.attention_ground},
      {"fault on a chip", c.stop_words, c.control},
      {"fault on its bar", c.stop_words, c.fault_ground},
      {"outline of the stop button", c.stop, c.panel},
      {"solid in the histogram", c.solid, c.control},
      {"curve of the force", c.force, c.control},
      {"a note on the timeline", c.note, c.control},
      {"a setting on the timeline", c.setting, c.control},
      {"a scene on the timeline", c.scene, c.control},
      {"a loss on the timeline", c.stop, c.control},
      {"the tick of a check box", c.on_accent, c.accent},
      {"what cannot be used now, on the panel", c.off, c.panel},
      {"focus of a view's button", ui::style::kViewFocus, ui::style::kViewGround},
  };
}

TEST(Style, EveryWordAndMarkOfEveryThemeStandsOutFromItsGround) {
  EXPECT_NEAR(contrastOf(Qt::white, Qt::black), 21.0, 1e-9);
  for (const Theme theme : {Theme::Dark, Theme::Light, Theme::HighContrast}) {
    const std::string name = ui::style::nameOf(theme).toStdString();
    const Colours& c = ui::style::coloursOf(theme);
    for (const Pair& pair : wordsOf(c))
      EXPECT_GE(contrastOf(pair.front, pair.ground), 4.5) << name << ": " << pair.name;
    for (const Pair& pair : marksOf(c))
      EXPECT_GE(contrastOf(pair.front, pair.ground), 3.0) << name << ": " << pair.name;
  }
  for (const Pair& pair : wordsOf(ui::style::kHighContrast))
    if (std::string(pair.name).starts_with("text")) {
      EXPECT_GE(contrastOf(pair.front, pair.ground), 7.0) << pair.name;
    }
}

TEST(Style, DigitsAreOfOneWidthInEverySize) {
  for (const Type type : {Type::Small, Type::Body, Type::Section, Type::Figure, Type::Force}) {
    const QFontMetricsF metrics(ui::style::font(type));
    for (char digit = '1'; digit <= '9'; ++digit)
      EXPECT_NEAR(metrics.horizontalAdvance(digit), metrics.horizontalAdvance('0'), 0.01)
          << int(type) << ", " << digit;
  }
  EXPECT_GT(ui::style::font(Type::Force).pointSizeF(),
            2.0 * ui::style::font(Type::Body).pointSizeF());
  EXPECT_LT(ui::style::font(Type::Small).pointSizeF(), ui::style::font(Type::Body).pointSizeF());
}

TEST(Style, ThemesHaveNamesAndAnUnknownOneIsDark) {
  for (const Theme theme : {Theme::System, Theme::Dark, Theme::Light, Theme::HighContrast})
    EXPECT_EQ(ui::style::themeOf(ui::style::nameOf(theme)), theme);
  EXPECT_EQ(ui::style::themeOf("mauve"), Theme::Dark);
  EXPECT_EQ(ui::style::themeOf({}), Theme::Dark);
}

TEST(Style, SymbolsAreDrawnInTheThemesColourAndCanBeToldApartAt16Pixels) {
  const QDir folder(":/icons");
  QStringList names = folder.entryList({"*.svg"});
  names.removeAll("palpate.svg");
  ASSERT_GE(names.size(), 10);
  std::vector<QImage> drawn;
  QImage sheet(40 * int(names.size()), 40, QImage::Format_RGB32);
  sheet.fill(ui::style::kDark.panel);
  QPainter painter(&sheet);
  for (int n = 0; n < names.size(); ++n) {
    const QString name = names[n].chopped(4);
    const QIcon icon = ui::style::icon(name.toUtf8());
    const QImage image = icon.pixmap(QSize(16, 16), 1.0).toImage();
    int ink = 0;
    QImage shape(16, 16, QImage::Format_RGB32);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const QColor c = image.pixelColor(x, y);
        ink += c.alpha() > 128;
        shape.setPixel(x, y, c.alpha() > 100 ? 0xffffffff : 0xff000000);
        if (c.alpha() == 255) {
          EXPECT_EQ(c.rgb(), ui::style::kDark.text.rgb()) << name.toStdString();
        }
      }
    EXPECT_GT(ink, 12) << name.toStdString();
    EXPECT_LT(ink, 170) << name.toStdString();
    for (const QImage& other : drawn)
      EXPECT_GT(window::differing(shape, other), 0.08) << name.toStdString();
    drawn.push_back(shape);
    painter.drawPixmap(40 * n + 12, 12, icon.pixmap(QSize(16, 16), 1.0));
    // on: the accent
    const QImage on = icon.pixmap(QSize(32, 32), QIcon::Normal, QIcon::On).toImage();
    EXPECT_GT(window::count(on.convertToFormat(QImage::Format_ARGB32),
                            [](QColor c) {
                              return c.alpha() == 255 && c.rgb() == ui::style::kDark.accent.rgb();
                            }),
              10)
        << name.toStdString();
  }
  painter.end();
  window::keep(sheet, "style_symbols");
}

TEST(Style, TheWheelChangesNoFieldWithoutTheFocusAndNoClosedBox) {
  QWidget panel;
  auto* number = new QDoubleSpinBox;
  auto* slider = new QSlider(Qt::Horizontal);
  auto* box = new QComboBox;
  box->addItems({"Mouse", "Slide", "Tap"});
  auto* first = new QPushButton("First");
  auto* column = new QVBoxLayout(&panel);
  for (QWidget* part : std::initializer_list<QWidget*>{first, number, slider, box})
    column->addWidget(part);
  number->setValue(50.0);
  slider->setValue(50);
  box->setCurrentIndex(1);
  panel.show();
  first->setFocus();
  const auto turn = [](QWidget& widget) {
    const QPointF at = widget.rect().center();
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &event);
    return event.isAccepted();
  };
  for (QWidget* part : std::initializer_list<QWidget*>{number, slider, box}) {
    EXPECT_FALSE(turn(*part)) << part->metaObject()->className();
    EXPECT_FALSE(part->focusPolicy() == Qt::WheelFocus);
  }
  EXPECT_EQ(number->value(), 50.0);
  EXPECT_EQ(slider->value(), 50);
  EXPECT_EQ(box->currentIndex(), 1);
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel, 120'000));
  number->setFocus();
  EXPECT_TRUE(turn(*number));
  EXPECT_EQ(number->value(), 49.0);
  box->setFocus();
  turn(*box);
  EXPECT_EQ(box->currentIndex(), 1);
}

TEST(Style, AListWithoutLinesSaysSo) {
  QTableWidget list;
  ui::style::makeLines(list, "Nothing yet");
  list.setColumnCount(1);
  list.show();
  auto* words = list.findChild<QLabel*>();
  ASSERT_NE(words, nullptr);
  EXPECT_EQ(words->text(), "Nothing yet");
  EXPECT_TRUE(words->isVisible());
  list.setRowCount(2);
  EXPECT_FALSE(words->isVisible());
  list.setRowCount(0);
  EXPECT_TRUE(words->isVisible());
}

TEST(Style, ATextThatIsSmallerThanTheDesktopsIsNotForced) {
  EXPECT_GE(ui::style::font(Type::Body).pointSizeF(), 9.75 - 1e-9);
  QLabel words("x");
  ui::style::setType(words, Type::Figure);
  EXPECT_NEAR(words.font().pointSizeF() / ui::style::font(Type::Body).pointSizeF(),
              double(ui::style::kFigure) / ui::style::kBody, 1e-6);
}

}  // namespace
