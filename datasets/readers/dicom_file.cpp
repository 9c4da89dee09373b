// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom_file.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMUtilities.h>
#include <vtkDICOMValue.h>
#include <vtkNew.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "datasets/readers/c_locale.h"
#include "datasets/readers/refusal.h"
#include "datasets/readers/vtk_errors.h"

namespace datasets {

using haptics::Expected;
using haptics::Vec3;

namespace {

constexpr std::string_view kDeflated = "1.2.840.10008.1.2.1.99";
constexpr std::string_view kFolderIndex = "1.2.840.10008.1.3.10";  // media storage directory
constexpr unsigned int kUndefinedLength = 0xffffffffu;

std::string textOf(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  std::string text = meta->Get(tag).AsString();
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

/// `wanted` numbers of an attribute; false if it has another count.
template <std::size_t N>
bool numbersOf(vtkDICOMMetaData* meta, vtkDICOMTag tag, std::array<double, N>& numbers) {
  const vtkDICOMValue& value = meta->Get(tag);
  if (!value.IsValid() || value.GetNumberOfValues() != N) return false;
  value.GetValues(numbers.data(), N);
  return true;
}

/// Syntaxes that Part 5 retired or that describe films: nobody decodes them here.
bool decodable(const std::string& syntax) {
  static constexpr std::array<std::string_view, 13> kKnown = {"1.2.840.10008.1.2",
                                                              "1.2.840.10008.1.2.1",
                                                              "1.2.840.10008.1.2.2",
                                                              "1.2.840.10008.1.2.5",
                                                              "1.2.840.10008.1.2.4.50",
                                                              "1.2.840.10008.1.2.4.51",
                                                              "1.2.840.10008.1.2.4.57",
                                                              "1.2.840.10008.1.2.4.70",
                                                              "1.2.840.10008.1.2.4.80",
                                                              "1.2.840.10008.1.2.4.81",
                                                              "1.2.840.10008.1.2.4.90",
                                                              "1.2.840.10008.1.2.4.91",
                                                              ""};
  for (const std::string_view known : kKnown)
    if (syntax == known) return true;
  return false;
}

haptics::Error fault(tl::unexpected<haptics::Error> error) { return std::move(error.value()); }

haptics::Error syntaxFault(const std::string& syntax) {
  const char* name = vtkDICOMUtilities::GetUIDName(syntax.c_str());
  const std::string known = name != nullptr && *name != '\0' ? name : "that is not known here";
  return fault(unsupported("unsupported-syntax",
                           "The images are stored in a transfer syntax (" + known +
                               ") that cannot be decoded; export them as explicit little endian."));
}

/// Whether the items of compressed pixel data end before the file does.
bool encapsulationCloses(const std::filesystem::path& path, std::int64_t begin, std::int64_t end) {
  std::ifstream in(path, std::ios::binary);
  std::int64_t at = begin;
  while (at + 8 <= end) {
    std::array<unsigned char, 8> head{};
    in.seekg(at);
    if (!in.read(reinterpret_cast<char*>(head.data()), 8)) return false;
    if (head[0] != 0xfe || head[1] != 0xff) return false;
    if (head[2] == 0xdd && head[3] == 0xe0) return true;
    if (head[2] != 0x00 || head[3] != 0xe0) return false;
    const std::int64_t length =
        head[4] | head[5] << 8 | head[6] << 16 | std::int64_t{head[7]} << 24;
    at += 8 + length;
  }
  return false;
}

std::optional<haptics::Error> pixelFault(const DicomFile& file, vtkDICOMMetaData* meta,
                                         vtkDICOMParser* parser, const std::string& syntax) {
  const int samples = meta->Get(DC::SamplesPerPixel).AsInt();
  const int frames = meta->Has(DC::NumberOfFrames) ? meta->Get(DC::NumberOfFrames).AsInt() : 1;
  const std::string meaning = textOf(meta, DC::PhotometricInterpretation);
  const auto size = static_cast<std::int64_t>(parser->GetFileSize());
  const auto begin = static_cast<std::int64_t>(parser->GetFileOffset());
  if (!parser->GetPixelDataFound()) {
    if (file.plane.rows > 0 && file.plane.columns > 0)
      return fault(malformed("no-pixels",
                             "A file of the series describes an image and ends without its pixels; "
                             "fetch it again."));
    return fault(
        unsupported("no-pixels", "The series holds no image (modality " +
                                     (file.modality.empty() ? "not stated" : file.modality) +
                                     "); choose the series of the scan."));
  }
  if (samples > 1 || meaning == "RGB" || meaning == "PALETTE COLOR")
    return fault(unsupported("not-scalar",
                             "The series holds colour pictures, which have no isosurface; choose "
                             "the series of the scan."));
  if (frames > 1 || meta->Has(DC::SharedFunctionalGroupsSequence))
    return fault(unsupported(
        "multi-frame", "The series is an enhanced multi-frame object of " + std::to_string(frames) +
                           " frames, which this version does not read; export it as one "
                           "file per slice."));
  // some files misstate their frames: then the pixels tell
  const std::int64_t needed = file.plane.rows * file.plane.columns * file.bits_allocated / 8;
  const bool compressed = parser->GetPixelDataVL() == kUndefinedLength;
  if (!compressed && needed > 0 && parser->GetPixelDataVL() >= 2 * needed)
    return fault(unsupported("multi-frame",
                             "A file of the series holds more pixels than the one slice it states; "
                             "export it as one file per slice."));
  const std::string kind = meta->Get(DC::ImageType).GetNumberOfValues() > 2
                               ? meta->Get(DC::ImageType).GetString(2)
                               : std::string();
  if (kind == "LOCALIZER")
    return fault(unsupported("localizer",
                             "The series is a scout view for planning and no stack of slices; "
                             "choose the series of the scan."));
  if (!decodable(syntax)) return syntaxFault(syntax);
  if (file.plane.rows < 1 || file.plane.columns < 1 ||
      (file.bits_allocated != 8 && file.bits_allocated != 16 && file.bits_allocated != 32))
    return fault(unsupported("bad-header", "A file of the series states " +
                                               std::to_string(file.plane.columns) + " x " +
                                               std::to_string(file.plane.rows) + " pixels of " +
                                               std::to_string(file.bits_allocated) +
                                               " bits, which is not an image that can be read."));
  const bool whole = compressed ? encapsulationCloses(file.path, begin, size)
                                : needed <= parser->GetPixelDataVL() && begin + needed <= size;
  if (!whole)
    return fault(malformed("truncated", "The file " + quoted(file.path) +
                                            " ends before its pixels do; copy or fetch it again."));
  return {};
}

/// Fills in where the slice lies; false if the file does not say.
bool placeSlice(vtkDICOMMetaData* meta, SlicePlane& plane) {
  std::array<double, 3> position{};
  std::array<double, 6> orientation{};
  std::array<double, 2> spacing{};
  if (!numbersOf(meta, DC::ImagePositionPatient, position) ||
      !numbersOf(meta, DC::ImageOrientationPatient, orientation) ||
      !numbersOf(meta, DC::PixelSpacing, spacing))
    return false;
  plane.position_mm = {position[0], position[1], position[2]};
  plane.along_row = {orientation[0], orientation[1], orientation[2]};
  plane.along_column = {orientation[3], orientation[4], orientation[5]};
  plane.row_step_mm = spacing[0];
  plane.column_step_mm = spacing[1];
  if (meta->Has(DC::SliceThickness)) plane.thickness_mm = meta->Get(DC::SliceThickness).AsDouble();
  return true;
}

void readRescale(vtkDICOMMetaData* meta, DicomFile& file) {
  if (!meta->Has(DC::RescaleSlope) || !meta->Has(DC::RescaleIntercept)) return;
  file.rescaled = true;
  file.slope = meta->Get(DC::RescaleSlope).AsDouble();
  file.intercept = meta->Get(DC::RescaleIntercept).AsDouble();
  const std::string type = textOf(meta, DC::RescaleType);
  const std::string kind = meta->Get(DC::ImageType).GetNumberOfValues() > 0
                               ? meta->Get(DC::ImageType).GetString(0)
                               : std::string();
  file.hounsfield = file.modality == "CT" && (type == "HU" || (type.empty() && kind == "ORIGINAL"));
}

}  // namespace

bool looksLikeDicom(const std::filesystem::path& path) {
  return vtkDICOMUtilities::IsDICOMFile(path.c_str());
}

std::optional<DicomFile> readDicomHeader(const std::filesystem::path& path) {
  const CLocale numbers_with_points;
  vtkNew<vtkDICOMMetaData> meta;
  vtkNew<vtkDICOMParser> parser;
  vtkNew<VtkErrors> errors;
  errors->watch(parser);
  errors->watch(meta);
  meta->SetNumberOfInstances(1);
  parser->SetMetaData(meta);
  parser->SetFileName(path.c_str());
  parser->Update();

  if (textOf(meta, DC::MediaStorageSOPClassUID) == kFolderIndex) return {};
  DicomFile file;
  file.path = path;
  file.series = textOf(meta, DC::SeriesInstanceUID);
  file.instance = textOf(meta, DC::SOPInstanceUID);
  file.modality = textOf(meta, DC::Modality);
  file.series_number = meta->Get(DC::SeriesNumber).AsInt();
  file.plane.rows = meta->Get(DC::Rows).AsInt();
  file.plane.columns = meta->Get(DC::Columns).AsInt();
  file.bits_allocated = meta->Get(DC::BitsAllocated).AsInt();
  file.bits_stored =
      meta->Has(DC::BitsStored) ? meta->Get(DC::BitsStored).AsInt() : file.bits_allocated;
  file.is_signed = meta->Get(DC::PixelRepresentation).AsInt() == 1;

  const std::string syntax = textOf(meta, DC::TransferSyntaxUID);
  if (syntax == kDeflated) {
    file.fault = syntaxFault(syntax);
    return file;
  }
  if (errors->errors() > 0 || parser->GetErrorCode() != 0) {
    file.fault =
        fault(malformed("truncated", "The header of " + quoted(path) +
                                         " is damaged or cut off; copy or fetch it again."));
    return file;
  }
  if (file.series.empty() && file.modality.empty() && file.plane.rows == 0) {
    file.fault = fault(malformed(
        "bad-header", "The header of " + quoted(path) + " cannot be understood; export it again."));
    return file;
  }
  file.fault = pixelFault(file, meta, parser, syntax);
  readRescale(meta, file);
  if (!file.fault &&
      (!std::isfinite(file.slope) || !std::isfinite(file.intercept) || file.slope == 0.0))
    file.fault = fault(malformed("bad-header",
                                 "The series states a rescale slope or intercept that cannot be "
                                 "used; export it again."));
  if (!placeSlice(meta, file.plane) && !file.fault)
    file.fault = fault(unsupported("bad-header",
                                   "The series does not say where its slices lie (position, "
                                   "orientation or pixel spacing is missing); export it again "
                                   "with its geometry."));
  return file;
}

}  // namespace datasets
