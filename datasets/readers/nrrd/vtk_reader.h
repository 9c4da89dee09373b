// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkImageAlgorithm.h>

#include <filesystem>
#include <memory>

#include "datasets/readers/nrrd/voxels.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"
#include "haptics/core/volume.h"

namespace datasets {

/// NRRD as a VTK algorithm. The output is an image in metres, patient LPS, with its direction
/// matrix; its scalars are the voxels of `volume()`, lent and not copied, so keep the volume as
/// long as the image. Reports progress as VTK does; SetAbortExecute during a ProgressEvent stops
/// it with Error::Kind::Cancelled.
class VtkNrrdReader : public vtkImageAlgorithm {
 public:
  static VtkNrrdReader* New();
  vtkTypeMacro(VtkNrrdReader, vtkImageAlgorithm)

      /// Update() parses the header of this file, and reads its voxels.
      void setPath(const std::filesystem::path& path);
  /// Update() reads the voxels of a file whose header has been parsed.
  void setParsed(std::shared_ptr<const ParsedNrrd> nrrd);
  /// Which of the file's volumes, from 0, and which of its voxels.
  void setChoice(int number, const Part& part);
  /// What the last Update() came to.
  const haptics::Expected<haptics::Volume>& volume() const { return volume_; }

 protected:
  VtkNrrdReader();
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  std::filesystem::path path_;
  std::shared_ptr<const ParsedNrrd> given_;  ///< null: the file at path_ is parsed
  std::shared_ptr<const ParsedNrrd> nrrd_;   ///< what RequestData() reads
  int number_ = 0;
  Part part_;
  haptics::Expected<haptics::Volume> volume_;
};

}  // namespace datasets
