// SPDX-License-Identifier: BSD-3-Clause
// Left is left in the pictures, however a file turns its axes: files of the marker phantom, in all
// eight orientations, are loaded and shown, and what is grabbed is looked at. Which side is which
// is told by the phantom's balls in the pixels, and the letters are read from the pixels too.
#include <gtest/gtest.h>

#include <vtkCamera.h>

#include <QApplication>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "tests/ui/window_support.h"
#include "ui/views/slice_readout.h"
#include "ui/views/slice_view.h"
#include "ui/views/volume_view.h"

namespace {

namespace fs = std::filesystem;
using haptics::Mat3;
using haptics::Vec3;
using ui::Plane;

constexpr int kLetterSide = 360;  // px, of a view
constexpr double kStep_mm = 2.0;  // of the files' voxels: coarse enough to be quick

/// The eight orientations along the patient's axes, by the signs of the three.
std::vector<Mat3> orientations() {
  std::vector<Mat3> all;
  for (int signs = 0; signs < 8; ++signs) {
    Mat3 axes = Mat3::Identity();
    for (int a = 0; a < 3; ++a)
      if ((signs >> a & 1) != 0) axes(a, a) = -1.0;
    all.push_back(axes);
  }
  return all;
}

/// The marker phantom's voxels as a file that lies like this holds them, every second of each axis.
struct Turned {
  Mat3 axes;
  Vec3 origin_mm = Vec3::Zero();
  int n = 0;
  std::vector<std::int16_t> voxels = {};
};

Turned turned(const Mat3& axes) {
  static const datasets::Phantom marker = datasets::makePhantom("marker").value();
  const haptics::Volume& volume = marker.volume;
  const auto* from = static_cast<const std::int16_t*>(volume.voxels.get());
  const auto size = volume.grid.dims[0];
  const auto step = std::lround(1e-3 * kStep_mm / volume.grid.spacing.x());
  Turned file{axes};
  file.n = static_cast<int>((size - 1) / step + 1);
  Vec3 first = Vec3::Zero();
  for (int a = 0; a < 3; ++a)
    if (axes(a, a) < 0.0) first[a] = static_cast<double>((file.n - 1) * step);
  file.origin_mm = 1e3 * volume.grid.worldOf(first);
  for (int k = 0; k < file.n; ++k)
    for (int j = 0; j < file.n; ++j)
      for (int i = 0; i < file.n; ++i) {
        const Vec3 at = first + axes * Vec3(i, j, k) * static_cast<double>(step);
        const auto index =
            std::lround(at.x()) + size * (std::lround(at.y()) + size * std::lround(at.z()));
        file.voxels.push_back(from[index]);
      }
  return file;
}

/// A folder of its own for the files of a case, removed at the end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("palpate-letters-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }

 private:
  fs::path path_;
};

std::shared_ptr<const haptics::Volume> read(const fs::path& path) {
  auto volume = datasets::readVolume(path);
  EXPECT_TRUE(volume) << sentence(volume.error());
  if (!volume) return nullptr;
  return std::make_shared<const haptics::Volume>(std::move(*volume));
}

std::shared_ptr<const haptics::Volume> throughDicom(const Turned& file) {
  Folder folder;
  const std::size_t pixels = static_cast<std::size_t>(file.n) * file.n;
  for (int k = 0; k < file.n; ++k) {
    datasets::testing::DicomSlice slice;
    slice.instance += "." + std::to_string(k + 1);
    slice.position_mm = file.origin_mm + kStep_mm * k * file.axes.col(2);
    slice.along_row = file.axes.col(0);
    slice.along_column = file.axes.col(1);
    slice.row_step_mm = slice.column_step_mm = kStep_mm;
    slice.rows = slice.columns = file.n;
    const auto first = file.voxels.begin() + static_cast<std::ptrdiff_t>(pixels) * k;
    slice.pixels.assign(first, first + static_cast<std::ptrdiff_t>(pixels));
    folder.write(std::to_string(k), bytesOf(slice));
  }
  return read(folder.path());
}

