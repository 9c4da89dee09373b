// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/arrivals.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace app::fetch {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 30;
constexpr std::size_t kMostWaste = 10'000;  // files that are not kept, and the server is given up
constexpr Uint32 kLongestValue = 4096;  // bytes of a value that is read; longer ones stay on disk

struct Identity {
  std::string study, series, image;
};

/// Who a file says that it is; nothing if it is no DICOM file. Reads the elements up to the series'
/// identifier only.
std::optional<Identity> identityOf(const fs::path& path) {
  DcmFileFormat file;
  const OFCondition read =
      file.loadFileUntilTag(OFFilename(path.c_str()), EXS_Unknown, EGL_noChange, kLongestValue,
                            ERM_autoDetect, DcmTagKey(0x0020, 0x0010));
  if (read.bad()) return {};
  Identity identity;
  for (const auto& [tag, text] : {std::pair{DCM_StudyInstanceUID, &identity.study},
                                  std::pair{DCM_SeriesInstanceUID, &identity.series},
                                  std::pair{DCM_SOPInstanceUID, &identity.image}}) {
    OFString value;
    if (file.getDataset()->findAndGetOFString(tag, value).bad()) return {};
    *text = value.c_str();
  }
  if (!isUid(identity.image)) return {};
  return identity;
}

}  // namespace

void shortenDictionary() {
  setenv(DCM_DICT_ENVIRONMENT_VARIABLE, "/dev/null", 1);
  DcmDataDictionary& dictionary = dcmDataDict.wrlock();
  for (const DcmTagKey& tag : {DCM_SOPInstanceUID, DCM_StudyInstanceUID, DCM_SeriesInstanceUID})
    dictionary.addEntry(new DcmDictEntry(tag.getGroup(), tag.getElement(), DcmVR{EVR_UI}, "UID", 1,
                                         1, nullptr, OFFalse, nullptr));
  dcmDataDict.wrunlock();
}

Arrivals::Arrivals(fs::path folder, FoundSeries wanted, Progress progress)
    : folder_{std::move(folder)},
      part_{folder_ / "coming"},
      wanted_{std::move(wanted)},
      progress_{std::move(progress)} {}

Expected<void> Arrivals::keep() {
  const auto identity = identityOf(part_);
  if (!identity) {
    ++unreadable_;
  } else if (identity->study != wanted_.study_uid || identity->series != wanted_.series_uid) {
    ++strangers_;
  } else if (!have_.contains(identity->image)) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%06zu.dcm", have_.size() + 1);
    std::error_code error;
    fs::rename(part_, folder_ / name.data(), error);
    if (error)
      return failed("unwritable", {"output-unwritable", {folder_.string(), error.message()}});
    have_.insert(identity->image);
    progress_(have_.size(), of(), bytes_);
    if (have_.size() > kMostImages)
      return refused("too-many", {"fetch-too-many-images", {std::to_string(kMostImages)}});
    return {};
  }
  drop();
  if (strangers_ + unreadable_ > kMostWaste)
    return refused("answer", {"fetch-other-images-only", {std::to_string(kMostWaste)}});
  return {};
}

bool Arrivals::isWhole() const {
  DcmFileFormat file;
  return file
      .loadFile(OFFilename(part_.c_str()), EXS_Unknown, EGL_noChange, kLongestValue, ERM_autoDetect)
      .good();
}

void Arrivals::drop() {
  std::error_code ignored;
  fs::remove(part_, ignored);
}

Expected<void> Arrivals::came(std::size_t bytes) {
  bytes_ += bytes;
  progress_(have_.size(), of(), bytes_);
  if (bytes_ > kMostBytes)
    return refused("too-many", {"fetch-too-many-bytes", {std::to_string(kMostBytes >> 30)}});
  return {};
}

void Arrivals::expect(std::vector<std::string> images) {
  expected_.insert(images.begin(), images.end());
}

std::vector<std::string> Arrivals::missing() const {
  std::vector<std::string> left;
  for (const std::string& image : expected_)
    if (!have_.contains(image)) left.push_back(image);
  return left;
}

std::optional<std::size_t> Arrivals::of() const {
  if (listed()) return expected_.size();
  if (const std::size_t announced = announced_; announced > 0) return announced;
  if (wanted_.images) return static_cast<std::size_t>(*wanted_.images);
  return {};
}

}  // namespace app::fetch
