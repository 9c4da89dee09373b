// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/structure.h"

#include <vtkDICOMDictEntry.h>
#include <vtkDICOMDictionary.h>
#include <vtkDICOMTag.h>
#include <vtkDICOMVR.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace {

constexpr std::size_t kDeepestSequence = 64;  // sequences and items in each other
constexpr int kMostBackwards = 1000;          // elements of an item before which they do not belong
constexpr std::uint32_t kUndefined = 0xffffffffu;
constexpr std::uint32_t kItem = 0xfffee000u, kItemEnd = 0xfffee00du, kSequenceEnd = 0xfffee0ddu;
constexpr std::uint32_t kTransferSyntax = 0x00020010u;
constexpr std::uint32_t kFloatPixels = 0x7fe00008u, kDoublePixels = 0x7fe00009u;
constexpr std::uint32_t kFirstPixels = kFloatPixels, kLastPixels = 0x7fe00010u;
constexpr std::int64_t kPreamble = 128;
constexpr std::string_view kBigEndian = "1.2.840.10008.1.2.2", kImplicit = "1.2.840.10008.1.2",
                           kDeflated = "1.2.840.10008.1.2.1.99";

/// A file's bytes, by place.
class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& path) : in_(path, std::ios::binary | std::ios::ate) {
    size_ = in_ ? static_cast<std::int64_t>(in_.tellg()) : 0;
  }
  std::int64_t size() const { return size_; }
  /// The bytes from `at`; empty where the file does not have so many.
  std::string_view at(std::int64_t at, std::int64_t count) {
    if (at < 0 || count > static_cast<std::int64_t>(window_.size()) || at + count > size_)
      return {};
    if (at < begin_ || at + count > begin_ + filled_) {
      in_.clear();
      in_.seekg(at);
      in_.read(window_.data(), static_cast<std::streamsize>(window_.size()));
      begin_ = at;
      filled_ = in_.gcount();
      if (count > filled_) return {};
    }
    return {window_.data() + (at - begin_), static_cast<std::size_t>(count)};
  }

 private:
  std::ifstream in_;
  std::int64_t size_ = 0, begin_ = 0, filled_ = 0;
  std::array<char, 16384> window_{};
};

/// How elements are written.
struct Encoding {
  bool is_explicit = true;
  bool is_big = false;

  std::uint32_t number(std::string_view bytes) const {
    std::uint32_t value = 0;
    for (std::size_t n = 0; n < bytes.size(); ++n) {
      const auto byte = static_cast<unsigned char>(bytes[is_big ? n : bytes.size() - 1 - n]);
      value = value << 8 | byte;
    }
    return value;
  }
};

struct Element {
  std::uint32_t tag = 0;
  vtkDICOMVR representation;  ///< the dictionary's where the file does not know it
  bool is_unknown = false;  ///< to the file: then what it holds is written without representations
  std::int64_t value = 0;   ///< where it begins
  std::uint32_t length = 0;

  bool isOpen() const { return length == kUndefined; }
};

vtkDICOMVR usualFor(std::uint32_t tag) {
  const vtkDICOMTag known(static_cast<unsigned short>(tag >> 16),
                          static_cast<unsigned short>(tag & 0xffff));
  const vtkDICOMVR usual = vtkDICOMDictionary::FindDictEntry(known).GetVR();
  return usual.IsValid() ? usual : vtkDICOMVR(vtkDICOMVR::UN);
}

bool isPrintable(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= 0x20 && c < 0x7f; });
}

/// The head of an element as vtk-dicom reads it.
std::optional<Element> elementAt(Bytes& bytes, std::int64_t at, const Encoding& encoding) {
  const std::string_view head = bytes.at(at, 8);
  if (head.empty()) return {};
  Element element;
  element.tag = encoding.number(head.substr(0, 2)) << 16 | encoding.number(head.substr(2, 2));
  element.value = at + 8;
  element.length = encoding.number(head.substr(4, 4));
  if (element.tag >> 16 == kItem >> 16) return element;
  element.representation = usualFor(element.tag);
  if (!encoding.is_explicit) {
    if ((element.tag & 0xffff) == 0) element.length = 4;  // whatever it says
    return element;
  }
  const vtkDICOMVR stated(std::string(head.substr(4, 2)).c_str());
  if (!stated.IsValid() && !isPrintable(head.substr(4, 2))) return element;
  const vtkDICOMVR taken = stated.IsValid() ? stated : element.representation;
  element.is_unknown = stated == vtkDICOMVR::UN;
  if (!element.is_unknown) element.representation = taken;
  element.length = encoding.number(head.substr(6, 2));
  if (!taken.HasLongVL()) return element;
  const std::string_view more = bytes.at(at + 8, 4);
  if (more.empty()) return {};
  element.value = at + 12;
  element.length = encoding.number(more);
  return element;
}

/// What has begun and holds elements.
struct Level {
  enum class Kind {
    DataSet,
    Sequence,
    Item,
    Skipped  ///< fragments, or a sequence that nobody knows: passed over as it is
  };
  std::int64_t end;  ///< beyond its last byte; the file's where only a delimiter tells
  Encoding encoding;
  Kind kind = Kind::DataSet;
  std::uint32_t delimiter = 0;
  std::uint32_t last = 0;  ///< tag
  int backwards = 0;       ///< elements whose tag is below that of the one before
  std::map<std::uint32_t, Element> seen = {};  ///< of a data set or an item

  bool isFull() const { return kind == Kind::Item && backwards > kMostBackwards; }
};

haptics::Error cutOff(const std::filesystem::path& path) {
  return malformed("truncated", {"file-damaged", {quoted(path)}}).value();
}

