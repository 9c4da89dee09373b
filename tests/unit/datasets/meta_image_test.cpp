// SPDX-License-Identifier: BSD-3-Clause
// MetaImage: what its header means, held against VTK's own reader, and what is refused.
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkMetaImageWriter.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "datasets/readers/volume_reader.h"
#include "tests/support/sentence.h"
#include "tests/unit/datasets/packed.h"
#include "tests/unit/datasets/scans.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using haptics::ScalarType;
using haptics::Vec3;
using testing::asBytes;
using testing::deflated;
using testing::reasonFor;
using testing::swapped;
using testing::voxelAt;
using testing::Workshop;

template <class T = std::int16_t>
std::string ramp(int count = 60) {
  std::string bytes;
  for (int v = 0; v < count; ++v) bytes += asBytes(static_cast<T>(v));
  return bytes;
}

/// A header of 5 x 4 x 3 voxels, up to the name of its data file.
std::string metaHeader(const std::string& more = {}, const std::string& type = "MET_SHORT") {
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "DimSize = 5 4 3\nElementType = " +
         type + "\n" + more;
}

std::string placedMeta(const std::string& more = {}) {
  return metaHeader(
      "TransformMatrix = 0 1 0 0 0 1 -1 0 0\nOffset = 10 20 30\nCenterOfRotation = 9 9 9\n"
      "AnatomicalOrientation = AIL\nElementSpacing = 2 3 4\n" +
      more);
}

TEST(MetaImage, IsReadInEveryForm) {
  Workshop workshop;
  workshop.write("v.raw", ramp());
  workshop.write("skip.raw", "abc" + ramp());
  workshop.write("packed.zraw", deflated(ramp(), false));
  workshop.write("be.raw", swapped(ramp(), 2));
  // VTK's reader asks for the size
  const std::string compressed = "CompressedData = True\nCompressedDataSize = " +
                                 std::to_string(deflated(ramp(), false).size()) + "\n";
  const std::map<std::string, std::string> files{
      {"local.mha", placedMeta("ElementDataFile = LOCAL\n") + ramp()},
      {"crlf.mha",
       "ObjectType = Image\r\nNDims = 3\r\nBinaryData = True\r\nDimSize = 5 4 3\r\n"
       "ElementType = MET_SHORT\r\nTransformMatrix = 0 1 0 0 0 1 -1 0 0\r\n"
       "Offset = 10 20 30\r\nElementSpacing = 2 3 4\r\nElementDataFile = LOCAL\r\n" +
           ramp()},
      {"packed.mha",
       placedMeta(compressed + "ElementDataFile = LOCAL\n") + deflated(ramp(), false)},
      {"detached.mhd", placedMeta("ElementDataFile = v.raw\n")},
      {"no-end.mhd", placedMeta("ElementDataFile = v.raw")},
      {"header.mhd", placedMeta("HeaderSize = 3\nElementDataFile = skip.raw\n")},
      {"last.mhd", placedMeta("HeaderSize = -1\nElementDataFile = skip.raw\n")},
      {"packed.mhd", placedMeta(compressed + "ElementDataFile = packed.zraw\n")},
      {"be.mhd",
       "NDims = 3\nDimSize = 5 4 3\nBinaryData = True\nElementByteOrderMSB = True\n"
       "ElementType = MET_SHORT\nRotation = 0 1 0 0 0 1 -1 0 0\nPosition = 10 20 30\n"
       "ElementSpacing = 2 3 4\nElementDataFile = be.raw\n"}};
  for (const auto& [name, bytes] : files) {
    const fs::path path = workshop.write(name, bytes);
    const auto v = readVolume(path);
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    EXPECT_EQ(v->type, ScalarType::Int16);
    EXPECT_TRUE(v->orientation_known) << name;
    for (int n = 0; n < 60; ++n) ASSERT_EQ(voxelAt(*v, n % 5, n / 5 % 4, n / 20), n) << name;
    // i along y, j along z, k along -x
    EXPECT_LT((v->grid.worldOf({4, 2, 1}) - Vec3(0.006, 0.028, 0.036)).norm(), 1e-12) << name;
    const auto part = readVolume(path, {.part = {.step = 2}});
    ASSERT_TRUE(part) << name << ": " << sentence(part.error());
    EXPECT_EQ(voxelAt(*part, 2, 1, 1), 4 + 5 * (2 + 4 * 2)) << name;

    vtkNew<vtkMetaImageReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    if (name != "last.mhd") {  // which VTK reads from its beginning
      for (int n = 0; n < 60; ++n)
        ASSERT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(n % 5, n / 5 % 4, n / 20, 0), n)
            << name;
    }
  }
}

