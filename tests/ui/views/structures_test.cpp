// SPDX-License-Identifier: BSD-3-Clause
// Structures of a scan, from their file to the pixels: a made scan that is stored mirrored, and a
// segmentation on a grid of its own. Places are in the patient's W.
#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkCellLocator.h>
#include <vtkFeatureEdges.h>
#include <vtkIdList.h>
#include <vtkOBBTree.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <functional>
#include <memory>

#include "app/application.h"
#include "app/window/scan/loader.h"
#include "app/window/structures/structures_controller.h"
#include "app/window/views/marks_controller.h"
#include "tests/ui/views/sphere_in_hand.h"
#include "tests/ui/views/structures_window.h"
#include "tests/ui/window_support.h"
#include "ui/controls/number_box.h"
#include "ui/props/structure_shape.h"
#include "ui/views/slice_readout.h"
#include "ui/window/main_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/view_frame.h"
#include "ui/window/views.h"

namespace {

using namespace structures;

bool near(QColor c, QColor wanted) {
  return std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) +
             std::abs(c.blue() - wanted.blue()) <
         12;
}
bool isNerve(QColor c) { return near(c, Qt::magenta); }
/// Lit, and behind the breath of a colour between outlines.
bool isNerveInSpace(QColor c) {
  return c.red() > 70 && c.blue() > 70 && c.green() < 0.6 * c.red() && c.green() < 0.6 * c.blue();
}
bool isCanalInSpace(QColor c) {
  return c.green() > 100 && c.red() < 0.4 * c.green() && c.blue() < 0.4 * c.green();
}

class Structures : public StructuresWindow {
 protected:
  /// The place of a structure is where its colour is seen.
  void expectIn(ui::SliceView& view, const Eigen::Vector3d& p_mm) {
    const QImage picture = window::pictureOf(view);
    const QPointF seen = window::centroid(picture, isNerve);
    const QPointF place = view.projected(p_mm);
    EXPECT_NEAR(seen.x(), place.x(), 2.5) << view.readout().name.toStdString();
    EXPECT_NEAR(seen.y(), place.y(), 2.5) << view.readout().name.toStdString();
  }
  /// Answers the next question by a word on one of its buttons.
  void answerNext(const QString& word) {
    auto* timer = new QTimer(&window());
    QObject::connect(timer, &QTimer::timeout, timer, [timer, word] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      timer->stop();
      for (QAbstractButton* button : box->buttons())
        if (button->text().remove('&').contains(word)) return button->click();
      ADD_FAILURE() << word.toStdString();
      box->reject();
    });
    timer->start(10);
  }
  QImage lookFrom(ui::Side side) {
    views().volume().lookFrom(side);
    return window::pictureAtRest(views().volume());
  }
};

TEST_F(Structures, AreDrawnInSlicesWhereTheyAreAndLeftStaysLeft) {
  start();
  views().slices().setObliqueShown(true);
  views().setCross(kNerve);
  for (const Plane plane : {Plane::Axial, Plane::Coronal, Plane::Sagittal})
    expectIn(views().slice(plane), kNerve);
  // by the radiological convention
  ui::SliceView& axial = views().slice(Plane::Axial);
  const QImage picture = window::pictureOf(axial);
  window::keep(picture, "structures_axial");
  EXPECT_GT(window::centroid(picture, isNerve).x(), axial.projected(Vec3::Zero()).x());
  EXPECT_LT(window::centroid(picture, isNerve).y(), axial.projected(Vec3::Zero()).y());
  // oblique, and turned about all axes
  ui::SliceView& oblique = views().slice(Plane::Oblique);
  const haptics::Mat3 turn =
      (Eigen::AngleAxisd(0.5, Vec3::UnitX()) * Eigen::AngleAxisd(0.9, Vec3::UnitZ())).matrix();
  oblique.setPlane({turn.col(0), turn.col(1), turn.col(2)}, kNerve, "tilted", {});
  expectIn(oblique, kNerve);

  // outlines leave the anatomy between them, fills cover it
  const auto middleOf = [&](ui::SliceView& view) {
    return window::pictureOf(view).pixelColor(view.projected(kCanal).toPoint());
  };
  views().setCross(kCanal);
  EXPECT_LT(std::abs(middleOf(axial).red() - middleOf(axial).green()), 12);
  part<QCheckBox>("structuresFilled").click();
  EXPECT_GT(middleOf(axial).green(), middleOf(axial).red() + 40);
  window::keep(window::pictureOf(window()), "structures_window");
}

