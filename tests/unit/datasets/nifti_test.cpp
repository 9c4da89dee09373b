// SPDX-License-Identifier: BSD-3-Clause
// NIfTI: what its header means, held against VTK's own writer, and what is refused.
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/nifti_bytes.h"
#include "tests/unit/datasets/packed.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::asBytes;
using testing::deflated;
using testing::Nifti;
using testing::voxelAt;
using testing::Workshop;

/// 5 x 4 x 3 voxels, placed by a matrix: i towards anterior, j towards superior, k towards left.
Nifti placedNifti() {
  Nifti n;
  n.matrix_code = 1;
  n.matrix = {0, 0, -4, 10, 2, 0, 0, 20, 0, 3, 0, 30};
  n.pixdim = {1, 2, 3, 4, 0, 0, 0, 0};
  for (std::int16_t v = 0; v < 60; ++v) n.voxels += asBytes(v);
  return n;
}

std::string reasonFor(const Workshop& workshop, const Nifti& n) {
  const auto v = readVolume(workshop.write("v.nii", bytesOf(n)));
  return v ? "" : v.error().reason;
}

TEST(NiftiFile, IsReadInBothVersionsAndByteOrdersPackedOrNot) {
  Workshop workshop;
  for (const int version : {1, 2})
    for (const bool big : {false, true})
      for (const bool packed : {false, true}) {
        Nifti n = placedNifti();
        n.version = version;
        n.big = big;
        const std::string bytes = packed ? deflated(bytesOf(n)) : bytesOf(n);
        const fs::path path = workshop.write(packed ? "v.nii.gz" : "v.nii", bytes);
        const auto v = readVolume(path);
        ASSERT_TRUE(v) << version << big << packed << ": " << sentence(v.error());
        EXPECT_TRUE(v->orientation_known);
        EXPECT_EQ(v->type, ScalarType::Int16);
        for (int i = 0; i < 60; ++i) ASSERT_EQ(voxelAt(*v, i % 5, i / 5 % 4, i / 20), i);
        // R and A become L and P
        EXPECT_LT((v->grid.worldOf({4, 2, 1}) - Vec3(-0.006, -0.028, 0.036)).norm(), 1e-9);
        const auto part = readVolume(path, {.part = {.step = 2}});
        ASSERT_TRUE(part) << sentence(part.error());
        EXPECT_EQ(voxelAt(*part, 2, 1, 1), 4 + 5 * (2 + 4 * 2));
      }
}

TEST(NiftiFile, AQuaternionPlacesAsItsMatrixDoes) {
  Workshop workshop;
  // 120 degrees about (1, 1, 1): x to y, y to z, z to x
  for (const double mirror : {1.0, -1.0}) {
    Nifti n = placedNifti();
    n.matrix_code = 0;
    n.quaternion_code = 1;
    n.quaternion = {0.5, 0.5, 0.5};
    n.offset = {10, 20, 30};
    n.pixdim[0] = mirror;
    const fs::path path = workshop.write("v.nii", bytesOf(n));
    const auto v = readVolume(path);
    ASSERT_TRUE(v) << sentence(v.error());
    EXPECT_LT((v->grid.worldOf({4, 2, 1}) - 1e-3 * Vec3(-10 - 4 * mirror, -20 - 8, 30 + 6)).norm(),
              1e-8);
    EXPECT_EQ(voxelAt(*v, 4, 2, 1), 4 + 5 * (2 + 4 * 1));  // no slice is turned about
    // both, and alike
    n.matrix_code = 2;
    n.matrix = {0, 0, 4 * mirror, 10, 2, 0, 0, 20, 0, 3, 0, 30};
    EXPECT_EQ(reasonFor(workshop, n), "") << mirror;
    n.matrix[2] *= -1.0;
    EXPECT_EQ(reasonFor(workshop, n), "ambiguous-orientation");
    n.matrix[2] *= -1.0;
    // aligned with another scan: moved and turned a little, which says nothing of the sides
    n.matrix[3] += 30.0;
    n.matrix[6] = float(4 * mirror * std::sin(0.1));
    n.matrix[2] = float(4 * mirror * std::cos(0.1));
    EXPECT_EQ(reasonFor(workshop, n), "");  // one axis alone: the quaternion has none off
    n.matrix[6] = 0.0F;
    n.matrix[2] = float(4 * mirror);
    EXPECT_EQ(reasonFor(workshop, n), "");
    n.matrix[4] *= 1.01;
    EXPECT_EQ(reasonFor(workshop, n), "ambiguous-orientation");
  }
}