TEST(MetaImage, WhatVtkWritesIsReadWithoutASide) {
  Workshop workshop;
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 3);
  image->SetSpacing(0.5, 0.25, 2.0);
  image->SetOrigin(1, 2, 3);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int n = 0; n < 60; ++n)
    image->SetScalarComponentFromDouble(n % 5, n / 5 % 4, n / 20, 0, 0.5 * n);
  for (const bool compressed : {false, true}) {
    vtkNew<vtkMetaImageWriter> writer;
    writer->SetInputData(image);
    const fs::path path = workshop.folder() / "v.mha";
    writer->SetFileName(path.c_str());
    writer->SetCompression(compressed);
    writer->Write();
    const auto v = readVolume(path);
    ASSERT_TRUE(v) << sentence(v.error());
    for (int n = 0; n < 60; ++n) ASSERT_EQ(voxelAt(*v, n % 5, n / 5 % 4, n / 20), 0.5 * n);
    EXPECT_LT((1e3 * v->grid.spacing - Vec3(0.5, 0.25, 2.0)).norm(), 1e-12);
    EXPECT_LT((1e3 * v->grid.origin - Vec3(1, 2, 3)).norm(), 1e-12);
    // it writes a matrix without knowing one, and says so
    EXPECT_FALSE(v->orientation_known);
  }
}

TEST(MetaImage, OrientationIsKnownFromAMatrixOnly) {
  Workshop workshop;
  const auto known = [&](const std::string& fields) {
    const auto found = survey(workshop.write(
        "v.mha",
        metaHeader(fields + "ElementSpacing = 1 1 1\nElementDataFile = LOCAL\n") + ramp()));
    EXPECT_EQ(found->series.front().verdict, Verdict::Sound)
        << sentence(found->series.front().message);
    return found->series.front().reasons.empty();
  };
  const std::string matrix = "TransformMatrix = 1 0 0 0 1 0 0 0 1\n";
  EXPECT_TRUE(known(matrix));
  EXPECT_TRUE(known(matrix + "AnatomicalOrientation = RAI\n"));
  EXPECT_FALSE(known(matrix + "AnatomicalOrientation = ???\n"));
  EXPECT_FALSE(known("AnatomicalOrientation = RAI\n"));
  EXPECT_FALSE(known(""));
}

TEST(MetaImage, ASpacingThatIsAssumedIsSaid) {
  Workshop workshop;
  const auto found = survey(workshop.write(
      "v.mha",
      metaHeader("TransformMatrix = 1 0 0 0 1 0 0 0 1\nElementDataFile = LOCAL\n") + ramp()));
  ASSERT_TRUE(found);
  const SeriesVerdict& verdict = found->series.front();
  EXPECT_EQ(verdict.reasons, std::vector<std::string>{"spacing-unknown"});
  EXPECT_NE(sentence(verdict.message).find("1 mm"), std::string::npos) << sentence(verdict.message);
}

TEST(MetaImage, TypesUnitsAndValues) {
  Workshop workshop;
  const std::map<std::string, std::pair<ScalarType, std::string>> types{
      {"MET_UCHAR", {ScalarType::UInt8, ramp<std::uint8_t>()}},
      {"MET_CHAR", {ScalarType::Int8, ramp<std::int8_t>()}},
      {"MET_USHORT", {ScalarType::UInt16, ramp<std::uint16_t>()}},
      {"MET_INT", {ScalarType::Int32, ramp<std::int32_t>()}},
      {"MET_UINT", {ScalarType::UInt32, ramp<std::uint32_t>()}},
      {"MET_FLOAT", {ScalarType::Float32, ramp<float>()}},
      {"MET_DOUBLE", {ScalarType::Float32, ramp<double>()}}};
  for (const auto& [name, type] : types) {
    const auto v = readVolume(workshop.write(
        "v.mha",
        metaHeader("DistanceUnits = cm\nElementSpacing = 0.1 0.2 0.3\nModality = MET_MOD_CT\n"
                   "ElementDataFile = LOCAL\n",
                   name) +
            type.second));
    ASSERT_TRUE(v) << name << ": " << sentence(v.error());
    EXPECT_EQ(v->type, type.first) << name;
    EXPECT_EQ(voxelAt(*v, 4, 3, 2), 59) << name;
    EXPECT_EQ(v->modality, "CT");
    EXPECT_LT((1e3 * v->grid.spacing - Vec3(1, 2, 3)).norm(), 1e-12);
  }
  const auto scaled = [&](const std::string& slope, const std::string& offset) {
    auto v = readVolume(
        workshop.write("v.mha", metaHeader("ElementToIntensityFunctionSlope = " + slope +
                                           "\nElementToIntensityFunctionOffset = " + offset +
                                           "\nElementSpacing = 1 1 1\nElementDataFile = LOCAL\n") +
                                    ramp()));
    EXPECT_TRUE(v);
    return std::move(*v);
  };
  EXPECT_EQ(scaled("2", "-1024").type, ScalarType::Int16);
  EXPECT_EQ(voxelAt(scaled("2", "-1024"), 4, 3, 2), 2 * 59 - 1024);
  EXPECT_EQ(scaled("1000", "0").type, ScalarType::UInt16);
  EXPECT_EQ(voxelAt(scaled("1000", "0"), 4, 3, 2), 59000);
  EXPECT_EQ(scaled("10000", "-5").type, ScalarType::Int32);
  EXPECT_EQ(voxelAt(scaled("10000", "-5"), 4, 3, 2), 589995);
  EXPECT_EQ(scaled("0.5", "0").type, ScalarType::Float32);
  EXPECT_EQ(voxelAt(scaled("0.5", "0"), 4, 3, 2), 29.5);
}

