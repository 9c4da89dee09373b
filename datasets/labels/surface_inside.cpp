// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/surface_inside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "datasets/labels/segments.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/meshes/tool_mesh.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;
using haptics::TriangleMesh;
using haptics::Vec3;

namespace {

/// What the file's own beginning says: the title of an STL, the comments of the other two.
struct StatedSpace {
  bool lps = false, ras = false;
};

StatedSpace spaceStatedIn(const fs::path& path) {
  constexpr std::size_t kTitle = 80, kComments = 4096;
  std::string beginning(lowered(path.extension().string()) == ".stl" ? kTitle : kComments, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(beginning.data(), std::streamsize(beginning.size()));
  beginning.resize(std::size_t(std::max(in.gcount(), std::streamsize{0})));
  return {beginning.find("SPACE=LPS") != beginning.npos,
          beginning.find("SPACE=RAS") != beginning.npos};
}

Expected<SurfaceSpace> spaceOf(const fs::path& path, std::optional<SurfaceSpace> said) {
  const StatedSpace stated = spaceStatedIn(path);
  if (!stated.lps && !stated.ras) {
    if (said) return *said;
    return unsupported("surface-space", {"surface-space-unknown", {quoted(path)}});
  }
  const SurfaceSpace space = stated.lps ? SurfaceSpace::Lps : SurfaceSpace::Ras;
  if ((stated.lps && stated.ras) || (said && *said != space))
    return unsupported("surface-space", {"surface-space-twice", {quoted(path)}});
  return space;
}

/// How many edges an odd number of triangles has: a ray could pass beside the last of them.
std::size_t openEdgesOf(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (std::size_t n = 0; n < 3; ++n)
      edges.emplace_back(std::minmax(triangle[n], triangle[(n + 1) % 3]));
  std::ranges::sort(edges);
  std::size_t open = 0;
  for (auto at = edges.begin(); at != edges.end();) {
    const auto next = std::find_if(at, edges.end(), [&](const auto& edge) { return edge != *at; });
    open += std::size_t((next - at) % 2);
    at = next;
  }
  return open;
}

/// Lines along i through a mesh whose vertices are indices of the scan.
class Crossings {
 public:
  explicit Crossings(const TriangleMesh& mesh) : mesh_(mesh) {
    for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n) order_.push_back(n);
    std::ranges::sort(order_, {}, [&](std::uint32_t n) { return lowest(n, 2); });
  }

  /// Where each line of the slice at k, which must grow from call to call, crosses the mesh: by j.
  const std::vector<std::vector<double>>& inSlice(std::int64_t k, std::int64_t lines) {
    for (; next_ < order_.size() && lowest(order_[next_], 2) <= double(k); ++next_)
      active_.push_back(order_[next_]);
    std::erase_if(active_, [&](std::uint32_t n) { return highest(n, 2) < double(k); });
    crossings_.resize(std::size_t(lines));
    for (auto& line : crossings_) line.clear();
    for (const std::uint32_t n : active_) {
      const double first = std::max(std::ceil(lowest(n, 1)), 0.0);
      const double last = std::min(std::floor(highest(n, 1)), double(lines - 1));
      for (double j = first; j <= last; ++j)
        if (isCrossed(n, j, double(k)))
          crossings_[std::size_t(j)].push_back(placeAlong(n, j, double(k)));
    }
    for (auto& line : crossings_) std::ranges::sort(line);
    return crossings_;
  }

 private:
  const Vec3& corner(std::uint32_t triangle, std::size_t n) const {
    return mesh_.vertices[mesh_.triangles[triangle][n]];
  }
  double lowest(std::uint32_t n, int axis) const {
    return std::min({corner(n, 0)[axis], corner(n, 1)[axis], corner(n, 2)[axis]});
  }
  double highest(std::uint32_t n, int axis) const {
    return std::max({corner(n, 0)[axis], corner(n, 1)[axis], corner(n, 2)[axis]});
  }

  /// Whether the line at j and k goes through a triangle: an odd number of its edges lie beyond j
  /// at k. Both triangles of an edge compute it alike, so a closed mesh is crossed in pairs, also
  /// through edges and corners.
  bool isCrossed(std::uint32_t triangle, double j, double k) const {
    bool crossed = false;
    for (std::size_t n = 0; n < 3; ++n) {
      auto [one, other] =
          std::minmax(mesh_.triangles[triangle][n], mesh_.triangles[triangle][(n + 1) % 3]);
      const Vec3 &a = mesh_.vertices[one], &b = mesh_.vertices[other];
      if ((a.z() > k) == (b.z() > k)) continue;
      const double place = a.y() + (k - a.z()) * (b.y() - a.y()) / (b.z() - a.z());
      const auto [low, high] = std::minmax(a.y(), b.y());
      if (j < std::clamp(place, low, high)) crossed = !crossed;
    }
    return crossed;
  }

  double placeAlong(std::uint32_t n, double j, double k) const {
    const Vec3& a = corner(n, 0);
    const Vec3 normal = (corner(n, 1) - a).cross(corner(n, 2) - a);
    const double i = a.x() - (normal.y() * (j - a.y()) + normal.z() * (k - a.z())) / normal.x();
    // one that the line lies in is crossed somewhere in it
    return std::isfinite(i) ? std::clamp(i, lowest(n, 0), highest(n, 0)) : lowest(n, 0);
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> order_, active_;  ///< upwards along k; those at the slice
  std::size_t next_ = 0;
  std::vector<std::vector<double>> crossings_;
};

}  // namespace

std::optional<SurfaceSpace> surfaceSpaceNamed(std::string_view name) {
  const std::string word = lowered(name);
  if (word == "lps") return SurfaceSpace::Lps;
  if (word == "ras") return SurfaceSpace::Ras;
  return {};
}

bool isSurfaceFile(const fs::path& path) {
  const std::string extension = lowered(path.extension().string());
  return extension == ".stl" || extension == ".obj" || extension == ".ply";
}

Expected<void> addSurface(LabelMap& map, const fs::path& path, std::optional<SurfaceSpace> said,
                          const ReadProgress& progress) {
  auto read = readToolMesh(path, MeshUnit::Millimetre);
  if (!read) return tl::unexpected(read.error());
  const auto space = spaceOf(path, said);
  if (!space) return tl::unexpected(space.error());
  TriangleMesh& mesh = read->mesh;
  if (const std::size_t open = openEdgesOf(mesh); open > 0)
    return unsupported("surface-open", {"surface-open", {quoted(path), std::to_string(open)}});
  const Vec3 signs = *space == SurfaceSpace::Ras ? Vec3(-1.0, -1.0, 1.0) : Vec3::Ones();
  for (Vec3& vertex : mesh.vertices) vertex = signs.cwiseProduct(vertex);
  const haptics::VoxelBox box = map.boxAround(mesh.vertices);
  const haptics::Grid& grid = map.grid();
  for (Vec3& vertex : mesh.vertices) vertex = grid.indexOf(vertex);
  const std::uint8_t number = map.add({.name = shownName(path.stem().string()),
                                       .colour = colourFarFromOthers(map.structures().size())});
  Crossings crossings(mesh);
  for (std::int64_t k = box.first[2]; k < box.end[2]; ++k) {
    if (progress.isCancelled()) return cancelled();
    progress.advanced(double(k - box.first[2]) / double(box.end[2] - box.first[2]));
    const auto& lines = crossings.inSlice(k, grid.dims[1]);
    for (std::int64_t j = 0; j < grid.dims[1]; ++j) {
      const std::vector<double>& line = lines[std::size_t(j)];
      for (std::size_t n = 0; n + 1 < line.size(); n += 2) {
        const double end = std::min(std::ceil(line[n + 1]), double(grid.dims[0]));
        for (double i = std::max(std::ceil(line[n]), 0.0); i < end; ++i)
          if (auto marked =
                  map.mark((k * grid.dims[1] + j) * grid.dims[0] + std::int64_t(i), number);
              !marked)
            return marked;
      }
    }
  }
  return {};
}

}  // namespace datasets
