// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/drawing.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <chrono>
#include <optional>

#include "ui/props/volume_prop.h"

namespace study {
namespace {

double msSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

Image imageOf(vtkRenderWindow* window) {
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> rgb;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, rgb);
  Image image{size[0], size[1]};
  image.grey.reserve(static_cast<std::size_t>(rgb->GetNumberOfTuples()));
  for (vtkIdType n = 0; n < rgb->GetNumberOfTuples(); ++n)
    image.grey.push_back((rgb->GetTypedComponent(n, 0) + rgb->GetTypedComponent(n, 1) +
                          rgb->GetTypedComponent(n, 2)) /
                         3.0);
  return image;
}

}  // namespace

const char* nameOf(BackEnd back_end) {
  switch (back_end) {
    case BackEnd::RayCast:
      return "ray caster";
    case BackEnd::RayCastCoarse:
      return "ray caster, unrefined";
    case BackEnd::ProcessorCast:
      return "VTK's CPU ray caster";
    case BackEnd::Mesh:
      return "mesh";
    case BackEnd::ReducedMesh:
      break;
  }
  return "reduced mesh";
}

struct Drawing::Stage {
  // the window last made is the first to go: the props' textures live in its context
  ui::VolumeProp surface;
  vtkNew<vtkVolume> processed;
  vtkNew<vtkFixedPointVolumeRayCastMapper> processor;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  double voxel_mm = 1.0;
  bool refined = true;
  std::optional<BackEnd> warm;  ///< what was drawn last

  vtkOpenGLGPUVolumeRayCastMapper* caster() const {
    return vtkOpenGLGPUVolumeRayCastMapper::SafeDownCast(surface.rayCast()->GetMapper());
  }
};

Drawing::Drawing(const datasets::Phantom& phantom, int side) : stage_(std::make_unique<Stage>()) {
  Stage& s = *stage_;
  s.voxel_mm = phantom.volume.grid.spacing.minCoeff() * ui::kMmPerM;
  const ui::Picture picture =
      ui::pictureOf(std::make_shared<const haptics::Volume>(phantom.volume));
  s.surface.show(picture);
  s.surface.setIsovalue(phantom.isovalue);
  own_sample_distance_ = s.caster()->GetSampleDistance() / s.voxel_mm;

  const auto start = std::chrono::steady_clock::now();
  const auto mesh = ui::isosurfaceMesh(picture.image, phantom.isovalue, picture.mirrored());
  meshing_ms_ = msSince(start);
  triangles_ = static_cast<int>(mesh->GetNumberOfPolys());
  s.surface.showFine(mesh, phantom.isovalue);

  // the CPU's ray caster has no isosurfaces: opacity steps up within one unit of intensity
  s.processor->SetInputData(picture.image);
  s.processor->SetAutoAdjustSampleDistances(0);
  s.processor->SetImageSampleDistance(1.0F);
  vtkVolumeProperty* property = s.processed->GetProperty();
  property->DeepCopy(s.surface.rayCast()->GetProperty());
  vtkNew<vtkPiecewiseFunction> step;
  step->AddPoint(phantom.isovalue - 0.5, 0.0);
  step->AddPoint(phantom.isovalue + 0.5, 1.0);
  property->SetScalarOpacity(step);
  s.processed->SetMapper(s.processor);
  s.processed->SetUserMatrix(s.surface.rayCast()->GetUserMatrix());

  s.renderer->SetBackground(0.0, 0.0, 0.0);
  s.renderer->AddVolume(s.surface.rayCast());
  s.renderer->AddActor(s.surface.mesh());
  s.renderer->AddVolume(s.processed);
  s.renderer->CreateLight();
  s.window->SetOffScreenRendering(1);
  s.window->SetMultiSamples(0);  // as the window's
  s.window->SetSize(side, side);
  s.window->AddRenderer(s.renderer);
}

Drawing::~Drawing() = default;

Look Drawing::look() const {
  vtkVolumeProperty* look = stage_->surface.rayCast()->GetProperty();
  return {haptics::Vec3{look->GetRGBTransferFunction()->GetColor(0.0)}, look->GetAmbient(),
          look->GetDiffuse(), look->GetSpecular(), look->GetSpecularPower()};
}

std::string Drawing::renderer() const {
  const std::string all = stage_->window->ReportCapabilities(), label = "OpenGL renderer string:";
  const auto from = all.find(label);
  if (from == std::string::npos) return "an unnamed renderer";
  const auto first = all.find_first_not_of(' ', from + label.size());
  return all.substr(first, all.find('\n', first) - first);
}

Shot Drawing::shoot(BackEnd back_end, double sample_distance, const Camera& camera,
                    const Frames& frames) {
  Stage& s = *stage_;
  const bool mesh = back_end == BackEnd::Mesh || back_end == BackEnd::ReducedMesh;
  s.surface.setMode(mesh ? ui::SurfaceMode::Mesh : ui::SurfaceMode::RayCast);
  s.surface.setMoving(back_end == BackEnd::ReducedMesh);
  // only when it changes: each time the shader is compiled anew
  if (const bool refined = back_end != BackEnd::RayCastCoarse; refined != s.refined)
    s.surface.setHitRefinement(s.refined = refined);
  s.processed->SetVisibility(back_end == BackEnd::ProcessorCast);
  if (back_end == BackEnd::ProcessorCast) s.surface.rayCast()->VisibilityOff();
  const auto distance_mm = static_cast<float>(sample_distance * s.voxel_mm);
  s.caster()->SetSampleDistance(distance_mm);
  s.processor->SetSampleDistance(distance_mm);
  s.processor->SetInteractiveSampleDistance(distance_mm);
  s.surface.update();
  // the others light the ambient share by themselves; this one asks the light for it
  const double ambient = back_end == BackEnd::ProcessorCast ? 1.0 : 0.0;
  vtkLight::SafeDownCast(s.renderer->GetLights()->GetItemAsObject(0))
      ->SetAmbientColor(ambient, ambient, ambient);

  vtkCamera* view = s.renderer->GetActiveCamera();
  view->SetPosition(camera.eye_mm.x(), camera.eye_mm.y(), camera.eye_mm.z());
  view->SetFocalPoint(camera.focus_mm.x(), camera.focus_mm.y(), camera.focus_mm.z());
  view->SetViewUp(camera.up.x(), camera.up.y(), camera.up.z());
  view->SetViewAngle(camera.angle_deg);
  s.renderer->ResetCameraClippingRange();

  // the first of a back-end compiles shaders and loads textures
  if (back_end != s.warm || frames.most == 0) {
    s.window->Render();
    s.window->WaitForCompletion();
    s.warm = back_end;
  }
  Shot shot;
  const auto start = std::chrono::steady_clock::now();
  while (static_cast<int>(shot.frames_ms.size()) < frames.least ||
         (static_cast<int>(shot.frames_ms.size()) < frames.most &&
          msSince(start) < 1000.0 * frames.seconds)) {
    const auto begin = std::chrono::steady_clock::now();
    s.window->Render();
    s.window->WaitForCompletion();  // glFinish
    shot.frames_ms.push_back(msSince(begin));
  }
  shot.image = imageOf(s.window);
  return shot;
}

}  // namespace study
