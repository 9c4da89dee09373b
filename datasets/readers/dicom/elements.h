// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkDICOMTag.h>

#include <string>

class vtkDICOMItem;
class vtkDICOMMetaData;
class vtkDICOMValue;

namespace datasets {

/// A value as text, without the padding behind it.
std::string trimmedValue(const vtkDICOMValue& value);

/// The text of an element of the root; empty where there is none.
std::string textOf(vtkDICOMMetaData* meta, vtkDICOMTag tag);

/// An item of a sequence; null where there is none, which vtk-dicom itself would follow to nowhere.
const vtkDICOMItem* itemOf(const vtkDICOMValue& sequence, int n);

/// An attribute of a frame: from its own functional group, the shared one, or the root, where a
/// file of one slice has it. By its full path, since private groups hold attributes of the same
/// name.
const vtkDICOMValue& ofFrame(vtkDICOMMetaData* meta, int frame, vtkDICOMTag group, vtkDICOMTag tag);

}  // namespace datasets
