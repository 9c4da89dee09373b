// SPDX-License-Identifier: BSD-3-Clause
// The list of tools: chosen by mouse and keys, read out, and drawn.
#include "ui/panels/tool_list.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QFile>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPixmap>
#include <QRadioButton>
#include <QScreen>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include "app/application.h"
#include "app/window/scan/loader.h"
#include "resources/named_tools.h"
#include "tests/support/places.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/window_support.h"
#include "ui/dialogs/unit_question.h"
#include "ui/panels/device_panel.h"
#include "ui/panels/tool_picture.h"
#include "ui/style/style.h"
#include "ui/window/main_window.h"

namespace {

using ui::ToolList;
using window::waitFor;

QList<ui::ToolEntry> namedEntries() {
  QList<ui::ToolEntry> entries;
  for (const resources::NamedTool& tool : resources::namedTools())
    entries.append({.id = QString::fromStdString(tool.name),
                    .use = QString::fromStdString(tool.use),
                    .title = QString::fromStdString(tool.title),
                    .length = tool.length,
                    .tip = tool.tip,
                    .mesh = resources::namedToolMesh(tool.name).value()});
  return entries;
}

/// The list, on the screen in a narrow panel, with the burr of 4 mm.
struct ListOnScreen {
  ToolList list;
  QListWidget* lines;
  QSignalSpy chosen{&list, &ToolList::toolChosen};

