// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/structure_props.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <algorithm>

#include "ui/props/picture.h"

namespace ui {
namespace {

// a smoothed surface is off by half a voxel, seen aslant by more
constexpr double kForward = 0.8;      // voxels
constexpr double kMostNearer = 0.02;  // of the distance
constexpr double kAmbientOfStructure = 0.25, kDiffuseOfStructure = 0.75;

// a pattern of four by four pixels; another structure's is shifted, or two of one opacity would
// hide each other
constexpr const char* kLightHere = "//VTK::Light::Impl";
constexpr const char* kDottedLight = R"(const float limits[16] =
      float[16](0.0, 8.0, 2.0, 10.0, 12.0, 4.0, 14.0, 6.0, 3.0, 11.0, 1.0, 9.0, 15.0, 7.0, 13.0, 5.0);
  int column = (int(gl_FragCoord.x) + dotShift) % 4, row = (int(gl_FragCoord.y) + dotShift / 4) % 4;
  if (limits[column + 4 * row] + 0.5 > 16.0 * dotOpacity) discard;
  //VTK::Light::Impl)";

Eigen::Affine3d frameOf(const haptics::Grid& grid) {
  Eigen::Affine3d X_WL_mm = Eigen::Affine3d::Identity();
  X_WL_mm.linear() = grid.direction;
  X_WL_mm.translation() = grid.origin * kMmPerM;
  return X_WL_mm;
}

}  // namespace

StructureProps::StructureProps(vtkRenderer& surfaces, vtkRenderer& outlines)
    : surfaces_(surfaces), outlines_(outlines) {}

StructureProps::~StructureProps() = default;

void StructureProps::show(const Structures& shown) {
  if (shown.map != shown_.map) {
    for (const Prop& prop : props_)
      if (prop.surface != nullptr) {
        surfaces_.RemoveActor(prop.surface);
        outlines_.RemoveActor(prop.flat);
      }
    props_.assign(shown.looks.size(), {});
  }
  shown_ = shown;
  for (std::size_t number = 0; number < props_.size(); ++number) look(number);
}

void StructureProps::showShape(std::size_t number, vtkPolyData* mesh) {
  Prop& prop = props_[number];
  const auto matrix = matrixOf(frameOf(shown_.map->grid));
  for (auto* part : {&prop.surface, &prop.flat}) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->ScalarVisibilityOff();
    *part = vtkSmartPointer<vtkActor>::New();
    (*part)->SetMapper(mapper);
    (*part)->SetUserMatrix(matrix);
  }
  prop.surface->GetProperty()->SetAmbient(kAmbientOfStructure);
  prop.surface->GetProperty()->SetDiffuse(kDiffuseOfStructure);
  vtkShaderProperty* shader = prop.surface->GetShaderProperty();
  shader->AddFragmentShaderReplacement(kLightHere, true, kDottedLight, false);
  shader->GetFragmentCustomUniforms()->SetUniformi("dotShift", static_cast<int>(number * 7 % 16));
  prop.flat->GetProperty()->LightingOff();
  look(number);
  surfaces_.AddActor(prop.surface);
  outlines_.AddActor(prop.flat);
}

void StructureProps::bringForward(vtkCamera& camera) {
  if (shown_.map == nullptr) return;
  const Eigen::Affine3d X_WL_mm = frameOf(shown_.map->grid);
  const double forward_mm = kForward * shown_.map->grid.spacing.maxCoeff() * kMmPerM;
  const Eigen::Vector3d eye_mm{camera.GetPosition()}, sight{camera.GetDirectionOfProjection()};
  for (const Prop& prop : props_) {
    if (prop.surface == nullptr) continue;
    Eigen::Affine3d forward{Eigen::Translation3d(-forward_mm * sight)};
    if (!camera.GetParallelProjection()) {
      const Eigen::Vector3d middle{prop.flat->GetCenter()};
      const double nearer = std::min(kMostNearer, forward_mm / (middle - eye_mm).norm());
      forward = Eigen::Translation3d(nearer * eye_mm) * Eigen::Scaling(1.0 - nearer);
    }
    prop.surface->SetUserMatrix(matrixOf(forward * X_WL_mm));
  }
}

void StructureProps::look(std::size_t number) {
  const Prop& prop = props_[number];
  if (prop.surface == nullptr) return;
  const StructureLook& look = shown_.looks[number];
  for (vtkActor* actor : {prop.surface.Get(), prop.flat.Get()}) {
    actor->SetVisibility(look.visible);
    actor->GetProperty()->SetColor(look.colour.redF(), look.colour.greenF(), look.colour.blueF());
  }
  prop.flat->SetVisibility(look.visible && shown_.through);
  prop.surface->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf(
      "dotOpacity", static_cast<float>(look.opacity));
}

}  // namespace ui