/// `space` is empty for a file that does not say how it lies.
std::shared_ptr<const haptics::Volume> throughNrrd(const Turned& file, const std::string& space,
                                                   const Vec3& signs) {
  const auto vector = [&](const Vec3& v) {
    const Vec3 w = signs.cwiseProduct(v);
    return "(" + std::to_string(w.x()) + "," + std::to_string(w.y()) + "," + std::to_string(w.z()) +
           ")";
  };
  const std::string n = std::to_string(file.n), step = std::to_string(kStep_mm);
  std::string bytes = "NRRD0004\ntype: short\ndimension: 3\nsizes: " + n + " " + n + " " + n +
                      "\nendian: little\nencoding: raw\n";
  if (space.empty()) {
    bytes += "spacings: " + step + " " + step + " " + step + "\n";
  } else {
    bytes += "space: " + space + "\nspace directions:";
    for (int a = 0; a < 3; ++a) bytes += " " + vector(kStep_mm * file.axes.col(a));
    bytes += "\nspace origin: " + vector(file.origin_mm) + "\n";
  }
  bytes += "\n";
  bytes.append(reinterpret_cast<const char*>(file.voxels.data()), 2 * file.voxels.size());
  Folder folder;
  folder.write("marker.nrrd", bytes);
  return read(folder.path() / "marker.nrrd");
}

bool letterColoured(QColor c) {
  return c.red() > 120 && c.green() > 0.8 * c.red() && c.blue() < 0.32 * c.green();
}

/// What a slice has around its picture, where its letters are.
QImage marginOf(const QImage& slice) {
  QImage margin = slice;
  QPainter(&margin).fillRect(ui::pictureIn(slice.rect(), false), Qt::black);
  return margin;
}
// brighter than the name of the plane
bool solidInSlice(QColor c) { return c.saturation() < 20 && c.red() > 210; }
// brighter than the smooth edge of a letter can be
bool solidInSpace(QColor c) {
  return window::surfaceColoured(c) && c.red() > 56 && !letterColoured(c);
}

/// The smallest rectangle about what `wanted` picks.
QRect extentOf(const QImage& image, const std::function<bool(QColor)>& wanted) {
  QRect extent;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (wanted(image.pixelColor(x, y))) extent |= QRect(x, y, 1, 1);
  return extent;
}

/// Where the phantom's balls stick out, as the pixels say: which of left and right, and which of
/// upper and lower, reaches farther from the middle of what is solid.
struct Balls {
  char horizontal = '-', vertical = '-';  ///< '<' or '>'; '^' or 'v'
};

Balls ballsIn(const QImage& image, const std::function<bool(QColor)>& solid) {
  const QRect extent = extentOf(image, solid);
  // the box's sides, as the rows and columns through most of its faces have them
  std::vector<int> lefts, rights, tops, bottoms;
  for (int y = extent.top(); y <= extent.bottom(); ++y) {
    const QRect row = extentOf(image.copy(0, y, image.width(), 1), solid);
    if (row.isValid()) lefts.push_back(row.left()), rights.push_back(row.right());
  }
  for (int x = extent.left(); x <= extent.right(); ++x) {
    const QRect column = extentOf(image.copy(x, 0, 1, image.height()), solid);
    if (column.isValid()) tops.push_back(column.top()), bottoms.push_back(column.bottom());
  }
  const auto median = [](std::vector<int>& of) {
    if (of.empty()) return 0;
    std::ranges::nth_element(of, of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2));
    return of[of.size() / 2];
  };
  const int left = median(lefts) - extent.left(), right = extent.right() - median(rights);
  const int up = median(tops) - extent.top(), down = extent.bottom() - median(bottoms);
  constexpr int kClear = 4;  // px; the smallest ball reaches 10
  Balls balls;
  if (std::abs(left - right) >= kClear) balls.horizontal = left > right ? '<' : '>';
  if (std::abs(up - down) >= kClear) balls.vertical = up > down ? '^' : 'v';
  return balls;
}

/// Letter pixels in black on white, as large as they are, in the middle of a square of one height.
QImage asGlyph(const QImage& image, const std::function<bool(QColor)>& ink) {
  const QRect extent = extentOf(image, ink);
  if (!extent.isValid() || extent.height() < 8) return {};
  QImage cut(extent.size(), QImage::Format_Grayscale8);
  for (int y = 0; y < cut.height(); ++y)
    for (int x = 0; x < cut.width(); ++x)
      cut.setPixelColor(
          x, y, ink(image.pixelColor(extent.topLeft() + QPoint{x, y})) ? Qt::black : Qt::white);
  constexpr int kHeight = 32;
  QImage glyph(kHeight, kHeight, QImage::Format_Grayscale8);
  glyph.fill(Qt::white);
  const QImage scaled = cut.scaledToHeight(kHeight, Qt::SmoothTransformation);
  QPainter painter(&glyph);
  painter.drawImage((kHeight - scaled.width()) / 2, 0, scaled);
  return glyph;
}

