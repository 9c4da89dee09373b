// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/core/geometry.h"
#include "ui/overlays/measure_words.h"
#include "ui/props/slice.h"
#include "ui/props/view_look.h"

class vtkActor2D;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace app {

/// A measure, mark or note that a film shows.
struct FilmMark {
  std::vector<haptics::Vec3> places_mm;    ///< W, joined by a line
  std::string words;                       ///< beside the last place, UTF-8
  std::vector<haptics::Vec3> arc_mm = {};  ///< W, of an angle
};

/// What a film has of the view beside the recording: as the user saw it.
struct FilmLook {
  ui::SurfaceColours colours = ui::SurfaceColours::Ivory;
  std::optional<double> second = {};  ///< isovalue of a second surface, which is seen as a veil
  double second_opacity = ui::kFirstOpacity;
  bool tint = true;  ///< cut faces have a colour of their own where the surface is a mesh
  std::vector<FilmMark> marks = {};
  bool slices = false;                      ///< three slices in a column beside it
  std::optional<ui::GreyWindow> grey = {};  ///< of the slices; none: as the volume is first shown
};

/// What a film has of a view.
FilmLook lookOf(const ui::ViewLook& view, std::vector<FilmMark> marks);

/// The marks of a scan with their words.
std::vector<FilmMark> filmMarks(const std::vector<ui::Measure>& marks,
                                const ui::MeasuredScan& scan);

/// Puts marks over a picture, in front of everything.
void addMarks(vtkRenderer& renderer, const std::vector<FilmMark>& marks);

/// The curve of the force in the lower right corner of a picture.
class FilmCurve {
 public:
  /// `width` and `height` of the picture, pixels.
  FilmCurve(vtkRenderer& renderer, int width, int height);
  ~FilmCurve();
  /// Shows forces [N], the newest last, at the right. `places`: how many the curve has room for;
  /// `most`: the force at its upper edge [N].
  void show(std::span<const float> forces, std::size_t places, double most);

 private:
  double left_, low_, width_, height_;  ///< pixels
  vtkSmartPointer<vtkPoints> points_;
  vtkSmartPointer<vtkPolyData> line_;
  vtkSmartPointer<vtkActor2D> ground_, curve_;
  vtkSmartPointer<vtkTextActor> scale_;
};

}  // namespace app
