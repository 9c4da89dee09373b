// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/fetch/archive.h"

namespace app::fetch {

/// Gives DCMTK a dictionary of the few elements that Arrivals reads: its own takes longer to read
/// than a search. Before anything else of DCMTK; not for DIMSE, which needs more.
void shortenDictionary();

/// The images of one series as they come: each is written to part(), then kept or not. Names of
/// files are numbers that this class counts; nothing that a server sent becomes a part of a path.
class Arrivals {
 public:
  /// Images, of how many if that is known, and bytes so far.
  using Progress =
      std::function<void(std::size_t images, std::optional<std::size_t> of, std::uint64_t bytes)>;
  Arrivals(std::filesystem::path folder, FoundSeries wanted, Progress progress);

  /// Where the next image is written; a file that is there is of no worth.
  const std::filesystem::path& part() const { return part_; }
  /// Looks at part(), which is whole, and keeps it if it is an image of the wanted series that has
  /// not come yet. Else it goes, and is counted. An error ends the transfer.
  haptics::Expected<void> keep();
  /// Whether part() ends where its data set does, for where nothing else says so.
  bool isWhole() const;
  /// Removes part().
  void drop();
  /// Bytes of part() came; bounds the whole transfer.
  haptics::Expected<void> came(std::size_t bytes);

  /// How many images the server says there are. Any thread.
  void announce(std::size_t images) { announced_ = images; }
  /// The identifiers of all images, if the server listed them.
  void expect(std::vector<std::string> images);
  /// Those that were listed and have not come.
  std::vector<std::string> missing() const;
  bool listed() const { return !expected_.empty(); }
  std::optional<std::size_t> of() const;

  std::size_t images() const { return have_.size(); }
  std::uint64_t bytes() const { return bytes_; }
  std::size_t strangers() const { return strangers_; }  ///< of other series, not kept
  std::size_t unreadable() const { return unreadable_; }

 private:
  std::filesystem::path folder_, part_;
  FoundSeries wanted_;
  Progress progress_;
  std::set<std::string> have_, expected_;
  std::atomic<std::size_t> announced_{0};
  std::uint64_t bytes_ = 0;
  std::size_t strangers_ = 0, unreadable_ = 0;
};

}  // namespace app::fetch