/// A letter as the views' painters draw it, so many pixels high.
QImage paintedGlyph(char letter, int pixels) {
  QImage page(80, 80, QImage::Format_RGB32);
  page.fill(Qt::white);
  QPainter painter(&page);
  QFont font = QApplication::font();
  font.setBold(true);
  font.setPixelSize(pixels);
  painter.setFont(font);
  painter.drawText(page.rect(), Qt::AlignCenter, QString(letter));
  painter.end();
  return asGlyph(page, [](QColor c) { return c.lightness() < 128; });
}

/// How much two glyphs differ, 0 to 1; 1 where there is none.
double apart(const QImage& a, const QImage& b) {
  if (a.isNull() || b.isNull()) return 1.0;
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) / 255.0;
  return sum / (a.width() * a.height());
}

/// The letter that the pixels show; '-' if none of the six, or none clearly.
char letterIn(const QImage& image) {
  // in slices, in 3-D, and without the roughness of pixels
  static constexpr std::array kPixels{14, 17, 48};
  static const auto kGlyphs = [] {
    std::vector<std::pair<char, QImage>> glyphs;
    for (const char candidate : {'L', 'R', 'A', 'P', 'S', 'I'})
      for (const int pixels : kPixels)
        glyphs.emplace_back(candidate, paintedGlyph(candidate, pixels));
    return glyphs;
  }();
  const QImage seen = asGlyph(image, letterColoured);
  std::map<char, double> differ;
  for (const auto& [candidate, glyph] : kGlyphs) {
    double& least = differ.try_emplace(candidate, 1.0).first->second;
    least = std::min(least, apart(seen, glyph));
  }
  std::vector<std::pair<double, char>> order;
  for (const auto& [candidate, least] : differ) order.emplace_back(least, candidate);
  std::ranges::sort(order);
  return order[0].first < 0.15 && order[0].first < 0.7 * order[1].first ? order[0].second : '-';
}

/// The letters read at the left, right, upper and lower side of a picture.
std::string lettersIn(const QImage& image) {
  std::array<QImage, 4> sides;
  for (QImage& side : sides) {
    side = QImage(image.size(), QImage::Format_RGB32);
    side.fill(Qt::black);
  }
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor colour = image.pixelColor(x, y);
      if (!letterColoured(colour)) continue;
      const double right = 2.0 * x / image.width() - 1.0, down = 2.0 * y / image.height() - 1.0;
      const std::size_t side =
          std::abs(right) > std::abs(down) ? (right > 0.0 ? 1 : 0) : (down > 0.0 ? 3 : 2);
      sides[side].setPixelColor(x, y, colour);
    }
  std::string letters;
  for (const QImage& side : sides) letters += letterIn(side);
  return letters;
}

/// All that is looked at: three slices; the 3-D view as it begins, from the front, from the left.
class LetterViews {
 public:
  LetterViews() {
    space_.setSurfaceWish(ui::SurfaceMode::Mesh);
    for (ui::SliceView* slice : {&axial_, &coronal_, &sagittal_})
      window::showAndWait(*slice, {kLetterSide, kLetterSide});
    window::showAndWait(space_, {kLetterSide, kLetterSide});
  }

  std::vector<QImage> picturesOf(const std::shared_ptr<const haptics::Volume>& volume) {
    const ui::Picture picture = ui::pictureOf(volume);
    std::vector<QImage> images;
    for (ui::SliceView* slice : {&axial_, &coronal_, &sagittal_}) {
      slice->show(picture);
      slice->resetView();  // which body it finds depends on the unit
      slice->setGrey({.level = 1000.0, .width = 200.0});
      slice->setCross(1e3 * volume->grid.worldOf(0.5 * Vec3(double(volume->grid.dims[0] - 1),
                                                            double(volume->grid.dims[1] - 1),
                                                            double(volume->grid.dims[2] - 1))));
      images.push_back(window::pictureOf(*slice));
    }
    space_.show(picture, 1000.0);
    space_.camera()->ParallelProjectionOff();
    space_.resetCamera();
    images.push_back(window::pictureAtRest(space_));
    // without perspective, in which the box's near face hides the small balls
    space_.camera()->ParallelProjectionOn();
    space_.camera()->SetParallelScale(30.0);     // mm, half the picture
    for (const double turn_deg : {0.0, 90.0}) {  // the second from the patient's left
      space_.camera()->Azimuth(turn_deg);
      space_.setIsovalue(1000.0);  // draws the surface again
      images.push_back(window::pictureAtRest(space_));
    }
    return images;
  }

