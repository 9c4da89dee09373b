// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nrrd_header.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include "datasets/readers/nrrd_text.h"
#include "datasets/readers/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

struct TypeName {
  std::string_view name;
  const char* teem;
  int bytes;
};

constexpr TypeName kTypes[] = {{"signed char", "signed char", 1},
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

Expected<void> readType(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* type = text.find("type");
  if (type == nullptr) return badHeader(path, "states no type");
  const std::string name = lowered(*type);
  for (const TypeName& known : kTypes)
    if (name == known.name) {
      header.type = known.teem;
      header.bytes_per_voxel = known.bytes;
      return {};
    }
  if (name.find("long") != name.npos || name.find("int64") != name.npos)
    return unsupported(
        "unsupported-type",
        "The voxels of " + quoted(path) +
            " are 64-bit integers, which cannot be shown or touched exactly; convert "
            "them to 32-bit integers or float.");
  if (name == "block")
    return unsupported("not-scalar",
                       "The voxels of " + quoted(path) +
                           " are blocks of bytes and no numbers; export a scalar volume.");
  return badHeader(path, "states an unknown type");
}

Expected<void> readSizes(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* dimension = text.find("dimension");
  const auto axes = dimension ? integerOf(*dimension) : std::nullopt;
  if (!axes) return badHeader(path, "states no dimension");
  if (*axes != 3)
    return unsupported("not-scalar",
                       "The dimension of " + quoted(path) + " is " + std::to_string(*axes) +
                           "; only a volume of three axes and one value per voxel can "
                           "be loaded, so export one such volume.");
  const std::string* sizes = text.find("sizes");
  if (sizes == nullptr) return badHeader(path, "states no sizes");
  const auto words = wordsOf(*sizes);
  if (words.size() != 3) return badHeader(path, "does not state three sizes");
  std::int64_t room = std::numeric_limits<std::int64_t>::max() / 64;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto size = integerOf(words[a]);
    if (!size || *size < 1) return badHeader(path, "states a size that is no positive number");
    if (*size > room)
      return unsupported("too-large",
                         "The header of " + quoted(path) +
                             " states more voxels than any memory holds; export it again.");
    room /= *size;
    header.dims[a] = *size;
  }
  const std::string* kinds = text.find("kinds");
  if (kinds == nullptr) return {};
  for (const std::string_view kind : wordsOf(*kinds)) {
    const std::string k = lowered(kind);
    if (k != "domain" && k != "space" && k != "none" && k != "???")
      return unsupported("not-scalar", "An axis of " + quoted(path) +
                                           " holds the components of colours or vectors and no "
                                           "places; export a scalar volume.");
  }
  return {};
}

Expected<void> readEncoding(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* encoding = text.find("encoding");
  if (encoding == nullptr) return badHeader(path, "states no encoding");
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
    return unsupported("unsupported-syntax", "The voxels of " + quoted(path) +
                                                 " are in an encoding that is unknown here; save "
                                                 "them as raw or gzip.");
  if (header.encoding != NrrdEncoding::Ascii && header.bytes_per_voxel > 1 && !text.find("endian"))
    return badHeader(path, "does not state the byte order");
  const auto skip = [&](const char* name_of_field, const char* other, std::int64_t least,
                        std::int64_t& count) {
    const std::string* field = text.find(name_of_field, other);
    if (field == nullptr) return true;
    header.skip_stated = true;
    const auto number = integerOf(*field);
    count = number.value_or(least - 1);
    return count >= least;
  };
  if (!skip("line skip", "lineskip", 0, header.line_skip) ||
      !skip("byte skip", "byteskip", -1, header.byte_skip))
    return badHeader(path, "skips a number of lines or bytes that makes no sense");
  return {};
}

