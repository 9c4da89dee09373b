// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/meshes/tool_mesh.h"

#include <vtkAbstractPolyDataReader.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <exception>
#include <fstream>
#include <map>
#include <string_view>
#include <utility>

#include "datasets/readers/files/c_locale.h"
#include "datasets/readers/files/memory_file.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/vtk_errors.h"
#include "datasets/readers/meshes/checks.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;
using haptics::TriangleMesh;
using haptics::Vec3;

namespace {

constexpr double kLongest = 0.5;               // m, a tool above this is probably in another unit
constexpr double kShortest = 1e-3;             // m
constexpr std::uintmax_t kLargest = 1u << 30;  // bytes of a mesh file

double metresIn(MeshUnit unit) {
  switch (unit) {
    case MeshUnit::Metre:
      return 1.0;
    case MeshUnit::Millimetre:
      return 1e-3;
    case MeshUnit::Centimetre:
      return 1e-2;
    case MeshUnit::Inch:
      break;
  }
  return 25.4e-3;
}

enum class MeshFormat { Stl, Obj, Ply };

Expected<MeshFormat> meshFormatOf(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".stl") return MeshFormat::Stl;
  if (extension == ".obj") return MeshFormat::Obj;
  if (extension == ".ply") return MeshFormat::Ply;
  return unsupported("unreadable", {"mesh-format-unknown", {quoted(path)}});
}

Expected<std::string> bytesIn(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return notFound(path);
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return notFound(path);
  if (size > kLargest) return unsupported("too-large", {"mesh-too-large", {quoted(path)}});
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size)) && size > 0) return notFound(path);
  return bytes;
}

/// The polygons in the file's bytes, counted by us.
Expected<std::int64_t> countedPolygons(MeshFormat format, const fs::path& path,
                                       std::string_view bytes) {
  switch (format) {
    case MeshFormat::Stl:
      return checkStl(path, bytes);
    case MeshFormat::Obj:
      return checkObj(path, bytes);
    case MeshFormat::Ply:
      break;
  }
  return checkPly(path, bytes);
}

vtkSmartPointer<vtkAbstractPolyDataReader> readerFor(MeshFormat format) {
  switch (format) {
    case MeshFormat::Stl: {
      // merging is ours: VTK's would drop triangles before they are counted
      const auto stl = vtkSmartPointer<vtkSTLReader>::New();
      stl->MergingOff();
      return stl;
    }
    case MeshFormat::Obj:
      return vtkSmartPointer<vtkOBJReader>::New();
    case MeshFormat::Ply:
      break;
  }
  return vtkSmartPointer<vtkPLYReader>::New();
}

/// VTK's view of the file as triangles; refused where it differs from our count.
Expected<vtkSmartPointer<vtkPolyData>> triangulated(MeshFormat format, const fs::path& path,
                                                    std::string_view bytes, std::int64_t polygons) {
  const CLocale numbers_with_points;
  const auto reader = readerFor(format);
  vtkNew<VtkErrors> errors;
  errors->watch(reader);
  MemoryFile places;
  if (format == MeshFormat::Obj && !places.append(placesOfObj(bytes)))
    return unsupported("too-large", {"mesh-memory", {quoted(path)}});
  reader->SetFileName(format == MeshFormat::Obj ? places.path().c_str() : path.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
  if (errors->errors() > 0 || reader->GetErrorCode() != 0 || read == nullptr ||
      read->GetNumberOfPolys() != polygons)
    return malformed("unreadable", {"mesh-unreadable", {quoted(path)}});
  vtkNew<vtkTriangleFilter> triangles;
  errors->watch(triangles);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->SetInputData(read);
  triangles->Update();
  return vtkSmartPointer<vtkPolyData>(triangles->GetOutput());
}

/// Vertices that triangles use, equal ones merged, in metres; triangles without area in corners
/// that coincide are left out.
Expected<TriangleMesh> meshOf(const fs::path& path, vtkPolyData* poly, double metres) {
  TriangleMesh mesh;
  std::map<std::array<double, 3>, std::uint32_t> index_of;
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = poly->GetPolys();
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    cells->GetCellAtId(c, corners);
    if (corners->GetNumberOfIds() != 3) continue;
    std::array<std::uint32_t, 3> triangle{};
    for (int i = 0; i < 3; ++i) {
      std::array<double, 3> p{};
      poly->GetPoint(corners->GetId(i), p.data());
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        return malformed("non-finite", {"mesh-vertex-not-finite", {quoted(path)}});
      for (double& x : p) x += 0.0;  // one zero, without a sign
      const auto [it, is_new] =
          index_of.try_emplace(p, static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) mesh.vertices.emplace_back(p[0] * metres, p[1] * metres, p[2] * metres);
      triangle[static_cast<std::size_t>(i)] = it->second;
    }
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      mesh.triangles.push_back(triangle);
  }
  if (mesh.triangles.empty()) return malformed("no-triangle", {"mesh-no-triangle", {quoted(path)}});
  return mesh;
}

std::vector<haptics::Message> warningsOf(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  const auto open = std::ranges::count_if(uses, [](const auto& edge) { return edge.second == 1; });
  const auto crowded =
      std::ranges::count_if(uses, [](const auto& edge) { return edge.second > 2; });

  Vec3 low = mesh.vertices.front(), high = low;
  for (const Vec3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double length = (high - low).maxCoeff();

  std::vector<haptics::Message> warnings;
  if (open > 0) warnings.push_back({"mesh-open", {std::to_string(open)}});
  if (crowded > 0) warnings.push_back({"mesh-not-manifold", {std::to_string(crowded)}});
  if (length > kLongest || length < kShortest)
    warnings.push_back({"mesh-length-unusual", {brief(length * 1e3)}});
  return warnings;
}

Expected<ToolMesh> read(const fs::path& path, MeshUnit unit) {
  const auto format = meshFormatOf(path);
  if (!format) return tl::unexpected(format.error());
  const auto bytes = bytesIn(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto polygons = countedPolygons(*format, path, *bytes);
  if (!polygons) return tl::unexpected(polygons.error());
  if (*polygons == 0) return malformed("no-triangle", {"mesh-no-triangle", {quoted(path)}});
  const auto poly = triangulated(*format, path, *bytes, *polygons);
  if (!poly) return tl::unexpected(poly.error());
  auto mesh = meshOf(path, *poly, metresIn(unit));
  if (!mesh) return tl::unexpected(std::move(mesh.error()));
  ToolMesh tool{std::move(*mesh), {}};
  tool.warnings = warningsOf(tool.mesh);
  return tool;
}

}  // namespace

std::optional<MeshUnit> meshUnitNamed(std::string_view name) {
  if (name == "m") return MeshUnit::Metre;
  if (name == "mm") return MeshUnit::Millimetre;
  if (name == "cm") return MeshUnit::Centimetre;
  if (name == "in") return MeshUnit::Inch;
  return std::nullopt;
}

Expected<ToolMesh> readToolMesh(const fs::path& path, MeshUnit unit) {
  try {
    return read(path, unit);
  } catch (const std::exception&) {
    return malformed("unreadable", {"mesh-unreadable", {quoted(path)}});
  }
}

}  // namespace datasets
