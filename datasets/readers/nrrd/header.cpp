// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd/header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>

#include "datasets/readers/files/data_file.h"
#include "datasets/readers/files/refusal.h"
#include "datasets/readers/files/stored_volumes.h"
#include "datasets/readers/nrrd/text.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

struct TypeName {
  std::string_view name;
  const char* teem;
  int bytes;
};

constexpr TypeName kNrrdTypes[] = {{"signed char", "signed char", 1},
                                   {"int8", "signed char", 1},
                                   {"int8_t", "signed char", 1},
                                   {"uchar", "unsigned char", 1},
                                   {"unsigned char", "unsigned char", 1},
                                   {"uint8", "unsigned char", 1},
                                   {"uint8_t", "unsigned char", 1},
                                   {"short", "short", 2},
                                   {"short int", "short", 2},
                                   {"signed short", "short", 2},
                                   {"signed short int", "short", 2},
                                   {"int16", "short", 2},
                                   {"int16_t", "short", 2},
                                   {"ushort", "unsigned short", 2},
                                   {"unsigned short", "unsigned short", 2},
                                   {"unsigned short int", "unsigned short", 2},
                                   {"uint16", "unsigned short", 2},
                                   {"uint16_t", "unsigned short", 2},
                                   {"int", "int", 4},
                                   {"signed int", "int", 4},
                                   {"int32", "int", 4},
                                   {"int32_t", "int", 4},
                                   {"uint", "unsigned int", 4},
                                   {"unsigned int", "unsigned int", 4},
                                   {"uint32", "unsigned int", 4},
                                   {"uint32_t", "unsigned int", 4},
                                   {"float", "float", 4},
                                   {"double", "double", 8}};

Expected<void> readNrrdType(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* type = text.find("type");
  if (type == nullptr) return missingField(path, "type");
  const std::string name = lowered(*type);
  for (const TypeName& known : kNrrdTypes)
    if (name == known.name) {
      header.type = known.teem;
      header.bytes_per_voxel = known.bytes;
      return {};
    }
  if (name.find("long") != name.npos || name.find("int64") != name.npos)
    return unsupported("unsupported-type", {"volume-type-unsupported", {quoted(path)}});
  if (name == "block")
    return unsupported("not-scalar", {"volume-colours-or-vectors", {quoted(path)}});
  return wrongField(path, "type");
}

using Words = std::vector<std::string_view>;

/// The components of a vector, "(1, 0, 0)".
Words componentsOf(std::string_view vector) {
  Words words;
  for (std::size_t at = 0; at <= vector.size();) {
    const auto end = std::min(vector.find(',', at), vector.size());
    words.push_back(trimmed(vector.substr(at, end - at)));
    at = end + 1;
  }
  return words;
}

/// The components of each vector of a field; empty for "none".
std::vector<Words> vectorsOf(std::string_view text) {
  std::vector<Words> vectors;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const bool vector = text.front() == '(';
    const auto end = std::min(vector ? text.find(')') : text.find_first_of(" \t("), text.size());
    vectors.push_back(vector ? componentsOf(text.substr(1, end - 1)) : Words());
    text.remove_prefix(std::min(vector ? end + 1 : end, text.size()));
  }
  return vectors;
}

/// Whether an axis leads anywhere in space. Of four components the last is a time.
bool isDirected(const Words& vector) {
  const bool timed = vector.size() == 4;
  return std::any_of(vector.begin(), vector.end() - (timed ? 1 : 0), [&](std::string_view word) {
    const double component = numberOf(word).value_or(1.0);
    return !std::isnan(component) && (!timed || component != 0.0);
  });
}

/// Per axis whether it has a direction in space; empty where directions are not stated.
std::vector<bool> directedAxes(const NrrdText& text) {
  const std::string* field = text.find("space directions");
  std::vector<bool> directed;
  if (field == nullptr) return directed;
  for (const Words& vector : vectorsOf(*field)) directed.push_back(isDirected(vector));
  return directed;
}