tl::unexpected<haptics::Error> outside(const fs::path& path) {
  return unsupported("outside-folder",
                     "The header " + quoted(path) +
                         " names a data file outside its own folder; put both into "
                         "one folder and name it without a path.");
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

/// Only plain files below the header's folder, whatever links lie on the way.
Expected<fs::path> dataFile(const fs::path& header, const std::string& name) {
  const fs::path relative(name);
  if (relative.is_absolute() || name == "-") return outside(header);
  for (const fs::path& part : relative)
    if (part == "..") return outside(header);
  const fs::path folder = header.has_parent_path() ? header.parent_path() : fs::path(".");
  std::error_code error;
  const fs::path real_folder = fs::canonical(folder, error);
  const fs::path real = error ? fs::path() : fs::canonical(folder / relative, error);
  if (error)
    return malformed("truncated", "The data file that " + quoted(header) +
                                      " names is missing; copy it beside the header.");
  const auto [end, unused] =
      std::mismatch(real_folder.begin(), real_folder.end(), real.begin(), real.end());
  if (end != real_folder.end() || !fs::is_regular_file(real, error)) return outside(header);
  return real;
}

Expected<void> readDataFiles(const fs::path& path, const NrrdText& text, NrrdHeader& header) {
  const std::string* field = text.find("data file", "datafile");
  if (field == nullptr) {
    if (text.bytes == 0)
      return malformed("truncated", quoted(path) + " ends with its header; fetch it again whole.");
    return {};
  }
  std::vector<std::string> names;
  if (field->starts_with("LIST"))
    names = text.listed_files;
  else if (field->find('%') != field->npos)
    names = expanded(*field);
  else
    names = {*field};
  if (names.empty())
    return badHeader(path, "names its data files in a way that cannot be followed");
  for (const std::string& name : names) {
    auto file = dataFile(path, name);
    if (!file) return tl::unexpected(std::move(file.error()));
    header.data_files.push_back(std::move(*file));
  }
  return {};
}

/// How many voxel bytes one stored byte can stand for at most.
double expansion(NrrdEncoding encoding, int bytes_per_voxel) {
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
  return 1.2e6;  // 45 MB of one value in a block of some forty bytes
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
  if (header.data_files.size() != 1 || header.skip_stated) return {};
  std::error_code error;
  std::int64_t length = 0;
  if (header.encoding == NrrdEncoding::Raw)
    length = static_cast<std::int64_t>(fs::file_size(header.data_files.front(), error));
  if (header.encoding == NrrdEncoding::Gzip) length = gzipLength(header.data_files.front());
  if (error || length <= needed) return {};
  return malformed("bad-header", "The data file of " + quoted(path) + " holds " +
                                     std::to_string(length - needed) +
                                     " bytes more than its voxels need and the header does not say "
                                     "which; add a byte skip to the header.");
}

Expected<void> checkCapacity(const fs::path& path, const NrrdHeader& header) {
  const std::vector<fs::path> files =
      header.data_files.empty() ? std::vector{path} : header.data_files;
  const std::int64_t voxels = header.dims[0] * header.dims[1] * header.dims[2];
  const std::int64_t needed =
      voxels * header.bytes_per_voxel / static_cast<std::int64_t>(files.size());
  for (const fs::path& file : files) {
    std::error_code error;
    auto stored = static_cast<std::int64_t>(fs::file_size(file, error));
    if (error) return notFound(file);
    if (header.data_files.empty()) stored -= header.header_bytes;
    if (header.encoding == NrrdEncoding::Raw) stored -= header.line_skip;
    if (header.encoding == NrrdEncoding::Raw) stored -= std::max<std::int64_t>(header.byte_skip, 0);
    const double most =
        expansion(header.encoding, header.bytes_per_voxel) * static_cast<double>(stored + 1);
    const bool holds = header.encoding == NrrdEncoding::Raw ? stored >= needed
                                                            : most >= static_cast<double>(needed);
    if (!holds)
      return malformed("truncated", quoted(file) + " is too short for the " +
                                        std::to_string(header.dims[0]) + " x " +
                                        std::to_string(header.dims[1]) + " x " +
                                        std::to_string(header.dims[2]) +
                                        " voxels that its header states; copy or fetch it again.");
  }
  if (auto nothing = checkNothingElse(path, header, needed); !nothing) return nothing;
  return checkRoom(voxels, header.bytes_per_voxel);
}

}  // namespace

bool looksLikeNrrd(const fs::path& path) {
  char magic[4] = {};
  std::ifstream in(path, std::ios::binary);
  return in.read(magic, 4) && std::string_view(magic, 4) == "NRRD";
}

Expected<NrrdHeader> readNrrdHeader(const fs::path& path) {
  const auto text = readNrrdText(path);
  if (!text) return tl::unexpected(text.error());
  NrrdHeader header;
  header.header_bytes = text->bytes;
  header.text = text->lines;
  for (const auto step : {readType, readSizes, readEncoding, readDataFiles})
    if (auto done = step(path, *text, header); !done)
      return tl::unexpected(std::move(done.error()));
  if (auto fits = checkCapacity(path, header); !fits)
    return tl::unexpected(std::move(fits.error()));
  return header;
}

}  // namespace datasets