 private:
  ui::SliceView axial_{Plane::Axial}, coronal_{Plane::Coronal}, sagittal_{Plane::Sagittal};
  ui::VolumeView space_;
};

/// What a picture must show where the balls stand out; '-' where the ball is hidden.
struct Shown {
  const char* name;
  char horizontal, vertical;  ///< letters
  bool in_space;
};
constexpr std::array<Shown, 6> kShown = {{{"axial", 'L', 'A', false},
                                          {"coronal", 'L', 'S', false},
                                          {"sagittal", 'A', 'S', false},
                                          {"space", 'L', '-', true},
                                          {"front", 'L', 'S', true},
                                          {"left", 'A', 'S', true}}};

char opposite(char letter) {
  constexpr std::string_view kLetters = "LRAPSI";
  return kLetters[kLetters.find(letter) ^ 1U];
}

/// That the balls stand where their letters do, and that every side has its letter.
void expectLettersAtTheirBalls(const std::vector<QImage>& images) {
  ASSERT_EQ(images.size(), kShown.size());
  for (std::size_t n = 0; n < images.size(); ++n) {
    const Shown& shown = kShown[n];
    const Balls balls = ballsIn(images[n], shown.in_space ? solidInSpace : solidInSlice);
    const std::string letters = lettersIn(shown.in_space ? images[n] : marginOf(images[n]));
    SCOPED_TRACE(std::string(shown.name) + ", letters left, right, up, down: " + letters);
    // the convention: the patient's left on the right, the front above or on the left, head up
    ASSERT_EQ(balls.horizontal, shown.horizontal == 'L' ? '>' : '<');
    const bool on_right = balls.horizontal == '>';
    EXPECT_EQ(letters[on_right ? 1 : 0], shown.horizontal);
    EXPECT_EQ(letters[on_right ? 0 : 1], opposite(shown.horizontal));
    const char above = shown.vertical == '-' ? 'S' : shown.vertical;
    if (shown.vertical != '-') {
      ASSERT_EQ(balls.vertical, '^');
    }
    EXPECT_EQ(letters[2], above);
    EXPECT_EQ(letters[3], opposite(above));
  }
}

TEST(Letters, StandWhereTheirSideIsHoweverAFileTurnsItsAxes) {
  LetterViews views;
  const std::vector<std::pair<std::string, Vec3>> spaces{{"left-posterior-superior", {1, 1, 1}},
                                                         {"right-anterior-superior", {-1, -1, 1}},
                                                         {"left-anterior-superior", {1, -1, 1}}};
  std::vector<QImage> first;
  int files = 0;
  for (const Mat3& axes : orientations()) {
    const Turned file = turned(axes);
    std::vector<std::pair<std::string, std::shared_ptr<const haptics::Volume>>> volumes{
        {"DICOM", throughDicom(file)}};
    for (const auto& [space, signs] : spaces)
      volumes.emplace_back(space, throughNrrd(file, space, signs));
    for (const auto& [name, volume] : volumes) {
      std::ostringstream what;
      what << name << ", axes " << axes.diagonal().transpose();
      SCOPED_TRACE(what.str());
      ASSERT_TRUE(volume);
      const std::vector<QImage> images = views.picturesOf(volume);
      expectLettersAtTheirBalls(images);
      if (first.empty()) {
        first = images;
        for (std::size_t n = 0; n < images.size(); ++n)
          window::keep(images[n], (std::string("letters_") + kShown[n].name).c_str());
      }
      // one phantom, one picture; a mesh's triangles follow the file's axes
      for (std::size_t n = 0; n < images.size(); ++n)
        EXPECT_LT(window::differing(images[n], first[n], 40), 0.01) << kShown[n].name;
      ++files;
      if (HasFailure()) return;
    }
  }
  EXPECT_EQ(files, 32);
}

TEST(Letters, AreNowhereWhereAFileDoesNotSayHowItLies) {
  LetterViews views;
  const auto volume = throughNrrd(turned(Mat3::Identity()), "", Vec3::Ones());
  ASSERT_TRUE(volume);
  ASSERT_FALSE(volume->orientation_known);
  const std::vector<QImage> images = views.picturesOf(volume);
  for (std::size_t n = 0; n < images.size(); ++n) {
    window::keep(images[n], (std::string("letterless_") + kShown[n].name).c_str());
    const QImage image = kShown[n].in_space ? images[n] : marginOf(images[n]);
    EXPECT_EQ(window::count(image, letterColoured), 0) << kShown[n].name;
    EXPECT_EQ(lettersIn(image), "----") << kShown[n].name;
  }
}

}  // namespace