/// How many components a vector in the header's space has; 0: it states no space.
std::int64_t spaceDimensionOf(const NrrdText& text) {
  if (const std::string* field = text.find("space dimension")) return integerOf(*field).value_or(0);
  const std::string* field = text.find("space");
  if (field == nullptr) return 0;
  const std::string name = lowered(*field);
  const bool timed = name.ends_with("time") || name == "rast" || name == "last" || name == "lpst";
  return timed ? 4 : 3;
}

bool areNumbers(const Words& words) {
  return std::ranges::all_of(words, [](std::string_view w) { return numberOf(w).has_value(); });
}

/// Every number that places the voxels is one as a whole: teem takes "1,5" for 1.
Expected<void> checkNumbers(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  constexpr std::array<const char*, 2> kPerAxis[] = {
      {"spacings", nullptr}, {"axis mins", "axismins"}, {"axis maxs", "axismaxs"}};
  for (const auto& [name, other] : kPerAxis) {
    const std::string* field = text.find(name, other);
    if (field == nullptr) continue;
    const Words words = wordsOf(*field);
    if (words.size() != header.sizes.size() || !areNumbers(words)) return noNumbers(path, name);
  }
  if (const std::string* field = text.find("space dimension"); field && !integerOf(*field))
    return wrongField(path, "space dimension");
  const auto dimension =
      static_cast<std::size_t>(std::max<std::int64_t>(spaceDimensionOf(text), 0));
  for (const char* name : {"space directions", "space origin"}) {
    const std::string* field = text.find(name);
    if (field == nullptr) continue;
    for (const Words& vector : vectorsOf(*field)) {
      const bool counted = dimension == 0 || vector.empty() || vector.size() == dimension;
      if (!counted || !areNumbers(vector)) return noNumbers(path, name);
    }
  }
  return {};
}

tl::unexpected<haptics::Error> notAPlace(const fs::path& path, std::size_t axis,
                                         const std::string& kind) {
  return unsupported("not-scalar",
                     {"nrrd-axis-kind", {std::to_string(axis + 1), quoted(path), kind}});
}

/// Which axes are i, j and k, and which counts the volumes.
Expected<void> readAxes(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::vector<std::int64_t>& sizes = header.sizes;
  std::vector<std::string> kinds(sizes.size());
  if (const std::string* field = text.find("kinds"); field != nullptr) {
    const auto words = wordsOf(*field);
    if (words.size() != sizes.size()) return wrongField(path, "kinds");
    std::ranges::transform(words, kinds.begin(), lowered);
  }
  const std::vector<bool> directed = directedAxes(text);
  std::vector<std::size_t> places, others;
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const std::string& kind = kinds[a];
    const bool space = kind == "domain" || kind == "space";
    const bool counts = kind == "list" || kind == "time";
    const bool unstated = kind.empty() || kind == "none" || kind == "???";
    const bool single = sizes[a] == 1 && (kind == "stub" || kind == "scalar");
    if (!space && !unstated && !single && !(counts && sizes.size() == 4))
      return notAPlace(path, a, kind);
    const bool place = sizes.size() == 3 || (directed.size() == sizes.size() ? directed[a] : space);
    (place ? places : others).push_back(a);
  }
  if (places.size() != 3)
    return unsupported("not-scalar",
                       {"nrrd-four-places", {quoted(path), std::to_string(places.size())}});
  for (std::size_t a = 0; a < 3; ++a) {
    header.axes[a] = static_cast<unsigned>(places[a]);
    header.dims[a] = sizes[places[a]];
  }
  if (others.empty()) return {};
  header.volume_axis = static_cast<int>(others.front());
  header.volumes = sizes[others.front()];
  if (header.volumes > kMostVolumes)
    return unsupported("too-large", {"file-too-many-volumes",
                                     {quoted(path), std::to_string(header.volumes),
                                      std::to_string(kMostVolumes)}});
  return {};
}

