// SPDX-License-Identifier: BSD-3-Clause
// Left is left, however a file turns its axes: one phantom without symmetry, in every orientation.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "datasets/readers/volume_reader.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "tests/support/turned_scan.h"
#include "tests/unit/datasets/nifti_bytes.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

using haptics::Mat3;
using haptics::Vec3;
using testing::DicomSlice;
using testing::voxelAt;
using testing::Workshop;

/// What the phantom is at a place of the patient, LPS: no two voxels alike.
double valueAt(const Vec3& p_mm) {
  return std::round(p_mm.x()) + 40.0 * std::round(p_mm.y()) + 1000.0 * std::round(p_mm.z());
}

constexpr std::array<int, 3> kOrientedDims{5, 6, 7};
const Vec3 kSpacing_mm{1.0, 2.0, 3.0};
const Vec3 kOrigin_mm{-3.0, 4.0, 2.0};

Vec3 placeOf(const Mat3& axes, int i, int j, int k) {
  return kOrigin_mm + axes * Vec3(i, j, k).cwiseProduct(kSpacing_mm);
}

/// The phantom's voxels, laid along these axes.
std::string voxelsAlong(const Mat3& axes) {
  std::string bytes;
  for (int k = 0; k < kOrientedDims[2]; ++k)
    for (int j = 0; j < kOrientedDims[1]; ++j)
      for (int i = 0; i < kOrientedDims[0]; ++i)
        bytes += testing::number(std::uint16_t(std::int16_t(valueAt(placeOf(axes, i, j, k)))), 2);
  return bytes;
}

void expectThePhantom(const haptics::Volume& v, const std::string& what) {
  ASSERT_EQ(v.grid.voxelCount(), kOrientedDims[0] * kOrientedDims[1] * kOrientedDims[2]) << what;
  EXPECT_TRUE(v.orientation_known) << what;
  for (std::int64_t k = 0; k < v.grid.dims[2]; ++k)
    for (std::int64_t j = 0; j < v.grid.dims[1]; ++j)
      for (std::int64_t i = 0; i < v.grid.dims[0]; ++i) {
        const Vec3 p_mm = 1e3 * v.grid.worldOf({double(i), double(j), double(k)});
        ASSERT_EQ(voxelAt(v, i, j, k), valueAt(p_mm)) << what << ", " << p_mm.transpose();
      }
}

// the third axis of a DICOM series runs along row x column: half of all orientations
TEST(Orientation, OfEveryDicomSeriesIsThePatients) {
  int series = 0;
  for (const Mat3& axes : turned::orientations()) {
    if (axes.determinant() < 0.0) continue;
    Workshop workshop;
    for (int k = 0; k < kOrientedDims[2]; ++k) {
      DicomSlice slice;
      slice.instance += "." + std::to_string(k + 1);
      slice.position_mm = placeOf(axes, 0, 0, k);
      slice.along_row = axes.col(0);
      slice.along_column = axes.col(1);
      slice.column_step_mm = kSpacing_mm.x();
      slice.row_step_mm = kSpacing_mm.y();
      slice.columns = kOrientedDims[0];
      slice.rows = kOrientedDims[1];
      for (int j = 0; j < kOrientedDims[1]; ++j)
        for (int i = 0; i < kOrientedDims[0]; ++i)
          slice.pixels.push_back(std::int16_t(valueAt(placeOf(axes, i, j, k))));
      workshop.write(std::to_string((k * 3) % kOrientedDims[2]), bytesOf(slice));
    }
    const auto v = readVolume(workshop.folder());
    ASSERT_TRUE(v) << sentence(v.error());
    EXPECT_EQ(v->grid.direction, axes);
    std::ostringstream what;
    what << "DICOM " << axes;
    expectThePhantom(*v, what.str());
    ++series;
  }
  EXPECT_EQ(series, 24);
}

