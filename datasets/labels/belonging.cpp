// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/belonging.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMMetaData.h>

#include <algorithm>
#include <variant>

#include "datasets/readers/dicom/elements.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/found.h"

namespace datasets {

ScanIdentity identityOf(const SeriesVerdict& scan) {
  ScanIdentity identity;
  const auto* series =
      scan.found != nullptr ? std::get_if<DicomSeries>(&scan.found->source) : nullptr;
  if (series == nullptr) return identity;
  const DicomFile& first = series->files.front();
  if (!first.identity.patient.starts_with('\n')) identity.patient_id = first.identity.patient;
  identity.patient_name = first.name;
  for (const DicomFile& file : series->files)
    identity.frames_of_reference.insert(
        file.attributes[static_cast<std::size_t>(Attribute::FrameOfReference)]);
  identity.frames_of_reference.erase("");
  return identity;
}

ScanIdentity identityOf(vtkDICOMMetaData* meta) {
  ScanIdentity identity{textOf(meta, DC::PatientID), textOf(meta, DC::PatientName), {}};
  if (const auto frame = textOf(meta, DC::FrameOfReferenceUID); !frame.empty())
    identity.frames_of_reference.insert(frame);
  return identity;
}

haptics::Expected<void> checkBelongs(const std::filesystem::path& path,
                                     const ScanIdentity& structures, const ScanIdentity& scan) {
  const auto differ = [](const std::string& one, const std::string& other) {
    return !one.empty() && !other.empty() && one != other;
  };
  // one person's name is spelled in several ways, so it counts only where an identifier is missing
  const bool have_ids = !structures.patient_id.empty() && !scan.patient_id.empty();
  const bool other_patient = have_ids ? differ(structures.patient_id, scan.patient_id)
                                      : differ(structures.patient_name, scan.patient_name);
  const bool other_frame =
      !structures.frames_of_reference.empty() && !scan.frames_of_reference.empty() &&
      !std::ranges::all_of(structures.frames_of_reference, [&](const std::string& frame) {
        return scan.frames_of_reference.contains(frame);
      });
  using haptics::Error;
  if (other_patient)
    return tl::unexpected(Error{
        Error::Kind::Correctable, {"labels-another-patient", {quoted(path)}}, "another-patient"});
  if (other_frame)
    return tl::unexpected(Error{Error::Kind::Correctable,
                                {"labels-another-frame", {quoted(path)}},
                                "another-frame-of-reference"});
  return {};
}

}  // namespace datasets