Expected<void> readNrrdSizes(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* dimension = text.find("dimension");
  if (dimension == nullptr) return missingField(path, "dimension");
  const auto axes = integerOf(*dimension);
  if (!axes) return wrongField(path, "dimension");
  if (*axes != 3 && *axes != 4)
    return unsupported("not-scalar", {"volume-axis-count", {quoted(path), std::to_string(*axes)}});
  const std::string* sizes = text.find("sizes");
  if (sizes == nullptr) return missingField(path, "sizes");
  const auto words = wordsOf(*sizes);
  if (static_cast<std::int64_t>(words.size()) != *axes) return wrongField(path, "sizes");
  std::int64_t room = std::numeric_limits<std::int64_t>::max() / 64;
  for (const std::string_view word : words) {
    const auto size = integerOf(word);
    if (!size || *size < 1) return wrongField(path, "sizes");
    if (*size > std::min<std::int64_t>(room, std::numeric_limits<std::int32_t>::max()))
      return unsupported("too-large", {"header-too-many-voxels", {quoted(path)}});
    room /= *size;
    header.sizes.push_back(*size);
  }
  return {};
}

Expected<void> readEncoding(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* encoding = text.find("encoding");
  if (encoding == nullptr) return missingField(path, "encoding");
  const std::string name = lowered(*encoding);
  if (name == "raw")
    header.encoding = NrrdEncoding::Raw;
  else if (name == "txt" || name == "text" || name == "ascii")
    header.encoding = NrrdEncoding::Ascii;
  else if (name == "hex")
    header.encoding = NrrdEncoding::Hex;
  else if (name == "gz" || name == "gzip")
    header.encoding = NrrdEncoding::Gzip;
  else if (name == "bz2" || name == "bzip2")
    header.encoding = NrrdEncoding::Bzip2;
  else
    return unsupported("unsupported-syntax", {"voxels-encoding-unknown", {quoted(path)}});
  const std::string* endian = text.find("endian");
  header.big_endian = endian != nullptr && lowered(*endian) == "big";
  if (header.encoding != NrrdEncoding::Ascii && header.bytes_per_voxel > 1 && endian == nullptr)
    return missingField(path, "endian");
  return {};
}

/// How much of each data file is none of the voxels.
Expected<void> readSkips(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const auto skip = [&](const char* name, const char* other, std::int64_t least,
                        std::int64_t& count) -> Expected<void> {
    const std::string* field = text.find(name, other);
    if (field == nullptr) return {};
    header.skip_stated = true;
    const auto number = integerOf(*field);
    if (!number) return wrongField(path, name);
    count = *number;
    if (count < least) return wrongField(path, name);
    return {};
  };
  if (auto lines = skip("line skip", "lineskip", 0, header.line_skip); !lines) return lines;
  return skip("byte skip", "byteskip", -1, header.byte_skip);
}

/// "slices/slice_%03d.raw 0 41 1": the names that teem would print; empty if it is no such form.
std::vector<std::string> expanded(std::string_view pattern) {
  const auto words = wordsOf(pattern);
  if (words.size() < 4 || words.size() > 5) return {};
  const std::string_view name = words[0];
  const auto percent = name.find('%');
  const auto conversion = name.find('d', percent);
  if (percent == name.npos || conversion == name.npos || name.rfind('%') != percent) return {};
  const std::string_view width_text = name.substr(percent + 1, conversion - percent - 1);
  const auto width = width_text.empty() ? std::optional<std::int64_t>(0) : integerOf(width_text);
  const auto first = integerOf(words[1]), last = integerOf(words[2]), step = integerOf(words[3]);
  if (!width || *width < 0 || *width > 9 || !first || !last || !step || *step == 0) return {};
  if (!width_text.empty() && width_text.front() != '0') return {};
  if ((*last - *first) / *step < 0 ||
      (*last - *first) / *step >= static_cast<std::int64_t>(kMostDataFiles) || *first < 0 ||
      *last < 0)
    return {};
  std::vector<std::string> names;
  for (std::int64_t i = *first; *step > 0 ? i <= *last : i >= *last; i += *step) {
    std::string number = std::to_string(i);
    if (static_cast<std::int64_t>(number.size()) < *width)
      number.insert(0, static_cast<std::size_t>(*width) - number.size(), '0');
    names.push_back(std::string(name.substr(0, percent)) + number +
                    std::string(name.substr(conversion + 1)));
  }
  return names;
}

