// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/process/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <mutex>
#include <random>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace haptics {

namespace fs = std::filesystem;

namespace {

/// The parts that are not finished.
struct Pending {
  std::mutex mutex;
  std::vector<fs::path> parts;
};
Pending& pending() {
  static auto* const kept = new Pending;  // for whoever ends the program after its last destructor
  return *kept;
}
void forget(const fs::path& part) { std::erase(pending().parts, part); }

Error cannotWrite(const fs::path& named, int why) {
  const Message reason = why == ENOSPC || why == EDQUOT ? Message{"disk-full", {}}
                                                        : std::generic_category().message(why);
  return {Error::Kind::Unsupported, {"output-unwritable", {named.string(), reason}}, "unwritable"};
}

/// What tells a regular file from all others: device, number, and when it was made, since the
/// number of a file that is gone is given to another.
using FileIdentity = std::tuple<std::uint64_t, std::uint64_t, std::int64_t, std::uint32_t>;

std::optional<FileIdentity> identityOf(const fs::path& path) {
  struct statx what {};
  if (::statx(AT_FDCWD, path.c_str(), 0, STATX_TYPE | STATX_INO | STATX_BTIME, &what) != 0 ||
      !S_ISREG(what.stx_mode))
    return {};
  return FileIdentity{std::uint64_t{what.stx_dev_major} << 32 | what.stx_dev_minor, what.stx_ino,
                      what.stx_btime.tv_sec, what.stx_btime.tv_nsec};
}

/// The files that are kept.
struct Kept {
  std::mutex mutex;
  std::set<FileIdentity> files;
};
Kept& kept() {
  static auto* const inputs = new Kept;  // for whoever writes after the last destructor
  return *inputs;
}
bool isKept(const fs::path& path) {
  const auto file = identityOf(path);
  const std::scoped_lock lock(kept().mutex);
  return file && kept().files.contains(*file);
}

tl::unexpected<Error> wouldReplaceInput(const fs::path& named) {
  return tl::unexpected(
      Error{Error::Kind::Unsupported, {"output-is-input", {named.string()}}, "unwritable"});
}

/// 0, or an errno.
int sync(const fs::path& path, int flags) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | flags);
  if (file < 0) return errno;
  // there are file systems that have nothing to sync
  const int why = ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
  ::close(file);
  return why;
}

/// The descriptor of this process that a path such as /dev/stdout or /proc/self/fd/3 stands for.
std::optional<int> descriptorAt(fs::path path) {
  const fs::path ours = "/proc/" + std::to_string(::getpid()) + "/fd";
  constexpr int kMostLinks = 40;
  for (int links = 0; links < kMostLinks; ++links) {
    std::error_code error;
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", error);
    if (error) return {};
    const std::string name = path.filename().string();
    int descriptor = -1;
    const auto [end, wrong] = std::from_chars(name.data(), name.data() + name.size(), descriptor);
    if (folder == ours && wrong == std::errc{} && end == name.data() + name.size())
      return descriptor;
    const fs::path link = fs::read_symlink(path, error);
    if (error) return {};
    path = folder / link;
  }
  return {};
}

/// Opens what can only be written as it is; none where it is a file, or nothing yet. Waits for a
/// pipe's reader.
std::optional<int> openedAsItIs(const fs::path& path) {
  if (const auto descriptor = descriptorAt(path))
    return ::fcntl(*descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  struct stat what {};
  if (::stat(path.c_str(), &what) != 0 || !(S_ISCHR(what.st_mode) || S_ISFIFO(what.st_mode)))
    return {};
  return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
}

}  // namespace

Output::Output(fs::path named, fs::path target)
    : named_{std::move(named)}, target_{std::move(target)} {}

