// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/parsed.h"

#include <string>
#include <string_view>
#include <utility>

namespace datasets {

using haptics::Expected;

namespace {

constexpr std::string_view kDeflatedSyntax = "1.2.840.10008.1.2.1.99";

}  // namespace

Expected<std::unique_ptr<ParsedDicom>> ParsedDicom::of(const Beginning& beginning) {
  const std::filesystem::path& path = beginning.path;
  std::unique_ptr<ParsedDicom> parsed{new ParsedDicom};
  parsed->structure_ = structureOf(path, path);
  const auto bare = bareDataSetOf(beginning.bytes);
  if ((bare && bare->needsRewriting()) ||
      (!parsed->structure_.fault && parsed->structure_.syntax == kDeflatedSyntax)) {
    auto copy = RewrittenFile::of(path);
    if (!copy) return tl::unexpected(copy.error());
    parsed->rewritten_.emplace(std::move(*copy));
    parsed->structure_ = structureOf(parsed->rewritten_->path(), path);
  }
  std::string from = parsed->rewritten_ ? parsed->rewritten_->path() : path.string();
  if (parsed->structure_.fault) {
    auto copy = RewrittenFile::beginningOf(from, parsed->structure_.sound_bytes);
    if (!copy) return tl::unexpected(*parsed->structure_.fault);
    parsed->sound_part_.emplace(std::move(*copy));
    from = parsed->sound_part_->path();
  }
  parsed->errors_->watch(parsed->parser_);
  parsed->errors_->watch(parsed->meta_);
  parsed->meta_->SetNumberOfInstances(1);
  parsed->parser_->SetMetaData(parsed->meta_);
  parsed->parser_->SetFileName(from.c_str());
  parsed->parser_->Update();
  return parsed;
}

}  // namespace datasets