/// "512 x 512 x 300".
std::string inWords(const std::vector<std::int64_t>& sizes) {
  std::string words;
  for (const std::int64_t size : sizes)
    words += (words.empty() ? "" : " x ") + std::to_string(size);
  return words;
}

/// Whether so many files have a piece each: one for each place along the axes behind the first
/// `axes`, or, where the pieces have all axes, a slab of the slowest.
bool areShared(const std::vector<std::int64_t>& sizes, std::int64_t axes, std::int64_t files) {
  const auto dimension = static_cast<std::int64_t>(sizes.size());
  if (axes < 1 || axes > dimension) return false;
  if (axes == dimension) return sizes.back() % files == 0;
  const auto pieces = std::accumulate(sizes.begin() + static_cast<std::ptrdiff_t>(axes),
                                      sizes.end(), std::int64_t{1}, std::multiplies<>());
  return pieces == files;
}

/// Names of data files, and how many axes the piece in each has; no names if they cannot be
/// followed.
struct DataFileNames {
  std::vector<std::string> names;
  std::int64_t axes = 0;
};

DataFileNames namesIn(const std::string& field, const NrrdText& text, std::size_t dimension) {
  const bool list = isList(field), pattern = !list && field.find('%') != field.npos;
  if (!list && !pattern) return {{field}, 0};
  // "LIST 2" and "s%d.raw 1 9 1 2"; all axes but the slowest where it is not said
  const Words words = wordsOf(field);
  const std::size_t said = list ? 1 : 4;
  const auto axes = words.size() > said ? integerOf(words[said])
                                        : std::optional(static_cast<std::int64_t>(dimension) - 1);
  if (!axes || words.size() > said + 1) return {};
  return {list ? text.listed_files : expanded(field), *axes};
}

Expected<void> readDataFiles(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* field = text.find("data file", "datafile");
  if (field == nullptr) {
    if (text.bytes == 0) return malformed("truncated", {"file-damaged", {quoted(path)}});
    return {};
  }
  const auto [names, axes] = namesIn(*field, text, header.sizes.size());
  if (names.empty()) return malformed("bad-header", {"header-unreadable", {quoted(path)}});
  for (const std::string& name : names) {
    auto file = dataFileOf(path, name);
    if (!file) return tl::unexpected(std::move(file.error()));
    header.data_files.push_back(std::move(*file));
  }
  const auto count = static_cast<std::int64_t>(names.size());
  if (count > 1 && !areShared(header.sizes, axes, count))
    return malformed("bad-header", {"nrrd-data-file-count",
                                    {quoted(path), std::to_string(count), inWords(header.sizes)}});
  return {};
}

/// How many voxel bytes one stored byte can stand for at most. `needed`: bytes of the voxels.
double expansion(NrrdEncoding encoding, int bytes_per_voxel, std::int64_t needed) {
  switch (encoding) {
    case NrrdEncoding::Raw:
      return 1.0;
    case NrrdEncoding::Ascii:
      return bytes_per_voxel / 2.0;  // a digit and a blank
    case NrrdEncoding::Hex:
      return 0.5;
    case NrrdEncoding::Gzip:
      return 1032.0;  // the most that deflate can do
    case NrrdEncoding::Bzip2:
      break;
  }
  // 45 MB of one value in a block of some forty bytes; but no scan is of one value, and what claims
  // to be one would take gigabytes
  constexpr std::int64_t kLarge = std::int64_t{1} << 28;
  return needed > kLarge ? 1e5 : 1.2e6;
}

