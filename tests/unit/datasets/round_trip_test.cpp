// SPDX-License-Identifier: BSD-3-Clause
// Volumes of every kind, written as NRRD and read back.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <string>
#include <vector>

#include "datasets/readers/nrrd/writer.h"
#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/alike.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using haptics::Mat3;
using haptics::ScalarType;
using haptics::Vec3;
using testing::Workshop;

TEST(RoundTrip, EveryKindOfVolumeComesBackFromItsNrrdAlike) {
  const Mat3 turned = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Mat3 mirrored = turned * Vec3(1, 1, -1).asDiagonal();
  Workshop workshop;
  const auto out = workshop.folder() / "out.nrrd";
  for (const ScalarType type :
       {ScalarType::UInt8, ScalarType::Int8, ScalarType::UInt16, ScalarType::Int16,
        ScalarType::UInt32, ScalarType::Int32, ScalarType::Float32})
    for (const Mat3& direction : {Mat3(Mat3::Identity()), turned, mirrored})
      for (const bool known : {true, false}) {
        SCOPED_TRACE(std::string(haptics::nameOf(type)) + (known ? "" : ", without sides"));
        haptics::Grid grid;
        grid.dims = {13, 7, 5};
        grid.spacing = Vec3(0.337891e-3, 0.451171875e-3, 2.5e-3);
        grid.origin = Vec3(-0.1155, 0.00185, 0.69421);
        grid.direction = direction;
        auto voxels = haptics::allocateVoxels(13 * 7 * 5, type);
        ASSERT_TRUE(voxels);
        haptics::visitVoxels(type, voxels->get(), [](const auto* first) {
          using T = std::remove_cvref_t<decltype(*first)>;
          auto* to = const_cast<T*>(first);
          for (int n = 0; n < 13 * 7 * 5; ++n) to[n] = static_cast<T>(7.3 * (n % 17));
        });
        const bool ct = type == ScalarType::Int16;
        const auto volume = haptics::makeVolume(
            grid, type, *voxels,
            {.unit = ct ? "HU" : "", .modality = ct ? "CT" : "MR", .orientation_known = known});
        ASSERT_TRUE(volume) << sentence(volume.error());
        ASSERT_TRUE(writeNrrd(*volume, out));
        const auto back = readVolume(out);
        ASSERT_TRUE(back) << sentence(back.error());
        testing::expectAlike(*volume, *back);
      }
}

}  // namespace
}  // namespace datasets