TEST(MetaImage, NumbersAreReadWholeOrRefusedByTheNameOfTheirField) {
  Workshop workshop;
  const std::string data = "ElementDataFile = LOCAL\n";
  struct Written {
    std::string fields;
    const char* refused;  ///< the field that the sentence names; null: it is read
  };
  const Written all[] = {
      {"ElementSpacing = +1.5 .5 1e-3\n", nullptr},
      {"ElementSpacing = 1,5 1,5 2,5\n", "ElementSpacing"},
      {"ElementSpacing = 1.5mm 1.5mm 2.5mm\n", "ElementSpacing"},
      {"ElementSize = 1_5 1 1\n", "ElementSize"},
      {"ElementSpacing = 0x10 1 1\n", "ElementSpacing"},
      {"ElementSpacing = 1.5.5 1 1\n", "ElementSpacing"},
      {"ElementSpacing = 1 5 1 5 2 5\n", "ElementSpacing"},
      {"Position = 1,5 0 0\n", "Position"},
      {"Origin = 1 0\n", "Origin"},
      {"Offset = inf 0 0\n", "Offset"},
      {"TransformMatrix = 1,0 0 0 0 1 0 0 0 1\n", "TransformMatrix"},
      {"Orientation = 1 0 0 0 1 0 0 0 1mm\n", "Orientation"},
      {"HeaderSize = 0x0\n", "HeaderSize"},
      {"ElementToIntensityFunctionSlope = 1,5\n", "ElementToIntensityFunctionSlope"}};
  for (const auto& [fields, refused] : all) {
    const auto v = readVolume(workshop.write("v.mha", metaHeader(fields + data) + ramp()));
    EXPECT_EQ(v.has_value(), refused == nullptr) << fields << (v ? "" : sentence(v.error()));
    if (v || refused == nullptr) continue;
    EXPECT_EQ(v.error().reason, "bad-header") << fields;
    EXPECT_NE(sentence(v.error()).find(refused), std::string::npos)
        << fields << sentence(v.error());
  }
  for (const auto& [counts, refused] : {std::pair{"NDims = 3.0\nDimSize = 5 4 3\n", "\"NDims\""},
                                        {"NDims = 3\nDimSize = 5 4 3,0\n", "\"DimSize\""}}) {
    const auto v =
        readVolume(workshop.write("v.mha", counts + ("ElementType = MET_SHORT\n" + data) + ramp()));
    ASSERT_FALSE(v) << counts;
    EXPECT_NE(sentence(v.error()).find(refused), std::string::npos) << sentence(v.error());
  }
}

TEST(MetaImage, AShearOfATenthOfADegreeIsRoundingAndMoreIsNot) {
  Workshop workshop;
  const auto found = [&](double off_deg) {
    const double off = off_deg * std::numbers::pi / 180.0;
    std::ostringstream matrix;
    matrix.precision(9);
    // the second axis leans towards the first; the third is turned about
    matrix << "TransformMatrix = 1 0 0 " << std::sin(off) << " " << std::cos(off) << " 0 0 0 -1\n";
    return workshop.write(
        "v.mha",
        metaHeader(matrix.str() + "ElementSpacing = 1 2 3\nElementDataFile = LOCAL\n") + ramp());
  };
  const auto v = readVolume(found(0.1));
  ASSERT_TRUE(v) << sentence(v.error());
  EXPECT_LT((v->grid.direction.transpose() * v->grid.direction - haptics::Mat3::Identity()).norm(),
            1e-12);
  EXPECT_LT(v->grid.direction.determinant(), 0.0);
  EXPECT_LT((v->grid.direction.col(0) - Vec3(1, 0, 0)).norm(), 0.06 * std::numbers::pi / 180.0);
  EXPECT_NE(sentence(survey(found(0.1))->series.front().message).find("0.1 degrees off"),
            std::string::npos);
  EXPECT_EQ(reasonFor(found(0.12)), "sheared");
}

