// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/sessions/session_recording.h"

#include <algorithm>

#include "app/recording/facts.h"
#include "app/recording/unfinished.h"
#include "app/recording/volume_hash.h"
#include "app/window/scan/edited_volume.h"
#include "app/window/scan/sentence.h"

namespace app {

namespace {
constexpr int kStatusMs = 250;
constexpr int kLongestHashMs = 10'000;  // that the end of a recording waits for its volume's hash
}  // namespace

SessionRecording::SessionRecording(haptics::Session& session, const Recordings& recordings,
                                   VolumeIdentity& identity, QObject* parent)
    : QObject(parent), session_(session), recordings_(recordings), identity_(identity) {
  connect(&identity_, &VolumeIdentity::sought, this, &SessionRecording::identify);
}

SessionRecording::~SessionRecording() { end(); }

haptics::Expected<void> SessionRecording::start(std::shared_ptr<const haptics::Scene> scene,
                                                const std::string& tool,
                                                ui::RecordingStates states) {
  if (recorder_ != nullptr || finisher_.isRunning())
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported,
        tr("The last recording is being finished; try again in a moment.").toStdString(), "busy"});
  target_ = recordings_.next();
  auto recorder = Recorder::create(
      target_, recordingFacts("palpate", states.when ? beganNow() : nlohmann::ordered_json{}),
      {.rate = session_.rate()});
  if (!recorder) return tl::unexpected(recorder.error());
  recorder_ = std::move(*recorder);
  stopping_ = false;
  if (states.scan)
    hasher_.start(
        [volume = scene->volume,
         recorder = recorder_](const background::Watch& watch) -> haptics::Expected<std::string> {
          const auto hash = openHashOfVoxels(*volume, watch.cancel);
          if (hash) recorder->stateVoxels(*hash);
          return hash.value_or("");
        },
        [](const auto&) {});
  describe(std::move(scene), tool);
  session_.record({recorder_, &recorder_->ring()});
  clock_.start();
  shown_.start();
  showStatus(ui::RecordingStatus::State::Recording);
  return {};
}

void SessionRecording::stop() {
  if (!isRecording()) return;
  session_.record(nullptr);
  stopping_ = true;
  elapsed_ = static_cast<double>(clock_.restart()) * 1e-3;
  showStatus(ui::RecordingStatus::State::Finishing);
}

void SessionRecording::end() {
  stop();
  hasher_.wait();
  finisher_.wait();
  if (recorder_ != nullptr) recorder_->finish();
  recorder_.reset();
  stopping_ = false;
}

std::filesystem::path SessionRecording::present() const {
  return recorder_ != nullptr || finisher_.isRunning() ? partOf(target_) : std::filesystem::path{};
}

void SessionRecording::describe(std::shared_ptr<const haptics::Scene> scene,
                                const std::string& tool) {
  if (!isRecording()) return;
  recorder_->describe(scene, tool);
  scenes_.push_back(scene);
  identity_.seek(scene->volume);
}

void SessionRecording::identify(const std::shared_ptr<const haptics::Volume>& volume) {
  const auto hash = identity_.of(volume);
  for (const auto& scene : scenes_)
    if (scanOf(scene->volume) == volume && hash && recorder_) recorder_->identify(scene->id, *hash);
  std::erase_if(scenes_, [&](const auto& scene) { return scanOf(scene->volume) == volume; });
}

void SessionRecording::note(const char* kind, const QString& text, std::optional<double> value) {
  if (isRecording()) recorder_->note(kind, text.toStdString(), value);
}

void SessionRecording::refresh() {
  if (recorder_ == nullptr) return;
  // what is left waits for the servo thread to leave the ring, and for the volume's hash
  if (stopping_) {
    const bool identified =
        !hasher_.isRunning() && (scenes_.empty() || clock_.elapsed() > kLongestHashMs);
    if (session_.hasLeftRing() && identified) finish();
    return;
  }
  if (shown_.elapsed() < kStatusMs) return;
  shown_.restart();
  if (recorder_->status().failure.empty()) return showStatus(ui::RecordingStatus::State::Recording);
  session_.record(nullptr);
  elapsed_ = static_cast<double>(clock_.restart()) * 1e-3;
  stopping_ = true;
  showStatus(ui::RecordingStatus::State::Stopped);
}

void SessionRecording::showStatus(ui::RecordingStatus::State state) {
  const RecorderStatus status = recorder_->status();
  ui::RecordingStatus shown{
      .state = state,
      .elapsed = stopping_ ? elapsed_ : static_cast<double>(clock_.elapsed()) * 1e-3,
      .samples = status.steps,
      .gaps = status.lost,
      .bytes = status.bytes,
      .failure = sentenceOf(status.failure)};
  // before there is anything to go by, what a step may take at most
  constexpr double kMostBytes = 300.0 * 1000.0;  // a second
  const double rate = status.duration > 1.0 ? double(status.bytes) / status.duration : kMostBytes;
  shown.room = recordings_.room() / std::max(1.0, rate);
  emit statusChanged(shown);
}

void SessionRecording::finish() {
  const bool failed = !recorder_->status().failure.empty();
  finisher_.start(
      [recorder = std::move(recorder_)](const background::Watch&) { return recorder->finish(); },
      [this, failed](const haptics::Expected<std::filesystem::path>& done) {
        if (!failed) emit statusChanged({});
        if (done)
          return emit finished(true, tr("The session was recorded: \"%1\".")
                                         .arg(QString::fromStdString(done->stem().string())));
        const haptics::Error& error = done.error();
        emit finished(false,
                      error.reason == background::kNoMemory || error.reason == background::kThrew
                          ? tr("The recording could not be finished: there is no "
                               "memory left. It can be recovered.")
                          : sentenceOf(error));
      });
  recorder_.reset();
  scenes_.clear();
  stopping_ = false;
}

}  // namespace app
