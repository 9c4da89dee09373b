// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/volume_prop.h"

#include <vtkActor.h>
#include <vtkCamera.h>
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
#include <vtkUniforms.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <QCoreApplication>
#include <algorithm>
#include <string>

#include "ui/props/cut_tint.h"
#include "ui/props/viewport.h"
#include "ui/style/scene_colours.h"

namespace ui {
namespace {

// as a texture, 2 to 4 GB: beyond that drivers fail in ways that they do not report
constexpr std::int64_t kMostTexels = std::int64_t{1} << 30;
constexpr float kOcclusion = 0.75F;         // share of the light that a deep place loses
constexpr float kOcclusionReach_mm = 5.0F;  // how far what takes the light may be
constexpr double kAmbient = 0.15, kDiffuse = 0.8, kSpecular = 0.15, kSpecularPower = 20.0;

// VTK 9.1 shades the first sample beyond the crossing, which draws terraces. The replacements lean
// on the text of its shader; tests/ui holds them to it. cropLeast and cropGreatest are the corners
// of the box of voxels that exist, as texture coordinates.
constexpr const char* kShadeHere = "vec4 vs = vec4(s);";
constexpr const char* kRefineHit = R"(bool beside = any(lessThan(g_dataPos, cropLeast))
                   || any(greaterThan(g_dataPos, cropGreatest));
        vec3 back = (g_dataPos - mix(cropGreatest, cropLeast, greaterThan(g_dirStep, vec3(0.0))))
                  / (abs(g_dirStep) + vec3(1e-12)) * sign(g_dirStep)
                  + vec3(equal(g_dirStep, vec3(0.0)));
        // the step before, but not before the box
        float way = clamp(min(back.x, min(back.y, back.z)), 0.0, 1.0);
        vec3 before = g_dataPos - (beside ? 1.0 : way) * g_dirStep;
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
          vec3 edge = min(abs(g_dataPos - cropLeast), abs(cropGreatest - g_dataPos))
                    / in_cellStep[0];
          float facing = edge.x < edge.y ? (edge.x < edge.z ? ray.x : ray.z)
                                         : (edge.y < edge.z ? ray.y : ray.z);
          g_srcColor.rgb = surfaceColour * (0.15 + 0.8 * facing);
        }
        else if (occlusion > 0.0)
        {
          // the light that comes from all sides: what lies above the surface takes its share
          vec3 one = in_cellStep[0];
          vec3 rise = vec3(
            texture3D(in_volume[0], g_dataPos + vec3(one.x, 0.0, 0.0)).r
              - texture3D(in_volume[0], g_dataPos - vec3(one.x, 0.0, 0.0)).r,
            texture3D(in_volume[0], g_dataPos + vec3(0.0, one.y, 0.0)).r
              - texture3D(in_volume[0], g_dataPos - vec3(0.0, one.y, 0.0)).r,
            texture3D(in_volume[0], g_dataPos + vec3(0.0, 0.0, one.z)).r
              - texture3D(in_volume[0], g_dataPos - vec3(0.0, 0.0, one.z)).r) / in_cellSpacing[0];
          vec3 outwards = -rise / max(length(rise), 1e-12);
          float lost = 0.0;
          for (int ring = 0; ring < 4; ++ring)
          {
            float reach = occlusionReach * (0.25 + 0.25 * float(ring));
            for (int side = 0; side < 4; ++side)
            {
              float turn = 1.5708 * float(side) + 0.7854 * float(ring);
              vec3 aside = normalize(cross(outwards, abs(outwards.z) < 0.8 ? vec3(0.0, 0.0, 1.0)
                                                                         : vec3(1.0, 0.0, 0.0)));
              vec3 other = cross(outwards, aside);
              vec3 along = normalize(0.6 * outwards + cos(turn) * aside + sin(turn) * other);
              vec3 there = g_dataPos + reach * along / in_cellSpacing[0] * one;
              bool within = all(greaterThan(there, cropLeast)) && all(lessThan(there, cropGreatest));
              float value = texture3D(in_volume[0], there).r * in_volume_scale[0].r
                          + in_volume_bias[0].r;
              lost += (within && value > s) ? 1.0 : 0.0;
            }
          }
          g_srcColor.rgb *= 1.0 - occlusion * lost / 16.0;
        }
        if (!cut && isCut(g_dataPos)) g_srcColor.rgb *= cutColour / max(surfaceColour, vec3(0.05));
        if (beside) g_srcColor = vec4(0.0);
        g_srcColor.rgb *= g_srcColor.a;)";
