// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/readers/dicom/attributes.h"
#include "datasets/readers/dicom/stack.h"
#include "datasets/readers/files/beginning.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

class vtkDICOMMetaData;

namespace datasets {

class ParsedDicom;

/// What slices of one stack have in common, beside their series. Compared, never shown. Empty where
/// it is not stated.
struct SliceIdentity {
  std::string patient;  ///< PatientID; without one, the name behind a line break
  std::string study, modality;

  auto operator<=>(const SliceIdentity&) const = default;
  bool operator==(const SliceIdentity&) const = default;
};

/// What one DICOM file says of a slice: of the only one, or of a frame of an enhanced object.
/// Identifiers serve to group files and are never shown.
struct DicomFile {
  std::filesystem::path path;
  bool rewritten = false;         ///< read by way of a RewrittenFile
  std::string syntax;             ///< TransferSyntaxUID; empty where it is not stated
  std::int64_t pixels_begin = 0;  ///< bytes of the file before its pixels
  int frame = 0;                  ///< which of the file's
  int frame_count = 1;            ///< in the file
  std::string series;             ///< SeriesInstanceUID
  std::string instance;           ///< SOPInstanceUID
  SliceIdentity identity;
  std::string name;                ///< of the patient; one person's is spelled in several ways
  std::string birth_date, issuer;  ///< of the patient, and of the patient's identifier
  std::string sop_class;           ///< what kind of object it is
  Attributes attributes;
  int series_number = 0;
  std::string modality;
  Labels labels;
  SlicePlane plane;
  bool placed = false;  ///< the plane is the file's; else unknown
  int bits_allocated = 0;
  int bits_stored = 0;
  int high_bit = 0;  ///< the highest of the stored bits; above and below there may be anything
  bool is_signed = false;
  bool inverted = false;  ///< MONOCHROME1: small values are meant to be shown bright
  bool rescaled = false;  ///< slope and intercept are stated
  double slope = 1.0;
  double intercept = 0.0;
  std::vector<StatedWindow> windows = {};  ///< of the values after the rescale; sound ones alone
  bool hounsfield = false;                 ///< CT, rescaled, and the file says or implies HU
  /// The first and last of the stored values that mean "nothing was measured here".
  std::optional<std::array<double, 2>> padding;
  /// Why this file cannot be a slice, if it cannot.
  std::optional<haptics::Error> fault;
};

/// Whether an object marks parts of a scan and is none itself: segments (binary, fractional or a
/// label map), or contours.
bool holdsStructures(const DicomFile& file);
bool holdsContours(const DicomFile& file);

/// What a file states as a whole, with a fault where the file, its pixels or their number cannot be
/// read.
DicomFile describedBy(const std::filesystem::path& path, const ParsedDicom& parsed);

/// Fills in where the slice of `file.frame` lies, or says why that is not known.
std::optional<haptics::Error> placeSlice(vtkDICOMMetaData* meta, DicomFile& file);

/// Whether a file begins like DICOM: the mark after a preamble, or a first element that fits.
bool looksLikeDicom(const Beginning& file);

/// What the header of one file says.
struct DicomHeader {
  bool is_folder_index = false;  ///< a sound DICOMDIR
  /// An entry for each frame, or a single one with a fault, as that of structures has. Empty for
  /// what is no image and no part of a series: a folder's index, or what only begins like DICOM.
  std::vector<DicomFile> frames;
};

/// Parses one header.
DicomHeader readDicomHeader(const Beginning& beginning);

}  // namespace datasets
