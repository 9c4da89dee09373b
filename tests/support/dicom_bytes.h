// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "haptics/core/geometry.h"

namespace datasets::testing {

/// One slice of a CT as a file of explicit little endian, of signed 16-bit pixels.
struct DicomSlice {
  std::string series = "1.2.3.4", instance = "1.2.3.4.5";
  haptics::Vec3 position_mm = haptics::Vec3::Zero();
  haptics::Vec3 along_row = haptics::Vec3::UnitX(), along_column = haptics::Vec3::UnitY();
  double row_step_mm = 1.0, column_step_mm = 1.0;
  int rows = 1, columns = 1;
  double slope = 1.0, intercept = 0.0;
  std::vector<std::int16_t> pixels = {};
  std::vector<std::int16_t> padding = {};  ///< none; a value; or a value and a limit
};

/// A data element with a length of 16 bits, or of 32 where the representation asks for it.
inline std::string element(unsigned group, unsigned number, const std::string& representation,
                           std::string value) {
  if (value.size() % 2 == 1) value += representation == "UI" ? '\0' : ' ';
  const auto word = [](std::size_t v) { return std::string{char(v & 0xff), char(v >> 8 & 0xff)}; };
  std::string bytes = word(group) + word(number) + representation;
  if (representation == "OW" || representation == "OB" || representation == "SQ" ||
      representation == "UN")
    bytes += word(0) + word(value.size()) + word(value.size() >> 16);
  else
    bytes += word(value.size());
  return bytes + value;
}

inline std::string number(std::size_t v, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n) text += char(v >> (8 * n) & 0xff);
  return text;
}

/// Numbers as a decimal string: "1\-2.5".
inline std::string decimals(const std::vector<double>& values) {
  std::string text;
  for (const double v : values) {
    char number[32];
    std::snprintf(number, sizeof number, "%.10g", v);
    text += (text.empty() ? "" : "\\") + std::string{number};
  }
  return text;
}

/// A sequence whose length and whose items' lengths are stated.
inline std::string sequence(unsigned group, unsigned number_of,
                            const std::vector<std::string>& items) {
  std::string all;
  for (const std::string& item : items)
    all += number(0xe000fffe, 4) + number(item.size(), 4) + item;
  return element(group, number_of, "SQ", all);
}

