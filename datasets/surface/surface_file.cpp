// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/surface/surface_file.h"

#include <strings.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include "datasets/surface/surface_check.h"
#include "haptics/process/output_file.h"

namespace datasets {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as in memory");

constexpr std::size_t kStlHeader = 80, kStlTriangle = 50;  // bytes
constexpr std::size_t kPlyCorner = 12, kPlyTriangle = 13;
constexpr std::int64_t kMostStl = std::numeric_limits<std::uint32_t>::max();
constexpr std::int64_t kMostPly = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kAtOnce = 1 << 20;  // bytes

std::string textOf(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

/// What 3D Slicer reads, too.
std::string frameWords(const Surface& surface, SurfaceFrame frame) {
  if (!surface.volume().orientation_known) return "left and right unknown";
  return frame == SurfaceFrame::Lps ? "SPACE=LPS" : "SPACE=RAS";
}

std::string isovalueWords(const Surface& surface) {
  const std::string& unit = surface.volume().unit;
  return "isovalue " + textOf(surface.isovalue()) + (unit.empty() ? "" : " " + unit);
}

std::string plyHeaderOf(const Surface& surface, SurfaceFrame frame) {
  return "ply\nformat binary_little_endian 1.0\ncomment Palpate\ncomment " +
         frameWords(surface, frame) + "\ncomment unit mm\ncomment " + isovalueWords(surface) +
         "\nelement vertex " + std::to_string(surface.corners()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(surface.triangles()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// A file that is written in large parts.
class Buffered {
 public:
  explicit Buffered(haptics::OutputFile file) : file_{std::move(file)} {}
  void put(std::string_view bytes) {
    buffer_ += bytes;
    if (buffer_.size() < kAtOnce) return;
    file_.write(buffer_);
    buffer_.clear();
  }
  template <class T>
  void putBytes(const T& value) {
    put({reinterpret_cast<const char*>(&value), sizeof value});
  }
  haptics::OutputFile& flushed() {
    file_.write(buffer_);
    buffer_.clear();
    return file_;
  }

 private:
  haptics::OutputFile file_;
  std::string buffer_;
};

class StlTriangles : public SurfaceCheck {
 public:
  explicit StlTriangles(Buffered& file) : file_{file} {}
  void triangle(const std::array<std::int64_t, 3>& corners,
                const std::array<SurfacePoint, 3>& points) override {
    SurfaceCheck::triangle(corners, points);
    const auto vector = [&](std::size_t n) {
      return haptics::Vec3{points[n][0], points[n][1], points[n][2]};
    };
    const haptics::Vec3 normal =
        (vector(1) - vector(0)).cross(vector(2) - vector(0)).stableNormalized();
    file_.putBytes(SurfacePoint{static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                                static_cast<float>(normal.z())});
    file_.putBytes(points);
    file_.putBytes(std::uint16_t{0});
  }

 private:
  Buffered& file_;
};

class PlyCorners : public SurfaceReceiver {
 public:
  explicit PlyCorners(Buffered& file) : file_{file} {}
  void corner(const SurfacePoint& point) override { file_.putBytes(point); }

 private:
  Buffered& file_;
};

class PlyTriangles : public SurfaceCheck {
 public:
  explicit PlyTriangles(Buffered& file) : file_{file} {}
  void triangle(const std::array<std::int64_t, 3>& corners,
                const std::array<SurfacePoint, 3>& points) override {
    SurfaceCheck::triangle(corners, points);
    file_.putBytes(std::uint8_t{3});
    for (const std::int64_t n : corners) file_.putBytes(static_cast<std::int32_t>(n));
  }

 private:
  Buffered& file_;
};

class ObjCorners : public SurfaceReceiver {
 public:
  explicit ObjCorners(Buffered& file) : file_{file} {}
  void corner(const SurfacePoint& point) override {
    char line[80] = "v";
    char* end = line + 1;
    for (const float x : point) {
      *end++ = ' ';
      end = std::to_chars(end, line + sizeof line, x).ptr;
    }
    *end++ = '\n';
    file_.put({line, static_cast<std::size_t>(end - line)});
  }

 private:
  Buffered& file_;
};

class ObjTriangles : public SurfaceCheck {
 public:
  explicit ObjTriangles(Buffered& file) : file_{file} {}
  void triangle(const std::array<std::int64_t, 3>& corners,
                const std::array<SurfacePoint, 3>& points) override {
    SurfaceCheck::triangle(corners, points);
    char line[80] = "f";
    char* end = line + 1;
    for (const std::int64_t n : corners) {
      *end++ = ' ';
      end = std::to_chars(end, line + sizeof line, n + 1).ptr;
    }
    *end++ = '\n';
    file_.put({line, static_cast<std::size_t>(end - line)});
  }

 private:
  Buffered& file_;
};

/// Writes what the format has; whether the triangles are sound, or nothing: cancelled.
std::optional<bool> put(const Surface& surface, SurfaceFormat format, SurfaceFrame frame,
                        Buffered& file, const EditWatch& watch) {
  const auto inTwo = [&](SurfaceReceiver& corners, SurfaceCheck& triangles) -> std::optional<bool> {
    if (!surface.walk(frame, corners, partOf(watch, 0.0, 0.4)) ||
        !surface.walk(frame, triangles, partOf(watch, 0.4, 1.0)))
      return {};
    return triangles.holds();
  };
  if (format == SurfaceFormat::Ply) {
    file.put(plyHeaderOf(surface, frame));
    PlyCorners corners{file};
    PlyTriangles triangles{file};
    return inTwo(corners, triangles);
  }
  if (format == SurfaceFormat::Obj) {
    file.put("# Palpate\n# " + frameWords(surface, frame) + "\n# unit mm\n# " +
             isovalueWords(surface) + "\n");
    ObjCorners corners{file};
    ObjTriangles triangles{file};
    return inTwo(corners, triangles);
  }
  std::string header =
      "Palpate " + frameWords(surface, frame) + " unit mm " + isovalueWords(surface);
  header.resize(kStlHeader, ' ');
  file.put(header);
  file.putBytes(static_cast<std::uint32_t>(surface.triangles()));
  StlTriangles triangles{file};
  if (!surface.walk(frame, triangles, watch)) return {};
  return triangles.holds();
}

}  // namespace

std::optional<SurfaceFormat> surfaceFormatOf(const std::filesystem::path& file) {
  for (const SurfaceFormatName& one : kSurfaceFormats)
    if (strcasecmp(file.extension().c_str(), one.ending) == 0) return one.format;
  return {};
}

std::int64_t bytesOf(const Surface& surface, SurfaceFormat format) {
  const std::int64_t corners = surface.corners(), triangles = surface.triangles();
  switch (format) {
    case SurfaceFormat::Stl:
      return kStlHeader + 4 + kStlTriangle * triangles;
    case SurfaceFormat::Ply:
      return static_cast<std::int64_t>(plyHeaderOf(surface, SurfaceFrame::Lps).size()) +
             kPlyCorner * corners + kPlyTriangle * triangles;
    case SurfaceFormat::Obj:
      break;
  }
  // "v x y z", "f a b c", and the mean length of the numbers from 1 to `corners`
  const double longest = std::floor(std::log10(double(corners))) + 1.0;
  const double digits = longest - (std::pow(10.0, longest) - 1.0) / (9.0 * double(corners));
  return std::llround((5.0 + surface.cornerLetters()) * double(corners) +
                      (5.0 + 3.0 * digits) * double(triangles));
}

haptics::Expected<std::int64_t> writeSurface(const Surface& surface,
                                             const std::filesystem::path& out, SurfaceFormat format,
                                             SurfaceFrame frame, const EditWatch& watch) {
  const std::int64_t most = format == SurfaceFormat::Stl   ? kMostStl
                            : format == SurfaceFormat::Ply ? kMostPly
                                                           : surface.triangles();
  if (surface.triangles() > most)
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Unsupported,
                       {"surface-too-large", {std::to_string(surface.triangles())}},
                       "too-large"});
  auto opened = haptics::OutputFile::open(out);
  if (!opened) return tl::unexpected(opened.error());
  Buffered file{std::move(*opened)};
  const std::optional<bool> sound = put(surface, format, frame, file, watch);
  if (!sound)
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
  if (!*sound)
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported, {"surface-not-closed", {}}, "not-closed"});
  haptics::OutputFile& whole = file.flushed();
  if (auto closed = whole.close(); !closed) return tl::unexpected(closed.error());
  return whole.finish();
}

}  // namespace datasets
