// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/dimse_archive.h"

#include <cstdlib>

#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmnet/dul.h>
#include <dcmtk/oflog/oflog.h>
#include "app/fetch/arrivals.h"
#include "app/fetch/association.h"
#include "app/fetch/incoming.h"

namespace app::fetch {
namespace {

using haptics::Expected;
using Purpose = Association::Purpose;

constexpr std::size_t kUidsOfARequest = 200;  // in one list, which a length of 16 bits holds

void put(DcmDataset& keys, const DcmTagKey& tag, const std::string& value) {
  keys.putAndInsertString(tag, value.c_str());
}

std::string valueOf(DcmDataset& match, const DcmTagKey& tag) {
  OFString value;
  match.findAndGetOFString(tag, value);
  const auto end = value.find_last_not_of(" ");
  return end == OFString_npos ? std::string{} : std::string(value.c_str(), end + 1);
}

std::optional<std::int64_t> numberOf(DcmDataset& match, const DcmTagKey& tag) {
  const std::string text = valueOf(match, tag);
  if (text.empty() || text.size() > 12 || text.find_first_not_of("0123456789") != text.npos)
    return {};
  return std::stoll(text);
}

DcmDataset keysOf(const char* level, const FoundSeries& series) {
  DcmDataset keys;
  put(keys, DCM_QueryRetrieveLevel, level);
  put(keys, DCM_StudyInstanceUID, series.study_uid);
  put(keys, DCM_SeriesInstanceUID, series.series_uid);
  return keys;
}

class DimseArchive final : public Archive {
 public:
  DimseArchive(const Server& server, std::string key_passphrase, bool fetches)
      : watch_{server},
        key_passphrase_{std::move(key_passphrase)},
        found_for_{!fetches      ? Purpose::Find
                   : server.move ? Purpose::Move
                                 : Purpose::Get} {}

  Expected<void> echo() override {
    auto association = Association::open(watch_, Purpose::Echo, key_passphrase_);
    if (!association) return tl::unexpected(association.error());
    if (auto answered = (*association)->echo(); !answered) return answered;
    // what an echo does not show: whether this program may search. No study has this identifier
    FoundSeries none;
    none.study_uid = "1.2.276.0.7230010.3.0.0";
    DcmDataset keys;
    put(keys, DCM_QueryRetrieveLevel, "STUDY");
    put(keys, DCM_StudyInstanceUID, none.study_uid);
    if (auto searched = (*association)->find(keys, 1, [](DcmDataset&) {}); !searched)
      return searched;
    (*association)->release();
    return {};
  }

  Expected<Findings> find(const Query& query) override;
  Expected<void> get(const FoundSeries& series, Arrivals& arrivals) override;

 private:
  ConnectionWatch watch_;
  std::string key_passphrase_;
  Purpose found_for_;
  std::unique_ptr<Association> open_;  ///< of a search, for the transfer that follows