constexpr const char* kDeclarations = "//VTK::Base::Dec";
constexpr const char* kStartIndex =
    "l_initialIndex = findIsoSurfaceIndex(scalar[maxComp], l_normValues);";
// A ray begins outside the solid; what lies before the box of voxels that exist is left out. Its
// first sample is on the box: a step further, a ray near the rim of a cut has left the solid.
constexpr const char* kStartOutside = R"(l_initialIndex = 0;
      vec3 enter = (mix(cropGreatest, cropLeast, greaterThan(g_dirStep, vec3(0.0))) - g_dataPos)
                 / (abs(g_dirStep) + vec3(1e-12)) * sign(g_dirStep);
      float skipped = max(0.0, max(enter.x, max(enter.y, enter.z)) + 1e-3);
      g_dataPos += skipped * g_dirStep;
      g_currentT += skipped;)";

// A reduced mesh may have two sides of a thin wall in one place: it is lit by how squarely it is
// seen, from either side.
constexpr const char* kLitFront = "float df = max(0.0,normalVCVSOutput.z);";
constexpr const char* kLitBothSides = "float df = abs(normalVCVSOutput.z);";

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
      mesh_mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()),
      second_(vtkSmartPointer<vtkActor>::New()),
      second_mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()) {
  caster_->SetBlendModeToIsoSurface();
  caster_->SetAutoAdjustSampleDistances(0);
  caster_->SetImageSampleDistance(1.0F);  // more, and meshes beside it lose their edges
  caster_->SetUseJittering(0);
  vtkVolumeProperty* look = volume_->GetProperty();
  look->ShadeOn();
  look->SetInterpolationTypeToLinear();
  look->SetAmbient(kAmbient);
  look->SetDiffuse(kDiffuse);
  look->SetSpecular(kSpecular);
  look->SetSpecularPower(kSpecularPower);
  vtkNew<vtkPiecewiseFunction> opaque;
  opaque->AddPoint(0.0, 1.0);
  look->SetScalarOpacity(opaque);
  volume_->SetMapper(caster_);
  volume_->VisibilityOff();
  carved_.tint(*volume_);
  setHitRefinement(true);

  mesh_mapper_->ScalarVisibilityOff();
  mesh_->SetMapper(mesh_mapper_);
  second_->SetMapper(second_mapper_);
  second_mapper_->ScalarVisibilityOff();
  for (vtkActor* actor : {mesh_.Get(), second_.Get(), carved_.actor()}) {
    actor->GetProperty()->SetAmbient(kAmbient);
    actor->GetProperty()->SetDiffuse(kDiffuse);
    actor->GetProperty()->SetSpecular(kSpecular);
    actor->GetProperty()->SetSpecularPower(kSpecularPower);
    actor->GetShaderProperty()->AddFragmentShaderReplacement(kLitFront, false, kLitBothSides,
                                                             false);
    actor->VisibilityOff();
  }
  colourAll();
}

VolumeProp::~VolumeProp() = default;

void VolumeProp::show(const Picture& picture) {
  picture_ = picture;
  reduced_ = {};
  fine_mesh_ = nullptr;
  second_reduced_ = {};
  second_value_.reset();
  caster_->SetInputData(picture.image);
  const double finest_mm = picture.volume->grid.spacing.minCoeff() * kMmPerM;
  caster_->SetSampleDistance(static_cast<float>(finest_mm));
  const auto X_WL = matrixOf(picture.X_WL_mm);
  volume_->SetUserMatrix(X_WL);
  mesh_->SetUserMatrix(X_WL);
  second_->SetUserMatrix(X_WL);
  carved_.actor()->SetUserMatrix(X_WL);
  carved_.end();
  crop();
  colourAll();
  setMode(mode_);
}

void VolumeProp::replace(const Picture& picture) {
  picture_ = picture;
  reduced_ = {};
  fine_mesh_ = nullptr;
  second_reduced_ = {};
  caster_->SetInputData(picture.image);
  carved_.end();
  crop();
}

void VolumeProp::showLive(const haptics::Volume& voxels,
                          std::shared_ptr<const haptics::Volume> scan,
                          std::span<const haptics::VoxelBox> cut_before) {
  carved_.begin(voxels, std::move(scan), cut_before);
  caster_->SetInputData(imageOf(voxels));
}

