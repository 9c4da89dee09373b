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
#include "datasets/readers/meshes/polygons.h"

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
    } else if (word != "comment" && word != "obj_info" && !word.empty()) {
      return {};
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
  bool atEnd() {
    std::string_view rest = rest_;
    return takeWord(rest).empty();
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

/// What a property says of a mesh: its place in a vertex, or the corners of a face.
enum class Meaning { X, Y, Z, Corners, Nothing };

Meaning meaningOf(const PlyElement& element, const Property& property) {
  if (element.name == "vertex" && !property.count) {
    if (property.name == "x") return Meaning::X;
    if (property.name == "y") return Meaning::Y;
    if (property.name == "z") return Meaning::Z;
  }
  const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
  return element.name == "face" && property.count && corners ? Meaning::Corners : Meaning::Nothing;
}

/// Whether each property that is needed is there once.
bool hasPolygons(const PlyHeader& header) {
  for (const Meaning meaning : {Meaning::X, Meaning::Y, Meaning::Z, Meaning::Corners}) {
    int found = 0;
    for (const PlyElement& element : header.elements)
      for (const Property& property : element.properties)
        found += meaningOf(element, property) == meaning ? 1 : 0;
    if (found != 1) return false;
  }
  return true;
}

bool isIndex(double number) {
  return number >= 0.0 && number < 0x1p32 && number == std::floor(number);
}

/// Reads the rows of one element behind the other.
class Rows {
 public:
  Rows(const fs::path& path, std::string_view bytes, Form form)
      : path_(path), numbers_(bytes, form) {}

  Expected<void> read(const PlyElement& element) {
    // a row without properties takes no room: nothing would bound the walk
    if (element.properties.empty()) return {};
    for (std::int64_t row = 0; row < element.count; ++row) {
      std::array<double, 3> place{};
      for (const Property& property : element.properties) {
        const Meaning meaning = meaningOf(element, property);
        if (property.count) {
          if (auto list = readList(property, meaning == Meaning::Corners); !list) return list;
          continue;
        }
        const auto number = numbers_.next(property.value);
        if (!number) return cutOff();
        if (meaning != Meaning::Nothing) place[static_cast<std::size_t>(meaning)] = *number;
      }
      if (element.name != "vertex") continue;
      const auto finite = placeOf(path_, place);
      if (!finite) return tl::unexpected(finite.error());
      polygons_.places.push_back(*finite);
    }
    return {};
  }

  /// Once all elements are read.
  Expected<Polygons> polygons() {
    if (!numbers_.atEnd()) return malformed("truncated", {"file-damaged", {quoted(path_)}});
    for (const std::uint32_t corner : polygons_.corners)
      if (corner >= polygons_.places.size()) return badFace();
    return std::move(polygons_);
  }

 private:
  Expected<void> readList(const Property& property, bool corners) {
    const auto count = numbers_.next(*property.count);
    if (!count || !isIndex(*count)) return cutOff();
    if (corners && *count < 3.0) return badFace();
    if (corners && *count > double{kMostCorners}) return tooManyCorners(path_);
    for (double i = 0.0; i < *count; ++i) {
      const auto number = numbers_.next(property.value);
      if (!number) return cutOff();
      if (!corners) continue;
      if (!isIndex(*number)) return badFace();
      polygons_.corners.push_back(static_cast<std::uint32_t>(*number));
    }
    if (corners) polygons_.ends.push_back(polygons_.corners.size());
    return {};
  }
  tl::unexpected<haptics::Error> cutOff() const {
    return malformed("truncated", {"file-damaged", {quoted(path_)}});
  }
  tl::unexpected<haptics::Error> badFace() const {
    return malformed("bad-index", {"mesh-face-wrong", {quoted(path_)}});
  }

  const fs::path& path_;
  Numbers numbers_;
  Polygons polygons_;
};

}  // namespace

Expected<Polygons> readPly(const fs::path& path, std::string_view bytes) {
  std::string_view rest = bytes;
  const auto header = plyHeaderOf(rest);
  if (!header || !hasPolygons(*header))
    return malformed("bad-header", {"mesh-unreadable", {quoted(path)}});
  Rows rows(path, rest, header->form);
  for (const PlyElement& element : header->elements)
    if (auto read = rows.read(element); !read) return tl::unexpected(read.error());
  return rows.polygons();
}

}  // namespace datasets
