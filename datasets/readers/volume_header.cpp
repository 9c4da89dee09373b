// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/volume_header.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "datasets/readers/files/header_words.h"
#include "datasets/readers/meta_image/header.h"
#include "datasets/readers/nifti/header.h"
#include "datasets/readers/nrrd/header.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;

namespace {

HeaderPtr withStamps(FileStamp of_header, const std::vector<fs::path>& data_files,
                     VolumeHeader header) {
  header.files.push_back(std::move(of_header));
  for (const fs::path& file : data_files) header.files.push_back(stampOf(file));
  return std::make_shared<const VolumeHeader>(std::move(header));
}

Expected<HeaderPtr> nrrdHeader(const fs::path& path) {
  FileStamp stamp = stampOf(path);  // before the parse, so that a change during it is seen
  auto nrrd = parseNrrd(path);
  if (!nrrd) return tl::unexpected(std::move(nrrd.error()));
  auto parsed = std::make_shared<const ParsedNrrd>(std::move(*nrrd));
  return withStamps(std::move(stamp), parsed->header.data_files, {parsed, {}});
}

/// The header of a format whose parser gives StoredVolumes.
template <Expected<StoredVolumes> (*describe)(const fs::path&)>
Expected<HeaderPtr> storedHeader(const fs::path& path) {
  FileStamp stamp = stampOf(path);  // before the parse, as above
  auto stored = describe(path);
  if (!stored) return tl::unexpected(std::move(stored.error()));
  const std::vector<fs::path> data_files{stored->voxels.file};
  return withStamps(std::move(stamp), data_files, {std::move(*stored), {}});
}

bool isNrrd(const Beginning& file) {
  const std::string extension = lowered(file.path.extension().string());
  return looksLikeNrrd(file) || extension == ".nrrd" || extension == ".nhdr";
}

/// All formats of whole volumes; the first that recognises a file reads it. To add a format, add
/// its row.
constexpr VolumeFormat kVolumeFormats[] = {
    {isNrrd, nrrdHeader},
    {looksLikeMetaImage, storedHeader<describeMetaImage>},
    {looksLikeNifti, storedHeader<describeNifti>},
};

}  // namespace

const VolumeFormat* formatOf(const Beginning& file) {
  const auto* const found = std::ranges::find_if(
      kVolumeFormats, [&](const VolumeFormat& format) { return format.recognises(file); });
  return found != std::end(kVolumeFormats) ? found : nullptr;
}

bool isVolumeFile(const fs::path& path) { return formatOf(Beginning(path)) != nullptr; }

Expected<HeaderPtr> headerOf(const fs::path& path) {
  const VolumeFormat* const format = formatOf(Beginning(path));
  return (format != nullptr ? *format : kVolumeFormats[0]).header(path);
}

const StoredVolumes& VolumeHeader::stored() const {
  if (const auto* nrrd = std::get_if<std::shared_ptr<const ParsedNrrd>>(&parsed))
    return (*nrrd)->stored;
  return std::get<StoredVolumes>(parsed);
}

bool VolumeHeader::isUpToDate() const {
  return std::ranges::all_of(files, [](const FileStamp& f) { return stampOf(f.path) == f; });
}

bool VolumeHeader::isReadDirectly() const {
  const auto* nrrd = std::get_if<std::shared_ptr<const ParsedNrrd>>(&parsed);
  return stored().count() == 1 && (nrrd == nullptr || !needsTeem((*nrrd)->header));
}

Expected<haptics::Volume> readDirectly(const VolumeHeader& header, const ReadProgress& progress) {
  if (const auto* nrrd = std::get_if<std::shared_ptr<const ParsedNrrd>>(&header.parsed))
    return decodeNrrd(**nrrd, 0, {}, progress);
  return readVolume(header.stored(), 0, {}, progress);
}

}  // namespace datasets