void VolumeProp::renew(const Picture& picture) {
  picture_ = picture;
  reduced_ = {};
  second_reduced_ = {};
  fine_is_old_ = true;
}

void VolumeProp::crop() {
  const haptics::VoxelBox box = picture_.volume->bounds();
  const auto& dims = picture_.volume->grid.dims;
  for (std::size_t a = 0; a < 3; ++a) {
    // the centre of voxel i is at (i + 1/2) / n
    crop_least_[a] = static_cast<float>((double(box.first[a]) + 0.5) / double(dims[a]));
    crop_greatest_[a] = static_cast<float>((double(box.end[a]) - 0.5) / double(dims[a]));
  }
  tellShader();
}

void VolumeProp::tellShader() {
  vtkUniforms* uniforms = volume_->GetShaderProperty()->GetFragmentCustomUniforms();
  // VTK complains of a uniform that its shader does not use
  if (!refined_) return uniforms->RemoveAllUniforms();
  const Rgb colour = colouring_.at(isovalue_);
  uniforms->SetUniform3f("surfaceColour", colour.data());
  const Rgb cut{style::kCutFace};
  uniforms->SetUniform3f("cutColour", cut.data());
  uniforms->SetUniform3f("cropLeast", crop_least_.data());
  uniforms->SetUniform3f("cropGreatest", crop_greatest_.data());
  uniforms->SetUniformf("occlusion", occluded_ ? kOcclusion : 0.0F);
  uniforms->SetUniformf("occlusionReach", kOcclusionReach_mm);
}

void VolumeProp::setColouring(const Colouring& colouring) {
  colouring_ = colouring;
  colourAll();
}

void VolumeProp::colourAll() {
  const Rgb colour = colouring_.at(isovalue_);
  vtkNew<vtkColorTransferFunction> everywhere;
  everywhere->AddRGBPoint(0.0, colour[0], colour[1], colour[2]);
  volume_->GetProperty()->SetColor(everywhere);
  tellShader();
  mesh_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  if (!second_value_) return;
  const Rgb veil = colouring_.at(*second_value_);
  second_->GetProperty()->SetColor(veil[0], veil[1], veil[2]);
}

void VolumeProp::setOcclusion(bool on) {
  occluded_ = on;
  tellShader();
}

void VolumeProp::setSecond(std::optional<double> isovalue) {
  if (isovalue == second_value_) return;
  second_value_ = isovalue;
  second_reduced_ = {};
  colourAll();
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
  colourAll();
  volume_->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
  reduced_ = {};
  fine_mesh_ = nullptr;
}

void VolumeProp::setMoving(bool moving) { moving_ = moving; }

void VolumeProp::setBudget(std::optional<std::int64_t> triangles) {
  if (triangles == budget_) return;
  budget_ = triangles;
  reduced_.light = nullptr;
  second_reduced_.light = nullptr;
}

void VolumeProp::showFine(vtkPolyData* mesh, double isovalue) {
  if (isovalue != isovalue_) return;
  fine_mesh_ = mesh;
  fine_is_old_ = false;
}

void VolumeProp::setHitRefinement(bool on) {
  vtkShaderProperty* shader = volume_->GetShaderProperty();
  shader->ClearAllFragmentShaderReplacements();
  refined_ = on;
  tellShader();
  if (!on) return;
  shader->AddFragmentShaderReplacement(kDeclarations, true,
                                       std::string{CutTint::kDeclared} + kDeclarations, false);
  shader->AddFragmentShaderReplacement(kStartIndex, false, kStartOutside, false);
  shader->AddFragmentShaderReplacement(kShadeHere, false, kRefineHit, false);
  shader->AddFragmentShaderReplacement(kPremultiply, false, kLightCutFace, false);
}

void VolumeProp::update() {
  second_->SetVisibility(picture_.volume != nullptr && second_value_.has_value());
  if (second_->GetVisibility()) {
    secondReduced();
    second_mapper_->SetInputData(moving_ ? lightOf(second_reduced_) : second_reduced_.whole.Get());
  }
  const bool meshed = mode_ == SurfaceMode::Mesh && picture_.volume != nullptr;
  carved_.actor()->SetVisibility(meshed && !carved_.isEmpty());
  if (!meshed) {
    carved_.upload(*caster_);
    carved_.tintFor(isovalue_);
    return;
  }
  vtkPolyData* mesh = fine_mesh_;
  if (mesh == nullptr || moving_) {
    mesh = reducedMesh();
    if (moving_) mesh = lightOf(reduced_);
  }
  carved_.contour(isovalue_, picture_.mirrored(), colouring_.at(isovalue_));
  mesh_mapper_->SetInputData(carved_.beside(mesh));
}

