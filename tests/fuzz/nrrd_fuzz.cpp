// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as an NRRD: all that is done before its voxels are read, the parse by teem included.
#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/readers/nrrd/header.h"
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
  const auto header = datasets::readNrrdHeader(path);
  const auto description = datasets::describeNrrd(path);
  fuzz::require(header || !description, "what is described has a header");
  if (!description) {
    fuzz::require(!description.error().what.empty() && !description.error().reason.empty(),
                  "a refusal has a sentence and a reason");
    return 0;
  }
  fuzz::require(description->grid.dims == header->dims, "the sizes are those of the header");
  fuzz::require(description->grid.spacing.allFinite() && description->grid.spacing.minCoeff() > 0.0,
                "the spacing is positive");
  fuzz::require(description->grid.origin.allFinite() && description->grid.direction.allFinite(),
                "the volume lies somewhere");
  return 0;
}
