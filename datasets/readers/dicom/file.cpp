// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/file.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMTagPath.h>
#include <vtkDICOMUtilities.h>
#include <vtkDICOMValue.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/readers/dicom/codestream.h"
#include "datasets/readers/dicom/elements.h"
#include "datasets/readers/dicom/numbers.h"
#include "datasets/readers/dicom/parsed.h"
#include "datasets/readers/dicom/rewritten_file.h"
#include "datasets/readers/files/c_locale.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/vtk_errors.h"

namespace datasets {

using haptics::Expected;
using haptics::Vec3;

namespace {

constexpr std::string_view kFolderIndex = "1.2.840.10008.1.3.10";  // media storage directory
constexpr std::string_view kDose = "1.2.840.10008.5.1.4.1.1.481.2";
constexpr std::string_view kBigEndianSyntax = "1.2.840.10008.1.2.2";
constexpr std::string_view kContours = "1.2.840.10008.5.1.4.1.1.481.3";
constexpr std::string_view kSegments = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr std::string_view kSegmentMap = "1.2.840.10008.5.1.4.1.1.66.7";
constexpr unsigned int kUndefinedLength = 0xffffffffu;
constexpr int kMostFrames = 65'535;

/// A text in the file's character set, as UTF-8.
std::string shownText(vtkDICOMMetaData* meta, vtkDICOMTag tag) {
  std::string text = meta->Get(tag).AsUTF8String();
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

haptics::Error fault(tl::unexpected<haptics::Error> error) { return std::move(error.value()); }

haptics::Error senseless(const DicomFile& file, const char* attribute) {
  return fault(
      malformed("bad-header", {"dicom-number-unreadable", {quoted(file.path), attribute}}));
}

/// As many numbers as asked for, where the element is there.
template <std::size_t N>
std::optional<haptics::Error> readNumbers(const DicomFile& file, const char* attribute,
                                          const vtkDICOMValue& value,
                                          std::optional<std::array<double, N>>& numbers) {
  const auto all = numbersIn(value);
  if (!all || (!all->empty() && all->size() != N)) return senseless(file, attribute);
  if (all->empty()) return {};
  numbers.emplace();
  std::ranges::copy(*all, numbers->begin());
  return {};
}

/// Syntaxes that Part 5 retired or that describe films: nobody decodes them here.
bool decodable(const std::string& syntax) {
  static constexpr std::array<std::string_view, 4> kPlain = {
      "1.2.840.10008.1.2", "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.2", ""};
  return codingOf(syntax).has_value() || std::ranges::find(kPlain, syntax) != kPlain.end();
}

haptics::Error syntaxFault(const std::string& syntax) {
  constexpr std::size_t kLongest = 64;
  if (syntax.size() > kLongest || syntax.find_first_not_of("0123456789.") != syntax.npos)
    return fault(unsupported("unsupported-syntax", {"dicom-syntax-no-identifier", {}}));
  const char* name = vtkDICOMUtilities::GetUIDName(syntax.c_str());
  if (name == nullptr || *name == '\0')
    return fault(unsupported("unsupported-syntax", {"dicom-syntax-unknown", {syntax}}));
  return fault(
      unsupported("unsupported-syntax", {"dicom-syntax-unknown", {syntax + " (" + name + ")"}}));
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

/// Whether a program that took the file for text has put a carriage return before each line feed:
/// what follows `begin` has no line feed without one, and as many bytes too many.
bool isTextModeCopy(const std::filesystem::path& path, std::int64_t begin, std::int64_t too_many) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(begin);
  std::vector<char> block(std::size_t{1} << 16);
  std::int64_t feeds = 0;
  char before = 0;
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    for (const char c : std::span{block.data(), static_cast<std::size_t>(in.gcount())}) {
      if (c == '\n' && before != '\r') return false;
      feeds += c == '\n' ? 1 : 0;
      before = c;
    }
  return feeds > 0 && feeds <= too_many;
}

/// Of a file whose pixels are not compressed: what follows them must be elements, or nothing.
std::optional<haptics::Error> checkBehindPixels(const DicomFile& file, std::int64_t begin,
                                                std::int64_t end, std::int64_t size) {
  if (file.rewritten || size <= end) return {};
  if (isTextModeCopy(file.path, begin, size - end))
    return fault(malformed("truncated", {"dicom-copied-as-text", {quoted(file.path)}}));
  constexpr std::int64_t kElementHead = 8;
  if (size - end >= kElementHead) return {};  // its elements have been looked at
  std::ifstream in(file.path, std::ios::binary);
  in.seekg(end);
  for (char c = 0; in.get(c);)
    if (c != '\0') return fault(malformed("truncated", {"file-damaged", {quoted(file.path)}}));
  return {};
}

std::optional<haptics::Error> pixelFault(const DicomFile& file, vtkDICOMMetaData* meta,
                                         vtkDICOMParser* parser) {
  const int samples = meta->Get(DC::SamplesPerPixel).AsInt();
  const std::string meaning = textOf(meta, DC::PhotometricInterpretation);
  const auto size = static_cast<std::int64_t>(parser->GetFileSize());
  const auto begin = static_cast<std::int64_t>(parser->GetFileOffset());
  if (!parser->GetPixelDataFound()) {
    if (file.plane.rows > 0 && file.plane.columns > 0)
      return fault(malformed("no-pixels", {"dicom-pixels-missing", {}}));
    return fault(unsupported("no-pixels", {"dicom-no-image", {}}));
  }
  if (samples > 1 || meaning == "RGB" || meaning == "PALETTE COLOR")
    return fault(unsupported("not-scalar", {"dicom-colour", {}}));
  const auto cutOff = [&] {
    return fault(malformed("truncated", {"file-damaged", {quoted(file.path)}}));
  };
  if (file.frame_count > size) return cutOff();
  if (file.frame_count > kMostFrames)
    return fault(unsupported("too-large", {"dicom-pixels-impossible", {quoted(file.path)}}));
  constexpr std::int64_t kMostSide = 65'535;
  if (file.plane.rows > kMostSide || file.plane.columns > kMostSide || file.bits_allocated > 64 ||
      file.plane.rows < 0 || file.plane.columns < 0 || file.bits_allocated < 0)
    return fault(malformed("bad-header", {"dicom-pixels-impossible", {quoted(file.path)}}));
  const bool are_bits = file.bits_allocated == 1;  // of segments, one frame's behind another's
  const std::int64_t slice = file.plane.rows * file.plane.columns * file.bits_allocated / 8;
  const std::int64_t needed =
      (file.plane.rows * file.plane.columns * file.bits_allocated * file.frame_count + 7) / 8;
  const bool compressed = parser->GetPixelDataVL() == kUndefinedLength;
  // some files misstate their frames: then the pixels tell
  if (!compressed && !are_bits && needed > 0 && parser->GetPixelDataVL() >= needed + slice)
    return fault(malformed("bad-header", {"dicom-more-pixels-than-slices", {}}));
  const std::string kind = meta->Get(DC::ImageType).GetNumberOfValues() > 2
                               ? meta->Get(DC::ImageType).GetString(2)
                               : std::string();
  if (kind == "LOCALIZER") return fault(unsupported("localizer", {"dicom-scout", {}}));
  if (!decodable(file.syntax) ||
      (are_bits && (codingOf(file.syntax) || file.syntax == kBigEndianSyntax)))
    return syntaxFault(file.syntax);
  // pixels without a length are compressed, and the other way round
  if (compressed != codingOf(file.syntax).has_value())
    return fault(malformed("bad-header", {"dicom-pixels-stored-otherwise", {quoted(file.path)}}));
  if (file.plane.rows < 1 || file.plane.columns < 1 ||
      (file.bits_allocated != 8 && file.bits_allocated != 16 && file.bits_allocated != 32 &&
       !(are_bits && file.sop_class == kSegments)))
    return fault(unsupported("bad-header",
                             {"dicom-pixel-format",
                              {std::to_string(file.plane.columns), std::to_string(file.plane.rows),
                               std::to_string(file.bits_allocated)}}));
  // a frame takes a fragment at least, whose head has 8 bytes
  const bool whole = compressed ? encapsulationCloses(file.path, begin, size) &&
                                      file.frame_count <= (size - begin) / 8
                                : needed <= parser->GetPixelDataVL() && begin + needed <= size;
  if (!whole) return cutOff();
  if (compressed) return {};
  return checkBehindPixels(file, begin, begin + parser->GetPixelDataVL(), size);
}

haptics::Error unplaced() { return fault(unsupported("bad-header", {"dicom-place-missing", {}})); }

std::optional<haptics::Error> readRescale(vtkDICOMMetaData* meta, DicomFile& file) {
  const auto transformation = [&](vtkDICOMTag tag) -> const vtkDICOMValue& {
    return ofFrame(meta, file.frame, DC::PixelValueTransformationSequence, tag);
  };
  if (itemOf(transformation(DC::ModalityLUTSequence), 0) != nullptr)
    return fault(unsupported("unsupported-type", {"dicom-value-table", {quoted(file.path)}}));
  std::optional<std::array<double, 1>> slope, intercept;
  if (auto bad = readNumbers(file, "rescale slope", transformation(DC::RescaleSlope), slope))
    return bad;
  if (auto bad =
          readNumbers(file, "rescale intercept", transformation(DC::RescaleIntercept), intercept))
    return bad;
  if (slope.has_value() != intercept.has_value())
    return fault(malformed("bad-header", {"dicom-rescale-unusable", {quoted(file.path)}}));
  if (!slope) return {};
  file.rescaled = true;
  file.slope = slope->front();
  file.intercept = intercept->front();
  if (file.slope == 0.0)
    return fault(malformed("bad-header", {"dicom-rescale-unusable", {quoted(file.path)}}));
  const std::string type = trimmedValue(transformation(DC::RescaleType));
  const std::string kind = meta->Get(DC::ImageType).GetNumberOfValues() > 0
                               ? meta->Get(DC::ImageType).GetString(0)
                               : std::string();
  file.hounsfield = file.modality == "CT" && (type == "HU" || (type.empty() && kind == "ORIGINAL"));
  return {};
}

/// What an element names, in UTF-8, one name for each of its values.
std::vector<std::string> namesIn(const vtkDICOMValue& value) {
  std::istringstream all(value.AsUTF8String());
  std::vector<std::string> names;
  for (std::string name; std::getline(all, name, '\\');) names.push_back(std::move(name));
  return names;
}

/// The windows that a frame states. Nothing is refused for what cannot be read of them.
std::vector<StatedWindow> windowsOf(vtkDICOMMetaData* meta, int frame) {
  constexpr std::size_t kMost = 8;  // no menu needs more
  using Voxel = std::numeric_limits<float>;
  const auto stated = [&](vtkDICOMTag tag) -> const vtkDICOMValue& {
    return ofFrame(meta, frame, DC::FrameVOILUTSequence, tag);
  };
  const auto levels = eachNumberIn(stated(DC::WindowCenter));
  const auto widths = eachNumberIn(stated(DC::WindowWidth));
  const auto names = namesIn(stated(DC::WindowCenterWidthExplanation));
  std::vector<StatedWindow> windows;
  for (std::size_t n = 0; n < std::min({levels.size(), widths.size(), kMost}); ++n)
    if (levels[n] && widths[n] && std::abs(*levels[n]) <= Voxel::max() &&
        *widths[n] >= Voxel::min() && *widths[n] <= Voxel::max())
      windows.push_back({*levels[n], *widths[n], n < names.size() ? names[n] : std::string()});
  return windows;
}

/// A stored value of the file's own sign, whatever sign its attribute was written with.
double storedValue(const DicomFile& file, double number) {
  const double all = std::ldexp(1.0, file.bits_allocated);
  if (file.is_signed && number >= 0.5 * all) return number - all;
  if (!file.is_signed && number < 0.0) return number + all;
  return number;
}

std::optional<haptics::Error> readPadding(vtkDICOMMetaData* meta, DicomFile& file) {
  std::optional<std::array<double, 1>> value, limit;
  if (auto bad = readNumbers(file, "pixel padding value", meta->Get(DC::PixelPaddingValue), value))
    return bad;
  if (auto bad =
          readNumbers(file, "pixel padding limit", meta->Get(DC::PixelPaddingRangeLimit), limit))
    return bad;
  if (!value) return {};
  const double one = storedValue(file, value->front());
  const double other = limit ? storedValue(file, limit->front()) : one;
  file.padding = {std::min(one, other), std::max(one, other)};
  return {};
}

void readAttributes(vtkDICOMMetaData* meta, DicomFile& file) {
  file.attributes = attributesOf(meta, file.frame);
  file.attributes[static_cast<std::size_t>(Attribute::VoxelType)] =
      (file.is_signed ? "signed " : "unsigned ") + std::to_string(file.bits_allocated);
}

/// What differs from frame to frame, and why it cannot be used, if it cannot.
void readFrame(vtkDICOMMetaData* meta, DicomFile& file) {
  file.fault = readRescale(meta, file);
  if (!file.fault) file.fault = readPadding(meta, file);
  readAttributes(meta, file);
  file.windows = windowsOf(meta, file.frame);
  if (file.fault) return;
  if (file.sop_class == kDose)
    file.fault = fault(unsupported("bad-header", {"dicom-dose", {quoted(file.path)}}));
  // several frames at the one place that a root states are no stack
  else if (file.frame_count > 1 && !meta->Has(DC::PerFrameFunctionalGroupsSequence))
    file.fault = unplaced();
  else
    file.fault = placeSlice(meta, file);
}

/// How many frames; some programs leave the number out of a file of one.
std::optional<haptics::Error> readFrameCount(vtkDICOMMetaData* meta, DicomFile& file) {
  const vtkDICOMValue& stated = meta->Get(DC::NumberOfFrames);
  if (!stated.IsValid() || trimmedValue(stated).empty()) return {};
  const auto count = integerString(trimmedValue(stated));
  if (!count || *count < 1) return senseless(file, "number of frames");
  file.frame_count = *count;
  return {};
}

/// Whether it is known what the stored bits mean.
std::optional<haptics::Error> bitsFault(const DicomFile& file, vtkDICOMMetaData* meta) {
  const auto sign = numbersIn(meta->Get(DC::PixelRepresentation));
  if (!sign || sign->size() != 1 || (sign->front() != 0.0 && sign->front() != 1.0))
    return fault(malformed("bad-header", {"dicom-sign-missing", {quoted(file.path)}}));
  const bool fits = file.bits_stored >= 1 && file.bits_stored <= file.bits_allocated &&
                    file.high_bit >= file.bits_stored - 1 && file.high_bit < file.bits_allocated;
  const bool moved = file.high_bit != file.bits_stored - 1;
  if (fits && !(moved && codingOf(file.syntax))) return {};
  return fault(malformed("bad-header", {"dicom-pixels-impossible", {quoted(file.path)}}));
}

bool isUnderstood(const DicomFile& file) {
  return !file.series.empty() || !file.modality.empty() || file.plane.rows != 0;
}

}  // namespace

std::optional<haptics::Error> placeSlice(vtkDICOMMetaData* meta, DicomFile& file) {
  std::optional<std::array<double, 3>> position;
  std::optional<std::array<double, 6>> orientation;
  std::optional<std::array<double, 2>> spacing;
  const auto ofGroup = [&](vtkDICOMTag group, vtkDICOMTag tag) -> const vtkDICOMValue& {
    return ofFrame(meta, file.frame, group, tag);
  };
  if (auto bad = readNumbers(
          file, "position", ofGroup(DC::PlanePositionSequence, DC::ImagePositionPatient), position))
    return bad;
  if (auto bad = readNumbers(file, "direction",
                             ofGroup(DC::PlaneOrientationSequence, DC::ImageOrientationPatient),
                             orientation))
    return bad;
  if (auto bad = readNumbers(file, "pixel spacing",
                             ofGroup(DC::PixelMeasuresSequence, DC::PixelSpacing), spacing))
    return bad;
  if (!position || !orientation || !spacing) return unplaced();
  SlicePlane& plane = file.plane;
  file.placed = true;
  plane.position_mm = Vec3::Map(position->data());
  plane.along_row = Vec3::Map(orientation->data());
  plane.along_column = Vec3::Map(orientation->data() + 3);
  plane.row_step_mm = spacing->front();
  plane.column_step_mm = spacing->back();
  // needed of a single slice only, so a number that is none is not stated
  const auto thickness = numbersIn(ofGroup(DC::PixelMeasuresSequence, DC::SliceThickness));
  if (thickness && thickness->size() == 1 && thickness->front() > 0.0)
    plane.thickness_mm = thickness->front();
  return {};
}

bool holdsStructures(const DicomFile& file) {
  return file.sop_class == kSegments || file.sop_class == kSegmentMap ||
         file.sop_class == kContours;
}

bool holdsContours(const DicomFile& file) { return file.sop_class == kContours; }

bool looksLikeDicom(const Beginning& file) {
  // what vtk-dicom looks for, without opening the file once more
  constexpr std::int64_t kLeast = 256;  // bytes
  const bool marked = file.file_size >= kLeast && file.bytes.size() >= 136 &&
                      file.bytes.compare(128, 8, std::string("DICM\2\0\0\0", 8)) == 0;
  return marked || vtkDICOMUtilities::IsDICOMFile(file.path.c_str()) ||
         bareDataSetOf(file.bytes).has_value();
}

DicomFile describedBy(const std::filesystem::path& path, const ParsedDicom& parsed) {
  vtkDICOMMetaData* meta = parsed.meta();
  vtkDICOMParser* parser = parsed.parser();
  DicomFile file;
  file.path = path;
  file.rewritten = parsed.isRewritten();
  file.pixels_begin = static_cast<std::int64_t>(parser->GetFileOffset());
  file.series = textOf(meta, DC::SeriesInstanceUID);
  file.name = textOf(meta, DC::PatientName);
  file.birth_date = textOf(meta, DC::PatientBirthDate);
  file.issuer = textOf(meta, DC::IssuerOfPatientID);
  file.identity = {.patient = textOf(meta, DC::PatientID),
                   .study = textOf(meta, DC::StudyInstanceUID),
                   .modality = textOf(meta, DC::Modality)};
  if (file.identity.patient.empty() && !file.name.empty()) file.identity.patient = "\n" + file.name;
  file.sop_class = textOf(meta, DC::SOPClassUID);
  file.instance = textOf(meta, DC::SOPInstanceUID);
  file.modality = modalityFrom(textOf(meta, DC::Modality));
  file.labels = {shownText(meta, DC::PatientName), shownText(meta, DC::StudyDescription),
                 shownText(meta, DC::SeriesDescription)};
  file.series_number = meta->Get(DC::SeriesNumber).AsInt();
  file.plane.rows = meta->Get(DC::Rows).AsInt();
  file.plane.columns = meta->Get(DC::Columns).AsInt();
  file.bits_allocated = meta->Get(DC::BitsAllocated).AsInt();
  file.bits_stored =
      meta->Has(DC::BitsStored) ? meta->Get(DC::BitsStored).AsInt() : file.bits_allocated;
  file.high_bit = meta->Has(DC::HighBit) ? meta->Get(DC::HighBit).AsInt() : file.bits_stored - 1;
  file.inverted = textOf(meta, DC::PhotometricInterpretation) == "MONOCHROME1";
  file.is_signed = meta->Get(DC::PixelRepresentation).AsInt() == 1;
  readAttributes(meta, file);

  file.syntax = textOf(meta, DC::TransferSyntaxUID);
  if (parsed.structure().fault)
    file.fault = parsed.structure().fault;
  else if (!parsed.isSound())
    file.fault = fault(malformed("truncated", {"file-damaged", {quoted(path)}}));
  else if (!isUnderstood(file))
    file.fault = fault(malformed("bad-header", {"header-unreadable", {quoted(path)}}));
  else if (file.sop_class != kContours)
    file.fault = readFrameCount(meta, file);
  if (file.fault || file.sop_class == kContours) return file;
  file.fault = bitsFault(file, meta);
  if (auto pixels = pixelFault(file, meta, parser)) file.fault = std::move(pixels);
  return file;
}

DicomHeader readDicomHeader(const Beginning& beginning) {
  const CLocale numbers_with_points;
  const std::filesystem::path& path = beginning.path;
  const auto parsed = ParsedDicom::of(beginning);
  if (!parsed) {
    DicomFile file;
    file.path = path;
    file.fault = parsed.error();
    return {.frames = {file}};
  }
  vtkDICOMMetaData* meta = (*parsed)->meta();
  if (textOf(meta, DC::MediaStorageSOPClassUID) == kFolderIndex)
    return {.is_folder_index = !(*parsed)->structure().fault, .frames = {}};
  DicomFile file = describedBy(path, **parsed);
  // it only began like a data set
  if (bareDataSetOf(beginning.bytes) && !isUnderstood(file)) return {};
  if (holdsStructures(file)) {
    file.fault = fault(unsupported("no-pixels", {"dicom-structures", {quoted(path)}}));
    return {.frames = {file}};
  }
  if (file.fault) {
    placeSlice(meta, file);  // to know what it is a copy of
    return {.frames = {file}};
  }
  DicomHeader all;
  for (file.frame = 0; file.frame < file.frame_count; ++file.frame) {
    all.frames.push_back(file);
    readFrame(meta, all.frames.back());
    // what one frame lacks, all others may: a small file must not make many entries
    if (all.frames.back().fault) return {.frames = {all.frames.back()}};
  }
  return all;
}

}  // namespace datasets