/// The turn of AQuaternionPlacesAsItsMatrixDoes, by a matrix in which i leans towards k.
Nifti shearedNifti(double off_deg, bool with_quaternion, double mirror = 1.0) {
  Nifti n = placedNifti();
  const double off = off_deg * std::numbers::pi / 180.0;
  n.matrix = {2 * std::sin(off), 0, 4 * mirror, 10, 2 * std::cos(off), 0, 0, 20, 0, 3, 0, 30};
  n.pixdim[0] = mirror;
  if (with_quaternion) n.quaternion_code = 1;
  n.quaternion = {0.5, 0.5, 0.5};
  n.offset = {10, 20, 30};
  return n;
}

TEST(NiftiFile, AShearOfATenthOfADegreeIsRoundingAndMoreIsNot) {
  Workshop workshop;
  struct Sheared {
    double off_deg;
    bool with_quaternion;
    const char* reason;
    const char* said;
  };
  const Sheared all[] = {{0.004, false, "", ""},
                         {0.1, false, "", "0.1 degrees off their right angles, which is taken"},
                         {0.1, true, "", "0.1 degrees off their right angles, which is taken"},
                         {0.12, false, "sheared", "0.12 degrees off their right angles"},
                         {0.12, true, "", "0.12 degrees off their right angles, so the qform"},
                         {5.0, true, "", "5 degrees off their right angles, so the qform"},
                         {25.0, true, "ambiguous-orientation", "by its qform and by its sform"}};
  for (const double mirror : {1.0, -1.0})
    for (const int version : {1, 2})
      for (const auto& [off_deg, with_quaternion, reason, said] : all) {
        Nifti n = shearedNifti(off_deg, with_quaternion, mirror);
        n.version = version;
        const fs::path path = workshop.write("v.nii", bytesOf(n));
        const auto found = survey(path);
        ASSERT_TRUE(found) << off_deg;
        const std::string message = sentence(found->series.front().message);
        EXPECT_NE(message.find(said), std::string::npos) << off_deg << message;
        EXPECT_EQ(message == "One evenly spaced stack.", *said == 0) << message;
        const auto v = readVolume(path);
        ASSERT_EQ(v ? "" : v.error().reason, reason) << off_deg;
        if (!v) continue;
        // R and A become L and P, and no side is swapped
        const haptics::Mat3& axes = v->grid.direction;
        EXPECT_LT((axes.transpose() * axes - haptics::Mat3::Identity()).norm(), 1e-12) << off_deg;
        EXPECT_EQ(axes.determinant() > 0.0, mirror > 0.0) << off_deg;
        const bool by_quaternion = with_quaternion && off_deg > 0.11;
        const double within = by_quaternion ? 1e-6 : off_deg * std::numbers::pi / 180.0;
        EXPECT_LT((axes.col(0) - Vec3(0, -1, 0)).norm(), within) << off_deg;
        EXPECT_LT((axes.col(1) - Vec3(0, 0, 1)).norm(), 1e-6) << off_deg;
        EXPECT_LT((axes.col(2) - Vec3(-mirror, 0, 0)).norm(), within) << off_deg;
        EXPECT_LT((v->grid.spacing - Vec3(0.002, 0.003, 0.004)).norm(), 1e-8) << off_deg;
        EXPECT_EQ(voxelAt(*v, 4, 2, 1), 4 + 5 * (2 + 4 * 1));
      }
}

TEST(NiftiFile, IsKnownByItsContentWhateverItsName) {
  Workshop workshop;
  const std::string bytes = bytesOf(placedNifti());
  for (const char* name : {"v", "V.NII", "v.hdr", "v.gz", "V.NII.GZ", "packed"}) {
    const bool packed = std::string(name).ends_with("gz") || std::string(name).ends_with("GZ") ||
                        std::string(name) == "packed";
    const auto v = readVolume(workshop.write(name, packed ? deflated(bytes) : bytes));
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    EXPECT_EQ(voxelAt(*v, 4, 3, 2), 59) << name;
  }
}

