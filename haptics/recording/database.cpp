// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/recording/database.h"

#include <sqlite3.h>

#include <utility>

namespace haptics {

Statement::Statement(sqlite3* database, std::string_view sql) {
  sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement_, nullptr);
}
Statement::~Statement() { sqlite3_finalize(statement_); }
Statement::Statement(Statement&& other) noexcept
    : statement_{std::exchange(other.statement_, nullptr)} {}

Statement& Statement::bind(int at, std::int64_t value) {
  sqlite3_bind_int64(statement_, at, value);
  return *this;
}
Statement& Statement::bind(int at, double value) {
  sqlite3_bind_double(statement_, at, value);
  return *this;
}
Statement& Statement::bind(int at, std::string_view value) {
  sqlite3_bind_text64(statement_, at, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  return *this;
}
Statement& Statement::bind(int at, std::span<const std::uint8_t> value) {
  // a null pointer would be bound as NULL
  static constexpr std::uint8_t kNothing = 0;
  sqlite3_bind_blob64(statement_, at, value.empty() ? &kNothing : value.data(), value.size(),
                      SQLITE_TRANSIENT);
  return *this;
}
Statement& Statement::bindNull(int at) {
  sqlite3_bind_null(statement_, at);
  return *this;
}

Statement::Step Statement::step() {
  // SQLite answers to a statement that was not prepared, too
  switch (sqlite3_step(statement_)) {
    case SQLITE_ROW:
      return Step::Row;
    case SQLITE_DONE:
      return Step::Done;
    default:
      return Step::Failed;
  }
}
void Statement::reset() { sqlite3_reset(statement_); }
bool Statement::run() {
  Step at = Step::Row;
  while (at == Step::Row) at = step();
  const bool done = sqlite3_reset(statement_) == SQLITE_OK;
  return at == Step::Done && done;
}

bool Statement::isNull(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}
std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}
double Statement::real(int column) const { return sqlite3_column_double(statement_, column); }
std::string Statement::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return text == nullptr
             ? std::string{}
             : std::string(text,
                           static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}
std::vector<std::uint8_t> Statement::blob(int column) const {
  const auto* bytes = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_, column));
  if (bytes == nullptr) return {};
  return {bytes, bytes + sqlite3_column_bytes(statement_, column)};
}

Expected<Database> Database::open(const std::filesystem::path& path, Mode mode, const char* vfs) {
  constexpr int kLargestValue = 1 << 28;  // bytes; a shell of ten million points
  sqlite3* opened = nullptr;
  int flags = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_NOFOLLOW;
  flags |= mode == Mode::Create    ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
           : mode == Mode::Recover ? SQLITE_OPEN_READWRITE
                                   : SQLITE_OPEN_READONLY;
  // the folders on the way may be links, the file itself not
  std::error_code error;
  const std::filesystem::path folder =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const std::filesystem::path place =
      vfs == nullptr ? std::filesystem::weakly_canonical(folder, error) / path.filename() : path;
  const int status = sqlite3_open_v2(place.c_str(), &opened, flags, vfs);
  Database database{opened};
  if (status != SQLITE_OK)
    return tl::unexpected(Error{Error::Kind::NotFound, database.complaint(), "unreadable"});
  // nothing in a foreign file is to be run
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, kLargestValue);
  database.run("PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0;");
  // a log in memory in place of a shared one: nobody else may look in, and no disk can be too full
  if (mode != Mode::Read) database.run("PRAGMA locking_mode = EXCLUSIVE;");
  return database;
}

Database::~Database() { sqlite3_close_v2(database_); }
Database::Database(Database&& other) noexcept
    : database_{std::exchange(other.database_, nullptr)} {}

bool Database::run(const char* sql) {
  return sqlite3_exec(database_, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

std::int64_t Database::integer(std::string_view sql) {
  Statement statement = prepare(sql);
  return statement.step() == Statement::Step::Row ? statement.integer(0) : 0;
}

bool Database::isSound() {
  Statement check = prepare("PRAGMA integrity_check(1)");
  return check.step() == Statement::Step::Row && check.text(0) == "ok";
}

bool Database::isFull() const { return (sqlite3_errcode(database_) & 0xff) == SQLITE_FULL; }
bool Database::isBusy() const { return (sqlite3_errcode(database_) & 0xff) == SQLITE_BUSY; }
std::string Database::complaint() const { return sqlite3_errmsg(database_); }
void Database::keepLog() {
  sqlite3_db_config(database_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

}  // namespace haptics