TEST(MetaImage, RefusesByName) {
  Workshop workshop;
  const auto reason = [&](const std::string& text) {
    return reasonFor(workshop.write("v.mha", text));
  };
  const std::string data = "ElementSpacing = 1 1 1\nElementDataFile = LOCAL\n";
  const std::string start = "ObjectType = Image\nBinaryData = True\n";
  EXPECT_EQ(reason(metaHeader(data) + ramp()), "");
  EXPECT_EQ(reason(""), "bad-header");
  EXPECT_EQ(reason(std::string(3000, '\0')), "bad-header");
  EXPECT_EQ(reason(metaHeader("ElementSpacing = 1 1 1\n")), "bad-header");
  EXPECT_EQ(reason(metaHeader(data) + ramp().substr(1)), "truncated");
  EXPECT_EQ(
      reason(metaHeader("CompressedData = True\n" + data) + deflated(ramp(), false).substr(0, 60)),
      "truncated");
  EXPECT_EQ(reason(metaHeader("ElementNumberOfChannels = 3\n" + data) + ramp(180)), "not-scalar");
  EXPECT_EQ(reason(metaHeader(data, "MET_LONG_LONG") + ramp(240)), "unsupported-type");
  EXPECT_EQ(reason(metaHeader(data, "MET_STRING") + ramp()), "bad-header");
  EXPECT_EQ(reason(start + "NDims = 2\nDimSize = 5 4\nElementType = MET_SHORT\n" + data + ramp()),
            "not-scalar");
  for (const char* sizes : {"-5 4 3", "0 4 3", "5 4", "5 4 x"})
    EXPECT_EQ(reason(start + "NDims = 3\nDimSize = " + sizes + "\nElementType = MET_SHORT\n" +
                     data + ramp()),
              "bad-header")
        << sizes;
  EXPECT_EQ(reason(start +
                   "NDims = 3\nDimSize = 4000000000 4000000000 4000000000\n"
                   "ElementType = MET_SHORT\n" +
                   data + ramp()),
            "too-large");
  EXPECT_EQ(reason(start +
                   "CompressedData = True\nNDims = 3\nDimSize = 2000 2000 2000\n"
                   "ElementType = MET_SHORT\n" +
                   data + ramp()),
            "truncated");
  EXPECT_EQ(reason(metaHeader("ElementSpacing = 1 0 1\nElementDataFile = LOCAL\n") + ramp()),
            "bad-header");
  EXPECT_EQ(reason(metaHeader("ElementSpacing = 1 nan 1\nElementDataFile = LOCAL\n") + ramp()),
            "bad-header");
  EXPECT_EQ(
      reason(metaHeader("TransformMatrix = 1 0 0 0.1 0.99498743710662 0 0 0 1\n" + data) + ramp()),
      "sheared");
  EXPECT_EQ(reason(metaHeader("TransformMatrix = 2 0 0 0 1 0 0 0 1\n" + data) + ramp()),
            "bad-header");
  EXPECT_EQ(reason("NDims = 3\nBinaryData = False\nDimSize = 5 4 3\nElementType = MET_SHORT\n" +
                   data + "0 1 2"),
            "unsupported-syntax");
}

TEST(MetaImage, DataFilesStayInTheHeadersFolder) {
  Workshop workshop;
  workshop.write("outside.raw", ramp());
  workshop.write("in/inside.raw", ramp());
  workshop.write("in/longer.raw", "some header" + ramp());
  fs::create_symlink(workshop.folder() / "outside.raw", workshop.folder() / "in/link.raw");
  const auto reason = [&](const std::string& data) {
    return reasonFor(workshop.write(
        "in/v.mhd", metaHeader("ElementSpacing = 1 1 1\nElementDataFile = " + data + "\n")));
  };
  EXPECT_EQ(reason("inside.raw"), "");
  EXPECT_EQ(reason("../outside.raw"), "outside-folder");
  EXPECT_EQ(reason((workshop.folder() / "in/inside.raw").string()), "outside-folder");
  EXPECT_EQ(reason("link.raw"), "outside-folder");
  EXPECT_EQ(reason("/dev/zero"), "outside-folder");
  EXPECT_EQ(reason("absent.raw"), "truncated");
  EXPECT_NE(sentence(readVolume(workshop.folder() / "in/v.mhd").error()).find("\"absent.raw\""),
            std::string::npos);
  EXPECT_EQ(reason("longer.raw"), "bad-header");
  EXPECT_EQ(reason("LIST"), "unsupported-syntax");
  EXPECT_EQ(reason("s%03d.raw 1 3 1"), "unsupported-syntax");
}

}  // namespace
}  // namespace datasets
