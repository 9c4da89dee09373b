// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tests/support/dicom_bytes.h"

/// DICOM objects that mark structures, byte by byte.
namespace datasets::testing {

/// The elements that say what an object is, whose, and where.
struct Origin {
  std::string sop_class, modality;
  std::string patient_id = "P1", patient_name = "Doe^Jane";
  std::string frame_of_reference = "1.2.3.9";
};

inline std::string fileHead(const std::string& sop_class, const std::string& syntax) {
  const std::string meta = element(2, 1, "OB", std::string{'\0', '\1'}) +
                           element(2, 2, "UI", sop_class) + element(2, 3, "UI", "1.2.3.7") +
                           element(2, 0x10, "UI", syntax);
  return std::string(128, '\0') + "DICM" + element(2, 0, "UL", number(meta.size(), 4)) + meta;
}

inline std::string rootOf(const Origin& origin) {
  return element(8, 0x16, "UI", origin.sop_class) + element(8, 0x18, "UI", "1.2.3.7") +
         element(8, 0x60, "CS", origin.modality) + element(0x10, 0x10, "PN", origin.patient_name) +
         element(0x10, 0x20, "LO", origin.patient_id) + element(0x20, 0xd, "UI", "1.2.3.1") +
         element(0x20, 0xe, "UI", "1.2.3.6") + element(0x20, 0x11, "IS", "9") +
         (origin.frame_of_reference.empty() ? std::string()
                                            : element(0x20, 0x52, "UI", origin.frame_of_reference));
}

inline std::string vectorOf(const haptics::Vec3& v) { return decimals({v.x(), v.y(), v.z()}); }

/// A segmentation object.
struct SegmentObject {
  struct Segment {
    int number;
    std::string label;
    std::vector<int> cie_lab = {};
  };
  struct Frame {
    int segment;
    haptics::Vec3 position_mm;
    std::vector<int> values;  ///< a row behind the other
  };
  Origin origin{"1.2.840.10008.5.1.4.1.1.66.4", "SEG"};
  std::string type = "BINARY";
  int columns = 1, rows = 1;
  haptics::Vec3 along_row = haptics::Vec3::UnitX(), along_column = haptics::Vec3::UnitY();
  double column_step_mm = 1.0, row_step_mm = 1.0;
  double between_mm = 0.0, thickness_mm = 0.0;  ///< 0: not stated
  int greatest = 255;
  std::vector<Segment> segments;
  std::vector<Frame> frames;

