// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/overlays.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "ui/style/scene_colours.h"

namespace app {
namespace {

constexpr double kWide = 0.28, kHigh = 0.14;  // of the picture
constexpr double kMargin = 45.0;              // this part of the shorter side is left free
constexpr int kWordsSize = 16, kAside = 8, kAbove = 6;  // pixels

/// Puts the words of marks on the side of their places where they have room, before each picture.
class Sides : public vtkCommand {
 public:
  static Sides* New() { return new Sides; }
  void add(vtkBillboardTextActor3D& words) { words_.emplace_back(&words); }
  void Execute(vtkObject* caller, unsigned long, void*) override {
    auto* renderer = vtkRenderer::SafeDownCast(caller);
    for (const auto& words : words_) {
      std::array<double, 3> at{};
      words->GetPosition(at.data());
      renderer->SetWorldPoint(at[0], at[1], at[2], 1.0);
      renderer->WorldToDisplay();
      std::array<int, 4> box{};  // from and to in x, then in y
      vtkTextRenderer::GetInstance()->GetBoundingBox(words->GetTextProperty(), words->GetInput(),
                                                     box.data(), 72);
      const double right = renderer->GetDisplayPoint()[0] + kAside + (box[1] - box[0]);
      const bool fits = right < renderer->GetOrigin()[0] + renderer->GetSize()[0];
      words->SetDisplayOffset(fits ? kAside : -kAside, kAbove);
      words->GetTextProperty()->SetJustification(fits ? VTK_TEXT_LEFT : VTK_TEXT_RIGHT);
    }
  }

 private:
  std::vector<vtkSmartPointer<vtkBillboardTextActor3D>> words_;
};

}  // namespace

FilmLook lookOf(const ui::ViewLook& view, std::vector<FilmMark> marks) {
  return {.colours = view.colours,
          .second = view.second,
          .second_opacity = view.second_opacity,
          .marks = std::move(marks),
          .grey = ui::GreyWindow{view.grey_level, view.grey_width}};
}

std::vector<FilmMark> filmMarks(const std::vector<ui::Measure>& marks,
                                const ui::MeasuredScan& scan) {
  std::vector<FilmMark> shown;
  for (const ui::Measure& mark : marks) {
    const QString value = ui::valueOf(mark, scan), words = QString::fromStdString(mark.text);
    shown.push_back(
        {mark.places_mm,
         (value.isEmpty() ? words
                          : QCoreApplication::translate("app::Film", "%1: %2").arg(words, value))
             .toStdString(),
         ui::arcOf(mark)});
  }
  return shown;
}

void addMarks(vtkRenderer& renderer, const std::vector<FilmMark>& marks) {
  const QColor& ink = ui::style::kMeasure;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines, dots;
  vtkNew<Sides> sides;
  for (const FilmMark& mark : marks) {
    if (mark.places_mm.size() > 1)
      lines->InsertNextCell(static_cast<vtkIdType>(mark.places_mm.size()));
    for (const haptics::Vec3& p : mark.places_mm) {
      const vtkIdType point = points->InsertNextPoint(p.data());
      if (mark.places_mm.size() > 1) lines->InsertCellPoint(point);
      dots->InsertNextCell(1, &point);
    }
    if (!mark.arc_mm.empty()) lines->InsertNextCell(static_cast<vtkIdType>(mark.arc_mm.size()));
    for (const haptics::Vec3& p : mark.arc_mm)
      lines->InsertCellPoint(points->InsertNextPoint(p.data()));
    if (mark.words.empty() || mark.places_mm.empty()) continue;
    vtkNew<vtkBillboardTextActor3D> words;
    words->SetInput(mark.words.c_str());
    const haptics::Vec3& last = mark.places_mm.back();
    words->SetPosition(last.x(), last.y(), last.z());
    vtkTextProperty* look = words->GetTextProperty();
    look->SetFontSize(kWordsSize);
    look->SetColor(ink.redF(), ink.greenF(), ink.blueF());
    look->SetBackgroundColor(0.0, 0.0, 0.0);
    look->SetBackgroundOpacity(0.6);
    renderer.AddActor(words);
    sides->add(*words);
  }
  renderer.AddObserver(vtkCommand::StartEvent, sides);
  vtkNew<vtkPolyData> shapes;
  shapes->SetPoints(points);
  shapes->SetLines(lines);
  shapes->SetVerts(dots);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shapes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->LightingOff();
  look->SetColor(ink.redF(), ink.greenF(), ink.blueF());
  look->SetLineWidth(2.0F);
  look->SetPointSize(8.0F);
  renderer.AddActor(actor);
}

FilmCurve::FilmCurve(vtkRenderer& renderer, int width, int height)
    : left_(width * (1.0 - kWide) - std::min(width, height) / kMargin),
      low_(std::min(width, height) / kMargin),
      width_(width * kWide),
      height_(height * kHigh),
      points_(vtkSmartPointer<vtkPoints>::New()),
      line_(vtkSmartPointer<vtkPolyData>::New()),
      ground_(vtkSmartPointer<vtkActor2D>::New()),
      curve_(vtkSmartPointer<vtkActor2D>::New()),
      scale_(vtkSmartPointer<vtkTextActor>::New()) {
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> box;
  box->InsertNextCell(4);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
    box->InsertCellPoint(corners->InsertNextPoint(left_ + x * width_, low_ + y * height_, 0.0));
  vtkNew<vtkPolyData> ground;
  ground->SetPoints(corners);
  ground->SetPolys(box);
  line_->SetPoints(points_);
  for (const auto& [actor, data, colour, opacity] :
       {std::tuple{ground_.Get(), ground.Get(), ui::style::kViewGround, 0.7},
        std::tuple{curve_.Get(), line_.Get(), ui::style::kForceArrow, 1.0}}) {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    actor->GetProperty()->SetOpacity(opacity);
    actor->VisibilityOff();
    renderer.AddActor2D(actor);
  }
  curve_->GetProperty()->SetLineWidth(2.0F);
  vtkTextProperty* look = scale_->GetTextProperty();
  look->SetFontSize(kWordsSize);
  look->SetColor(1.0, 1.0, 1.0);
  look->SetVerticalJustificationToTop();
  scale_->SetDisplayPosition(static_cast<int>(left_ + 4.0), static_cast<int>(low_ + height_ - 2.0));
  scale_->VisibilityOff();
  renderer.AddActor2D(scale_);
}

FilmCurve::~FilmCurve() = default;

void FilmCurve::show(std::span<const float> forces, std::size_t places, double most) {
  if (forces.size() > places) forces = forces.last(places);
  points_->Reset();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<vtkIdType>(forces.size()));
  const double step = width_ / static_cast<double>(std::max<std::size_t>(places, 2) - 1);
  for (std::size_t n = 0; n < forces.size(); ++n) {
    const double force = std::clamp(static_cast<double>(forces[n]) / most, 0.0, 1.0);
    const double from_right = static_cast<double>(forces.size() - 1 - n) * step;
    line->InsertCellPoint(points_->InsertNextPoint(left_ + width_ - from_right,
                                                   low_ + 1.0 + force * (height_ - 2.0), 0.0));
  }
  line_->SetLines(line);
  points_->Modified();
  scale_->SetInput(QString("%1 N").arg(most).toUtf8().constData());
  for (vtkProp* prop : {static_cast<vtkProp*>(ground_), static_cast<vtkProp*>(curve_),
                        static_cast<vtkProp*>(scale_)})
    prop->VisibilityOn();
}

}  // namespace app
