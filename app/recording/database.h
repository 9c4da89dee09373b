// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace app {

/// One prepared statement. As in SQLite, parameters count from 1 and columns from 0.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);
  ~Statement();
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&&) = delete;

  Statement& bind(int at, std::int64_t value);
  Statement& bind(int at, double value);
  Statement& bind(int at, std::string_view value);
  Statement& bind(int at, std::span<const std::uint8_t> value);
  Statement& bindNull(int at);

  enum class Step { Row, Done, Failed };
  Step step();
  void reset();
  /// Runs the statement to its end and resets it. Returns false on failure.
  bool run();

  bool isNull(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  std::vector<std::uint8_t> blob(int column) const;

 private:
  sqlite3_stmt* statement_ = nullptr;
};

/// An open SQLite file. One thread at a time.
class Database {
 public:
  enum class Mode {
    Create,   ///< the file must not exist; locked against other processes
    Recover,  ///< the file may be changed; locked against other processes
    Read      ///< the file is finished, and no process writes it: it alone is read, and no log
  };
  /// A statement over the file ends as failed when it has taken more steps of SQLite's machine than
  /// a file of this size can need (pages may form circles), or once `cancel`, which may be null, is
  /// true. `vfs` names an SQLite file system to use instead of the operating system's; for tests.
  static haptics::Expected<Database> open(const std::filesystem::path& path, Mode mode,
                                          const std::atomic<bool>* cancel = nullptr,
                                          const char* vfs = nullptr);
  /// Whether a process, also this one, has a file open to write. The file is looked at and not
  /// written, and no log is made.
  static bool isLocked(const std::filesystem::path& path);
  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  bool run(const char* sql);
  Statement prepare(std::string_view sql);
  /// The first column of the first row, or 0.
  std::int64_t integer(std::string_view sql);
  bool isSound();  ///< the whole file is consistent
  /// Whether the file has these tables and indices, word for word, and nothing else. To be asked
  /// before any other query of a foreign file: a column could be computed, a table be a view.
  bool hasSchema(const char* sql);

  /// Whether the last failure was a full disk, or a missing permission to write.
  bool isFull() const;
  bool isBusy() const;
  std::string complaint() const;  ///< SQLite's message for the last failure
  /// `cancel` is looked at no longer.
  void forgetCancel();
  /// On closing, leaves the log beside the file, because there may be no room to merge it.
  void keepLog();

 private:
  struct Bound;
  explicit Database(sqlite3* database);

  sqlite3* database_;
  std::unique_ptr<Bound> bound_;  ///< of the steps of a statement
};

}  // namespace app