haptics::Error senseless(const std::filesystem::path& path) {
  return malformed("bad-header", {"header-unreadable", {quoted(path)}}).value();
}

/// The level that an element opens: none where it is only a value, unexpected where it has no
/// place.
tl::expected<std::optional<Level>, std::monostate> levelOf(const Element& element,
                                                           const Level& around, std::int64_t size) {
  using enum Level::Kind;
  const bool is_item = element.tag == kItem;
  Level level{element.isOpen() ? size : element.value + element.length, around.encoding, Skipped,
              is_item ? kItemEnd : kSequenceEnd};
  if (element.is_unknown) level.encoding = {false, false};
  if (around.kind == Skipped) {
    if (!element.isOpen()) return std::nullopt;
  } else if (is_item != (around.kind == Sequence)) {
    return tl::unexpected(std::monostate{});  // elements outside of items, or the reverse
  } else if (is_item) {
    level.kind = Item;
  } else if (element.representation == vtkDICOMVR::SQ) {
    level.kind = Sequence;
  } else if (!element.isOpen()) {
    return std::nullopt;
  } else if (element.representation == vtkDICOMVR::UN) {
    level.encoding = {false, false};
  } else if (element.representation != vtkDICOMVR::OB && element.tag >> 16 != kLastPixels >> 16) {
    return tl::unexpected(std::monostate{});
  }
  return level;
}

/// Whether an element was there before with another value. Private ones are nobody's here.
bool isOtherThanBefore(Bytes& bytes, const Element& element, Level& level) {
  if (level.kind != Level::Kind::DataSet && level.kind != Level::Kind::Item) return false;
  if ((element.tag >> 16) % 2 == 1 || (element.tag & 0xffff) == 0) return false;
  const auto [before, is_first] = level.seen.try_emplace(element.tag, element);
  if (is_first) return false;
  const Element& first = before->second;
  if (element.length == 0 && first.length == 0) return false;
  const std::string one(bytes.at(first.value, first.length));
  return one.empty() || one != bytes.at(element.value, element.length);
}

std::string nameOf(std::uint32_t tag) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "(%04X,%04X)", tag >> 16, tag & 0xffff);
  return text.data();
}

/// The elements after the file's own group.
void walk(const std::filesystem::path& named, Bytes& bytes, std::int64_t at,
          const Encoding& encoding, DicomStructure& structure) {
  std::vector<Level> levels{{bytes.size(), encoding}};
  while (at < bytes.size()) {
    while (levels.size() > 1 && at >= levels.back().end) levels.pop_back();
    const auto element = elementAt(bytes, at, levels.back().encoding);
    if (!element) return;
    const bool is_outermost = levels.size() == 1;
    if (is_outermost) structure.sound_bytes = at;
    at = element->value;
    if (!is_outermost && element->tag == levels.back().delimiter) {
      levels.pop_back();
      continue;
    }
    if (is_outermost && (element->tag == kFloatPixels || element->tag == kDoublePixels)) {
      structure.fault = unsupported("unsupported-type",
                                    {"dicom-float-pixels", {quoted(named), nameOf(element->tag)}})
                            .value();
      return;
    }
    if (isOtherThanBefore(bytes, *element, levels.back())) {
      structure.fault =
          malformed("bad-header", {"dicom-element-twice", {quoted(named), nameOf(element->tag)}})
              .value();
      return;
    }
    if (!element->isOpen() && element->length > bytes.size() - at) {
      // whether the pixels are whole is asked once it is known what they should be
      if (is_outermost && element->tag >= kFirstPixels && element->tag <= kLastPixels) return;
      structure.fault = cutOff(named);
      return;
    }
    if (element->tag < levels.back().last) ++levels.back().backwards;
    levels.back().last = element->tag;
    const auto level = levelOf(*element, levels.back(), bytes.size());
    if (!level || levels.size() > kDeepestSequence || levels.back().isFull()) {
      structure.fault = senseless(named);
      return;
    }
    if (*level)
      levels.push_back(**level);
    else
      at += element->length;
  }
}

/// How a data set without a stated syntax begins.
Encoding guessedAt(Bytes& bytes, std::int64_t at) {
  const std::string_view head = bytes.at(at, 8);
  if (head.empty()) return {};
  const vtkDICOMVR stated(std::string(head.substr(4, 2)).c_str());
  return {stated.IsValid(), head[0] == '\0' && head[1] == '\x08'};
}

}  // namespace

DicomStructure structureOf(const std::filesystem::path& path, const std::filesystem::path& named) {
  Bytes bytes(path);
  DicomStructure structure;
  std::int64_t at = 0;
  for (const std::int64_t mark : {kPreamble, std::int64_t{0}})
    if (bytes.at(mark, 4) == "DICM") at = mark + 4;
  for (;;) {
    const auto element = elementAt(bytes, at, {});
    if (!element || element->tag >> 16 != 2) break;
    if (element->length > bytes.size() - element->value) {
      structure.fault = cutOff(named);
      structure.sound_bytes = at;
      return structure;
    }
    at = element->value + element->length;
    if (element->tag != kTransferSyntax) continue;
    structure.syntax = bytes.at(element->value, element->length);
    const auto end = structure.syntax.find_last_not_of(std::string_view("\0 ", 2));
    structure.syntax.resize(end == std::string::npos ? 0 : end + 1);
  }
  if (structure.syntax == kDeflated) return structure;
  const Encoding encoding = structure.syntax.empty() ? guessedAt(bytes, at)
                                                     : Encoding{structure.syntax != kImplicit,
                                                                structure.syntax == kBigEndian};
  walk(named, bytes, at, encoding, structure);
  return structure;
}

}  // namespace datasets
