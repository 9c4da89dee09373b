// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "datasets/surface/surface.h"

namespace datasets {

enum class SurfaceFormat { Stl, Obj, Ply };

struct SurfaceFormatName {
  SurfaceFormat format;
  const char* ending;
};
inline constexpr std::array<SurfaceFormatName, 3> kSurfaceFormats{{
    {SurfaceFormat::Stl, ".stl"},
    {SurfaceFormat::Obj, ".obj"},
    {SurfaceFormat::Ply, ".ply"},
}};
/// The format that a file's ending names, in any case of its letters.
std::optional<SurfaceFormat> surfaceFormatOf(const std::filesystem::path& file);

/// Bytes of the file; of OBJ, which has numbers as text, about.
std::int64_t bytesOf(const Surface& surface, SurfaceFormat format);

/// Writes a surface in millimetres: binary STL, OBJ, or binary PLY. Its header has the frame, the
/// unit and the isovalue, and nothing of the patient. The triangles are checked while they are
/// written. If they are not closed and turned outwards, there is no file, reason "not-closed". The
/// file is written completely or not at all. Returns its size in bytes.
haptics::Expected<std::int64_t> writeSurface(const Surface& surface,
                                             const std::filesystem::path& out, SurfaceFormat format,
                                             SurfaceFrame frame, const EditWatch& watch = {});

}  // namespace datasets
