// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/job.h"

#include <unistd.h>

#include <QUrl>
#include <chrono>
#include <set>

#include "app/fetch/arrivals.h"
#include "app/fetch/dimse_archive.h"
#include "app/fetch/keyring.h"
#include "app/fetch/web_archive.h"
#include "resources/messages/messages.h"

namespace app::fetch {
namespace {

using haptics::Expected;
using nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr double kFind_s = 600.0, kGet_s = 7200.0;
constexpr std::chrono::milliseconds kBetweenReports{100};

std::string megabytes(std::uint64_t bytes) { return std::to_string(bytes / 1'000'000); }

/// Progress on a descriptor, at most ten times a second.
class Report {
 public:
  Report(int to, bool json) : to_{to}, json_{json} {}
  void progress(std::size_t images, std::optional<std::size_t> of, std::uint64_t bytes) {
    if (Clock::now() - told_ < kBetweenReports) return;
    told_ = Clock::now();
    std::string line;
    if (json_) {
      ordered_json object{{"event", "progress"}, {"images", images}, {"bytes", bytes}};
      if (of) object["of"] = *of;
      line = object.dump() + '\n';
    } else if (isatty(to_) == 1) {
      line = "\r" + std::to_string(images) + (of ? " of " + std::to_string(*of) : "") +
             " images, " + megabytes(bytes) + " MB ";
    }
    if (!line.empty()) (void)!write(to_, line.data(), line.size());
  }