TEST_F(Structures, AreDrawnInSpaceWhereTheyAreAndThroughTheBone) {
  for (const auto mode : {ui::SurfaceMode::Mesh, ui::SurfaceMode::RayCast}) {
    mode_ = mode;
    start();
    ui::VolumeView& view = views().volume();
    QImage picture = lookFrom(ui::Side::Anterior);
    const char* const name =
        mode == ui::SurfaceMode::Mesh ? "structures_space_mesh" : "structures_space_ray_cast";
    window::keep(picture, name);
    const auto expectAt = [&](const std::function<bool(QColor)>& colour, const Eigen::Vector3d& p) {
      const QPointF seen = window::centroid(picture, colour, 20);
      const QPointF place = view.projected(p / ui::kMmPerM);
      EXPECT_NEAR(seen.x(), place.x(), 4.0) << name;
      EXPECT_NEAR(seen.y(), place.y(), 4.0) << name;
    };
    expectAt(isNerveInSpace, kNerve);
    EXPECT_GT(window::centroid(picture, isNerveInSpace).x(), picture.width() / 2);
    expectAt(isCanalInSpace, kCanal);  // within the bone: its outline
    part<QCheckBox>("structuresThrough").click();
    picture = window::pictureAtRest(view);
    EXPECT_EQ(window::count(picture, isCanalInSpace), 0) << name;
    expectAt(isNerveInSpace, kNerve);
    // bone is before it from the other side
    picture = lookFrom(ui::Side::Right);
    EXPECT_EQ(window::count(picture, isNerveInSpace), 0) << name;

    // opaque it covers its disc, half of that at half the opacity
    picture = lookFrom(ui::Side::Left);
    const int whole = window::count(picture, isNerveInSpace);
    list().selectRow(0);
    part<ui::NumberBox>("structureOpacity").setValue(50.0);
    const int half = window::count(window::pictureAtRest(view), isNerveInSpace);
    EXPECT_GT(whole, 200);
    EXPECT_NEAR(half, whole / 2, whole / 6) << name;
    // and the picture of the view, larger, has it too
    EXPECT_GT(window::count(view.picture(2.0), isNerveInSpace), 3 * half);
    application_.reset();
  }
}

