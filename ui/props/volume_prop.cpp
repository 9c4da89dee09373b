// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/volume_prop.h"

#include <vtkActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <QCoreApplication>
#include <algorithm>

namespace ui {
namespace {

// as a texture, 2 to 4 GB: beyond that drivers fail in ways that they do not report
constexpr std::int64_t kMostTexels = std::int64_t{1} << 30;
constexpr std::array<double, 3> kSurfaceColour{0.93, 0.88, 0.78};  // ivory; the shader below too

// VTK 9.1 shades the first sample beyond the crossing, which draws terraces. Both replacements
// lean on the text of its shader; tests/ui holds them to it.
constexpr const char* kShadeHere = "vec4 vs = vec4(s);";
constexpr const char* kRefineHit = R"(vec3 before = g_dataPos - g_dirStep;
        vec3 beyond = g_dataPos;
        bool rising = scalar[maxComp] > s;
        // a ray that begins inside the solid meets the cut face where it enters
        float first = texture3D(in_volume[0], before).r * in_volume_scale[0].r
                    + in_volume_bias[0].r;
        bool cut = rising && first > s;
        for (int bisection = 0; bisection < 6; ++bisection)
        {
          g_dataPos = 0.5 * (before + beyond);
          float here = texture3D(in_volume[0], g_dataPos).r * in_volume_scale[0].r
                     + in_volume_bias[0].r;
          if ((here > s) == rising) beyond = g_dataPos; else before = g_dataPos;
        }
        vec4 vs = vec4(s);)";
// A ray that enters the volume inside the solid meets the cut face, as the touch does.
// There the gradient says nothing: the face is lit by how squarely it is seen.
constexpr const char* kPremultiply = "g_srcColor.rgb *= g_srcColor.a;";
constexpr const char* kLightCutFace = R"(if (cut)
        {
          vec3 ray = abs(normalize(g_dirStep / in_cellStep[0] * in_cellSpacing[0]));
          vec3 edge = min(abs(g_dataPos - in_texMin[0]), abs(in_texMax[0] - g_dataPos));
          float facing = edge.x < edge.y ? (edge.x < edge.z ? ray.x : ray.z)
                                         : (edge.y < edge.z ? ray.y : ray.z);
          g_srcColor.rgb = vec3(0.93, 0.88, 0.78) * (0.15 + 0.8 * facing);
        }
        g_srcColor.rgb *= g_srcColor.a;)";
constexpr const char* kStartIndex =
    "l_initialIndex = findIsoSurfaceIndex(scalar[maxComp], l_normValues);";
constexpr const char* kStartOutside = "l_initialIndex = 0;";

QString words(const char* text) { return QCoreApplication::translate("ui::VolumeProp", text); }

}  // namespace

SurfaceChoice chooseSurface(std::optional<SurfaceMode> wish, const Graphics& graphics,
                            const haptics::Grid& grid) {
  const auto longest = *std::max_element(grid.dims.begin(), grid.dims.end());
  if (graphics.major * 10 + graphics.minor < 32)
    return {SurfaceMode::Mesh, words("OpenGL is older than 3.2")};
  if (longest > graphics.max_3d_texture || grid.voxelCount() > kMostTexels)
    return {SurfaceMode::Mesh, words("the volume is larger than the graphics can hold")};
  if (*std::min_element(grid.dims.begin(), grid.dims.end()) < 2)
    return {SurfaceMode::Mesh, words("the volume is flat")};
  if (wish) return {*wish, words("as asked for")};
  if (graphics.software()) return {SurfaceMode::Mesh, words("software graphics")};
  return {SurfaceMode::RayCast, words("drawn by the graphics card")};
}

