// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/tool_prop.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkQuadricDecimation.h>

#include <algorithm>
#include <cmath>

#include "ui/props/picture.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr double kWireTriangles = 90.0;
constexpr double kApart = 3e-4;  // m

vtkSmartPointer<vtkPolyData> polyDataOf(const haptics::TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  for (const haptics::Vec3& v : mesh.vertices) points->InsertNextPoint((v * kMmPerM).eval().data());
  vtkNew<vtkCellArray> cells;
  for (const auto& t : mesh.triangles) {
    const vtkIdType ids[3] = {t[0], t[1], t[2]};
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  if (!mesh.triangles.empty()) {
    data->SetPolys(cells);
    return data;
  }
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) cells->InsertNextCell(1, &i);
  data->SetVerts(cells);
  return data;
}

// 10 µm or a tenth of a degree: less than a pixel in any view of a patient
bool visiblyApart(const haptics::Pose& a, const haptics::Pose& b) {
  return (a.translation() - b.translation()).norm() > 1e-5 ||
         (a.linear() - b.linear()).cwiseAbs().maxCoeff() > 2e-3;
}

}  // namespace

ToolProp::ToolProp()
    : proxy_(vtkSmartPointer<vtkActor>::New()), device_(vtkSmartPointer<vtkActor>::New()) {
  vtkProperty* solid = proxy_->GetProperty();
  // steel, bluish against bone: what faces the viewer shines, what does not is still not black
  solid->SetColor(style::kProxy[0], style::kProxy[1], style::kProxy[2]);
  solid->SetAmbient(0.30);
  solid->SetDiffuse(0.70);
  solid->SetSpecular(0.55);
  solid->SetSpecularPower(28.0);
  solid->SetPointSize(4.0F);
  vtkProperty* wire = device_->GetProperty();
  wire->SetColor(style::kDevice[0], style::kDevice[1], style::kDevice[2]);
  wire->SetRepresentationToWireframe();
  wire->LightingOff();
  wire->SetPointSize(3.0F);
  proxy_->VisibilityOff();
  device_->VisibilityOff();
}

ToolProp::~ToolProp() = default;

bool ToolProp::setTurning(bool turning) {
  if (turning == turning_) return false;
  turning_ = turning;
  const auto& colour = turning ? style::kTurning : style::kProxy;
  proxy_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  return true;
}

void ToolProp::show(const haptics::TriangleMesh& mesh) {
  auto data = polyDataOf(mesh);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SetFeatureAngle(40.0);
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> solid;
  if (mesh.triangles.empty())
    solid->SetInputData(data);
  else
    solid->SetInputConnection(normals->GetOutputPort());
  solid->ScalarVisibilityOff();
  proxy_->SetMapper(solid);
  vtkNew<vtkPolyDataMapper> wire;
  // few lines: a dense wireframe would hide the proxy that it stands over
  vtkNew<vtkQuadricDecimation> coarse;
  const auto triangles = static_cast<double>(mesh.triangles.size());
  coarse->SetInputData(data);
  coarse->SetTargetReduction(1.0 - kWireTriangles / std::max(triangles, kWireTriangles));
  if (triangles > kWireTriangles)
    wire->SetInputConnection(coarse->GetOutputPort());
  else
    wire->SetInputData(data);
  wire->ScalarVisibilityOff();
  device_->SetMapper(wire);
  radius_ = 0.0;
  for (const haptics::Vec3& v : mesh.vertices) radius_ = std::max(radius_, v.norm());
  shown_ = true;
  proxy_->VisibilityOn();
  showDevice();
}

void ToolProp::showDevice() {
  const double turned = Eigen::AngleAxisd{X_WP_.linear().transpose() * X_WD_.linear()}.angle();
  const double apart =
      (X_WP_.translation() - X_WD_.translation()).norm() + std::abs(turned) * radius_;
  // it does not come and go at the limit
  const double limit = device_->GetVisibility() != 0 ? 0.8 * kApart : kApart;
  device_->SetVisibility(shown_ && (!only_apart_ || apart > limit));
}

bool ToolProp::deviceShown() const { return device_->GetVisibility() != 0; }
vtkActor* ToolProp::proxy() const { return proxy_; }
vtkActor* ToolProp::device() const { return device_; }

bool ToolProp::move(const haptics::Pose& X_WP, const haptics::Pose& X_WD) {
  if (!visiblyApart(X_WP, X_WP_) && !visiblyApart(X_WD, X_WD_)) return false;
  X_WP_ = X_WP;
  X_WD_ = X_WD;
  proxy_->SetUserMatrix(matrixOf(X_WP));
  device_->SetUserMatrix(matrixOf(X_WD));
  showDevice();
  return true;
}

}  // namespace ui