/// The unpacked length of a gzip file of one member, as its last four bytes state it.
std::int64_t gzipLength(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  unsigned char bytes[4] = {};
  in.seekg(-4, std::ios::end);
  if (!in.read(reinterpret_cast<char*>(bytes), 4)) return 0;
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | std::int64_t{bytes[3]} << 24;
}

/// A foreign header before the voxels would shift them all: a data file must not be longer than
/// they are, unless the header says what to skip.
Expected<void> checkNothingElse(const fs::path& path, const NrrdHeader& header,
                                std::int64_t needed) {
  if (header.skip_stated) return {};
  for (const fs::path& file : header.data_files) {
    std::error_code error;
    std::int64_t length = 0;
    if (header.encoding == NrrdEncoding::Raw)
      length = static_cast<std::int64_t>(fs::file_size(file, error));
    if (header.encoding == NrrdEncoding::Gzip) length = gzipLength(file);
    if (!error && length > needed)
      return malformed("bad-header", {"header-bytes-unexplained",
                                      {quoted(path), std::to_string(length - needed)}});
  }
  return {};
}

Expected<void> checkCapacity(const fs::path& path, const NrrdHeader& header) {
  const std::vector<fs::path> files =
      header.data_files.empty() ? std::vector{path} : header.data_files;
  const std::int64_t needed = header.voxelsPerFile() * header.bytes_per_voxel;
  for (const fs::path& file : files) {
    std::error_code error;
    auto stored = static_cast<std::int64_t>(fs::file_size(file, error));
    if (error) return notFound(file);
    if (header.data_files.empty()) stored -= header.header_bytes;
    if (header.encoding == NrrdEncoding::Raw) stored -= header.line_skip;
    if (header.encoding == NrrdEncoding::Raw) stored -= std::max<std::int64_t>(header.byte_skip, 0);
    const double most = expansion(header.encoding, header.bytes_per_voxel, needed) *
                        static_cast<double>(stored + 1);
    const bool holds = header.encoding == NrrdEncoding::Raw ? stored >= needed
                                                            : most >= static_cast<double>(needed);
    if (!holds) return malformed("truncated", {"file-shorter-than-header", {quoted(file)}});
  }
  return checkNothingElse(path, header, needed);
}

}  // namespace

std::int64_t NrrdHeader::voxelCount() const {
  return std::accumulate(sizes.begin(), sizes.end(), std::int64_t{1}, std::multiplies<>());
}

std::int64_t NrrdHeader::voxelsPerFile() const {
  return voxelCount() / static_cast<std::int64_t>(std::max<std::size_t>(data_files.size(), 1));
}

bool looksLikeNrrd(const Beginning& file) { return file.bytes.starts_with("NRRD"); }

bool holdsSegments(const Beginning& file) {
  if (!looksLikeNrrd(file)) return false;
  const auto text = readNrrdText(file.path);
  return text && (text->keys.contains("Segment0_ID") || text->keys.contains("Segment0_Name"));
}

Expected<NrrdHeader> readNrrdHeader(const fs::path& path) {
  const auto text = readNrrdText(path);
  if (!text) return tl::unexpected(text.error());
  NrrdHeader header;
  header.header_bytes = text->bytes;
  header.text = text->lines;
  header.skips = text->skips;
  for (const auto step : {readNrrdType, readNrrdSizes, checkNumbers, readAxes, readEncoding,
                          readSkips, readDataFiles})
    if (auto done = step(path, *text, header); !done)
      return tl::unexpected(std::move(done.error()));
  if (auto fits = checkCapacity(path, header); !fits)
    return tl::unexpected(std::move(fits.error()));
  return header;
}

}  // namespace datasets
