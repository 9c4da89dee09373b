// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an NRRD: all that is done before its voxels are read, the parse by teem and the
// segments that it names included; and as a table that names labels.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/labels/label_table.h"
#include "datasets/labels/segments.h"
#include "datasets/readers/nrrd/voxels.h"
#include "tests/fuzz/require.h"
#include "tests/support/scratch_folder.h"

namespace {

/// The folder of the header, with data files that it may name.
const support::ScratchFolder& folder() {
  static const support::ScratchFolder scratch;
  static const bool filled = [] {
    scratch.write("data.raw", std::string(4096, '\1'));
    for (const char* name : {"slice_0.raw", "slice_1.raw", "slice_2.raw"})
      scratch.write(name, std::string(64, '\2'));
    return true;
  }();
  fuzz::require(filled, "the scratch folder can be written");
  return scratch;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto path =
      folder().write("volume.nhdr", std::string_view(reinterpret_cast<const char*>(bytes), size));
  if (const auto segments = datasets::segmentsOf(path))
    for (const datasets::Segment& segment : *segments) {
      const std::string& name = segment.structure.name;
      fuzz::require(segment.label > 0 && segment.layer >= 0, "a segment lies somewhere");
      fuzz::require(name.size() <= datasets::Structure::kLongestName &&
                        std::ranges::none_of(name, [](unsigned char c) { return c < 0x20; }) &&
                        datasets::shownName(name) == name,
                    "a name is plain and bounded");
    }
  else
    fuzz::require(!segments.error().message.empty() && !segments.error().reason.empty(),
                  "a refusal has a sentence and a reason");
  if (const auto table = datasets::readLabelTable(path))
    for (const auto& [number, named] : *table)
      fuzz::require(number >= 0 && datasets::shownName(named.name) == named.name,
                    "a name is plain and bounded");
  const auto nrrd = datasets::parseNrrd(path);
  if (!nrrd) {
    fuzz::require(!nrrd.error().message.empty() && !nrrd.error().reason.empty(),
                  "a refusal has a sentence and a reason");
    return 0;
  }
  const haptics::Grid& grid = nrrd->stored.grid;
  fuzz::require(grid.dims == nrrd->header.dims, "the sizes are those of the header");
  fuzz::require(grid.spacing.allFinite() && grid.spacing.minCoeff() > 0.0,
                "the spacing is positive");
  fuzz::require(grid.origin.allFinite() && grid.direction.allFinite(), "the volume lies somewhere");
  return 0;
}