TEST(Orientation, OfEveryNrrdIsThePatients) {
  // what turns the patient's LPS into the file's world
  const std::vector<std::pair<std::string, Vec3>> spaces{{"left-posterior-superior", {1, 1, 1}},
                                                         {"right-anterior-superior", {-1, -1, 1}},
                                                         {"left-anterior-superior", {1, -1, 1}}};
  for (const auto& [space, signs] : spaces)
    for (const Mat3& axes : turned::orientations()) {
      const auto vector = [&signs = signs](const Vec3& v) {
        const Vec3 w = signs.cwiseProduct(v);
        return "(" + std::to_string(w.x()) + "," + std::to_string(w.y()) + "," +
               std::to_string(w.z()) + ")";
      };
      std::string bytes = "NRRD0004\ntype: short\ndimension: 3\nspace: " + space +
                          "\nsizes: " + std::to_string(kOrientedDims[0]) + " " +
                          std::to_string(kOrientedDims[1]) + " " +
                          std::to_string(kOrientedDims[2]) + "\nspace directions:";
      for (int axis = 0; axis < 3; ++axis)
        bytes += " " + vector(axes.col(axis) * kSpacing_mm[axis]);
      bytes += "\nspace origin: " + vector(kOrigin_mm) + "\nendian: little\nencoding: raw\n\n";
      bytes += voxelsAlong(axes);
      Workshop workshop;
      const auto v = readVolume(workshop.write("phantom.nrrd", bytes));
      ASSERT_TRUE(v) << sentence(v.error());
      std::ostringstream what;
      what << space << " " << axes;
      expectThePhantom(*v, what.str());
    }
}

TEST(Orientation, OfEveryMetaImageIsThePatients) {
  for (const Mat3& axes : turned::orientations()) {
    std::ostringstream header;
    header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix =";
    // one axis after the other
    for (int axis = 0; axis < 3; ++axis) header << " " << axes.col(axis).transpose();
    header << "\nOffset = " << kOrigin_mm.transpose()
           << "\nElementSpacing = " << kSpacing_mm.transpose()
           << "\nDimSize = 5 6 7\nElementType = MET_SHORT\n"
           << "ElementDataFile = LOCAL\n";
    Workshop workshop;
    const auto v = readVolume(workshop.write("phantom.mha", header.str() + voxelsAlong(axes)));
    ASSERT_TRUE(v) << sentence(v.error());
    std::ostringstream what;
    what << "MetaImage " << axes;
    expectThePhantom(*v, what.str());
  }
}

TEST(Orientation, OfEveryNiftiFileIsThePatients) {
  const Vec3 ras(-1, -1, 1);
  for (const bool by_matrix : {true, false})
    for (const Mat3& axes : turned::orientations()) {
      const Mat3 turned = ras.asDiagonal() * axes;
      const Vec3 origin = ras.cwiseProduct(kOrigin_mm);
      testing::Nifti n;
      n.dim = {3, kOrientedDims[0], kOrientedDims[1], kOrientedDims[2], 1, 1, 1, 1};
      // a left-handed frame is a rotation of one whose third axis is turned about
      const bool mirrored = turned.determinant() < 0.0;
      n.pixdim = {mirrored ? -1.0 : 1.0, 1, 2, 3, 0, 0, 0, 0};
      if (by_matrix) {
        n.matrix_code = 1;
        for (int row = 0; row < 3; ++row) {
          for (int axis = 0; axis < 3; ++axis)
            n.matrix[std::size_t(4 * row + axis)] = turned(row, axis) * kSpacing_mm[axis];
          n.matrix[std::size_t(4 * row + 3)] = origin[row];
        }
      } else {
        n.quaternion_code = 1;
        Mat3 rotation = turned;
        if (mirrored) rotation.col(2) *= -1.0;
        Eigen::Quaterniond q(rotation);
        if (q.w() < 0.0) q.coeffs() *= -1.0;
        n.quaternion = {q.x(), q.y(), q.z()};
        n.offset = {origin.x(), origin.y(), origin.z()};
      }
      n.voxels = voxelsAlong(axes);
      Workshop workshop;
      const auto v = readVolume(workshop.write("phantom.nii", bytesOf(n)));
      ASSERT_TRUE(v) << sentence(v.error());
      std::ostringstream what;
      what << "NIfTI " << by_matrix << " " << axes;
      expectThePhantom(*v, what.str());
    }
}

}  // namespace
}  // namespace datasets