  ListOnScreen() : lines(list.findChild<QListWidget*>("toolLines")) {
    list.setTools(namedEntries());
    list.showTool("burr-4");
    window::showAndWait(list, {250, list.sizeHint().height()});
  }
  bool isOpen() const { return lines->isVisible(); }
  QListWidgetItem* line(const QString& title) const {
    const auto found = lines->findItems(title, Qt::MatchExactly);
    if (found.size() != 1) throw std::logic_error(title.toStdString());
    return found.front();
  }
  void click(const QString& title) {
    lines->scrollToItem(line(title));
    QTest::mouseClick(lines->viewport(), Qt::LeftButton, {},
                      lines->visualItemRect(line(title)).center());
  }
  QStringList ids() const {
    QStringList ids;
    for (const QList<QVariant>& emitted : chosen) ids << emitted.front().toString();
    return ids;
  }
};

TEST(ToolList, IsChosenFromByMouse) {
  ListOnScreen shown;
  EXPECT_FALSE(shown.isOpen());
  QTest::mouseClick(&shown.list, Qt::LeftButton);
  ASSERT_TRUE(shown.isOpen());
  shown.click("Probing");  // the title of a group
  EXPECT_TRUE(shown.isOpen());
  shown.click("Hook");
  EXPECT_FALSE(shown.isOpen());
  EXPECT_EQ(shown.ids(), QStringList{"hook"});
  // what is shown is what is there, and not what is wished
  EXPECT_TRUE(shown.list.accessibleDescription().startsWith("Burr, 4 mm"));
  shown.list.showTool("hook");
  EXPECT_TRUE(shown.list.accessibleDescription().startsWith("Hook"));
  EXPECT_EQ(shown.chosen.count(), 1);

  QSignalSpy file(&shown.list, &ToolList::fileWanted);
  QTest::mouseClick(&shown.list, Qt::LeftButton);
  shown.click("From a file…");
  EXPECT_EQ(file.count(), 1);
  EXPECT_EQ(shown.chosen.count(), 1);
}

TEST(ToolList, IsChosenFromByKeys) {
  ListOnScreen shown;
  for (const int key : {Qt::Key_Down, Qt::Key_Return, Qt::Key_Space}) {
    QTest::keyClick(&shown.list, static_cast<Qt::Key>(key));
    ASSERT_TRUE(shown.isOpen()) << key;
    EXPECT_EQ(shown.lines->currentItem()->text(), "Burr, 4 mm");
    QTest::keyClick(shown.lines, Qt::Key_Escape);
    EXPECT_FALSE(shown.isOpen());
  }
  EXPECT_EQ(shown.chosen.count(), 0);
  // down past the end of a group: its title is no line to stop at
  QTest::keyClick(&shown.list, Qt::Key_Down);
  QStringList passed;
  for (int k = 0; k < 3; ++k) {
    QTest::keyClick(shown.lines, Qt::Key_Down);
    passed << shown.lines->currentItem()->text();
  }
  EXPECT_EQ(passed, (QStringList{"Burr, 6 mm", "Hand drill", "Straight probe"}));
  QTest::keyClicks(shown.lines, "cu");
  EXPECT_EQ(shown.lines->currentItem()->text(), "Curved probe");
  QTest::keyClick(shown.lines, Qt::Key_Return);
  EXPECT_FALSE(shown.isOpen());
  EXPECT_EQ(shown.ids(), QStringList{"curved-probe"});
  // a letter or the wheel on the closed button loads nothing
  QTest::keyClick(&shown.list, Qt::Key_N);
  QWheelEvent wheel(QPointF(9, 9), shown.list.mapToGlobal(QPointF(9, 9)), {}, {0, -120}, {}, {},
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&shown.list, &wheel);
  EXPECT_EQ(shown.chosen.count(), 1);
}

TEST(ToolList, IsReadOutLineByLine) {
  ListOnScreen shown;
  EXPECT_EQ(shown.list.accessibleDescription(), "Burr, 4 mm, length 145 mm · tip 4 mm");
  QTest::mouseClick(&shown.list, Qt::LeftButton);
  QAccessibleInterface* lines = QAccessible::queryAccessibleInterface(shown.lines);
  ASSERT_NE(lines, nullptr);
  ASSERT_EQ(lines->childCount(), 3 + 15 + 1);  // groups, tools, the file
  QStringList names, present;
  for (int k = 0; k < lines->childCount(); ++k) {
    const QAccessibleInterface* line = lines->child(k);
    names << line->text(QAccessible::Name);
    if (line->text(QAccessible::Description).contains("present")) present << names.back();
  }
  EXPECT_EQ(names[0], "Drilling");
  EXPECT_EQ(names[1], "Burr, 1 mm, length 145 mm · tip 1 mm");
  EXPECT_TRUE(names.contains("Needle, length 100 mm · tip 0.3 mm"))
      << names.join('\n').toStdString();
  EXPECT_TRUE(names.contains("Curved probe, length 150 mm · tip 1.5 mm"));
  EXPECT_EQ(names.back(), "Tool from a file");
  EXPECT_EQ(present, QStringList{"Burr, 4 mm, length 145 mm · tip 4 mm"});
}

TEST(ToolList, FitsANarrowPanelAndIsDrawnInThePalettesColours) {
  ListOnScreen shown;
  const auto wear = [&](QColor ground, QColor ink) {
    QPalette palette;
    for (const auto role : {QPalette::Button, QPalette::Base, QPalette::Window})
      palette.setColor(role, ground);
    for (const auto role : {QPalette::ButtonText, QPalette::Text, QPalette::WindowText})
      palette.setColor(role, ink);
    shown.list.setPalette(palette);
  };
  EXPECT_LE(shown.list.sizeHint().width(), 268);
  EXPECT_LE(shown.list.sizeHint().height(), 56);
  EXPECT_LE(shown.list.minimumSizeHint().width(), 180);
  wear(QColor(0xff, 0xff, 0xff), QColor(0x1b, 0x1f, 0x27));
  const QImage light = window::pictureOf(shown.list);
  window::keep(shown.list.grab().toImage(), "tool-button");
  QTest::mouseClick(&shown.list, Qt::LeftButton);
  QWidget* popup = shown.lines->window();
  EXPECT_LE(popup->width(), 300);
  EXPECT_LE(popup->height(), 0.8 * shown.list.screen()->availableGeometry().height());
  EXPECT_TRUE(shown.list.screen()->availableGeometry().contains(popup->geometry()));
  EXPECT_FALSE(shown.lines->horizontalScrollBar()->isVisible());
  window::keep(popup->grab().toImage(), "tool-list");
  // the tick stands at the present tool alone
  const auto right = [&](const QString& title) {
    QRect rect = shown.lines->visualItemRect(shown.line(title));
    rect.setLeft(rect.right() - 24);
    return rect;
  };
  shown.lines->setCurrentItem(shown.line("Hook"));
  const QImage lines = window::pictureOf(*shown.lines->viewport());
  const auto ink = [&](const QString& title) {
    const QImage part = lines.copy(right(title));
    const QColor ground = part.pixelColor(0, 0);
    return window::count(part, [&](QColor c) { return c != ground; });
  };
  EXPECT_GT(ink("Burr, 4 mm"), 15);
  EXPECT_EQ(ink("Burr, 2 mm"), 0);
  QTest::keyClick(shown.lines, Qt::Key_Escape);
  // a file with a long name makes neither wide
  shown.list.showOther({.id = "/a", .use = "From a file", .title = QString(200, 'w') + ".stl"});
  EXPECT_LE(shown.list.sizeHint().width(), 268);
  QTest::mouseClick(&shown.list, Qt::LeftButton);
  EXPECT_LE(popup->width(), 400);
  QTest::keyClick(shown.lines, Qt::Key_Escape);
  shown.list.showTool("burr-4");

  wear(QColor(0x17, 0x1a, 0x20), QColor(0xe6, 0xe9, 0xee));
  const QImage in_dark = window::pictureOf(shown.list);
  window::keep(shown.list.grab().toImage(), "tool-button-dark");
  QTest::mouseClick(&shown.list, Qt::LeftButton);
  window::keep(popup->grab().toImage(), "tool-list-dark");
  const auto bright = [](QColor c) { return c.lightness() > 180; };
  // the ground is the theme's; words and picture have the palette's ink
  EXPECT_LT(window::count(light, bright), window::count(in_dark, bright) / 4);
  EXPECT_GT(window::count(in_dark, bright), 150);
}

/// Of a picture's alpha: how far ink reaches up and down in a column, in pixels of the widget.
double inkAcross(const QImage& image, double x) {
  double sum = 0.0;
  const int column = static_cast<int>(x * image.devicePixelRatio());
  for (int y = 0; y < image.height(); ++y) sum += image.pixelColor(column, y).alphaF() > 0.15F;
  return sum / image.devicePixelRatio();
}

TEST(ToolList, HasPicturesThatShowSizeAndShape) {
  constexpr QSize kSize{84, 30};
  std::map<std::string, QImage> pictures;
  for (const resources::NamedTool& tool : resources::namedTools()) {
    SCOPED_TRACE(tool.name);
    const ui::ToolPicture picture(resources::namedToolMesh(tool.name).value());
    for (const double ratio : {1.0, 2.0}) {
      const QImage image = picture.pixmap(kSize, ratio, Qt::black).toImage();
      ASSERT_EQ(image.size(), kSize * ratio);
      int clear = 0, part = 0, ink = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
          const int alpha = image.pixelColor(x, y).alpha();
          clear += alpha == 0;
          part += alpha > 0 && alpha < 80;
          ink += alpha >= 80;
        }
      EXPECT_GT(ink, 50 * ratio);
      EXPECT_GT(part, 5 * ratio);  // smooth edges
      EXPECT_GT(clear, 0.06 * kSize.width() * kSize.height() * ratio * ratio);
      pictures[tool.name] = image;
    }
  }
  // the tip is at the right, and burrs of more millimetres are larger
  for (const int mm : {2, 4, 6}) {
    const QImage& burr = pictures["burr-" + std::to_string(mm)];
    double across = 0.0;
    for (int x = 82 - 2 * mm; x < 82; ++x) across = std::max(across, inkAcross(burr, x));
    EXPECT_NEAR(across, 1.9 * mm + 1.8, 1.0) << mm;  // with the line around it
    EXPECT_GT(inkAcross(burr, 80.5), 0.0);
    // the handle fades
    EXPECT_EQ(inkAcross(burr, 0.5), 0.0);
  }
  // the hook reaches down, towards +x
  const QImage& hook = pictures["hook"];
  double above = 0.0, below = 0.0;
  for (int y = 0; y < 30; ++y) (y < 15 ? above : below) += hook.pixelColor(2 * 80, 2 * y).alphaF();
  EXPECT_GT(below, above);