Expected<Output> Output::at(const fs::path& path) {
  std::error_code error;
  Output output{path, fs::weakly_canonical(path, error)};
  if (error) return tl::unexpected(output.unwritable(error.value()));
  if (!output.target_.has_filename() ||
      (fs::exists(output.target_, error) && !fs::is_regular_file(output.target_, error)))
    return tl::unexpected(
        Error{Error::Kind::Unsupported, {"output-no-regular-file", {path.string()}}, "unwritable"});
  if (isKept(output.target_)) return wouldReplaceInput(path);
  // two may write at once, and what an earlier one left is not ours
  std::random_device lot;
  const std::scoped_lock lock(pending().mutex);
  int file = -1;
  // names have 255 bytes, and this one may have them all
  const std::string begin = output.target_.filename().string().substr(0, 230);
  do {
    output.part_ = output.target_.parent_path() / (begin + ".part" + std::to_string(lot()));
    file = ::open(output.part_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  } while (file < 0 && errno == EEXIST);
  if (file < 0) return tl::unexpected(output.unwritable(errno));
  ::close(file);
  pending().parts.push_back(output.part_);
  output.pending_ = true;
  return output;
}

Output::Output(Output&& other) noexcept
    : named_{std::move(other.named_)},
      target_{std::move(other.target_)},
      part_{std::move(other.part_)},
      pending_{std::exchange(other.pending_, false)} {}

Output::~Output() {
  if (!pending_) return;
  const std::scoped_lock lock(pending().mutex);
  std::error_code ignored;
  fs::remove(part_, ignored);
  forget(part_);
}

Expected<std::int64_t> Output::finish() {
  if (const int why = sync(part_, 0); why != 0) return tl::unexpected(unwritable(why));
  // while it was written, its name may have become another's
  if (isKept(target_)) return wouldReplaceInput(named_);
  const std::scoped_lock lock(pending().mutex);
  std::error_code error;
  const auto bytes = fs::file_size(part_, error);
  if (!error) fs::rename(part_, target_, error);
  if (error) return tl::unexpected(unwritable(error.value()));
  pending_ = false;
  forget(part_);
  // that its name survives the power, too; where that cannot be had, it is there all the same
  sync(target_.parent_path(), O_DIRECTORY);
  return static_cast<std::int64_t>(bytes);
}

Error Output::unwritable(int why) const { return cannotWrite(named_, why); }

Expected<OutputFile> OutputFile::open(const fs::path& path) {
  if (const auto special = openedAsItIs(path)) {
    std::FILE* file = *special < 0 ? nullptr : ::fdopen(*special, "w");
    if (file == nullptr) return tl::unexpected(cannotWrite(path, errno));
    return OutputFile{path, std::nullopt, file};
  }
  auto output = Output::at(path);
  if (!output) return tl::unexpected(output.error());
  std::FILE* file = std::fopen(output->part().c_str(), "wbe");
  if (file == nullptr) return tl::unexpected(output->unwritable(errno));
  return OutputFile{path, std::move(*output), file};
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : named_{std::move(other.named_)},
      output_{std::move(other.output_)},
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

Expected<void> OutputFile::close() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && failure_ == 0) failure_ = errno;
  if (failure_ != 0) return tl::unexpected(cannotWrite(named_, failure_));
  return {};
}

Expected<std::int64_t> OutputFile::finish() {
  return output_ ? output_->finish() : static_cast<std::int64_t>(size_);
}

Expected<void> writeFile(const fs::path& path, std::string_view text) {
  auto file = OutputFile::open(path);
  if (!file) return tl::unexpected(file.error());
  file->write(text);
  if (auto closed = file->close(); !closed) return closed;
  if (auto finished = file->finish(); !finished) return tl::unexpected(finished.error());
  return {};
}

void keepInput(const fs::path& path) {
  const auto file = identityOf(path);
  if (!file) return;
  const std::scoped_lock lock(kept().mutex);
  kept().files.insert(*file);
}

void discardOutputs() {
  pending().mutex.lock();  // for good
  std::error_code ignored;
  for (const fs::path& part : pending().parts) fs::remove(part, ignored);
}

}  // namespace haptics