inline std::string bytesOf(const DicomSlice& s) {
  const auto us = [](int v) { return number(std::size_t(v), 2); };
  const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
  std::string meta = element(2, 1, "OB", std::string{'\0', '\1'}) + element(2, 2, "UI", ct) +
                     element(2, 3, "UI", s.instance) +
                     element(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  std::string bytes =
      std::string(128, '\0') + "DICM" + element(2, 0, "UL", number(meta.size(), 4)) + meta;
  bytes += element(8, 8, "CS", "ORIGINAL\\PRIMARY\\AXIAL") + element(8, 0x16, "UI", ct) +
           element(8, 0x18, "UI", s.instance) + element(8, 0x60, "CS", "CT") +
           element(0x20, 0xe, "UI", s.series) + element(0x20, 0x11, "IS", "1") +
           element(0x20, 0x32, "DS",
                   decimals({s.position_mm.x(), s.position_mm.y(), s.position_mm.z()})) +
           element(0x20, 0x37, "DS",
                   decimals({s.along_row.x(), s.along_row.y(), s.along_row.z(), s.along_column.x(),
                             s.along_column.y(), s.along_column.z()})) +
           element(0x28, 2, "US", us(1)) + element(0x28, 4, "CS", "MONOCHROME2") +
           element(0x28, 0x10, "US", us(s.rows)) + element(0x28, 0x11, "US", us(s.columns)) +
           element(0x28, 0x30, "DS", decimals({s.row_step_mm, s.column_step_mm})) +
           element(0x28, 0x100, "US", us(16)) + element(0x28, 0x101, "US", us(16)) +
           element(0x28, 0x102, "US", us(15)) + element(0x28, 0x103, "US", us(1));
  for (std::size_t n = 0; n < s.padding.size(); ++n)
    bytes += element(0x28, 0x120 + unsigned(n), "SS", number(std::uint16_t(s.padding[n]), 2));
  bytes += element(0x28, 0x1052, "DS", decimals({s.intercept})) +
           element(0x28, 0x1053, "DS", decimals({s.slope}));
  std::string pixels;
  for (const std::int16_t v : s.pixels) pixels += number(std::uint16_t(v), 2);
  return bytes + element(0x7fe0, 0x10, "OW", pixels);
}

/// The elements of a data set as bytesOf makes it, one after the other: tag, representation, value.
struct Element {
  unsigned group, number;
  std::string representation, value;
};
inline std::vector<Element> elementsOf(const std::string& data_set) {
  const auto word = [&](std::size_t at) {
    return unsigned(std::uint8_t(data_set[at])) | unsigned(std::uint8_t(data_set[at + 1])) << 8;
  };
  std::vector<Element> elements;
  for (std::size_t at = 0; at < data_set.size();) {
    Element e{word(at), word(at + 2), data_set.substr(at + 4, 2), {}};
    const bool is_long = e.representation == "OW" || e.representation == "OB" ||
                         e.representation == "SQ" || e.representation == "UN";
    const std::size_t length = is_long ? word(at + 8) | word(at + 10) << 16 : word(at + 6);
    e.value = data_set.substr(at + (is_long ? 12 : 8), length);
    at += (is_long ? 12 : 8) + length;
    elements.push_back(std::move(e));
  }
  return elements;
}

/// Where the data set begins in a file of bytesOf's.
inline std::size_t dataSetOf(const std::string& file) {
  const auto* meta = reinterpret_cast<const unsigned char*>(file.data()) + 132 + 8;
  return 132 + 12 + (meta[0] | std::size_t{meta[1]} << 8);
}

/// The file with elements of its data set replaced or added; one without a representation is
/// taken out.
inline std::string edited(const std::string& file, const std::vector<Element>& changes) {
  const std::size_t begin = dataSetOf(file);
  std::map<std::pair<unsigned, unsigned>, Element> all;
  for (Element& e : elementsOf(file.substr(begin))) all[{e.group, e.number}] = std::move(e);
  for (const Element& e : changes)
    if (e.representation.empty())
      all.erase({e.group, e.number});
    else
      all[{e.group, e.number}] = e;
  std::string bytes = file.substr(0, begin);
  for (const auto& [tag, e] : all) bytes += element(e.group, e.number, e.representation, e.value);
  return bytes;
}

/// The file with compressed pixels: an offset table and fragments.
inline std::string encapsulated(const std::string& file, const std::string& syntax,
                                const std::vector<std::string>& fragments,
                                const std::vector<std::size_t>& offsets = {}) {
  const std::string meta = element(2, 1, "OB", std::string{'\0', '\1'}) +
                           element(2, 2, "UI", "1.2.840.10008.5.1.4.1.1.2") +
                           element(2, 0x10, "UI", syntax);
  std::string bytes =
      std::string(128, '\0') + "DICM" + element(2, 0, "UL", number(meta.size(), 4)) + meta;
  for (const Element& e : elementsOf(file.substr(dataSetOf(file))))
    if (e.group != 0x7fe0) bytes += element(e.group, e.number, e.representation, e.value);
  bytes += number(0x7fe0, 2) + number(0x10, 2) + "OB" + number(0, 2) + number(0xffffffff, 4);
  const auto item = [](const std::string& value) {
    return number(0xe000fffe, 4) + number(value.size(), 4) + value;
  };
  std::string table;
  for (const std::size_t offset : offsets) table += number(offset, 4);
  bytes += item(table);
  for (const std::string& fragment : fragments)
    bytes += item(fragment.size() % 2 == 0 ? fragment : fragment + '\0');
  return bytes + number(0xe0ddfffe, 4) + number(0, 4);
}

/// A data set of explicit little endian in the other two uncompressed encodings.
inline std::string asImplicit(const std::string& data_set) {
  std::string bytes;
  for (const Element& e : elementsOf(data_set))
    bytes += number(e.group, 2) + number(e.number, 2) + number(e.value.size(), 4) + e.value;
  return bytes;
}
inline std::string asBigEndian(const std::string& data_set) {
  const auto turned = [](std::string text) { return std::string{text.rbegin(), text.rend()}; };
  std::string bytes;
  for (Element e : elementsOf(data_set)) {
    const bool is_long = e.representation == "OW" || e.representation == "OB";
    if (e.representation == "US" || e.representation == "SS" || e.representation == "OW")
      for (std::size_t n = 0; n + 1 < e.value.size(); n += 2) std::swap(e.value[n], e.value[n + 1]);
    bytes += turned(number(e.group, 2)) + turned(number(e.number, 2)) + e.representation;
    bytes += is_long ? number(0, 2) + turned(number(e.value.size(), 4))
                     : turned(number(e.value.size(), 2));
    bytes += e.value;
  }
  return bytes;
}

}  // namespace datasets::testing
