// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/meta_image/header.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/readers/files/data_file.h"
#include "datasets/readers/files/file_geometry.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;
using haptics::ScalarType;
using haptics::Vec3;

namespace {

struct MetaText {
  std::map<std::string, std::string> fields;
  std::int64_t bytes = 0;  ///< up to what follows the header

  /// The value under the first of its names that is stated; null where none is.
  const std::string* find(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (const auto it = fields.find(name); it != fields.end()) return &it->second;
    return nullptr;
  }
  bool isTrue(std::initializer_list<const char*> names) const {
    const std::string* value = find(names);
    return value != nullptr && !value->empty() &&
           (value->front() == 'T' || value->front() == 't' || value->front() == '1');
  }
};

/// Lines of "Key = Value"; the last names the data file.
Expected<MetaText> readText(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return notFound(path);
  MetaText text;
  std::string line;
  for (char c = 0; in.get(c);) {
    if (++text.bytes > kLongestHeader)
      return malformed("bad-header", {"header-unreadable", {quoted(path)}});
    if (c != '\n') {
      line.push_back(c);
      if (in.peek() != std::ifstream::traits_type::eof()) continue;
    }
    const std::string_view content = trimmed(line);
    const auto equals = content.find('=');
    if (!content.empty()) {
      if (equals == content.npos)
        return malformed("bad-header", {"header-unreadable", {quoted(path)}});
      const std::string key(trimmed(content.substr(0, equals)));
      if (!text.fields.emplace(key, trimmed(content.substr(equals + 1))).second)
        return malformed("bad-header", {"header-unreadable", {quoted(path)}});
      if (key == "ElementDataFile") return text;
    }
    line.clear();
  }
  return missingField(path, "ElementDataFile");
}

struct ElementType {
  std::string_view name;
  ScalarType type;
  bool is_double;
};

// as long as MetaIO stores them, whatever a C compiler's long is
constexpr ElementType kMetaTypes[] = {
    {"MET_UCHAR", ScalarType::UInt8, false},   {"MET_CHAR", ScalarType::Int8, false},
    {"MET_USHORT", ScalarType::UInt16, false}, {"MET_SHORT", ScalarType::Int16, false},
    {"MET_UINT", ScalarType::UInt32, false},   {"MET_INT", ScalarType::Int32, false},
    {"MET_ULONG", ScalarType::UInt32, false},  {"MET_LONG", ScalarType::Int32, false},
    {"MET_FLOAT", ScalarType::Float32, false}, {"MET_DOUBLE", ScalarType::Float32, true}};

Expected<void> readMetaType(const fs::path& path, const MetaText& text, StoredVolumes& stored) {
  const std::string* channels = text.find({"ElementNumberOfChannels"});
  const std::string* type = text.find({"ElementType"});
  if (type == nullptr) return missingField(path, "ElementType");
  if ((channels != nullptr && *channels != "1") || type->ends_with("_ARRAY"))
    return unsupported("not-scalar", {"volume-colours-or-vectors", {quoted(path)}});
  for (const ElementType& known : kMetaTypes)
    if (*type == known.name) {
      stored.voxels.layout.type = known.type;
      stored.voxels.layout.doubles = known.is_double;
      return {};
    }
  if (type->find("LONG") != type->npos)
    return unsupported("unsupported-type", {"volume-type-unsupported", {quoted(path)}});
  return wrongField(path, "ElementType");
}

Expected<void> readMetaSizes(const fs::path& path, const MetaText& text, StoredVolumes& stored) {
  const std::string* dims = text.find({"NDims"});
  if (dims == nullptr) return missingField(path, "NDims");
  const auto axes = integerOf(*dims);
  if (!axes) return wrongField(path, "NDims");
  if (*axes != 3 && *axes != 4)
    return unsupported("not-scalar", {"volume-axis-count", {quoted(path), std::to_string(*axes)}});
  const std::string* sizes = text.find({"DimSize"});
  const auto words = sizes != nullptr ? wordsOf(*sizes) : std::vector<std::string_view>();
  if (static_cast<std::int64_t>(words.size()) != *axes) return wrongField(path, "DimSize");
  for (std::size_t a = 0; a < words.size(); ++a) {
    const auto size = integerOf(words[a]);
    if (!size) return wrongField(path, "DimSize");
    stored.voxels.layout.sizes[a] = *size;
  }
  return {};
}

/// So many numbers; empty where they are not stated, an error where they are anything else.
Expected<std::vector<double>> numbersOf(const fs::path& path, const MetaText& text,
                                        std::initializer_list<const char*> names,
                                        std::size_t count) {
  std::vector<double> numbers;
  const auto* const name = std::ranges::find_if(
      names, [&](const char* stated) { return text.find({stated}) != nullptr; });
  if (name == names.end()) return numbers;
  const std::string* field = text.find({*name});
  for (const std::string_view word : wordsOf(*field))
    numbers.push_back(numberOf(word).value_or(std::nan("")));
  if (numbers.size() != count ||
      !std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }))
    return wrongField(path, *name);
  return numbers;
}

std::optional<double> millimetresIn(const std::string* unit) {
  if (unit == nullptr || *unit == "mm" || *unit == "?") return 1.0;
  if (*unit == "cm") return 10.0;
  if (*unit == "um") return 1e-3;
  return {};
}

