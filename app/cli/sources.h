// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/view_file/view_file.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"
#include "haptics/tool/point_shell.h"
#ifdef PALPATE_READERS
#include "datasets/readers/volume_reader.h"
#endif

namespace app::cli {

/// The volume of a command: a path, or a named phantom.
struct VolumeChoice {
  std::string path = {};
  std::string phantom = {};
  std::optional<int> series = {};
  bool correct = false;                ///< resample tilted or unevenly spaced slices
  bool largest_part = false;           ///< read the largest part of a series that lacks slices
  int every = 1;                       ///< read only every Nth voxel along each axis
  std::vector<std::int64_t> box = {};  ///< first and end along i, j, k; empty: all
};
/// Adds --series, --correct, --largest-part, --every and --box.
void addReading(CLI::App& command, VolumeChoice& choice);
#ifdef PALPATE_READERS
datasets::Reading readingOf(const VolumeChoice& choice);
#endif
haptics::Expected<std::shared_ptr<const haptics::Volume>> loadVolume(const VolumeChoice& choice);

/// Reads a saved view. Refuses one of another scan, by geometry and, where both are known, by hash.
haptics::Expected<ViewFile> viewOver(const std::string& path, const haptics::Volume& scan,
                                     const std::optional<VolumeHash>& hash = {});

/// Which tool: a named one, a mesh file, or a CSV of points (x,y,z in metres, one header line).
struct ToolChoice {
  std::string name = {};
  int points = 0;                        ///< 0: the mesh's vertices
  std::optional<std::string> unit = {};  ///< unit of a mesh file: m, mm, cm, in; default mm
};
/// A sentence if options contradict each other: points can be spread only over meshes, and only
/// mesh files have units.
std::optional<std::string> contradictionIn(const ToolChoice& choice);

struct LoadedTool {
  haptics::Tool tool;
  std::vector<haptics::Message> warnings;
};
haptics::Expected<LoadedTool> loadTool(const ToolChoice& choice);

/// A file that a command writes: its option and its path.
struct Target {
  std::string option;
  std::string path;
};
/// A sentence if a target is a file that the command reads, also through a link or another name, or
/// if two targets are the same.
std::optional<std::string> overwritten(const std::vector<Target>& targets,
                                       const VolumeChoice& volume,
                                       const std::vector<std::string>& inputs);

/// Rows of numbers after one line of names.
struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  std::vector<std::size_t> lines;  ///< the line of each row in its file, from 1
};
/// Reads one. Every row must begin with at least `columns` finite numbers; behind them may be texts
/// and empty fields. A first line of numbers is refused, since it would be lost.
haptics::Expected<NumberTable> readNumbers(const std::string& path, std::size_t columns);

}  // namespace app::cli
