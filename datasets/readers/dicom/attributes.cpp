// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/attributes.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMItem.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMValue.h>

#include "datasets/readers/dicom/elements.h"
#include "datasets/readers/dicom/numbers.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {
namespace {

constexpr DC::EnumType kRoot{};  // no functional group

/// Where an attribute stands: in a functional group of an enhanced object, or in the root.
struct Source {
  Attribute attribute;
  DC::EnumType group, tag;
};

using enum Attribute;

constexpr Source kSources[] = {
    {CardiacPhase, DC::CardiacSynchronizationSequence, DC::NominalPercentageOfCardiacPhase},
    {TriggerDelay, DC::CardiacSynchronizationSequence, DC::NominalCardiacTriggerDelayTime},
    {TriggerTime, kRoot, DC::TriggerTime},
    {RespiratoryPhase, DC::RespiratorySynchronizationSequence,
     DC::NominalPercentageOfRespiratoryPhase},
    {TemporalPosition, DC::FrameContentSequence, DC::TemporalPositionIndex},
    {TemporalPosition, kRoot, DC::TemporalPositionIdentifier},
    {TimeOffset, DC::TemporalPositionSequence, DC::TemporalPositionTimeOffset},
    {Echo, kRoot, DC::EchoNumbers},
    {EchoTime, DC::MREchoSequence, DC::EffectiveEchoTime},
    {EchoTime, kRoot, DC::EchoTime},
    {DiffusionWeighting, DC::MRDiffusionSequence, DC::DiffusionBValue},
    {DiffusionDirection, DC::MRDiffusionSequence, DC::DiffusionGradientOrientation},
    {Energy, DC::MultienergyCTProcessingSequence, DC::MonoenergeticEnergyEquivalent},
    {Voltage, DC::CTXRayDetailsSequence, DC::KVP},
    {Acquisition, DC::FrameContentSequence, DC::FrameAcquisitionNumber},
    {Acquisition, kRoot, DC::AcquisitionNumber},
    {Kernel, DC::CTReconstructionSequence, DC::ConvolutionKernel},
    {ImageType, DC::CTImageFrameTypeSequence, DC::FrameType},
    {ImageType, DC::MRImageFrameTypeSequence, DC::FrameType},
    {ImageType, kRoot, DC::ImageType},
    {FrameOfReference, kRoot, DC::FrameOfReferenceUID},
    {Stack, DC::FrameContentSequence, DC::StackID},
    {SliceThickness, DC::PixelMeasuresSequence, DC::SliceThickness},
    {Exposure, DC::CTExposureSequence, DC::ExposureInmAs},
    {Exposure, kRoot, DC::Exposure},
    {Description, kRoot, DC::SeriesDescription},
    {AcquisitionTime, DC::FrameContentSequence, DC::FrameAcquisitionDateTime},
    {AcquisitionTime, kRoot, DC::AcquisitionDateTime},
    {AcquisitionTime, kRoot, DC::AcquisitionTime},
    {ContentTime, kRoot, DC::ContentTime},
};

std::string comparable(const vtkDICOMValue& value) {
  if (!value.IsValid()) return {};
  const auto numbers = numbersIn(value);
  if (!numbers || numbers->empty()) return trimmedValue(value);
  std::string text;
  for (const double number : *numbers) text += (text.empty() ? "" : "\\") + exact(number);
  return text;
}

/// The frame's index along the dimensions that its object declares, but for that of its place.
std::string dimensionOf(vtkDICOMMetaData* meta, int frame) {
  const vtkDICOMValue& indices =
      ofFrame(meta, frame, DC::FrameContentSequence, DC::DimensionIndexValues);
  const vtkDICOMValue& dimensions = meta->Get(DC::DimensionIndexSequence);
  const auto all = numbersIn(indices);
  std::string text;
  for (int n = 0; all && n < static_cast<int>(all->size()); ++n) {
    const vtkDICOMItem* dimension = itemOf(dimensions, n);
    if (dimension == nullptr) return {};
    const vtkDICOMTag pointer = dimension->Get(DC::DimensionIndexPointer).AsTag();
    if (pointer == DC::InStackPositionNumber || pointer == DC::ImagePositionPatient) continue;
    text += (text.empty() ? "" : "\\") + exact((*all)[static_cast<std::size_t>(n)]);
  }
  return text;
}

}  // namespace

Attributes attributesOf(vtkDICOMMetaData* meta, int frame) {
  Attributes all;
  for (const Source& source : kSources) {
    std::string& value = all[static_cast<std::size_t>(source.attribute)];
    if (!value.empty()) continue;
    value = comparable(source.group == kRoot ? meta->Get(source.tag)
                                             : ofFrame(meta, frame, source.group, source.tag));
  }
  all[static_cast<std::size_t>(Dimension)] = dimensionOf(meta, frame);
  return all;
}

const AttributeTraits& traitsOf(Attribute attribute) {
  static const std::array<AttributeTraits, kAttributes> all{{
      {{"attribute-phase", {}}, "%", true, false, false},
      {{"attribute-trigger-delay", {}}, "ms", true, false, true},
      {{"attribute-trigger-time", {}}, "ms", true, false, true},
      {{"attribute-breath", {}}, "%", true, false, false},
      {{"attribute-time", {}}, "", true, false, true},
      {{"attribute-time", {}}, "s", true, false, true},
      {{"attribute-echo", {}}, "", true, false, false},
      {{"attribute-echo-time", {}}, "ms", true, false, false},
      {{"attribute-b-value", {}}, "s/mm²", true, false, false},
      {{"attribute-direction", {}}, nullptr, true, false, false},
      {{"attribute-energy", {}}, "keV", true, true, false},
      {{"attribute-voltage", {}}, "kV", true, true, false},
      {{"attribute-acquisition", {}}, "", false, true, false},
      {{"attribute-kernel", {}}, nullptr, true, true, false},
      {{"attribute-image-type", {}}, nullptr, true, true, false},
      {{"attribute-frame-of-reference", {}}, nullptr, true, true, false},
      {{"attribute-stack", {}}, nullptr, true, false, false},
      {{"attribute-dimension", {}}, nullptr, true, false, false},
      {{"attribute-thickness", {}}, "mm", false, false, false},
      {{"attribute-voxel-type", {}}, nullptr, true, true, false},
      {{"attribute-exposure", {}}, "mAs", false, false, false},
      {{"attribute-description", {}}, nullptr, true, true, false},
      {{"attribute-acquisition-time", {}}, nullptr, false, false, true},
      {{"attribute-content-time", {}}, nullptr, false, false, true},
  }};
  return all[static_cast<std::size_t>(attribute)];
}

}  // namespace datasets