  // it is drawn once for each size and colour
  const ui::ToolPicture picture(resources::namedToolMesh("hook").value());
  const QPixmap once = picture.pixmap(kSize, 1.0, Qt::black);
  EXPECT_EQ(picture.pixmap(kSize, 1.0, Qt::black).cacheKey(), once.cacheKey());
  EXPECT_NE(picture.pixmap(kSize, 1.0, Qt::white).cacheKey(), once.cacheKey());
}

/// Counts the paints of every widget.
class ToolPaints : public QObject {
 public:
  ToolPaints() { qApp->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::Paint;
    return false;
  }
  int count = 0;
};

TEST(ToolList, IsPaintedOnlyWhenItChanges) {
  ListOnScreen shown;
  QTest::qWait(200);
  ToolPaints paints;
  shown.list.showTool("burr-4");
  QTest::qWait(200);
  EXPECT_EQ(paints.count, 0);
  shown.list.showTool("cane");
  EXPECT_TRUE(waitFor([&] { return paints.count > 0; }));
}

TEST(ToolList, ChangesTheToolThatTouches) {
  app::Application application(window::sphereInHand("tap"));
  application.start();
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene != 0; }));
  auto& list = window::panelOf<ToolList>(application.window());
  auto* lines = list.findChild<QListWidget*>("toolLines");
  const auto begins = [&](const char* title) {
    return list.accessibleDescription().startsWith(QString(title) + ", ");
  };
  const auto scene = application.snapshot().scene;
  QTest::keyClick(&list, Qt::Key_Down);
  QTest::keyClicks(lines, "burr");
  QTest::keyClick(lines, Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene > scene; }));
  EXPECT_EQ(application.shown()->tool.name, "burr-1");
  EXPECT_EQ(application.shown()->scene->tool.mesh.vertices.size(),
            resources::namedToolMesh("burr-1")->vertices.size());
  EXPECT_TRUE(begins("Burr, 1 mm")) << list.accessibleDescription().toStdString();

  // one from a file stands in the list while it is in the hand, and can be chosen there again
  const QTemporaryDir folder;
  const QString path = folder.filePath("mine.obj");
  ASSERT_TRUE(QFile::copy(QString::fromStdString(places::source("resources/tools/peg.obj")), path));
  const int named = lines->count();
  emit window::panelOf<ui::DevicePanel>(application.window()).toolFileChosen(path, "m");
  ASSERT_TRUE(waitFor([&] { return application.shown()->tool.file.has_value(); }));
  EXPECT_EQ(list.accessibleDescription(), "mine.obj, length 50 mm");
  EXPECT_EQ(lines->count(), named + 2);
  ASSERT_TRUE(
      waitFor([&] { return application.snapshot().scene == application.shown()->scene->id; }));
  const auto with_file = application.snapshot().scene;
  QTest::keyClick(&list, Qt::Key_Down);
  EXPECT_EQ(lines->currentItem()->text(), "mine.obj");
  QTest::keyClick(lines, Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return application.snapshot().scene > with_file; }));
  EXPECT_EQ(application.shown()->tool.file, std::filesystem::path(path.toStdString()));
  // a file that is found is asked about: its box beside a hand in each unit
  const auto before_asked = application.shown()->scene;
  bool asked = false;
  QTimer answers;
  QObject::connect(&answers, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<ui::UnitDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    answers.stop();
    asked = true;
    window::keep(dialog->grab().toImage(), "tool-unit");
    EXPECT_EQ(dialog->unit(), "m");  // the peg is 50 mm long, and its file in metres
    EXPECT_TRUE(dialog->findChild<QLabel*>("size_m")->text().startsWith("50 mm long"));
    EXPECT_TRUE(dialog->findChild<QLabel*>("size_in")->text().startsWith("1.27 mm long"));
    dialog->findChild<QRadioButton*>("unit_cm")->click();
    dialog->reject();
  });
  answers.start(50);
  emit window::panelOf<ui::DevicePanel>(application.window()).toolFileFound(path);
  ASSERT_TRUE(waitFor([&] { return asked; }));
  QTest::qWait(100);
  EXPECT_EQ(application.shown()->scene, before_asked);
  emit window::panelOf<ui::DevicePanel>(application.window()).toolChosen("hook");
  ASSERT_TRUE(waitFor([&] { return application.shown()->tool.name == "hook"; }));
  EXPECT_TRUE(begins("Hook"));
  EXPECT_EQ(lines->count(), named);
  window::keep(application.window().grab().toImage(), "tool-window");
}