TEST_F(Structures, AreListedSearchedShownAloneAndRenamed) {
  start();
  ASSERT_EQ(list().rowCount(), 3);
  constexpr int kName = 2, kShown = 0;
  EXPECT_EQ(list().item(0, kName)->text(), kSecret);
  EXPECT_EQ(list().item(1, kName)->text(), "Canal <b>x</b>");
  EXPECT_EQ(list().item(2, kName)->text(), "Structure 3");
  // what is chosen is named with its number, and stays in sight
  const auto title = [&] { return part<QLabel>("structureTitle").text(); };
  EXPECT_EQ(title(), "");
  list().selectRow(2);
  EXPECT_EQ(title(), "Structure 3");
  EXPECT_TRUE(list().item(1, kName)->toolTip().contains("Structure 2: Canal &lt;b&gt;x"))
      << list().item(1, kName)->toolTip().toStdString();
  part<QLineEdit>("structureSearch").setText("canal");
  EXPECT_EQ(title(), "Structure 2: Canal <b>x</b>");
  EXPECT_TRUE(list().isRowHidden(0) && !list().isRowHidden(1) && list().isRowHidden(2));
  part<QLineEdit>("structureSearch").clear();
  EXPECT_FALSE(list().isRowHidden(0));

  views().setCross(kNerve);
  ui::SliceView& axial = views().slice(Plane::Axial);
  const auto nerves = [&] { return window::count(window::pictureOf(axial), isNerve); };
  window::afterTicks(*application_, 50);  // the window is laid out
  const int at_first = nerves();
  EXPECT_GT(at_first, 20);
  list().selectRow(1);
  part<QPushButton>("structureAlone").click();
  EXPECT_EQ(nerves(), 0);
  EXPECT_EQ(list().item(0, kShown)->checkState(), Qt::Unchecked);
  EXPECT_EQ(list().item(1, kShown)->checkState(), Qt::Checked);
  // once more brings back what was shown before
  EXPECT_TRUE(part<QPushButton>("structureAlone").isChecked());
  part<QPushButton>("structureAlone").click();
  EXPECT_NEAR(nerves(), at_first, 8);
  EXPECT_FALSE(part<QPushButton>("structureAlone").isChecked());
  list().item(2, kShown)->setCheckState(Qt::Unchecked);
  for (int click = 0; click < 2; ++click) part<QPushButton>("structureAlone").click();
  EXPECT_EQ(list().item(0, kShown)->checkState(), Qt::Checked);
  EXPECT_EQ(list().item(2, kShown)->checkState(), Qt::Unchecked);
  part<QPushButton>("structureAlone").click();
  part<QPushButton>("structuresOn").click();
  EXPECT_NEAR(nerves(), at_first, 8);
  part<QPushButton>("structuresOff").click();
  EXPECT_EQ(nerves(), 0);
  list().item(0, kShown)->setCheckState(Qt::Checked);
  EXPECT_NEAR(nerves(), at_first, 8);
  list().selectRow(0);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Space);
  EXPECT_EQ(nerves(), 0);
  EXPECT_EQ(list().item(0, kShown)->checkState(), Qt::Unchecked);
  QTest::keyClick(&list(), Qt::Key_Space);
  EXPECT_NEAR(nerves(), at_first, 8);

  // another colour, in slices and in 3-D
  QTimer::singleShot(0, &window(), [] {
    auto* dialog = qobject_cast<QColorDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    dialog->setCurrentColor(Qt::green);
    dialog->accept();
  });
  part<QPushButton>("structureColour").click();
  EXPECT_EQ(nerves(), 0);
  EXPECT_EQ(structures().shown().looks[0].colour, QColor(Qt::green));
  EXPECT_EQ(window::count(lookFrom(ui::Side::Anterior), isNerveInSpace), 0);

  // a name is plain text, and what no name can have is left out
  list().item(0, kName)->setText("my\n\x1b nerve");
  EXPECT_EQ(structures().shown().looks[0].name, "my  nerve");
  EXPECT_EQ(list().item(0, kName)->text(), "my  nerve");
  list().item(0, kName)->setText("  ");
  EXPECT_EQ(list().item(0, kName)->text(), "my  nerve");
}

TEST_F(Structures, ThatIsChosenIsSeen) {
  start();
  ui::VolumeView& view = views().volume();
  // seen from the right, the nerve is behind the bone
  lookFrom(ui::Side::Right);
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                    list().visualItemRect(list().item(0, 2)).center());
  EXPECT_LT((views().cross_mm() - kNerve).norm(), 1.0);
  part<QCheckBox>("structuresThrough").click();
  const QImage picture = window::pictureAtRest(view);
  window::keep(picture, "structures_gone_to");
  EXPECT_GT(window::count(picture, isNerveInSpace), 200);
  const QPointF place = view.projected(kNerve / ui::kMmPerM);
  EXPECT_NEAR(place.x(), view.width() / 2.0, 6.0);
  EXPECT_NEAR(place.y(), view.height() / 2.0, 6.0);
  // neither another cell nor a move in the list moves the camera
  const Eigen::Matrix3d look = view.viewAxes();
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Down);
  EXPECT_TRUE(list().item(1, 2)->isSelected());
  part<ui::NumberBox>("structureOpacity").setValue(50.0);
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                    list().visualItemRect(list().item(2, 5)).center());
  EXPECT_TRUE(list().item(2, 2)->isSelected());
  EXPECT_EQ(view.viewAxes(), look);
  EXPECT_LT((views().cross_mm() - kNerve).norm(), 1.0);
  // by the key, too: the one at the back
  list().selectRow(2);
  QTest::keyClick(&list(), Qt::Key_Return);
  EXPECT_LT((views().cross_mm() - kSinus).norm(), 1.0);
  EXPECT_GT(view.viewAxes().col(2).dot(kSinus), 0.0);
}