  Expected<void> attempt(const FoundSeries& series, Arrivals& arrivals, bool all);
};

/// Asks which images there are. A server that cannot say is no error.
Expected<void> list(Association& association, const FoundSeries& series, Arrivals& arrivals) {
  DcmDataset keys = keysOf("IMAGE", series);
  put(keys, DCM_SOPInstanceUID, "");
  std::vector<std::string> images;
  auto listed = association.find(keys, kMostImages, [&](DcmDataset& match) {
    if (std::string uid = valueOf(match, DCM_SOPInstanceUID); isUid(uid))
      images.push_back(std::move(uid));
  });
  if (!listed && listed.error().reason != "answer" && listed.error().reason != "permission")
    return listed;
  if (listed) arrivals.expect(std::move(images));
  return {};
}

Expected<Findings> DimseArchive::find(const Query& query) {
  auto association = Association::open(watch_, found_for_, key_passphrase_);
  if (!association) return tl::unexpected(association.error());
  DcmDataset keys;
  put(keys, DCM_SpecificCharacterSet, "ISO_IR 192");
  put(keys, DCM_QueryRetrieveLevel, "STUDY");
  put(keys, DCM_StudyInstanceUID, "");
  put(keys, DCM_PatientID, query.patient_id);
  put(keys, DCM_PatientName, query.patient_name);
  put(keys, DCM_AccessionNumber, query.accession_number);
  put(keys, DCM_StudyDate, query.study_date);
  put(keys, DCM_StudyDescription, query.study_description);
  put(keys, DCM_ModalitiesInStudy, query.modality);
  Findings all;
  std::vector<FoundSeries> studies;
  auto searched = (*association)->find(keys, kMostStudies, [&](DcmDataset& match) {
    match.convertToUTF8();
    FoundSeries study;
    study.study_uid = valueOf(match, DCM_StudyInstanceUID);
    if (!isUid(study.study_uid)) {
      ++all.refused;
      return;
    }
    study.study_date = dateOf(valueOf(match, DCM_StudyDate));
    study.patient_name = valueOf(match, DCM_PatientName);
    study.patient_id = valueOf(match, DCM_PatientID);
    study.study_description = valueOf(match, DCM_StudyDescription);
    studies.push_back(std::move(study));
  });
  if (!searched) return tl::unexpected(searched.error());
  for (const FoundSeries& study : studies) {
    DcmDataset narrowed = keysOf("SERIES", study);
    put(narrowed, DCM_Modality, query.modality);
    put(narrowed, DCM_SeriesNumber, "");
    put(narrowed, DCM_SeriesDescription, "");
    put(narrowed, DCM_NumberOfSeriesRelatedInstances, "");
    searched =
        (*association)->find(narrowed, kMostSeries - all.series.size(), [&](DcmDataset& match) {
          match.convertToUTF8();
          FoundSeries series = study;
          series.series_uid = valueOf(match, DCM_SeriesInstanceUID);
          const std::string of = valueOf(match, DCM_StudyInstanceUID);
          if (!isUid(series.series_uid) || (!of.empty() && of != study.study_uid)) {
            ++all.refused;
            return;
          }
          series.modality = modalityOf(valueOf(match, DCM_Modality));
          series.number = numberOf(match, DCM_SeriesNumber);
          series.images = numberOf(match, DCM_NumberOfSeriesRelatedInstances);
          series.series_description = valueOf(match, DCM_SeriesDescription);
          all.series.push_back(std::move(series));
        });
    if (!searched) return tl::unexpected(searched.error());
  }
  if (found_for_ == Purpose::Find)
    (*association)->release();
  else
    open_ = std::move(*association);
  return all;
}

/// All images of the series, or those that are missing.
Expected<void> DimseArchive::attempt(const FoundSeries& series, Arrivals& arrivals, bool all) {
  const bool moves = watch_.server().move;
  Expected<std::unique_ptr<Association>> association = std::move(open_);
  if (!*association) association = Association::open(watch_, found_for_, key_passphrase_);
  if (!association) return tl::unexpected(association.error());
  if (!all && !arrivals.listed())
    if (auto listed = list(**association, series, arrivals); !listed) return listed;
  std::vector<DcmDataset> requests;
  if (all || !arrivals.listed()) {
    requests.push_back(keysOf("SERIES", series));
  } else {
    const std::vector<std::string> missing = arrivals.missing();
    for (std::size_t at = 0; at < missing.size(); at += kUidsOfARequest) {
      std::string list_of_uids;
      for (std::size_t i = at; i < std::min(missing.size(), at + kUidsOfARequest); ++i)
        list_of_uids += (list_of_uids.empty() ? "" : "\\") + missing[i];
      DcmDataset keys = keysOf("IMAGE", series);
      put(keys, DCM_SOPInstanceUID, list_of_uids);
      requests.push_back(keys);
    }
  }
  bool whole = true;
  for (DcmDataset& keys : requests) {
    const std::size_t had = arrivals.images();
    Expected<Retrieved> brought;
    if (!moves) {
      brought = (*association)->get(keys, arrivals);
      if (!brought) return tl::unexpected(brought.error());
    } else {
      auto incoming = Incoming::open(watch_, arrivals, key_passphrase_);
      if (!incoming) return tl::unexpected(incoming.error());
      brought = (*association)->move(keys, arrivals, [&] { return (*incoming)->health(); });
      if (brought) (*incoming)->settle(brought->sent);
      const auto health = (*incoming)->health();
      incoming->reset();
      if (!health) return health;
      if (!brought) return tl::unexpected(brought.error());
    }
    whole = whole && brought->failed == 0 && brought->sent == arrivals.images() - had;
  }
  // which images there are is asked where the server's count does not say that all have come
  if (!whole && !arrivals.listed())
    if (auto listed = list(**association, series, arrivals); !listed) return listed;
  (*association)->release();
  return {};
}

Expected<void> DimseArchive::get(const FoundSeries& series, Arrivals& arrivals) {
  for (int number = 1;; ++number) {
    const auto brought = attempt(series, arrivals, number == 1);
    if (brought && (!arrivals.listed() || arrivals.missing().empty() || number > 1)) return {};
    // a server that starts again may close connections at once
    const bool lost =
        !brought && (isLoss(brought.error()) || (number > 1 && brought.error().reason == "closed"));
    if (!brought && (number == kAttempts || !lost)) return brought;
    if (brought) continue;
    const auto until =
        Pace::Clock::now() + std::chrono::duration<double>(watch_.server().pauseAfter(number));
    while (Pace::Clock::now() < until && !ConnectionWatch::stopping())
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (ConnectionWatch::stopping()) return cancelled();
  }
}

}  // namespace

Expected<std::unique_ptr<Archive>> openDimse(const Server& server, const Login& login,
                                             bool fetches) {
  // DCMTK's own words hold what a server sent
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  setenv("TCP_NODELAY", "1", 1);
  dcmConnectionTimeout.set(static_cast<Sint32>(kConnectTime_s));
  dcmDisableGethostbyaddr.set(OFTrue);
  const auto patience = static_cast<Sint32>(server.patience_s);
  dcmSocketReceiveTimeout.set(patience + 2);
  dcmSocketSendTimeout.set(patience + 2);
  return std::make_unique<DimseArchive>(server, login.key_passphrase, fetches);
}

}  // namespace app::fetch