TEST(NiftiFile, WhatVtkWritesIsPlacedAsItWas) {
  Workshop workshop;
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 3);
  image->SetSpacing(0.5, 0.25, 2.0);
  image->AllocateScalars(VTK_SHORT, 1);
  for (int n = 0; n < 60; ++n) image->SetScalarComponentFromDouble(n % 5, n / 5 % 4, n / 20, 0, n);
  const double turned[16] = {0.6, -0.8, 0, 10, 0.8, 0.6, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1};
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(turned);
  for (const char* name : {"v.nii", "v.nii.gz"}) {
    vtkNew<vtkNIFTIImageWriter> writer;
    writer->SetInputData(image);
    writer->SetQFormMatrix(matrix);
    writer->SetSFormMatrix(matrix);
    const fs::path path = workshop.folder() / name;
    writer->SetFileName(path.c_str());
    writer->Write();
    const auto v = readVolume(path);
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    for (int n = 0; n < 60; ++n) ASSERT_EQ(voxelAt(*v, n % 5, n / 5 % 4, n / 20), n);
    const Vec3 ras(10 + 0.6 * 0.5 * 4 - 0.8 * 0.25 * 2, 20 + 0.8 * 0.5 * 4 + 0.6 * 0.25 * 2, 32);
    EXPECT_LT((v->grid.worldOf({4, 2, 1}) - 1e-3 * Vec3(-ras.x(), -ras.y(), ras.z())).norm(), 1e-8);
    vtkNew<vtkNIFTIImageReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    for (int n = 0; n < 60; ++n)
      ASSERT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(n % 5, n / 5 % 4, n / 20, 0),
                voxelAt(*v, n % 5, n / 5 % 4, n / 20));
  }
}

TEST(NiftiFile, WithoutAPlaceHasNoSide) {
  Workshop workshop;
  Nifti n = placedNifti();
  n.matrix_code = 0;
  auto found = survey(workshop.write("v.nii", bytesOf(n)));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->series.front().verdict, Verdict::Sound);
  EXPECT_EQ(found->series.front().reasons, std::vector<std::string>{"orientation-unknown"});
  EXPECT_LT((found->series.front().spacing_mm - Vec3(2, 3, 4)).norm(), 1e-6);
  n.units = 1;  // metres
  n.pixdim = {1, 0.002F, 0.003F, 0.004F, 0, 0, 0, 0};
  EXPECT_LT(
      (readVolume(workshop.write("v.nii", bytesOf(n)))->grid.spacing - Vec3(0.002, 0.003, 0.004))
          .norm(),
      1e-9);
  n.units = 3;  // micrometres
  n.pixdim = {1, 20, 30, 40, 0, 0, 0, 0};
  EXPECT_LT((readVolume(workshop.write("v.nii", bytesOf(n)))->grid.spacing - Vec3(2e-5, 3e-5, 4e-5))
                .norm(),
            1e-12);
}

TEST(NiftiFile, OffersItsVolumes) {
  Workshop workshop;
  Nifti n = placedNifti();
  n.dim = {4, 5, 4, 3, 2, 1, 1, 1};
  for (std::int16_t v = 100; v < 160; ++v) n.voxels += asBytes(v);
  for (const char* name : {"v.nii", "v.nii.gz"}) {
    const std::string bytes = bytesOf(n);
    const fs::path path =
        workshop.write(name, fs::path(name).extension() == ".gz" ? deflated(bytes) : bytes);
    EXPECT_EQ(readVolume(path).error().reason, "which-series");
    const auto v = readVolume(path, {.series = 1});
    ASSERT_TRUE(v) << sentence(v.error());
    EXPECT_EQ(voxelAt(*v, 4, 3, 2), 159);
  }
}

TEST(NiftiFile, RescalesAndKeepsWholeNumbersWhole) {
  Workshop workshop;
  const auto with = [&](double slope, double intercept) {
    Nifti n = placedNifti();
    n.slope = slope;
    n.intercept = intercept;
    auto v = readVolume(workshop.write("v.nii", bytesOf(n)));
    EXPECT_TRUE(v) << sentence(v.error());
    return std::move(*v);
  };
  EXPECT_EQ(voxelAt(with(0.0, 77.0), 4, 3, 2), 59);  // no slope: nothing is rescaled
  EXPECT_EQ(voxelAt(with(std::nan(""), 0.0), 4, 3, 2), 59);
  EXPECT_EQ(with(1.0, -1024.0).type, ScalarType::Int16);
  EXPECT_EQ(voxelAt(with(1.0, -1024.0), 4, 3, 2), 59 - 1024);
  EXPECT_EQ(with(1e6, 0.0).type, ScalarType::Int32);
  EXPECT_EQ(voxelAt(with(1e6, 0.0), 4, 3, 2), 59e6);
  EXPECT_EQ(with(5e7, 0.0).type, ScalarType::UInt32);
  EXPECT_EQ(with(0.25, 1.0).type, ScalarType::Float32);
  EXPECT_EQ(voxelAt(with(0.25, 1.0), 4, 3, 2), 15.75);
}

