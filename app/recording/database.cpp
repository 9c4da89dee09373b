// SPDX-License-Identifier: BSD-3-Clause
#include "app/recording/database.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

namespace app {

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

namespace {

using FileNumber = std::pair<dev_t, ino_t>;

/// The files that this process has open to write.
struct Written {
  std::mutex mutex;
  std::multiset<FileNumber> files;
};
Written& written() {
  static auto* const files = new Written;  // for whoever closes after the last destructor
  return *files;
}

std::optional<FileNumber> fileAt(const std::filesystem::path& path) {
  struct stat what {};
  if (::lstat(path.c_str(), &what) != 0 || !S_ISREG(what.st_mode)) return {};
  return FileNumber{what.st_dev, what.st_ino};
}

}  // namespace

/// How many steps of SQLite's machine are left to the statement that is under way, and more that
/// moves with a database.
struct Database::Bound {
  std::optional<FileNumber> written = {};  ///< the file, if it is open to write
  std::int64_t most = 0;                   ///< of a statement; 0: as many as it takes
  std::int64_t left = 0;
  const std::atomic<bool>* cancel = nullptr;
};

namespace {

constexpr std::int64_t kLargestValue = 1 << 28;  // bytes; a shell of ten million points
constexpr int kStepsAtOnce = 1000;               // of SQLite's machine, between two looks

/// The file as a name with options, which SQLite takes apart at "?".
std::string uriOf(const std::filesystem::path& path, const char* options) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string uri = "file:";
  for (const char c : path.string())
    if (c == '%' || c == '?' || c == '#')
      uri.append({'%', kDigits[(c >> 4) & 15], kDigits[c & 15]});
    else
      uri += c;
  return uri + '?' + options;
}

using SchemaRow = std::array<std::string, 4>;

std::vector<SchemaRow> schemaOf(Statement rows, std::size_t most) {
  std::vector<SchemaRow> schema;
  while (schema.size() <= most && rows.step() == Statement::Step::Row)
    schema.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3)});
  std::ranges::sort(schema);
  return schema;
}

}  // namespace

Database::Database(sqlite3* database) : database_{database}, bound_{std::make_unique<Bound>()} {}

haptics::Expected<Database> Database::open(const std::filesystem::path& path, Mode mode,
                                           const std::atomic<bool>* cancel, const char* vfs) {
  sqlite3* opened = nullptr;
  int flags = SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_NOFOLLOW;
  flags |= mode == Mode::Create    ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
           : mode == Mode::Recover ? SQLITE_OPEN_READWRITE
                                   : SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
  // the folders on the way may be links, the file itself not
  std::error_code error;
  const std::filesystem::path folder =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const std::filesystem::path place =
      vfs == nullptr ? std::filesystem::weakly_canonical(folder, error) / path.filename() : path;
  // of a file that is only read, SQLite shall neither take back what a log beside it says, nor
  // make one
  const std::string name = mode == Mode::Read ? uriOf(place, "immutable=1") : place.string();
  const int status = sqlite3_open_v2(name.c_str(), &opened, flags, vfs);
  Database database{opened};
  if (status != SQLITE_OK)
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::NotFound, database.complaint(), "unreadable"});
  // nothing in a foreign file is to be run
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  // a file of foreign origin holds no value that is larger than itself
  std::int64_t largest = kLargestValue;
  if (mode != Mode::Create) {
    std::int64_t bytes = 0;
    for (const char* part : {"", "-wal"})
      if (const auto size = std::filesystem::file_size(place.string() + part, error); !error)
        bytes += static_cast<std::int64_t>(std::min<std::uintmax_t>(size, std::uintmax_t{1} << 50));
    largest = std::clamp<std::int64_t>(bytes, 1000, kLargestValue);
    // the shortest row has some ten bytes, and takes some thirty steps
    database.bound_->most = 1'000'000 + 20 * bytes;
    database.bound_->cancel = cancel;
    sqlite3_progress_handler(
        opened, kStepsAtOnce,
        [](void* of) {
          auto& bound = *static_cast<Bound*>(of);
          bound.left -= kStepsAtOnce;
          return bound.left < 0 || (bound.cancel != nullptr && *bound.cancel) ? 1 : 0;
        },
        database.bound_.get());
  }
  sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, static_cast<int>(largest));
  database.run("PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0;");
  // a log in memory in place of a shared one: nobody else may look in, and no disk can be too full
  if (mode != Mode::Read) {
    database.run("PRAGMA locking_mode = EXCLUSIVE;");
    if (const auto file = fileAt(place)) {
      database.bound_->written = file;
      const std::scoped_lock lock(written().mutex);
      written().files.insert(*file);
    }
  }
  return database;
}

Database::~Database() {
  sqlite3_close_v2(database_);
  if (!bound_ || !bound_->written) return;
  const std::scoped_lock lock(written().mutex);
  written().files.erase(written().files.find(*bound_->written));
}

bool Database::isLocked(const std::filesystem::path& path) {
  // to close one's own file would let go of SQLite's locks on it
  const auto file = fileAt(path);
  if (!file) return false;
  {
    const std::scoped_lock lock(written().mutex);
    if (written().files.contains(*file)) return true;
  }
  const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (opened < 0) return false;
  // the bytes that SQLite locks: "File Locking And Concurrency", sqlite.org
  struct flock asked {};
  asked.l_type = F_WRLCK;
  asked.l_whence = SEEK_SET;
  asked.l_start = 0x40000000;
  asked.l_len = 512;
  const bool locked = ::fcntl(opened, F_OFD_GETLK, &asked) == 0 && asked.l_type != F_UNLCK;
  ::close(opened);
  return locked;
}
Database::Database(Database&& other) noexcept
    : database_{std::exchange(other.database_, nullptr)}, bound_{std::move(other.bound_)} {}

Statement Database::prepare(std::string_view sql) {
  bound_->left = bound_->most;
  return Statement{database_, sql};
}

bool Database::run(const char* sql) {
  bound_->left = bound_->most;
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

bool Database::hasSchema(const char* sql) {
  constexpr std::string_view kRows = "SELECT type, name, tbl_name, sql FROM sqlite_schema";
  sqlite3* memory = nullptr;
  const int status =
      sqlite3_open_v2(":memory:", &memory, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
  Database expected{memory};
  if (status != SQLITE_OK || !expected.run(sql)) return false;
  const auto wanted = schemaOf(expected.prepare(kRows), 100);
  return schemaOf(prepare(kRows), wanted.size()) == wanted;
}

bool Database::isFull() const { return (sqlite3_errcode(database_) & 0xff) == SQLITE_FULL; }
bool Database::isBusy() const { return (sqlite3_errcode(database_) & 0xff) == SQLITE_BUSY; }
std::string Database::complaint() const { return sqlite3_errmsg(database_); }
void Database::forgetCancel() { bound_->cancel = nullptr; }
void Database::keepLog() {
  sqlite3_db_config(database_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

}  // namespace app
