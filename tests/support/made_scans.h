// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/dicom_bytes.h"
#include "tests/support/places.h"
#include "tests/support/scratch_folder.h"

namespace support {

/// Scans in folders of the real ones' names, of the same kinds and sizes, for tests that need any
/// such scan. Not a head: a bright disc in air.
class MadeScans {
 public:
  MadeScans() {
    const std::string failing = "dicom_oddities/series_failing/";
    const std::string mixed = "philips_head_phantom/mixed_series_one_folder/IM";
    // a scout, two reconstructions at the same places, and a picture in colour
    one(mixed + "0001", "1", 512, 0, {}, {{8, 8, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER"}});
    for (int k = 0; k < 4; ++k) {
      one(mixed + "000" + std::to_string(2 + k), "2", 512, k, {0, 0, double(k)});
      one(mixed + "000" + std::to_string(6 + k), "3", 512, 10 + k, {0, 0, double(k)});
    }
    one(mixed + "0010", "4", 512, 0, {},
        {{0x28, 2, "US", datasets::testing::number(3, 2)}, {0x28, 4, "CS", "RGB"}});
    write("philips_head_phantom/mixed_series_one_folder/DIRFILE", "a list");
    for (int k = 0; k < 48; ++k)
      one("philips_head_phantom/bone_1mm/I" + std::to_string(100 + k), "5", 512, k,
          {0, 0, double(k)});
    for (int k = 0; k < 5; ++k) {
      one(failing + "gantrytilting/" + std::to_string(k), "6", 64, k, {0, 0.3 * k, double(k)});
      one(failing + "slicecount/" + std::to_string(k), "7", 64, k, {0, 0, double(k)});
    }
    std::string voxels;
    for (int n = 0; n < 40 * 40 * 40; ++n) {
      const int i = n % 40 - 20, j = n / 40 % 40 - 20, k = n / 1600 - 20;
      voxels += datasets::testing::number(i * i + j * j + k * k < 150 ? 900 : 100, 2);
    }
    // the same voxels on two grids
    for (const auto& [name, spacings] :
         {std::pair{"raw_le.nrrd", "1 1 1"}, std::pair{"ascii.nrrd", "1 1 1.5"}})
      write(std::string("nrrd_oddities/derived_from_tooth/") + name,
            std::string("NRRD0004\ntype: ushort\ndimension: 3\nsizes: 40 40 40\nspacings: ") +
                spacings + "\nendian: little\nencoding: raw\n\n" + voxels);
  }

  const std::filesystem::path& folder() const { return scratch_.folder(); }

 private:
  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((folder() / name).parent_path());
    std::ofstream(folder() / name, std::ios::binary) << bytes;
  }
  void one(const std::string& name, const std::string& series, int side, int kind,
           const haptics::Vec3& position_mm,
           const std::vector<datasets::testing::Element>& changes = {}) const {
    datasets::testing::DicomSlice slice;
    slice.series += "." + series;
    slice.instance += "." + series + "." + std::to_string(kind);
    slice.position_mm = position_mm;
    slice.columns = slice.rows = side;
    for (int n = 0; n < side * side; ++n) {
      const double from_middle = std::hypot(n % side - side / 2, n / side - side / 2);
      slice.pixels.push_back(
          std::int16_t(from_middle < 0.3 * side ? 800 + 10 * kind + n % 7 : -1000));
    }
    write(name, edited(bytesOf(slice), changes));
  }

  ScratchFolder scratch_;
};

/// Where the scans are: the real ones, or in their place made ones, written once.
inline const std::filesystem::path& anyScans() {
  static const std::filesystem::path folder = [] {
    if (std::filesystem::exists(places::scan())) return std::filesystem::path(places::scan());
    static const MadeScans made;
    return made.folder();
  }();
  return folder;
}

}  // namespace support
