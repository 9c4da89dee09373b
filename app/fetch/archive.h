// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/error.h"

namespace app::fetch {

class Arrivals;

// Limits that hold for every server.
inline constexpr std::size_t kMostStudies = 500;       ///< of one search
inline constexpr std::size_t kMostSeries = 5'000;      ///< of one search
inline constexpr std::size_t kMostImages = 100'000;    ///< of one series
inline constexpr double kConnectTime_s = 10.0;         ///< until a connection stands
inline constexpr std::uint64_t kLeastRate_B_s = 1024;  ///< averaged over the patience
inline constexpr int kAttempts = 5;                    ///< of one transfer, the first included

/// Where a server is and how this program presents itself there. Without secrets.
struct Server {
  std::string url;   ///< of DICOMweb; empty: DIMSE
  std::string host;  ///< of DIMSE
  std::uint16_t port = 0;
  std::string called, calling = "PALPATE";  ///< AE titles: the server's, ours
  bool tls = false;                         ///< of DIMSE; a URL says it itself
  std::string authority, certificate, key;  ///< PEM files, or empty
  bool move = false;                        ///< C-MOVE instead of C-GET
  std::string listen_address;               ///< of C-MOVE: numeric, as the user named it
  std::uint16_t listen_port = 0;
  double patience_s = 30.0;  ///< how long a server may be silent, or slower than kLeastRate_B_s

  bool isWeb() const { return !url.empty(); }
  /// How long to wait before another attempt [s]: a server that starts again takes a moment.
  double pauseAfter(int attempt) const { return attempt * patience_s / 30.0; }
  /// As the user typed it, for sentences.
  std::string name() const;
};

struct Login {
  enum class Kind { None, Basic, Bearer };
  Kind kind = Kind::None;
  std::string user, password;  ///< the password, or the bearer's token
  std::string key_passphrase;
};

/// What to search for. Empty fields match everything; `*` and `?` are wild cards in texts.
struct Query {
  std::string patient_id, patient_name, accession_number;
  std::string study_date;  ///< YYYYMMDD, or YYYYMMDD-YYYYMMDD with either end left out
  std::string study_description, modality;

  bool isEmpty() const;
};

/// A series that a server has.
struct FoundSeries {
  std::string study_uid, series_uid;  ///< well formed
  std::string modality;               ///< one of the standard's, or "OT"
  std::string study_date;             ///< YYYYMMDD or empty
  std::optional<std::int64_t> number, images, bytes;
  // who it is, as the server says, UTF-8
  std::string patient_name, patient_id, study_description, series_description;

  bool operator==(const FoundSeries&) const = default;
};

struct Findings {
  std::vector<FoundSeries> series;
  std::size_t refused = 0;  ///< entries without a well-formed identifier
};

/// A server, by either protocol. Each call may wait, within the limits above, and is made on the
/// thread that made the object.
class Archive {
 public:
  virtual ~Archive() = default;
  /// Whether the server answers and lets this program search.
  virtual haptics::Expected<void> echo() = 0;
  /// The series that match, in no order.
  virtual haptics::Expected<Findings> find(const Query& query) = 0;
  /// Brings the images of a series, and goes on after a lost connection with those that are
  /// missing.
  virtual haptics::Expected<void> get(const FoundSeries& series, Arrivals& arrivals) = 0;
};

/// 1 to 64 characters, digits and single dots between them. Nothing else may become a part of a
/// URL, and no identifier ever becomes the name of a file.
bool isUid(const std::string& text);
/// The standard's word for a modality that is touched, or "OT". A server's own words may name
/// somebody.
std::string modalityOf(const std::string& text);
/// YYYYMMDD, or empty.
std::string dateOf(const std::string& text);

/// By study, newest first, then by number and identifier; equal entries once. The order depends on
/// the entries alone, so that the same search gives the same indices.
void sortSeries(std::vector<FoundSeries>& series);
/// Eight hexadecimal digits that change with the series, to recognise that an index still names it.
std::string checkOf(const FoundSeries& series);

// Errors by what they mean for the exit code.
/// The server refused, or its answer was.
tl::unexpected<haptics::Error> refused(const char* reason, haptics::Message message);
/// Not reached, lost, too slow, or this machine failed.
tl::unexpected<haptics::Error> failed(const char* reason, haptics::Message message);
tl::unexpected<haptics::Error> cancelled();
/// Whether another attempt may succeed: the connection was lost or a server did not answer.
bool isLoss(const haptics::Error& error);

}  // namespace app::fetch
