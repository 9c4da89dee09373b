// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/formats.h"

namespace app::exporting {
namespace {

constexpr Format kFormats[] = {
    {"csv", "", "CSV (Motion-BIDS)", "Tables as text, laid out as Motion-BIDS asks.",
     "Motion-BIDS: the beginning of the names", exportCsv, kCsvEndings},
    {"hdf5", ".h5", "HDF5", "One file of arrays, for programs that compute.", "HDF5 (*.h5)",
     exportHdf5},
    {"mcap", ".mcap", "MCAP", "One file of messages over time, for viewers of robots' logs.",
     "MCAP (*.mcap)", exportMcap},
};

}  // namespace

std::span<const Format> formats() { return kFormats; }

}  // namespace app::exporting
