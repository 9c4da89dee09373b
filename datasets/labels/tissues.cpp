// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/tissues.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace datasets {

TissueTable tissuesOf(const LabelMap& labels, std::span<const TissueWanted> wanted) {
  std::vector<TissueTable::Part> parts;
  std::array<std::vector<std::size_t>, 256> of_code;
  for (const TissueWanted& one : wanted) {
    for (int code = 0; code < labels.codeCount(); ++code)
      if (std::ranges::binary_search(labels.structuresOf(static_cast<std::uint8_t>(code)),
                                     static_cast<std::uint8_t>(one.structure)))
        of_code[static_cast<std::size_t>(code)].push_back(parts.size());
    parts.push_back({.structure = one.structure, .energy = one.energy});
  }
  const auto& dims = labels.grid().dims;
  const std::uint8_t* row = labels.codes();
  for (std::int32_t k = 0; k < dims[2]; ++k)
    for (std::int32_t j = 0; j < dims[1]; ++j, row += dims[0])
      for (const std::uint8_t *at = row, *last = row + dims[0]; at != last;) {
        const auto* end = std::find_if(at, last, [at](std::uint8_t code) { return code != *at; });
        const auto i = static_cast<std::int32_t>(at - row);
        const auto count = static_cast<std::int32_t>(end - at);
        for (const std::size_t part : of_code[*at]) {
          auto& runs = parts[part].runs;
          // voxels beside it that belong to other structures as well have another code
          if (!runs.empty() && runs.back().k == k && runs.back().j == j &&
              runs.back().i + runs.back().count == i)
            runs.back().count += count;
          else
            runs.push_back({i, j, k, count});
        }
        at = end;
      }
  return TissueTable{dims, std::move(parts)};
}

}  // namespace datasets
