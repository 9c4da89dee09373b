// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/stage.h"

#include <qopengl.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "app/display.h"
#include "app/film/slices.h"
#include "datasets/edits/edited.h"
#include "ui/props/held_pass.h"
#include "ui/props/letters.h"
#include "ui/props/tool_prop.h"
#include "ui/props/veil_pass.h"
#include "ui/props/viewport.h"

namespace app {
namespace {

using haptics::Error;
using haptics::Expected;
using haptics::Vec3;

// as the window's: more takes seconds to draw where there is no graphics card
constexpr std::int64_t kFineVoxels = 24'000'000;
constexpr double kTextHeight = 720.0;  // pixels: the picture for which letters have their size

/// Where numbers read from a file can be drawn at all.
bool drawable(const haptics::Pose& X) {
  return X.matrix().allFinite() && X.translation().norm() < 100.0;
}

ui::Graphics graphicsNow() {
  ui::Graphics graphics;
  glGetIntegerv(GL_MAJOR_VERSION, &graphics.major);
  glGetIntegerv(GL_MINOR_VERSION, &graphics.minor);
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &graphics.max_3d_texture);
  graphics.renderer = QString::fromLatin1(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  return graphics;
}

}  // namespace

struct FilmStage::Layers {
  HeldDisplay display;  // outlives the window
  // the window last made is the first to go: the props' textures live in its context
  ui::VolumeProp surface;
  ui::ToolProp tool;
  vtkNew<vtkTextActor> text, note;
  vtkNew<vtkCamera> eye;
  vtkNew<ui::HeldPass> held;
  vtkNew<ui::VeilPass> veil;
  vtkNew<vtkRenderer> surface_layer, proxy_layer, veil_layer, overlay_layer;
  std::unique_ptr<FilmCurve> curve;
  std::optional<FilmSlices> slices;
  std::unique_ptr<ui::Letters> letters;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkUnsignedCharArray> pixels;

  ui::Graphics graphics;
  std::optional<ui::SurfaceMode> wish;
  std::shared_ptr<const haptics::Volume> volume;
  ui::Picture picture;
  std::optional<double> isovalue;
  bool has_tool = false;
  double tool_radius = 0.0;  ///< m
  FilmCamera camera;
  FilmFrame frame;
  FilmLook look;

  void redrawSurface() {
    held->forget();
    veil->forget();
  }

