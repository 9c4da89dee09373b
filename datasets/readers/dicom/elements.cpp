// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/elements.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMValue.h>

namespace datasets {

const vtkDICOMItem* itemOf(const vtkDICOMValue& sequence, int n) {
  const vtkDICOMItem* items = sequence.GetSequenceData();
  return items != nullptr && n < static_cast<int>(sequence.GetNumberOfValues()) ? items + n
                                                                                : nullptr;
}

std::string trimmedValue(const vtkDICOMValue& value) {
  std::string text = value.AsString();
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

std::string textOf(vtkDICOMMetaData* meta, vtkDICOMTag tag) { return trimmedValue(meta->Get(tag)); }

const vtkDICOMValue& ofFrame(vtkDICOMMetaData* meta, int frame, vtkDICOMTag group,
                             vtkDICOMTag tag) {
  for (const vtkDICOMItem* groups : {itemOf(meta->Get(DC::PerFrameFunctionalGroupsSequence), frame),
                                     itemOf(meta->Get(DC::SharedFunctionalGroupsSequence), 0)}) {
    const vtkDICOMItem* item = groups != nullptr ? itemOf(groups->Get(group), 0) : nullptr;
    if (item != nullptr && item->Get(tag).IsValid()) return item->Get(tag);
  }
  return meta->Get(tag);
}

}  // namespace datasets
