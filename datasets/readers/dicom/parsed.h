// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkNew.h>

#include <memory>
#include <optional>

#include "datasets/readers/dicom/rewritten_file.h"
#include "datasets/readers/dicom/structure.h"
#include "datasets/readers/files/beginning.h"
#include "datasets/readers/files/vtk_errors.h"
#include "haptics/core/error.h"

namespace datasets {

/// A DICOM file whose elements vtk-dicom has parsed, up to its pixels, after a walk along them: of
/// a faulty file those before the fault.
class ParsedDicom {
 public:
  /// Refuses what cannot be rewritten (RewrittenFile), and a fault without anything before it.
  static haptics::Expected<std::unique_ptr<ParsedDicom>> of(const Beginning& beginning);

  const DicomStructure& structure() const { return structure_; }
  bool isRewritten() const { return rewritten_.has_value(); }
  /// False: vtk-dicom found a fault that the walk did not.
  bool isSound() const { return errors_->errors() == 0 && parser_->GetErrorCode() == 0; }
  vtkDICOMMetaData* meta() const { return meta_; }
  vtkDICOMParser* parser() const { return parser_; }

 private:
  ParsedDicom() = default;

  DicomStructure structure_;
  std::optional<RewrittenFile> rewritten_, sound_part_;
  vtkNew<vtkDICOMMetaData> meta_;
  vtkNew<vtkDICOMParser> parser_;
  vtkNew<VtkErrors> errors_;
};

}  // namespace datasets