VolumeProp::VolumeProp()
    : volume_(vtkSmartPointer<vtkVolume>::New()),
      caster_(vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New()),
      mesh_(vtkSmartPointer<vtkActor>::New()),
      mesh_mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()) {
  caster_->SetBlendModeToIsoSurface();
  caster_->SetAutoAdjustSampleDistances(0);
  caster_->SetImageSampleDistance(1.0F);  // more, and meshes beside it lose their edges
  caster_->SetUseJittering(0);
  vtkVolumeProperty* look = volume_->GetProperty();
  look->ShadeOn();
  look->SetInterpolationTypeToLinear();
  look->SetAmbient(0.15);
  look->SetDiffuse(0.8);
  look->SetSpecular(0.15);
  look->SetSpecularPower(20.0);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(0.0, kSurfaceColour[0], kSurfaceColour[1], kSurfaceColour[2]);
  look->SetColor(colour);
  vtkNew<vtkPiecewiseFunction> opaque;
  opaque->AddPoint(0.0, 1.0);
  look->SetScalarOpacity(opaque);
  volume_->SetMapper(caster_);
  volume_->VisibilityOff();
  setHitRefinement(true);

  mesh_mapper_->ScalarVisibilityOff();
  mesh_->SetMapper(mesh_mapper_);
  mesh_->GetProperty()->SetColor(kSurfaceColour[0], kSurfaceColour[1], kSurfaceColour[2]);
  mesh_->GetProperty()->SetAmbient(0.15);
  mesh_->GetProperty()->SetDiffuse(0.8);
  mesh_->GetProperty()->SetSpecular(0.15);
  mesh_->GetProperty()->SetSpecularPower(20.0);
  mesh_->VisibilityOff();
}

VolumeProp::~VolumeProp() = default;

void VolumeProp::show(const Picture& picture) {
  picture_ = picture;
  reduced_mesh_ = nullptr;
  fine_mesh_ = nullptr;
  caster_->SetInputData(picture.image);
  const double finest_mm = picture.volume->grid.spacing.minCoeff() * kMmPerM;
  caster_->SetSampleDistance(static_cast<float>(finest_mm));
  const auto X_WL = matrixOf(picture.X_WL_mm);
  volume_->SetUserMatrix(X_WL);
  mesh_->SetUserMatrix(X_WL);
  setMode(mode_);
}

void VolumeProp::setMode(SurfaceMode mode) {
  mode_ = mode;
  const bool shown = picture_.volume != nullptr;
  volume_->SetVisibility(shown && mode == SurfaceMode::RayCast);
  mesh_->SetVisibility(shown && mode == SurfaceMode::Mesh);
}

void VolumeProp::setIsovalue(double isovalue) {
  if (isovalue == isovalue_ && volume_->GetProperty()->GetIsoSurfaceValues()->GetNumberOfContours())
    return;
  isovalue_ = isovalue;
  volume_->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
  reduced_mesh_ = nullptr;
  fine_mesh_ = nullptr;
}

void VolumeProp::setMoving(bool moving) { moving_ = moving; }

void VolumeProp::showFine(vtkPolyData* mesh, double isovalue) {
  if (isovalue == isovalue_) fine_mesh_ = mesh;
}

void VolumeProp::setHitRefinement(bool on) {
  vtkShaderProperty* shader = volume_->GetShaderProperty();
  shader->ClearAllFragmentShaderReplacements();
  if (!on) return;
  shader->AddFragmentShaderReplacement(kStartIndex, false, kStartOutside, false);
  shader->AddFragmentShaderReplacement(kShadeHere, false, kRefineHit, false);
  shader->AddFragmentShaderReplacement(kPremultiply, false, kLightCutFace, false);
}

void VolumeProp::update() {
  if (mode_ != SurfaceMode::Mesh || picture_.volume == nullptr) return;
  if (fine_mesh_ != nullptr && !moving_) {
    mesh_mapper_->SetInputData(fine_mesh_);
    return;
  }
  mesh_mapper_->SetInputData(reducedMesh());
}

vtkPolyData* VolumeProp::reducedMesh() {
  if (reduced_mesh_ == nullptr)
    reduced_mesh_ = isosurfaceMesh(picture_.reduced, isovalue_, picture_.mirrored());
  return reduced_mesh_;
}

Eigen::AlignedBox3d VolumeProp::bounds_mm() {
  if (picture_.volume == nullptr) return {};
  vtkPolyData* mesh = reducedMesh();
  if (mesh->GetNumberOfPoints() == 0) return boxOf_mm(picture_.volume->grid);
  const double* b = mesh->GetBounds();
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner)
    box.extend(Eigen::Vector3d{picture_.X_WL_mm * Eigen::Vector3d{b[corner & 1],
                                                                  b[2 + ((corner >> 1) & 1)],
                                                                  b[4 + ((corner >> 2) & 1)]}});
  return box;
}

}  // namespace ui