TEST_F(Structures, AreNamedUnderThePointer) {
  start();
  views().setCross(kNerve);
  ui::SliceView& axial = views().slice(Plane::Axial);
  const auto hover = [](QWidget& view, QPointF at) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, {}, {});
    QCoreApplication::sendEvent(&view, &move);
  };
  axial.grab();
  hover(axial, axial.projected(kNerve));
  EXPECT_EQ(axial.readout().structures, kSecret);
  EXPECT_EQ(axial.readout().value, "-1000");
  const auto written = [&] {
    QString all;
    for (const ui::ReadoutText& text : axial.readoutLayout().texts) all += text.text + '\n';
    return all;
  };
  EXPECT_TRUE(written().contains("left nerve")) << written().toStdString();
  hover(axial, axial.projected(kNerve + Vec3{-8.0, 0.0, 0.0}));
  EXPECT_EQ(axial.readout().structures, "");
  // hidden ones keep their names
  part<QPushButton>("structuresOff").click();
  hover(axial, axial.projected(kNerve));
  EXPECT_EQ(axial.readout().structures, kSecret);
  part<QPushButton>("structuresOn").click();

  // in 3-D what is before the bone, or seen through it
  ui::VolumeView& view = views().volume();
  lookFrom(ui::Side::Anterior);
  QString pointed;
  QObject::connect(&view, &ui::VolumeView::pointedChanged, &view,
                   [&](const QString& words) { pointed = words; });
  hover(view, view.projected(kNerve / ui::kMmPerM));
  // value, place and name are of one point: where the structure is met
  const auto isAt = [&](const char* value, const char* name, const Eigen::Vector3d& p_mm) {
    static const QRegularExpression words(
        "^(\\S+)   LPS ([-.\\d]+), ([-.\\d]+), ([-.\\d]+) mm   (.*)$");
    const auto match = words.match(pointed);
    const Eigen::Vector3d said{match.captured(2).toDouble(), match.captured(3).toDouble(),
                               match.captured(4).toDouble()};
    return match.hasMatch() && match.captured(1) == value && match.captured(5) == name &&
           (said - p_mm).norm() < 1.2;
  };
  EXPECT_TRUE(waitFor([&] {
    return isAt("-1,000", kSecret, kNerve - Vec3{0.0, 4.0, 0.0});
  })) << pointed.toStdString();
  hover(view, view.projected(kCanal / ui::kMmPerM));
  EXPECT_TRUE(waitFor([&] {
    return isAt("1,200", "Canal <b>x</b>", kCanal - Vec3{0.0, 3.0, 0.0});
  })) << pointed.toStdString();
  EXPECT_EQ(part<QLabel>("pointed").textFormat(), Qt::PlainText);
  part<QCheckBox>("structuresThrough").click();
  hover(view, view.projected(kCanal / ui::kMmPerM) + QPointF{1.0, 0.0});
  EXPECT_TRUE(waitFor([&] { return !pointed.contains("Canal"); })) << pointed.toStdString();
}

TEST_F(Structures, HaveNamesThatAreCutWhereThereIsNoRoom) {
  for (const int width : {150, 180, 240, 320, 600}) {
    const ui::SliceReadout said{.name = "Axial",
                                .short_name = "Ax.",
                                .place = "214 / 512   z 177.2 mm",
                                .grey = "W 2000  L 500",
                                .value = "1480 HU",
                                .structures = "Canal of the facial nerve, temporal bone",
                                .position = "LPS 102.4, 113.5, 108.2 mm",
                                .letters = {"R", "L", "A", "P"}};
    const QRect widget(0, 0, width, 200), picture = ui::pictureIn(widget, false);
    const auto layout = ui::layOut(said, QApplication::font(), widget, picture, 40, 0.5);
    bool value = false, named = false;
    for (std::size_t n = 0; n < layout.texts.size(); ++n) {
      const ui::ReadoutText& text = layout.texts[n];
      value = value || text.text.startsWith("1480 HU");
      named = named || text.text.contains("Cana");
      EXPECT_TRUE(widget.contains(text.box) && !picture.intersects(text.box)) << width;
      for (std::size_t other = 0; other < n; ++other)
        EXPECT_FALSE(layout.texts[other].box.intersects(text.box))
            << width << ": " << text.text.toStdString();
    }
    EXPECT_TRUE(value || width < 240) << width;
    EXPECT_TRUE(named || width < 180) << width;
  }
}