  /// The ray caster writes no depth: the proxy must be there before it. A mesh is drawn once and
  /// kept, so that the proxy may move over it at no cost.
  void placeProxy() {
    const bool cast = volume != nullptr && surface.mode() == ui::SurfaceMode::RayCast;
    surface_layer->RemoveActor(tool.proxy());
    proxy_layer->RemoveActor(tool.proxy());
    (cast ? surface_layer : proxy_layer)->AddActor(tool.proxy());
    surface_layer->SetPass(cast ? nullptr : held.Get());
  }
};

FilmStage::FilmStage(std::unique_ptr<Layers> layers) : layers_{std::move(layers)} {}
FilmStage::~FilmStage() = default;

Expected<std::unique_ptr<FilmStage>> FilmStage::open(int width, int height,
                                                     std::optional<ui::SurfaceMode> wish,
                                                     FilmLook look_of_view) {
  auto layers = std::make_unique<Layers>();
  Layers& s = *layers;
  if (!s.display.draws())
    return tl::unexpected(Error{Error::Kind::Unsupported, {"film-no-display", {}}, "no-display"});
  s.wish = wish;
  s.frame.width = width;
  s.frame.height = height;
  s.look = std::move(look_of_view);
  if (s.look.slices) width -= s.slices.emplace(width, height, s.look.grey).width();
  s.window->SetOffScreenRendering(1);
  s.window->SetMultiSamples(0);  // the kept surface is copied pixel by pixel
  s.window->SetSize(width, height);
  s.window->SetDPI(std::max(36, int(72.0 * std::min(width, height) / kTextHeight)));
  s.window->SetNumberOfLayers(4);
  int number = 0;
  for (vtkRenderer* layer :
       {s.surface_layer.Get(), s.proxy_layer.Get(), s.veil_layer.Get(), s.overlay_layer.Get()}) {
    layer->SetLayer(number++);
    layer->SetActiveCamera(s.eye);
    s.window->AddRenderer(layer);
  }
  s.surface_layer->SetBackground(0.07, 0.08, 0.10);
  // the proxy is hidden by the surface in front of it; the device never is
  s.proxy_layer->PreserveDepthBufferOn();
  s.veil_layer->PreserveDepthBufferOn();
  s.veil_layer->SetPass(s.veil);
  s.veil->setOpacity(s.look.second_opacity);
  s.veil_layer->AddActor(s.surface.secondMesh());
  s.veil_layer->SetDraw(s.look.second.has_value());
  addMarks(*s.overlay_layer, s.look.marks);
  s.curve = std::make_unique<FilmCurve>(*s.overlay_layer, width, height);
  s.surface_layer->AddVolume(s.surface.rayCast());
  s.surface_layer->AddActor(s.surface.mesh());
  s.surface_layer->AddActor(s.surface.carved().actor());
  s.surface.carved().setTint(s.look.tint);
  s.overlay_layer->AddActor(s.tool.device());
  s.overlay_layer->AddActor2D(s.text);
  s.letters = std::make_unique<ui::Letters>(s.overlay_layer);
  vtkTextProperty* look = s.text->GetTextProperty();
  look->SetFontFamilyToCourier();
  look->SetBold(1);
  look->SetFontSize(20);
  look->SetColor(1.0, 1.0, 1.0);
  look->SetBackgroundColor(0.0, 0.0, 0.0);
  look->SetBackgroundOpacity(0.6);
  s.text->SetDisplayPosition(std::min(width, height) / 45, std::min(width, height) / 45);
  s.text->VisibilityOff();
  s.note->SetInput(
      QCoreApplication::translate("ui::Measures", "Not for treatment").toUtf8().constData());
  s.note->GetTextProperty()->ShallowCopy(look);
  s.note->GetTextProperty()->SetFontFamilyToArial();
  s.note->GetTextProperty()->SetBold(0);
  s.note->GetTextProperty()->SetFontSize(18);
  s.note->GetTextProperty()->SetVerticalJustificationToTop();
  s.note->SetDisplayPosition(std::min(width, height) / 45, height - std::min(width, height) / 45);
  s.overlay_layer->AddActor2D(s.note);
  s.placeProxy();

  // words without OpenGL end the program
  s.overlay_layer->DrawOff();
  s.window->Render();
  s.overlay_layer->DrawOn();
  if (s.window->IsCurrent()) s.graphics = graphicsNow();
  if (s.graphics.major * 10 + s.graphics.minor < 32)
    return tl::unexpected(Error{Error::Kind::Unsupported, {"film-no-opengl", {}}, "no-graphics"});
  return std::unique_ptr<FilmStage>(new FilmStage(std::move(layers)));
}

void FilmStage::show(const haptics::Tool* tool) {
  Layers& s = *layers_;
  s.tool_radius = 0.0;
  s.has_tool = tool != nullptr;
  if (s.slices) s.slices->show(s.has_tool ? tool->mesh : haptics::TriangleMesh{});
  if (!s.has_tool) return;
  haptics::TriangleMesh mesh = tool->mesh;
  if (mesh.triangles.empty()) mesh.vertices = tool->shell.points;
  for (Vec3& v : mesh.vertices) {
    if (!v.allFinite()) v.setZero();
    s.tool_radius = std::max(s.tool_radius, v.norm());
  }
  s.tool.show(mesh);
}

void FilmStage::show(const std::shared_ptr<const haptics::Volume>& volume) {
  Layers& s = *layers_;
  if (volume == s.volume && !s.surface.carved().isOn()) return;
  s.volume = volume;
  s.isovalue.reset();
  s.redrawSurface();
  s.letters->setVisible(volume != nullptr && volume->orientation_known);
  if (volume == nullptr) {
    s.picture = {};
    s.surface.carved().end();
    s.surface.rayCast()->VisibilityOff();
    s.surface.mesh()->VisibilityOff();
    s.surface.secondMesh()->VisibilityOff();
  } else {
    s.picture = ui::pictureOf(volume);
    s.surface.show(s.picture);
    s.surface.setColouring(ui::Colouring::of(s.look.colours, s.picture));
    s.surface.setSecond(s.look.second);
    s.surface.setMode(ui::chooseSurface(s.wish, s.graphics, volume->grid).mode);
  }
  s.placeProxy();
  if (s.slices) s.slices->show(s.picture);
}

void FilmStage::showLive(const haptics::Volume& voxels) {
  Layers& s = *layers_;
  const auto& derivation = s.volume->derivation;
  s.surface.showLive(voxels, derivation ? derivation->scan : s.volume,
                     datasets::boxesOfStrokes(*s.volume));
  if (s.slices) s.slices->showLive(voxels);
  s.redrawSurface();
}

void FilmStage::carve(const haptics::VoxelBox& box) {
  Layers& s = *layers_;
  s.surface.carved().add(box);
  if (s.slices) s.slices->carve();
  s.redrawSurface();
}

void FilmStage::write(const std::string& text) {
  layers_->text->SetInput(text.c_str());
  layers_->text->SetVisibility(!text.empty());
}

void FilmStage::look(const FilmCamera& camera) {
  Layers& s = *layers_;
  s.camera = camera;
  const auto same = [](const Vec3& v, const double* now) { return v == Vec3{now}; };
  if (same(camera.position_mm, s.eye->GetPosition()) &&
      same(camera.focus_mm, s.eye->GetFocalPoint()) && same(camera.up, s.eye->GetViewUp()) &&
      camera.angle_deg == s.eye->GetViewAngle())
    return;
  s.eye->SetPosition(camera.position_mm.data());
  s.eye->SetFocalPoint(camera.focus_mm.data());
  s.eye->SetViewUp(camera.up.data());
  s.eye->SetViewAngle(camera.angle_deg);
  s.redrawSurface();
}

FilmCurve& FilmStage::curve() { return *layers_->curve; }
const FilmCamera& FilmStage::camera() const { return layers_->camera; }
double FilmStage::aspect() const {
  const int* size = layers_->window->GetSize();
  return double(size[0]) / size[1];
}
ui::SurfaceMode FilmStage::surfaceMode() const { return layers_->surface.mode(); }

Eigen::AlignedBox3d FilmStage::surfaceBox_mm(double isovalue) {
  if (layers_->volume == nullptr) return {};
  if (!std::isfinite(isovalue)) return ui::boxOf_mm(layers_->volume->grid);
  layers_->surface.setIsovalue(isovalue);
  layers_->isovalue.reset();
  return layers_->surface.bounds_mm();
}

void FilmStage::placeSurface(double isovalue) {
  Layers& s = *layers_;
  if (s.volume == nullptr || isovalue == s.isovalue) return;
  s.isovalue = isovalue;
  s.surface.setIsovalue(isovalue);
  s.redrawSurface();
  if (s.surface.mode() == ui::SurfaceMode::Mesh) {
    try {
      // closed at the cut faces, which are felt too
      const auto image = ui::reducedImageOf(*s.volume, kFineVoxels);
      s.surface.showFine(ui::isosurfaceMesh(image, isovalue, s.picture.mirrored()), isovalue);
    } catch (const std::bad_alloc&) {  // then the reduced mesh stays
    }
  }
}

void FilmStage::placeClippingPlanes(const haptics::Step& step) {
  Layers& s = *layers_;
  Eigen::AlignedBox3d box;
  if (s.volume != nullptr) box = ui::boxOf_mm(s.volume->grid);
  const Vec3 room = Vec3::Constant(s.tool_radius * ui::kMmPerM + 1.0);
  if (s.has_tool)
    for (const haptics::Pose* X : {&step.X_WP, &step.X_WD}) {
      if (!drawable(*X)) continue;
      const Vec3 p_mm = X->translation() * ui::kMmPerM;
      box.extend(Vec3{p_mm - room});
      box.extend(Vec3{p_mm + room});
    }
  for (const FilmMark& mark : s.look.marks)
    for (const Vec3& p_mm : mark.places_mm) box.extend(p_mm);
  if (box.isEmpty()) box.extend(Vec3::Zero().eval());
  const Vec3 away = (s.camera.focus_mm - s.camera.position_mm).normalized();
  const double middle = away.dot(box.center() - s.camera.position_mm);
  const double reach = 0.65 * box.diagonal().norm() + 1.0;
  // in steps of a factor: a tool that moves must not move the planes that the kept surface was
  // drawn between
  const double far_mm = std::exp2(std::ceil(std::log2(std::max(middle + reach, 1.0))));
  const double near_mm = std::max(middle - reach, far_mm * 0.002);
  const double near_step = std::exp2(std::floor(std::log2(near_mm)));
  const double* range = s.eye->GetClippingRange();
  if (range[0] == near_step && range[1] == far_mm) return;
  s.eye->SetClippingRange(near_step, far_mm);
  s.redrawSurface();
}

const FilmFrame& FilmStage::draw(const haptics::Step& step) {
  Layers& s = *layers_;
  if (std::isfinite(step.settings.isovalue)) placeSurface(step.settings.isovalue);
  const bool poses = drawable(step.X_WP) && drawable(step.X_WD);
  s.tool.proxy()->SetVisibility(s.has_tool && poses);
  s.tool.device()->SetVisibility(s.has_tool && poses);
  if (poses) s.tool.move(step.X_WP, step.X_WD);
  s.window->MakeCurrent();  // for the part of a texture that was cut
  s.surface.update();
  Eigen::Matrix3d axes;  // right, up, towards the viewer
  axes.col(2) = (s.camera.position_mm - s.camera.focus_mm).normalized();
  axes.col(0) = s.camera.up.cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  s.letters->show(axes, s.window->GetSize()[0], s.window->GetSize()[1]);
  placeClippingPlanes(step);
  s.window->Render();

  FilmFrame& frame = s.frame;
  const int width = frame.width - (s.slices ? s.slices->width() : 0);
  s.window->GetPixelData(0, 0, width - 1, frame.height - 1, 0, s.pixels);
  frame.rgb.resize(3 * static_cast<std::size_t>(frame.width) *
                   static_cast<std::size_t>(frame.height));
  for (std::ptrdiff_t y = 0; y < frame.height; ++y)
    std::copy_n(s.pixels->GetPointer(3 * y * width), 3 * width,
                frame.rgb.begin() + 3 * y * frame.width);
  if (s.slices) s.slices->draw(step, frame);
  return frame;
}

}  // namespace app