TEST(NiftiFile, RefusesByName) {
  Workshop workshop;
  const auto reason = [&](auto&& change) {
    Nifti n = placedNifti();
    change(n);
    return reasonFor(workshop, n);
  };
  EXPECT_EQ(reason([](Nifti&) {}), "");
  EXPECT_EQ(reason([](Nifti& n) { n.voxels.pop_back(); }), "truncated");
  EXPECT_EQ(reason([](Nifti& n) { n.dim = {3, 5, 4, -3, 1, 1, 1, 1}; }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.dim = {0, 5, 4, 3, 1, 1, 1, 1}; }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.dim = {9, 5, 4, 3, 1, 1, 1, 1}; }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.dim = {2, 5, 12, 1, 1, 1, 1, 1}; }), "not-scalar");
  EXPECT_EQ(reason([](Nifti& n) { n.dim = {5, 5, 4, 1, 1, 3, 1, 1}; }), "not-scalar");
  EXPECT_EQ(reason([](Nifti& n) { n.dim = {3, 30000, 30000, 30000, 1, 1, 1, 1}; }), "truncated");
  EXPECT_EQ(reason([](Nifti& n) {
              n.version = 2;
              n.dim = {3, 1LL << 40, 1LL << 40, 1LL << 40, 1, 1, 1, 1};
            }),
            "too-large");
  EXPECT_EQ(reason([](Nifti& n) { n.datatype = 128, n.bits = 24; }), "not-scalar");
  EXPECT_EQ(reason([](Nifti& n) { n.datatype = 32, n.bits = 64; }), "not-scalar");
  EXPECT_EQ(reason([](Nifti& n) { n.datatype = 1024, n.bits = 64; }), "unsupported-type");
  EXPECT_EQ(reason([](Nifti& n) { n.bits = 8; }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.first_voxel = 100; }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.first_voxel = std::nan(""); }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.first_voxel = 1e9; }), "truncated");
  EXPECT_EQ(reason([](Nifti& n) { n.matrix[1] = 0.5; }), "sheared");
  EXPECT_EQ(reason([](Nifti& n) { n.matrix[1] = std::nan(""); }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.matrix.fill(0.0); }), "bad-header");
  EXPECT_EQ(reason([](Nifti& n) {
              n.quaternion_code = 1, n.quaternion = {2, 0, 0};
            }),
            "bad-header");
  EXPECT_EQ(reason([](Nifti& n) { n.matrix_code = 0, n.pixdim[2] = -1; }), "bad-header");
  // the header of a pair, whose voxels are elsewhere
  std::string pair = bytesOf(placedNifti());
  pair[345] = 'i';
  EXPECT_EQ(readVolume(workshop.write("v.nii", pair)).error().reason, "bad-header");
  EXPECT_EQ(readVolume(workshop.write("v.hdr", pair)).error().reason, "unreadable");
  EXPECT_EQ(readVolume(workshop.write("v.nii", "")).error().reason, "bad-header");
  EXPECT_EQ(readVolume(workshop.write("v.nii.gz", deflated(bytesOf(placedNifti())).substr(0, 30)))
                .error()
                .reason,
            "bad-header");
  const std::string packed = deflated(bytesOf(placedNifti()));
  EXPECT_EQ(
      readVolume(workshop.write("v.nii.gz", packed.substr(0, packed.size() - 20))).error().reason,
      "truncated");
  Nifti huge = placedNifti();
  huge.dim = {3, 3000, 3000, 3000, 1, 1, 1, 1};
  EXPECT_EQ(readVolume(workshop.write("v.nii.gz", deflated(bytesOf(huge)))).error().reason,
            "truncated");
}

}  // namespace
}  // namespace datasets