Expected<void> readMetaGeometry(const fs::path& path, const MetaText& text, StoredVolumes& stored) {
  const std::size_t axes = integerOf(*text.find({"NDims"})) == 4 ? 4 : 3;
  const auto spacing = numbersOf(path, text, {"ElementSpacing", "ElementSize"}, axes);
  const auto origin = numbersOf(path, text, {"Offset", "Position", "Origin"}, axes);
  const auto matrix =
      numbersOf(path, text, {"TransformMatrix", "Rotation", "Orientation"}, axes * axes);
  for (const auto* numbers : {&spacing, &origin, &matrix})
    if (!*numbers) return tl::unexpected(numbers->error());
  const auto unit = millimetresIn(text.find({"DistanceUnits"}));
  if (!unit) return malformed("bad-header", {"header-unit-unknown", {quoted(path)}});
  const std::string* letters = text.find({"AnatomicalOrientation"});
  const bool doubted = letters != nullptr && letters->find('?') != letters->npos;

  FileGeometry geometry;
  geometry.dims = stored.voxels.layout.dims();
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double step = spacing->empty() ? 1.0 : *unit * (*spacing)[axis];
    if (step <= 0.0) return wrongField(path, "ElementSpacing");
    for (int c = 0; c < 3 && !matrix->empty(); ++c)
      geometry.steps_mm(c, a) = (*matrix)[axis * axes + static_cast<std::size_t>(c)];
    // the matrix turns, and does not stretch
    if (std::abs(geometry.steps_mm.col(a).norm() - 1.0) > 1e-3)
      return wrongField(path, "TransformMatrix");
    geometry.steps_mm.col(a) *= step / geometry.steps_mm.col(a).norm();
    if (!origin->empty()) geometry.origin_mm[a] = *unit * (*origin)[axis];
  }
  stored.spacing_stated = !spacing->empty();
  stored.facts.orientation_known = !matrix->empty() && !doubted;
  return place(stored, geometry);
}

Expected<void> readMetaValues(const fs::path& path, const MetaText& text, StoredVolumes& stored) {
  const auto slope = numbersOf(path, text, {"ElementToIntensityFunctionSlope"}, 1);
  const auto offset = numbersOf(path, text, {"ElementToIntensityFunctionOffset"}, 1);
  for (const auto* numbers : {&slope, &offset})
    if (!*numbers) return tl::unexpected(numbers->error());
  if (!slope->empty()) stored.slope = slope->front();
  if (stored.slope == 0.0 || !std::isfinite(stored.slope))
    return wrongField(path, "ElementToIntensityFunctionSlope");
  if (!offset->empty()) stored.intercept = offset->front();
  const std::string* modality = text.find({"Modality"});
  for (const char* code : {"CT", "MR", "NM", "US"})
    if (modality != nullptr && *modality == std::string("MET_MOD_") + code)
      stored.facts.modality = code;
  return {};
}

Expected<void> readMetaPlace(const fs::path& path, const MetaText& text, StoredVolumes& stored) {
  StoredVoxels& voxels = stored.voxels;
  if (text.find({"BinaryData"}) != nullptr && !text.isTrue({"BinaryData"}))
    return unsupported("unsupported-syntax", {"voxels-encoding-unknown", {quoted(path)}});
  voxels.deflated = text.isTrue({"CompressedData"});
  voxels.layout.swapped = voxels.layout.bytesPerVoxel() > 1 &&
                          text.isTrue({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
  const std::string& name = *text.find({"ElementDataFile"});
  const bool local = lowered(name) == "local";
  if (name.starts_with("LIST") || name.find('%') != name.npos)
    return unsupported("unsupported-syntax", {"meta-image-several-files", {quoted(path)}});
  if (local) {
    voxels.file = path;
    voxels.offset = text.bytes;
  } else {
    auto file = dataFileOf(path, name);
    if (!file) return tl::unexpected(std::move(file.error()));
    voxels.file = std::move(*file);
  }
  const std::string* field = text.find({"HeaderSize"});
  const auto header = field != nullptr ? integerOf(*field) : std::optional<std::int64_t>(0);
  if (!header) return wrongField(path, "HeaderSize");
  if (*header < -1 || (*header == -1 && voxels.deflated) ||
      (local && *header > 0 && *header < text.bytes))
    return wrongField(path, "HeaderSize");
  // from the beginning of the file, also where that is the header's
  if (*header > 0) voxels.offset = *header;
  if (auto holds = checkStored(voxels, path); !holds) return holds;
  std::error_code error;
  const auto length = static_cast<std::int64_t>(fs::file_size(voxels.file, error));
  const std::int64_t needed = voxels.layout.voxelCount() * voxels.layout.bytesPerVoxel();
  if (*header == -1) voxels.offset = length - needed;
  // a foreign header before the voxels would shift them all
  if (field == nullptr && !local && !voxels.deflated && length > needed)
    return malformed("bad-header",
                     {"header-bytes-unexplained", {quoted(path), std::to_string(length - needed)}});
  return {};
}

}  // namespace

bool looksLikeMetaImage(const Beginning& file) {
  const std::string extension = lowered(file.path.extension().string());
  return extension == ".mhd" || extension == ".mha" || file.bytes.starts_with("ObjectType");
}

Expected<StoredVolumes> describeMetaImage(const fs::path& path) {
  const auto text = readText(path);
  if (!text) return tl::unexpected(text.error());
  StoredVolumes stored;
  for (const auto step :
       {readMetaType, readMetaSizes, readMetaPlace, readMetaGeometry, readMetaValues})
    if (auto done = step(path, *text, stored); !done)
      return tl::unexpected(std::move(done.error()));
  return stored;
}

}  // namespace datasets
