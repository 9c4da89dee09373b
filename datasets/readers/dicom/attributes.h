// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "haptics/core/error.h"

class vtkDICOMMetaData;

namespace datasets {

/// By what the files of one series may differ. None of it parts files that make one even stack;
/// each may tell several volumes of a series apart. In the order in which they are tried.
enum class Attribute : std::size_t {
  CardiacPhase,
  TriggerDelay,
  TriggerTime,
  RespiratoryPhase,
  TemporalPosition,
  TimeOffset,
  Echo,
  EchoTime,
  DiffusionWeighting,
  DiffusionDirection,
  Energy,
  Voltage,
  Acquisition,
  Kernel,
  ImageType,
  FrameOfReference,
  Stack,
  Dimension,
  SliceThickness,
  VoxelType,
  Exposure,
  Description,
  AcquisitionTime,
  ContentTime,
  Count
};

inline constexpr auto kAttributes = static_cast<std::size_t>(Attribute::Count);

/// The value of each for one slice, compared as text; empty where it is not stated. A number is
/// written in one way ("1.0" and "1" are equal).
using Attributes = std::array<std::string, kAttributes>;

/// What a frame states. The voxel type is not an element and stays empty.
Attributes attributesOf(vtkDICOMMetaData* meta, int frame);

struct AttributeTraits {
  haptics::Message name;  ///< what it is called
  const char* unit;       ///< behind its value; null: the value is not shown
  /// Differs only between reconstructions or moments, so a part that has one value of it and is an
  /// even stack is a volume, also where the other parts are not.
  bool strong;
  bool told;   ///< the verdict on one stack says that its files differ in it
  bool timed;  ///< grows with time: images at one place can be ordered by it
};
const AttributeTraits& traitsOf(Attribute attribute);

}  // namespace datasets