TEST_F(Structures, ARefusedFileLeavesWhatWasThereAndAnotherScanTakesItAway) {
  start();
  QSignalSpy refused(&structures(), &app::StructuresController::refused);
  write<std::uint8_t>(path("far.nrrd"), {.dims = {4, 4, 4}, .origin = {9.0, 0.0, 0.0}}, "uchar", "",
                      [](const Eigen::Vector3d&) { return 1; });
  // a scan has more numbers than there may be structures
  write<std::int16_t>(path("many.nrrd"), gridOf({20, 20, 20}, 1e-3, haptics::Mat3::Identity()),
                      "short", "",
                      [](const Eigen::Vector3d& p) { return int(p.x()) * 20 + int(p.y()) + 1000; });
  for (const char* file : {"far.nrrd", "many.nrrd", "none.nrrd"}) {
    emit window().menus().structuresWanted(path(file));
    EXPECT_TRUE(waitFor([&] { return refused.count() == 1; })) << file;
    refused.clear();
    EXPECT_TRUE(message().contains(file)) << message().toStdString();
    EXPECT_EQ(list().rowCount(), 3);
    EXPECT_NE(structures().shown().map, nullptr);
  }
  views().setCross(kNerve);
  EXPECT_GT(window::count(window::pictureOf(views().slice(Plane::Axial)), isNerve), 20);

  emit window().menus().phantomWanted("sphere");
  ASSERT_TRUE(waitFor([&] {
    return window().windowTitle().startsWith("sphere", Qt::CaseInsensitive);
  })) << window().windowTitle().toStdString();
  EXPECT_EQ(structures().shown().map, nullptr);
  EXPECT_EQ(list().rowCount(), 0);
  EXPECT_TRUE(list().isHidden() || !list().isVisible());
  for (ui::SliceView* slice : views().slices().slices())
    EXPECT_EQ(window::count(window::pictureOf(*slice), isNerve), 0);
}

TEST_F(Structures, ThatAreClosedAreGone) {
  start();
  views().setCross(kNerve);
  part<QPushButton>("closeStructures").click();
  EXPECT_EQ(window::count(window::pictureOf(views().slice(Plane::Axial)), isNerve), 0);
  EXPECT_EQ(window::count(lookFrom(ui::Side::Anterior), isNerveInSpace), 0);
  EXPECT_TRUE(part<QPushButton>("openStructuresButton").isEnabled());
}