TEST(ToolList, TheUnitThatIsLikelyIsOfferedAndEachHasItsSizeBesideAHand) {
  using Sides = std::array<double, 3>;
  EXPECT_EQ(ui::likelyUnit(Sides{12.0, 160.0, 9.0}), "mm");
  EXPECT_EQ(ui::likelyUnit(Sides{0.012, 0.16, 0.009}), "m");
  EXPECT_EQ(ui::likelyUnit(Sides{1.2, 6.0, 0.9}), "cm");
  EXPECT_EQ(ui::likelyUnit(Sides{0.0, 0.0, 0.0}), "mm");
  // where several would do, in this order: mm, m, cm, in
  EXPECT_EQ(ui::likelyUnit(Sides{3.0, 30.0, 2.0}), "mm");
  EXPECT_EQ(ui::likelyUnit(Sides{1.0, 15.0, 1.0}), "mm");
  EXPECT_EQ(ui::likelyUnit(Sides{0.1, 0.45, 0.1}), "m");
  EXPECT_EQ(ui::likelyUnit(Sides{1.0, 5.0, 1.0}), "cm");
  const QRectF hand = ui::handOutline().boundingRect();
  EXPECT_NEAR(hand.height(), ui::kHandLength, 0.5);
  EXPECT_NEAR(hand.bottom(), 0.0, 0.5);
  EXPECT_GT(hand.width(), 80.0);
  EXPECT_LT(hand.width(), 140.0);

  ui::UnitDialog dialog("burr & handle.stl", Sides{12.0, 160.0, 9.0});
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog, 120'000));
  window::keep(dialog.grab().toImage(), "unit-question");
  EXPECT_EQ(dialog.unit(), "mm");
  const auto size = [&](const char* name) {
    return dialog.findChild<QLabel*>(name)->text().toStdString();
  };
  EXPECT_EQ(size("size_mm"), "160 mm long,\n12 mm by 9 mm");
  EXPECT_EQ(size("size_cm"), "1.6 m long,\n120 mm by 90 mm");
  EXPECT_EQ(size("size_m"), "160 m long,\n12 m by 9 m");
  EXPECT_EQ(size("size_in"), "4.06 m long,\n305 mm by 229 mm");
  // the picture chooses too, and shows the tool and the hand to one scale
  const auto picture = [&](int column) {
    auto* grid = dialog.findChild<QGridLayout*>();
    return grid->itemAtPosition(0, column)->widget();
  };
  const auto heightOf = [&](int column, const QColor& colour) {
    const QImage image = window::pictureOf(*picture(column));
    int top = image.height(), foot = -1;
    for (int y = 4; y < image.height() - 4; ++y)
      for (int x = 4; x < image.width() - 4; ++x)
        if (image.pixelColor(x, y).rgb() == colour.rgb()) {
          top = std::min(top, y);
          foot = std::max(foot, y);
        }
    return foot - top + 1;
  };
  const double tool = heightOf(0, ui::style::colours().solid);
  const double high = heightOf(0, ui::style::colours().dim);
  EXPECT_NEAR(tool / high, 160.0 / 180.0, 0.05);
  EXPECT_GT(heightOf(1, ui::style::colours().solid), 4 * heightOf(1, ui::style::colours().dim));
  QTest::mouseClick(picture(3), Qt::LeftButton);
  EXPECT_EQ(dialog.unit(), "in");
}

}  // namespace
