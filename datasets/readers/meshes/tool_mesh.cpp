// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/meshes/tool_mesh.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <fstream>
#include <map>
#include <new>
#include <string_view>
#include <utility>

#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/vtk_errors.h"
#include "datasets/readers/meshes/polygons.h"

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

Expected<Polygons> polygonsIn(MeshFormat format, const fs::path& path, std::string_view bytes) {
  switch (format) {
    case MeshFormat::Stl:
      return readStl(path, bytes);
    case MeshFormat::Obj:
      return readObj(path, bytes);
    case MeshFormat::Ply:
      break;
  }
  return readPly(path, bytes);
}

/// The polygons as triangles, which VTK cuts them into.
Expected<vtkSmartPointer<vtkPolyData>> triangulated(const fs::path& path,
                                                    const Polygons& polygons) {
  vtkNew<vtkPoints> places;  // of float32
  for (const Polygons::Place& place : polygons.places) places->InsertNextPoint(place.data());
  vtkNew<vtkCellArray> cells;
  std::size_t begin = 0;
  for (const std::size_t end : polygons.ends) {
    cells->InsertNextCell(static_cast<int>(end - begin));
    for (; begin < end; ++begin) cells->InsertCellPoint(polygons.corners[begin]);
  }
  vtkNew<vtkPolyData> read;
  read->SetPoints(places);
  read->SetPolys(cells);
  vtkNew<VtkErrors> errors;
  vtkNew<vtkTriangleFilter> triangles;
  errors->watch(triangles);
  triangles->SetInputData(read);
  triangles->Update();
  if (errors->errors() > 0) return malformed("unreadable", {"mesh-unreadable", {quoted(path)}});
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
  const auto polygons = polygonsIn(*format, path, *bytes);
  if (!polygons) return tl::unexpected(polygons.error());
  const auto poly = triangulated(path, *polygons);
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
  } catch (const std::bad_alloc&) {
    return unsupported("too-large", {"memory-too-small", {quoted(path)}});
  } catch (const std::exception&) {
    return malformed("unreadable", {"mesh-unreadable", {quoted(path)}});
  }
}

}  // namespace datasets