TEST_F(Structures, ADropShowsThemAndAsksWhereTheFileDoesNotTell) {
  start("");
  QSignalSpy opened(&structures(), &app::StructuresController::opened);
  QSignalSpy scans(&structures(), &app::StructuresController::scanWanted);
  emit window().dropped({path("a.seg.nrrd")});
  EXPECT_TRUE(waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(list().rowCount(), 3);

  // the scan's own voxels, with labels and nothing that says so
  haptics::Mat3 mirrored;
  mirrored << -1, 0, 0, 0, 1, 0, 0, 0, 1;
  write<std::uint8_t>(path("plain.nrrd"), gridOf(kScanDims, kScanStep, mirrored), "uchar", "",
                      labelAt);
  answerNext("structures");
  emit window().dropped({path("plain.nrrd")});
  EXPECT_TRUE(waitFor([&] { return opened.count() == 2; }));
  EXPECT_EQ(list().item(0, 2)->text(), "Structure 1");
  EXPECT_EQ(scans.count(), 0);
  answerNext("scan");
  emit window().dropped({path("plain.nrrd")});
  EXPECT_TRUE(waitFor([&] { return scans.count() == 1; }));
  // it is on view: before, what is dropped is sorted by the scan that goes
  EXPECT_TRUE(waitFor([&] { return structures().labels() == nullptr; }));
  // another grid is another scan
  write<std::int16_t>(path("other.nrrd"), gridOf({30, 30, 30}, 1e-3, mirrored), "short", "",
                      boneAt);
  emit window().dropped({path("other.nrrd")});
  EXPECT_TRUE(waitFor([&] { return scans.count() == 2; }));
  emit window().dropped({path("scan.nrrd"), path("other.nrrd")});
  EXPECT_EQ(scans.count(), 3);
}

TEST_F(Structures, OpenFileDoesAsADrop) {
  start("");
  const auto scan = application_->shown()->volume();
  QSignalSpy opened(&structures(), &app::StructuresController::opened);
  emit window().menus().openWanted(path("a.seg.nrrd"));
  EXPECT_TRUE(waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(list().rowCount(), 3);
  haptics::Mat3 mirrored;
  mirrored << -1, 0, 0, 0, 1, 0, 0, 0, 1;
  write<std::uint8_t>(path("plain.nrrd"), gridOf(kScanDims, kScanStep, mirrored), "uchar", "",
                      labelAt);
  answerNext("structures");
  emit window().menus().openWanted(path("plain.nrrd"));
  EXPECT_TRUE(waitFor([&] { return opened.count() == 2; }));
  EXPECT_EQ(application_->shown()->volume(), scan);
}

TEST_F(Structures, HalfOfWhichLiesOutsideTheScanSaySo) {
  start("");
  QSignalSpy opened(&structures(), &app::StructuresController::opened);
  haptics::Grid away = gridOf({20, 20, 20}, 1e-3, haptics::Mat3::Identity());
  const double edge = kScanStep * double(kScanDims[0]) / 2.0;
  away.origin.x() += edge;  // its middle lies at the border
  write<std::uint8_t>(path("away.nrrd"), away, "uchar", "",
                      [](const Eigen::Vector3d&) { return 1; });
  emit window().menus().structuresWanted(path("away.nrrd"));
  EXPECT_TRUE(waitFor([&] { return opened.count() == 1; }));
  EXPECT_TRUE(message().contains("50 % of what \"away.nrrd\" marks lies outside the scan"))
      << message().toStdString();
}

TEST_F(Structures, ComeBackWithTheWorkThatACrashLeft) {
  // what lies in a temporary folder is no recent place
  ASSERT_TRUE(QDir(path("")).mkdir("tmp"));
  qputenv("TMPDIR", path("tmp").toLocal8Bit());
  start();
  application_->marks().measures().replace(
      {{ui::MeasureKind::Distance, "Width", {{-5.25, 1, 2}, {10, 1, 2}}}});
  EXPECT_TRUE(waitFor([&] {
    return QSettings().value("places/structures").toStringList().join(' ').endsWith("a.seg.nrrd");
  }));
  application_->end();  // nothing is asked
  application_.reset();
  start("");
  EXPECT_EQ(list().rowCount(), 0);
  auto& resume = part<QPushButton>("takeWork");
  ASSERT_TRUE(waitFor([&] { return resume.isVisible(); }));
  QSignalSpy opened(&structures(), &app::StructuresController::opened);
  resume.click();
  EXPECT_TRUE(waitFor([&] { return opened.count() == 1; })) << message().toStdString();
  EXPECT_EQ(list().rowCount(), 3);
  EXPECT_EQ(application_->marks().measures().all().size(), 1U);
  // those that the user closed stay away, and nothing is left of what is forgotten
  part<QPushButton>("closeStructures").click();
  EXPECT_TRUE(waitFor([&] { return !QSettings().contains("places/structures"); }));
  qunsetenv("TMPDIR");
}

TEST_F(Structures, NamesGoToTheScreenAlone) {
  start();
  views().setCross(kNerve);
  QTest::qWait(1'500);  // the journal and the log are written
  application_->end();
  application_.reset();
  int files = 0;
  for (const char* part : {"state", "journal", "recordings"}) {
    QDirIterator all(path(part), QDir::Files, QDirIterator::Subdirectories);
    while (all.hasNext()) {
      QFile file(all.next());
      ASSERT_TRUE(file.open(QFile::ReadOnly));
      ++files;
      const QByteArray bytes = file.readAll();
      EXPECT_FALSE(bytes.contains("Doe") || bytes.contains("Canal")) << qPrintable(file.fileName());
    }
  }
  EXPECT_GT(files + 1, 0);
}

TEST_F(Structures, AShapeIsClosedSmoothAndWhereItsVoxelsAre) {
  for (const double side : {1.0, -1.0}) {
    haptics::Mat3 axes = haptics::Mat3::Identity();
    axes(0, 0) = side;
    const haptics::Grid grid = gridOf({48, 40, 36}, 1e-3, axes);
    const Eigen::Vector3d ball{9.0, -4.0, 5.0};
    auto codes = std::make_shared<std::uint8_t[]>(static_cast<std::size_t>(grid.voxelCount()));
    std::size_t n = 0;
    for (int k = 0; k < 36; ++k)
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 48; ++i, ++n) {
          const Eigen::Vector3d p = grid.worldOf({double(i), double(j), double(k)}) * ui::kMmPerM;
          if ((p - ball).norm() < 8.0) codes[static_cast<std::ptrdiff_t>(n)] = 1;
          // a nerve of one voxel
          if (j == 3 && k == 3) codes[static_cast<std::ptrdiff_t>(n)] = 2;
        }
    const ui::StructureMap map{grid, codes, {{}, {0}, {1}}};
    const auto boxes = ui::boxesOf(map, 3);
    const std::atomic<bool> never{false};
    EXPECT_EQ(ui::shapeOf(map, 2, boxes[2], 60'000, never).mesh, nullptr);
    for (const std::uint8_t number : {0, 1}) {
      const ui::StructureShape shape = ui::shapeOf(map, number, boxes[number], 60'000, never);
      ASSERT_NE(shape.mesh, nullptr);
      // its volume by the divergence of its triangles in W, positive where they face outwards
      double volume = 0.0, farthest = 0.0, worst_normal = 1.0;
      const auto at = [&](vtkIdType id) {
        return Eigen::Vector3d(grid.direction * Eigen::Vector3d{shape.mesh->GetPoint(id)} +
                               grid.origin * ui::kMmPerM);
      };
      for (vtkIdType cell = 0; cell < shape.mesh->GetNumberOfCells(); ++cell) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        shape.mesh->GetCellPoints(cell, count, ids);
        volume += at(ids[0]).dot(at(ids[1]).cross(at(ids[2]))) / 6.0;
      }
      for (vtkIdType id = 0; number == 0 && id < shape.mesh->GetNumberOfPoints(); ++id) {
        farthest = std::max(farthest, std::abs((at(id) - ball).norm() - 8.0));
        const Eigen::Vector3d normal =
            grid.direction *
            Eigen::Vector3d{shape.mesh->GetPointData()->GetNormals()->GetTuple3(id)};
        worst_normal = std::min(worst_normal, normal.dot((at(id) - ball).normalized()));
      }
      if (number == 0) {
        EXPECT_NEAR(volume, 4.0 / 3.0 * M_PI * 512.0, 0.06 * 2145.0) << side;
        EXPECT_LT(farthest, 0.8) << side;
        EXPECT_GT(worst_normal, 0.85) << side;
        EXPECT_LT((shape.places_mm.front() - ball).norm(), 0.9) << side;
      } else {
        EXPECT_GT(volume, 3.0) << side;
        const double* b = shape.mesh->GetBounds();
        EXPECT_GT(b[1] - b[0], 44.0) << side;
        // the middle of a nerve is a place of it
        EXPECT_EQ(map.codeAt(shape.places_mm.front()), 2) << side;
      }
    }
  }
}

TEST_F(Structures, AThinShellIsWholeWithFewTriangles) {
  const haptics::Grid grid = gridOf({44, 44, 44}, 1e-3, haptics::Mat3::Identity());
  auto codes = std::make_shared<std::uint8_t[]>(static_cast<std::size_t>(grid.voxelCount()));
  std::vector<Eigen::Vector3d> voxels;
  std::ptrdiff_t n = 0;
  for (int k = 0; k < 44; ++k)
    for (int j = 0; j < 44; ++j)
      for (int i = 0; i < 44; ++i, ++n) {
        const Eigen::Vector3d p = grid.worldOf({double(i), double(j), double(k)}) * ui::kMmPerM;
        if (p.norm() < 16.0 || p.norm() >= 18.0) continue;
        codes[n] = 1;
        voxels.push_back(p);
      }
  const ui::StructureMap map{grid, codes, {{}, {0}}};
  const std::atomic<bool> never{false};
  for (const std::int64_t most : {1'000'000, 4'000}) {
    const auto mesh = ui::shapeOf(map, 0, ui::boxesOf(map, 1)[0], most, never).mesh;
    ASSERT_NE(mesh, nullptr);
    EXPECT_LE(mesh->GetNumberOfPolys(), most);
    // closed
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(mesh);
    edges->FeatureEdgesOff();
    edges->BoundaryEdgesOn();
    edges->NonManifoldEdgesOn();
    edges->Update();
    EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0) << most;
    const auto at = [&](vtkIdType id) {
      return Eigen::Vector3d(Eigen::Vector3d{mesh->GetPoint(id)} + grid.origin * ui::kMmPerM);
    };
    double volume = 0.0;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetCellPoints(cell, count, ids);
      volume += at(ids[0]).dot(at(ids[1]).cross(at(ids[2]))) / 6.0;
    }
    EXPECT_NEAR(volume, double(voxels.size()), 0.06 * double(voxels.size())) << most;
    vtkNew<vtkCellLocator> cells;
    cells->SetDataSet(mesh);
    cells->BuildLocator();
    // each voxel is near it
    double farthest = 0.0;
    for (const Eigen::Vector3d& p : voxels) {
      const Eigen::Vector3d p_L = p - grid.origin * ui::kMmPerM;
      Eigen::Vector3d nearest;
      vtkIdType cell = 0;
      int part = 0;
      double squared = 0.0;
      cells->FindClosestPoint(p_L.data(), nearest.data(), cell, part, squared);
      farthest = std::max(farthest, std::sqrt(squared));
    }
    EXPECT_LT(farthest, 1.4) << most;
    vtkNew<vtkOBBTree> tree;
    tree->SetDataSet(mesh);
    tree->BuildLocator();
    // from the middle outwards one meets two walls, the inner and the outer
    int whole = 0;
    constexpr int kRays = 500;
    for (int ray = 0; ray < kRays; ++ray) {
      const double z = 1.0 - 2.0 * (ray + 0.5) / kRays, round = std::sqrt(1.0 - z * z);
      const Eigen::Vector3d along{round * std::cos(2.4 * ray), round * std::sin(2.4 * ray), z};
      const Eigen::Vector3d from = -grid.origin * ui::kMmPerM, to = from + 21.0 * along;
      vtkNew<vtkPoints> points;
      vtkNew<vtkIdList> met;
      tree->IntersectWithLine(from.data(), to.data(), points, met);
      if (points->GetNumberOfPoints() != 2) continue;
      const auto out = [&](vtkIdType m) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        mesh->GetCellPoints(met->GetId(m), count, ids);
        return (at(ids[1]) - at(ids[0])).cross(at(ids[2]) - at(ids[0])).dot(along);
      };
      const auto away = [&](vtkIdType m) {
        return (Eigen::Vector3d{points->GetPoint(m)} - from).norm();
      };
      whole += out(0) < 0.0 && out(1) > 0.0 && away(1) - away(0) > 0.7 ? 1 : 0;
    }
    EXPECT_GE(whole, kRays - 5) << most;
  }
}

}  // namespace
