// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd/vtk_reader.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <array>
#include <atomic>
#include <utility>

#include "datasets/readers/files/part.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

vtkStandardNewMacro(VtkNrrdReader);

namespace {

int vtkTypeOf(haptics::ScalarType type) {
  switch (type) {
    case haptics::ScalarType::UInt8:
      return VTK_UNSIGNED_CHAR;
    case haptics::ScalarType::Int8:
      return VTK_SIGNED_CHAR;
    case haptics::ScalarType::UInt16:
      return VTK_UNSIGNED_SHORT;
    case haptics::ScalarType::Int16:
      return VTK_SHORT;
    case haptics::ScalarType::UInt32:
      return VTK_UNSIGNED_INT;
    case haptics::ScalarType::Int32:
      return VTK_INT;
    case haptics::ScalarType::Float32:
      break;
  }
  return VTK_FLOAT;
}

std::array<int, 6> extentOf(const haptics::Grid& grid) {
  return {0, static_cast<int>(grid.dims[0]) - 1, 0, static_cast<int>(grid.dims[1]) - 1,
          0, static_cast<int>(grid.dims[2]) - 1};
}

void lend(const haptics::Volume& volume, vtkImageData& image) {
  const haptics::Grid& grid = volume.grid;
  image.SetExtent(extentOf(grid).data());
  image.SetSpacing(grid.spacing.data());
  image.SetOrigin(grid.origin.data());
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = grid.direction;
  image.SetDirectionMatrix(rows.data());
  const auto scalars =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtkTypeOf(volume.type)));
  scalars->SetName("voxels");
  // the image only looks: the volume owns the voxels
  scalars->SetVoidArray(const_cast<void*>(volume.voxels.get()), grid.voxelCount(), 1);
  image.GetPointData()->SetScalars(scalars);
}

}  // namespace

VtkNrrdReader::VtkNrrdReader() : volume_(notFound({})) { SetNumberOfInputPorts(0); }

void VtkNrrdReader::setPath(const std::filesystem::path& path) {
  path_ = path;
  given_.reset();
  Modified();
}

void VtkNrrdReader::setParsed(std::shared_ptr<const ParsedNrrd> nrrd) {
  given_ = std::move(nrrd);
  Modified();
}

void VtkNrrdReader::setChoice(int number, const Part& part) {
  number_ = number;
  part_ = part;
  Modified();
}

int VtkNrrdReader::RequestInformation(vtkInformation*, vtkInformationVector**,
                                      vtkInformationVector* out) {
  nrrd_ = given_;
  if (!nrrd_) {
    auto parsed = parseNrrd(path_);
    if (!parsed) {
      volume_ = tl::unexpected(std::move(parsed.error()));
      return 0;
    }
    nrrd_ = std::make_shared<const ParsedNrrd>(std::move(*parsed));
  }
  const haptics::Grid& grid = nrrd_->stored.grid;
  const auto window = windowOf(part_, grid.dims);
  if (!window) {
    volume_ = tl::unexpected(window.error());
    return 0;
  }
  out->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(),
                                    extentOf(gridOf(grid, *window)).data(), 6);
  return 1;
}

int VtkNrrdReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* out) {
  std::atomic<bool> stop = false;
  volume_ = decodeNrrd(*nrrd_, number_, part_,
                       {.advanced =
                            [&](double fraction) {
                              UpdateProgress(fraction);
                              if (GetAbortExecute() != 0) stop = true;
                            },
                        .cancel = &stop});
  if (!volume_) return 0;
  lend(*volume_, *vtkImageData::GetData(out));
  return 1;
}

}  // namespace datasets