void VolumeProp::cull(vtkCamera* camera) {
  const Eigen::Vector3d eye{camera->GetPosition()}, away{camera->GetDirectionOfProjection()};
  const auto isBeyond = [&](vtkActor* actor) {
    const double* b = actor->GetBounds();
    const Eigen::Vector3d least{b[0], b[2], b[4]}, most{b[1], b[3], b[5]};
    const double nearest =
        away.dot(0.5 * (least + most) - eye) - 0.5 * away.cwiseAbs().dot(most - least);
    return nearest > camera->GetClippingRange()[0];
  };
  // the fine mesh may be open at the faces of the volume
  const bool closed = carved_.isEmpty() && mesh_mapper_->GetInput() != fine_mesh_.Get();
  if (mesh_->GetVisibility()) mesh_->GetProperty()->SetBackfaceCulling(closed && isBeyond(mesh_));
  if (second_->GetVisibility()) second_->GetProperty()->SetBackfaceCulling(isBeyond(second_));
}

vtkPolyData* VolumeProp::reducedMesh() {
  if (reduced_.whole == nullptr)
    reduced_.whole = isosurfaceMesh(picture_.reduced, isovalue_, picture_.mirrored());
  return reduced_.whole;
}

vtkPolyData* VolumeProp::secondReduced() {
  if (second_reduced_.whole == nullptr)
    second_reduced_.whole = isosurfaceMesh(picture_.reduced, *second_value_, picture_.mirrored());
  return second_reduced_.whole;
}

vtkPolyData* VolumeProp::lightOf(Reduced& mesh) const {
  if (mesh.light == nullptr) mesh.light = budget_ ? lightMesh(mesh.whole, *budget_) : mesh.whole;
  return mesh.light;
}

vtkVolume* VolumeProp::rayCast() const { return volume_; }
vtkActor* VolumeProp::mesh() const { return mesh_; }
vtkActor* VolumeProp::secondMesh() const { return second_; }

Eigen::AlignedBox3d VolumeProp::bounds_mm() {
  if (picture_.volume == nullptr) return {};
  vtkPolyData* mesh = reducedMesh();
  if (mesh->GetNumberOfPoints() == 0) return boxOf_mm(*picture_.volume);
  const double* b = mesh->GetBounds();
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner)
    box.extend(Eigen::Vector3d{picture_.X_WL_mm * Eigen::Vector3d{b[corner & 1],
                                                                  b[2 + ((corner >> 1) & 1)],
                                                                  b[4 + ((corner >> 2) & 1)]}});
  return box;
}

std::vector<Eigen::Vector3d> VolumeProp::outline_mm() {
  std::vector<Eigen::Vector3d> outline;
  if (picture_.volume == nullptr) return outline;
  extendOutline(outline, *reducedMesh());
  if (second_value_) extendOutline(outline, *secondReduced());
  if (outline.empty())
    for (int corner = 0; corner < 8; ++corner)
      outline.push_back(
          boxOf_mm(*picture_.volume).corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  return outline;
}

/// Adds what lies farthest in 26 directions, but for a few places beyond.
void VolumeProp::extendOutline(std::vector<Eigen::Vector3d>& outline, vtkPolyData& mesh) const {
  constexpr vtkIdType kLooked = 20'000;  // points
  constexpr double kBeyond = 0.003;      // of them
  const vtkIdType count = mesh.GetNumberOfPoints(), step = std::max<vtkIdType>(1, count / kLooked);
  std::vector<Eigen::Vector3d> points;
  for (vtkIdType n = 0; n < count; n += step)
    points.emplace_back(picture_.X_WL_mm * Eigen::Vector3d{mesh.GetPoint(n)});
  if (points.empty()) return;
  const auto last = points.begin() + static_cast<std::ptrdiff_t>(
                                         (1.0 - kBeyond) * static_cast<double>(points.size() - 1));
  for (int n = 0; n < 27; ++n) {
    if (n == 13) continue;  // no direction
    const Eigen::Vector3d way{n % 3 - 1.0, n / 3 % 3 - 1.0, n / 9 - 1.0};
    std::ranges::nth_element(points, last, {}, [&](const auto& p) { return way.dot(p); });
    outline.push_back(*last);
  }
}

}  // namespace ui
