// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/core/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace haptics {

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
    Read      ///< the file is finished, and no process writes it
  };
  /// `vfs` names an SQLite file system to use instead of the operating system's; for tests.
  static Expected<Database> open(const std::filesystem::path& path, Mode mode,
                                 const char* vfs = nullptr);
  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  bool run(const char* sql);
  Statement prepare(std::string_view sql) { return Statement{database_, sql}; }
  /// The first column of the first row, or 0.
  std::int64_t integer(std::string_view sql);
  bool isSound();  ///< the whole file is consistent

  /// Whether the last failure was a full disk, or a missing permission to write.
  bool isFull() const;
  bool isBusy() const;
  std::string complaint() const;  ///< SQLite's message for the last failure
  /// On closing, leaves the log beside the file, because there may be no room to merge it.
  void keepLog();

 private:
  explicit Database(sqlite3* database) : database_{database} {}
  sqlite3* database_;
};

}  // namespace haptics
