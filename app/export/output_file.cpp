// SPDX-License-Identifier: BSD-3-Clause
#include "app/export/output_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

namespace app::exporting {

namespace fs = std::filesystem;
using haptics::Error;

Output::Output(fs::path named, fs::path target)
    : named_{std::move(named)}, target_{std::move(target)}, part_{target_.string() + ".part"} {}

haptics::Expected<Output> Output::at(const fs::path& path) {
  std::error_code error;
  Output output{path, fs::weakly_canonical(path, error)};
  if (error) return tl::unexpected(output.unwritable(error.value()));
  if (!output.target_.has_filename() ||
      (fs::exists(output.target_, error) && !fs::is_regular_file(output.target_, error)))
    return tl::unexpected(
        Error{Error::Kind::Unsupported,
              "\"" + path.string() + "\" is no regular file, and is not written over; name a file.",
              "unwritable"});
  std::FILE* file = std::fopen(output.part_.c_str(), "wbe");
  if (file == nullptr) return tl::unexpected(output.unwritable(errno));
  std::fclose(file);
  output.pending_ = true;
  return output;
}

Output::Output(Output&& other) noexcept
    : named_{std::move(other.named_)},
      target_{std::move(other.target_)},
      part_{std::move(other.part_)},
      pending_{std::exchange(other.pending_, false)} {}

Output::~Output() {
  std::error_code ignored;
  if (pending_) fs::remove(part_, ignored);
}

haptics::Expected<std::int64_t> Output::finish() {
  std::error_code error;
  const auto bytes = fs::file_size(part_, error);
  if (!error) fs::rename(part_, target_, error);
  if (error) return tl::unexpected(unwritable(error.value()));
  pending_ = false;
  return static_cast<std::int64_t>(bytes);
}

Error Output::unwritable(int why) const {
  const std::string reason =
      why == ENOSPC || why == EDQUOT ? "the disk is full" : std::generic_category().message(why);
  return {Error::Kind::Unsupported,
          "\"" + named_.string() + "\" cannot be written (" + reason +
              "); choose a folder that can be written and has room.",
          "unwritable"};
}

haptics::Expected<OutputFile> OutputFile::open(const fs::path& path) {
  auto output = Output::at(path);
  if (!output) return tl::unexpected(output.error());
  std::FILE* file = std::fopen(output->part().c_str(), "wbe");
  if (file == nullptr) return tl::unexpected(output->unwritable(errno));
  return OutputFile{std::move(*output), file};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : output_{std::move(other.output_)},
      file_{std::exchange(other.file_, nullptr)},
      size_{other.size_},
      failure_{other.failure_} {}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
}

bool OutputFile::write(std::string_view bytes) {
  if (failure_ != 0) return false;
  if (bytes.empty()) return true;  // of nothing there may be no address
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) failure_ = errno;
  size_ += bytes.size();
  return failure_ == 0;
}

haptics::Expected<void> OutputFile::close() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && failure_ == 0) failure_ = errno;
  if (failure_ != 0) return tl::unexpected(output_.unwritable(failure_));
  return {};
}

}  // namespace app::exporting