 private:
  int to_;
  bool json_;
  Clock::time_point told_ = Clock::now();
};

/// Host and port, as the keyring's entries have them.
std::string placeOf(const Server& server) {
  const QUrl url{QString::fromStdString(server.url)};
  return url.host().toStdString() + ":" +
         std::to_string(url.port(url.scheme() == "https" ? 443 : 80));
}

Expected<std::unique_ptr<Archive>> opened(Job& job) {
  if (job.from_keyring) {
    auto secret = secretOf({placeOf(job.server), job.keyring_user});
    if (!secret) return tl::unexpected(secret.error());
    job.login.kind = job.keyring_user.empty() ? Login::Kind::Bearer : Login::Kind::Basic;
    job.login.user = job.keyring_user;
    job.login.password = std::move(*secret);
  }
  if (job.server.isWeb()) {
    shortenDictionary();
    return openWeb(job.server, job.login);
  }
  return openDimse(job.server, job.login, job.command == Job::Command::Get);
}

/// Puts a secret into the keyring, or takes it out.
Outcome withKeyring(const Job& job) {
  // a URL that is none has no place
  if (const auto archive = openWeb(job.server, {}); !archive) return outcomeOf(archive.error());
  const KeyringEntry entry{placeOf(job.server), job.keyring_user};
  const bool stores = job.command == Job::Command::Remember;
  if (const auto sound = stores ? remember(entry, job.login.password) : forget(entry); !sound)
    return outcomeOf(sound.error());
  Outcome outcome;
  outcome.json[stores ? "remembered" : "forgotten"] = true;
  const haptics::Message done = stores ? haptics::Message{"fetch-remembered", {entry.server}}
                                       : haptics::Message{"fetch-forgotten", {entry.server}};
  outcome.text = resources::sentence(done) + "\n";
  return outcome;
}

Outcome listed(const Job& job, const Findings& findings) {
  Outcome outcome;
  ordered_json& list = outcome.json["series"] = ordered_json::array();
  std::string study_uid;
  std::size_t study = 0;
  for (const FoundSeries& series : findings.series) {
    if (list.empty() || series.study_uid != study_uid) ++study;
    study_uid = series.study_uid;
    ordered_json entry{{"index", list.size()},
                       {"study", study},
                       {"modality", series.modality},
                       {"study_date", series.study_date}};
    std::string line = std::to_string(list.size()) + ": study " + std::to_string(study) + ", " +
                       series.modality + (series.study_date.empty() ? "" : ", ") +
                       series.study_date;
    const auto add = [&](const char* name, const std::optional<std::int64_t>& value) {
      entry[name] = value ? ordered_json(*value) : ordered_json(nullptr);
      if (value) line += std::string(", ") + name + " " + std::to_string(*value);
    };
    add("number", series.number);
    add("images", series.images);
    add("bytes", series.bytes);
    entry["check"] = checkOf(series);
    if (job.names) {
      entry["patient_name"] = series.patient_name;
      entry["patient_id"] = series.patient_id;
      entry["study_description"] = series.study_description;
      entry["series_description"] = series.series_description;
      for (const std::string* text : {&series.patient_name, &series.patient_id,
                                      &series.study_description, &series.series_description})
        line += " | " + *text;
    }
    outcome.text += line + "\n";
    list.push_back(std::move(entry));
  }
  outcome.json["left_out"] = findings.refused;
  if (findings.series.empty()) outcome.text = "The server has no series that match.\n";
  if (findings.refused > 0)
    outcome.text +=
        resources::sentence({"fetch-entries-left-out", {std::to_string(findings.refused)}}) + "\n";
  return outcome;
}

Outcome fetched(const Job& job, Archive& archive, const FoundSeries& series) {
  Report report{job.progress_to, job.json};
  Arrivals arrivals{job.folder, series,
                    [&](std::size_t images, std::optional<std::size_t> of, std::uint64_t bytes) {
                      report.progress(images, of, bytes);
                    }};
  const auto brought = archive.get(series, arrivals);
  if (!brought) return outcomeOf(brought.error());
  const std::string host = job.server.name();
  if (arrivals.images() == 0) {
    if (arrivals.strangers() > 0)
      return outcomeOf(refused("other-images", {"fetch-other-images", {host}}).value());
    if (arrivals.unreadable() > 0)
      return outcomeOf(refused("answer", {"fetch-no-dicom", {host}}).value());
    return outcomeOf(refused("no-images", {"fetch-nothing-came", {host}}).value());
  }
  const std::size_t missing = arrivals.missing().size();
  Outcome outcome;
  outcome.json = {{"event", "done"},
                  {"folder", job.folder.string()},
                  {"images", arrivals.images()},
                  {"bytes", arrivals.bytes()},
                  {"missing", missing},
                  {"not_kept", arrivals.strangers() + arrivals.unreadable()}};
  outcome.text = std::to_string(arrivals.images()) + " images (" + megabytes(arrivals.bytes()) +
                 " MB) are in \"" + job.folder.string() + "\".\n";
  ordered_json warnings = ordered_json::array();
  const auto warn = [&](const haptics::Message& message) {
    const std::string sentence = resources::sentence(message);
    warnings.push_back({{"message", sentence}, {"words", jsonOf(message)}});
    outcome.text += sentence + "\n";
  };
  if (missing > 0) warn({"fetch-images-missing", {std::to_string(missing)}});
  if (arrivals.strangers() > 0)
    warn({"fetch-other-images-dropped", {std::to_string(arrivals.strangers())}});
  if (arrivals.unreadable() > 0)
    warn({"fetch-files-dropped", {std::to_string(arrivals.unreadable())}});
  outcome.json["warnings"] = warnings;
  return outcome;
}

}  // namespace

double longestOf(const Job& job) {
  switch (job.command) {
    case Job::Command::Echo:
    case Job::Command::Remember:
    case Job::Command::Forget:
      return 2.0 * kConnectTime_s + 3.0 * job.server.patience_s;
    case Job::Command::Find:
      return kFind_s;
    case Job::Command::Get:
      break;
  }
  return kGet_s;
}

Outcome done(Job job) {
  if (job.command == Job::Command::Remember || job.command == Job::Command::Forget)
    return withKeyring(job);
  auto archive = opened(job);
  if (!archive) return outcomeOf(archive.error());
  if (job.command == Job::Command::Echo) {
    if (const auto answered = (*archive)->echo(); !answered) return outcomeOf(answered.error());
    Outcome outcome;
    outcome.json["answers"] = true;
    outcome.text = resources::sentence({"fetch-answers", {job.server.name()}}) + "\n";
    return outcome;
  }
  auto findings = (*archive)->find(job.query);
  if (!findings) return outcomeOf(findings.error());
  sortSeries(findings->series);
  if (job.command == Job::Command::Find) return listed(job, *findings);
  const std::size_t count = findings->series.size();
  if (*job.index >= count)
    return outcomeOf(refused("usage", {"fetch-no-such-series",
                                       {std::to_string(*job.index), std::to_string(count)}})
                         .value());
  const FoundSeries& series = findings->series[*job.index];
  if (!job.check.empty() && job.check != checkOf(series))
    return outcomeOf(refused("changed", {"fetch-list-changed", {}}).value());
  return fetched(job, **archive, series);
}

}  // namespace app::fetch