  int bits() const { return type == "BINARY" ? 1 : 8; }
};

inline std::string pixelsOf(const SegmentObject& o) {
  std::string bytes;
  std::size_t bit = 0;
  for (const auto& frame : o.frames)
    for (const int value : frame.values) {
      if (o.bits() == 8) {
        bytes += char(value);
        continue;
      }
      if (bit % 8 == 0) bytes += '\0';
      if (value != 0) bytes.back() = char(std::uint8_t(bytes.back()) | 1U << bit % 8);
      ++bit;
    }
  return bytes;
}

/// All up to the pixels.
inline std::string headOf(const SegmentObject& o,
                          const std::string& syntax = "1.2.840.10008.1.2.1") {
  const auto us = [](int v) { return number(std::size_t(v), 2); };
  std::vector<std::string> segments, frames;
  for (const auto& s : o.segments) {
    std::string lab;
    for (const int v : s.cie_lab) lab += us(v);
    segments.push_back(element(0x62, 4, "US", us(s.number)) + element(0x62, 5, "LO", s.label) +
                       (lab.empty() ? lab : element(0x62, 0xd, "US", lab)));
  }
  for (const auto& f : o.frames)
    frames.push_back(sequence(0x20, 0x9113, {element(0x20, 0x32, "DS", vectorOf(f.position_mm))}) +
                     (f.segment == 0
                          ? std::string()
                          : sequence(0x62, 0xa, {element(0x62, 0xb, "US", us(f.segment))})));
  std::string measures;
  if (o.thickness_mm > 0.0) measures += element(0x18, 0x50, "DS", decimals({o.thickness_mm}));
  if (o.between_mm > 0.0) measures += element(0x18, 0x88, "DS", decimals({o.between_mm}));
  measures += element(0x28, 0x30, "DS", decimals({o.row_step_mm, o.column_step_mm}));
  const std::string shared =
      sequence(0x20, 0x9116,
               {element(0x20, 0x37, "DS",
                        decimals({o.along_row.x(), o.along_row.y(), o.along_row.z(),
                                  o.along_column.x(), o.along_column.y(), o.along_column.z()}))}) +
      sequence(0x28, 0x9110, {measures});
  return fileHead(o.origin.sop_class, syntax) + rootOf(o.origin) + element(0x28, 2, "US", us(1)) +
         element(0x28, 4, "CS", "MONOCHROME2") +
         element(0x28, 8, "IS", std::to_string(o.frames.size())) +
         element(0x28, 0x10, "US", us(o.rows)) + element(0x28, 0x11, "US", us(o.columns)) +
         element(0x28, 0x100, "US", us(o.bits())) + element(0x28, 0x101, "US", us(o.bits())) +
         element(0x28, 0x102, "US", us(o.bits() - 1)) + element(0x28, 0x103, "US", us(0)) +
         element(0x62, 1, "CS", o.type) + sequence(0x62, 2, segments) +
         (o.type == "FRACTIONAL" ? element(0x62, 0xe, "US", us(o.greatest)) : std::string()) +
         sequence(0x5200, 0x9229, {shared}) + sequence(0x5200, 0x9230, frames);
}

inline std::string bytesOf(const SegmentObject& o) {
  return headOf(o) + element(0x7fe0, 0x10, "OB", pixelsOf(o));
}

/// With one fragment for each frame.
inline std::string compressedBytesOf(const SegmentObject& o, const std::string& syntax,
                                     const std::vector<std::string>& fragments) {
  const auto item = [](const std::string& value) {
    return number(0xe000fffe, 4) + number(value.size(), 4) + value;
  };
  std::string bytes = headOf(o, syntax) + number(0x7fe0, 2) + number(0x10, 2) + "OB" +
                      number(0, 2) + number(0xffffffff, 4) + item("");
  for (const std::string& fragment : fragments)
    bytes += item(fragment.size() % 2 == 0 ? fragment : fragment + '\0');
  return bytes + number(0xe0ddfffe, 4) + number(0, 4);
}

/// A structure set.
struct ContourObject {
  struct DrawnContour {
    std::string type;
    std::vector<haptics::Vec3> corners;
  };
  struct Region {
    int number;
    std::string name;
    std::vector<int> colour = {};
    std::vector<DrawnContour> contours = {};
    std::string frame_of_reference = "1.2.3.9";
  };
  Origin origin{"1.2.840.10008.5.1.4.1.1.481.3", "RTSTRUCT", "P1", "Doe^Jane", ""};
  std::vector<Region> regions;
  bool contours_are_unknown = false;  ///< written as of an unknown kind, as long texts are
};

inline std::string bytesOf(const ContourObject& o) {
  std::vector<std::string> named, drawn;
  for (const auto& r : o.regions) {
    named.push_back(element(0x3006, 0x22, "IS", std::to_string(r.number)) +
                    element(0x3006, 0x24, "UI", r.frame_of_reference) +
                    element(0x3006, 0x26, "LO", r.name));
    std::vector<std::string> contours;
    for (const auto& c : r.contours) {
      std::vector<double> numbers;
      for (const haptics::Vec3& corner : c.corners)
        numbers.insert(numbers.end(), corner.begin(), corner.end());
      contours.push_back(
          element(0x3006, 0x42, "CS", c.type) +
          element(0x3006, 0x46, "IS", std::to_string(c.corners.size())) +
          element(0x3006, 0x50, o.contours_are_unknown ? "UN" : "DS", decimals(numbers)));
    }
    drawn.push_back(
        (r.colour.empty()
             ? std::string()
             : element(0x3006, 0x2a, "IS", decimals({r.colour.begin(), r.colour.end()}))) +
        sequence(0x3006, 0x40, contours) + element(0x3006, 0x84, "IS", std::to_string(r.number)));
  }
  return fileHead(o.origin.sop_class, "1.2.840.10008.1.2.1") + rootOf(o.origin) +
         sequence(0x3006, 0x20, named) + sequence(0x3006, 0x39, drawn);
}

}  // namespace datasets::testing
