// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/meshes/checks.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

enum class Number { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::optional<Number> numberNamed(std::string_view name) {
  if (name == "char" || name == "int8") return Number::Int8;
  if (name == "uchar" || name == "uint8") return Number::UInt8;
  if (name == "short" || name == "int16") return Number::Int16;
  if (name == "ushort" || name == "uint16") return Number::UInt16;
  if (name == "int" || name == "int32") return Number::Int32;
  if (name == "uint" || name == "uint32") return Number::UInt32;
  if (name == "float" || name == "float32") return Number::Float32;
  if (name == "double" || name == "float64") return Number::Float64;
  return {};
}

struct Property {
  std::string name;
  Number value = Number::Float32;
  std::optional<Number> count;  ///< stated for a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

enum class Form { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
  Form form = Form::Ascii;
  std::vector<PlyElement> elements;
};

std::optional<PlyHeader> plyHeaderOf(std::string_view& text) {
  if (takeLine(text) != "ply") return {};
  PlyHeader header;
  bool has_form = false;
  while (!text.empty()) {
    std::string_view line = takeLine(text);
    const std::string_view word = takeWord(line);
    if (word == "end_header") return has_form ? std::optional(header) : std::nullopt;
    if (word == "format") {
      const std::string_view form = takeWord(line);
      has_form = true;
      if (form == "ascii")
        header.form = Form::Ascii;
      else if (form == "binary_little_endian")
        header.form = Form::LittleEndian;
      else if (form == "binary_big_endian")
        header.form = Form::BigEndian;
      else
        return {};
    } else if (word == "element") {
      PlyElement element{std::string(takeWord(line)), 0, {}};
      const auto count = integerOf(takeWord(line));
      if (!count || *count < 0) return {};
      element.count = *count;
      header.elements.push_back(std::move(element));
    } else if (word == "property") {
      if (header.elements.empty()) return {};
      Property property;
      std::string_view type = takeWord(line);
      if (type == "list") {
        property.count = numberNamed(takeWord(line));
        if (!property.count) return {};
        type = takeWord(line);
      }
      const auto value = numberNamed(type);
      if (!value) return {};
      property.value = *value;
      property.name = takeWord(line);
      header.elements.back().properties.push_back(std::move(property));
    }
  }
  return {};
}

/// The numbers after the header, one by one.
class Numbers {
 public:
  Numbers(std::string_view bytes, Form form) : rest_(bytes), form_(form) {}

  std::optional<double> next(Number type) {
    if (form_ == Form::Ascii) return numberOf(takeWord(rest_));
    switch (type) {
      case Number::Int8:
        return as<std::int8_t>();
      case Number::UInt8:
        return as<std::uint8_t>();
      case Number::Int16:
        return as<std::int16_t>();
      case Number::UInt16:
        return as<std::uint16_t>();
      case Number::Int32:
        return as<std::int32_t>();
      case Number::UInt32:
        return as<std::uint32_t>();
      case Number::Float32:
        return as<float>();
      case Number::Float64:
        break;
    }
    return as<double>();
  }

 private:
  template <class T>
  std::optional<double> as() {
    if (rest_.size() < sizeof(T)) return {};
    char bytes[sizeof(T)];
    std::memcpy(bytes, rest_.data(), sizeof(T));
    rest_.remove_prefix(sizeof(T));
    if (form_ == Form::BigEndian) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
  }

  std::string_view rest_;
  Form form_;
};

static_assert(std::endian::native == std::endian::little,
              "numbers are taken as they lie in memory");

enum class Fault { None, Truncated, BadIndex };

/// Walks over one element's rows; corners of faces must name one of `vertices`.
Fault walk(const PlyElement& element, Numbers& numbers, std::int64_t vertices) {
  for (std::int64_t row = 0; row < element.count; ++row)
    for (const Property& property : element.properties) {
      if (!property.count) {
        if (!numbers.next(property.value)) return Fault::Truncated;
        continue;
      }
      const auto count = numbers.next(*property.count);
      if (!count || !(*count >= 0.0)) return Fault::Truncated;
      const bool corners = element.name == "face" &&
                           (property.name == "vertex_indices" || property.name == "vertex_index");
      if (corners && *count < 3.0) return Fault::BadIndex;
      for (double i = 0.0; i < *count; ++i) {
        const auto value = numbers.next(property.value);
        if (!value) return Fault::Truncated;
        if (corners && !(*value >= 0.0 && *value < static_cast<double>(vertices)))
          return Fault::BadIndex;
      }
    }
  return Fault::None;
}

}  // namespace

Expected<std::int64_t> checkPly(const fs::path& path, std::string_view bytes) {
  std::string_view rest = bytes;
  const auto header = plyHeaderOf(rest);
  if (!header) return malformed("bad-header", {"ply-header", {quoted(path)}});
  const auto countOf = [&](std::string_view name) {
    const auto it = std::ranges::find(header->elements, name, &PlyElement::name);
    return it == header->elements.end() ? std::int64_t{0} : it->count;
  };
  Numbers numbers(rest, header->form);
  for (const PlyElement& element : header->elements) {
    // a row without properties takes no room: nothing would bound the walk
    if (element.properties.empty()) continue;
    switch (walk(element, numbers, countOf("vertex"))) {
      case Fault::None:
        break;
      case Fault::Truncated:
        return malformed("truncated",
                         {"ply-cut-off", {quoted(path), std::to_string(element.count)}});
      case Fault::BadIndex:
        return malformed("bad-index", {"ply-face-index", {quoted(path)}});
    }
  }
  return countOf("face");
}

}  // namespace datasets
