// SPDX-License-Identifier: BSD-3-Clause
#include "app/film/film.h"

#include <unistd.h>

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

#include "app/film/ffmpeg_file.h"
#include "app/film/stage.h"
#include "app/film/theora_file.h"
#include "app/recording/recorded_cuts.h"
#include "haptics/process/output_file.h"
#include "ui/props/picture.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using haptics::Error;
using haptics::Expected;
using haptics::Vec3;

constexpr std::int64_t kMostFrames = 1'000'000;
constexpr double kCurveSeconds = 10.0;  // of the session, as the window's curve has
constexpr const char *kMp4 = ".mp4", *kOgg = ".ogv", *kTable = ".frames.csv";

tl::unexpected<Error> refused(haptics::Message message, const char* reason) {
  return tl::unexpected(Error{Error::Kind::Unsupported, std::move(message), reason});
}
tl::unexpected<Error> filmCancelled() {
  return tl::unexpected(Error{Error::Kind::Cancelled, {"work-cancelled", {}}, "cancelled"});
}
tl::unexpected<Error> unwritable(const fs::path& file) {
  return tl::unexpected(
      Error{Error::Kind::Unsupported, {"film-unwritable", {file.string()}}, "unwritable"});
}

/// Which step each frame shows.
class Timing {
 public:
  static Expected<Timing> of(const Recording& recording, const FilmOptions& options) {
    const double from = std::max(options.from, recording.begin());
    const double to = std::min(options.to, recording.end());
    if (!(from <= to)) return refused({"film-no-step", {}}, "nothing");
    const double step = options.speed / options.frames_per_second;
    // a thousandth of a frame: what rounding may take from the last
    const double frames = std::floor((to - from) / step + 1e-3) + 1.0;
    if (!(frames <= double(kMostFrames))) return refused({"film-too-long", {}}, "options");
    return Timing{from, step, std::int64_t(frames)};
  }
  std::int64_t count() const { return count_; }
  /// The first frame that is not before a time.
  std::int64_t firstAt(std::int64_t time_ns) const {
    return static_cast<std::int64_t>(std::ceil((double(time_ns) * 1e-9 - from_) / step_ - 1e-6));
  }
  std::size_t framesIn(double seconds) const {
    return static_cast<std::size_t>(std::clamp(seconds / step_, 2.0, 1e5));
  }
  std::int64_t time_ns(std::int64_t frame) const {
    return std::llround((from_ + double(frame) * step_) * 1e9);
  }

 private:
  Timing(double from, double step, std::int64_t count) : from_{from}, step_{step}, count_{count} {}
  double from_, step_;
  std::int64_t count_;
};

/// Finds steps by their time, and keeps the block it was last in.
class StepFinder {
 public:
  explicit StepFinder(Recording& recording) : recording_{recording} {}
  /// The last at or before a time, or the first; valid until the next is asked for.
  Expected<const RecordedStep*> at(std::int64_t time_ns) {
    const std::size_t block = recording_.blockAt(double(time_ns) * 1e-9);
    if (block != block_) {
      auto steps = recording_.block(block);
      if (!steps) return tl::unexpected(steps.error());
      steps_ = std::move(*steps);
      block_ = block;
    }
    const auto after = std::upper_bound(
        steps_.begin(), steps_.end(), time_ns,
        [](std::int64_t time, const RecordedStep& step) { return time < step.step.time_ns; });
    return &*(after == steps_.begin() ? after : after - 1);
  }

 private:
  Recording& recording_;
  std::optional<std::size_t> block_;
  std::vector<RecordedStep> steps_;
};

/// OUT without an ending that says what kind of film it is.
fs::path stemOf(const fs::path& out) {
  const std::string ending = out.extension().string();
  return ending == kMp4 || ending == kOgg ? fs::path{out}.replace_extension() : out;
}

/// Whether a file can be made in the folder, and takes the name of none that is not one.
bool canHold(const fs::path& target) {
  std::error_code error;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path{"."};
  if (access(folder.c_str(), W_OK | X_OK) != 0) return false;
  return !fs::exists(target, error) || fs::is_regular_file(target, error);
}

/// The film's file, written by whoever can.
using FilmFile = std::variant<FfmpegFile, TheoraFile>;

std::string burntIn(const haptics::Step& step) {
  return QCoreApplication::translate("app::Film", "%1 s   %2 N")
      .arg(double(step.time_ns) * 1e-9, 9, 'f', 3)
      .arg(step.sent_W.force.norm(), 6, 'f', 2)
      .toStdString();
}

std::string rowOf(std::int64_t frame, const haptics::Step& step, double seconds) {
  char number[32];
  char* const end = std::to_chars(number, number + sizeof number, seconds).ptr;
  return std::to_string(frame) + ',' + std::to_string(step.sequence) + ',' +
         std::to_string(step.time_ns) + ',' + std::string(number, end) + '\n';
}

/// Draws the frames of a recording, one after another.
class Drawing {
 public:
  Drawing(Recording& recording, const VolumeOfScene& volume, const FilmOptions& options,
          const Timing& timing, FilmStage& stage)
      : recording_{recording},
        volume_{volume},
        options_{options},
        timing_{timing},
        stage_{stage},
        finder_{recording},
        cameras_{recording} {}

  /// Chooses from where the film is taken, as far as that is for the film to choose.
  Expected<void> begin() {
    auto first = finder_.at(timing_.time_ns(0));
    if (!first) return tl::unexpected(first.error());
    enter((*first)->step.scene);
    if (volume_ && recording_.isCut()) {
      auto cuts = cutsOf(recording_, [&, step = 0]() mutable {
        return !options_.goes_on || ++step % 1000 != 0 || options_.goes_on(0.0);
      });
      if (!cuts) return tl::unexpected(cuts.error());
      cuts_.set(std::move(*cuts));
    }
    if (options_.burn_in)
      if (auto read = readForces(); !read) return read;
    if (options_.recorded_camera && !cameras_.empty()) return {};
    if (options_.camera) {
      stage_.look(*options_.camera);
      return {};
    }
    if (auto seen = lookAtAll(**first); !seen) return tl::unexpected(seen.error());
    return {};
  }

  struct Drawn {
    const FilmFrame& picture;
    const haptics::Step& step;
  };
  Expected<Drawn> draw(std::int64_t frame) {
    const std::int64_t time_ns = timing_.time_ns(frame);
    auto found = finder_.at(time_ns);
    if (!found) return tl::unexpected(found.error());
    const haptics::Step& step = (*found)->step;
    enter(step.scene);
    if (auto cut = showCuts(step); !cut) return tl::unexpected(cut.error());
    if (options_.recorded_camera && !cameras_.empty()) stage_.look(cameras_.at(time_ns));
    if (options_.burn_in) {
      stage_.write(burntIn(step));
      const auto shown = static_cast<std::size_t>(frame) + 1;
      stage_.curve().show(std::span{forces_}.first(std::min(shown, forces_.size())),
                          timing_.framesIn(kCurveSeconds), most_force_);
    }
    return Drawn{stage_.draw(step), step};
  }

 private:
  /// The greatest force since the frame before, for each frame.
  Expected<void> readForces() {
    forces_.assign(static_cast<std::size_t>(timing_.count()), 0.0F);
    double most = 0.0;
    auto read = recording_.forEach(options_.from, options_.to, [&](const RecordedStep& row) {
      const std::int64_t frame = std::min(timing_.firstAt(row.step.time_ns), timing_.count() - 1);
      const double force = row.step.sent_W.force.norm();
      if (!std::isfinite(force)) return true;
      float& shown = forces_[static_cast<std::size_t>(std::max<std::int64_t>(frame, 0))];
      shown = std::max(shown, static_cast<float>(force));
      most = std::max(most, force);
      return !options_.goes_on || frame % 1000 != 0 || options_.goes_on(0.0);
    });
    // 1, 2, 5, 10, …
    most_force_ = 1.0;
    for (int n = 0; most_force_ < most && n < 30; ++n) most_force_ *= n % 3 == 1 ? 2.5 : 2.0;
    return read;
  }

  /// From where the surface and all that the tool does are seen.
  Expected<void> lookAtAll(RecordedStep first) {
    const Eigen::AlignedBox3d box = stage_.surfaceBox_mm(first.step.settings.isovalue);
    const bool surface = !box.isEmpty();
    std::vector<FilmBall> balls;
    for (int corner = 0; surface && corner < 8; ++corner)
      balls.push_back({box.corner(Eigen::AlignedBox3d::CornerType(corner)), 0.0});
    const Vec3 centre = surface ? box.center() : Vec3::Zero().eval();
    // a device that flew away is not looked for
    const double reach = surface ? 1.5 * box.diagonal().norm() : 1e4;
    const RecordedScene* scene = recording_.scene(first.step.scene);
    const double radius_mm = scene == nullptr ? 1.0 : scene->tool.shell.radius * ui::kMmPerM + 1.0;
    Vec3 sum = Vec3::Zero();
    int poses = 0;
    constexpr std::int64_t kLooks = 200;
    for (std::int64_t n = 0; n < kLooks; ++n) {
      auto found = finder_.at(timing_.time_ns(n * (timing_.count() - 1) / (kLooks - 1)));
      if (!found) return tl::unexpected(found.error());
      const haptics::Step& step = (*found)->step;
      for (const haptics::Pose* X : {&step.X_WP, &step.X_WD}) {
        const Vec3 p_mm = X->translation() * ui::kMmPerM;
        if (!((p_mm - centre).norm() < reach)) continue;
        balls.push_back({p_mm, radius_mm});
        sum += p_mm;
        ++poses;
      }
    }
    if (balls.empty()) balls.push_back({centre, 1.0});
    // from the front; of a surface from the tool's side, a little from beside so that they are
    // seen against each other, and never from straight above
    Vec3 from = -Vec3::UnitY();
    if (surface && poses > 0) {
      constexpr double kBeside = 0.6;  // rad
      const Vec3 side = Eigen::AngleAxisd(kBeside, Vec3::UnitZ()) * Vec3{sum / poses - centre};
      const double level = std::hypot(side.x(), side.y());
      if (level > 1e-3) from = side;
      from.z() = std::clamp(from.z(), -0.8 * level, 0.8 * level);
    }
    stage_.look(cameraAround(balls, from, stage_.aspect()));
    return {};
  }

  void enter(std::uint32_t id) {
    if (id == scene_) return;
    scene_ = id;
    const RecordedScene* scene = recording_.scene(id);
    stage_.show(scene == nullptr ? nullptr : &scene->tool);
    on_view_ = scene == nullptr || !volume_ ? nullptr : volume_(id);
    stage_.show(on_view_);
    cuts_.forget();
  }

  Expected<void> showCuts(const haptics::Step& step) {
    if (on_view_ == nullptr) return {};
    const auto moved = cuts_.moveTo(on_view_, step.scene, step.sequence);
    if (!moved) return tl::unexpected(moved.error());
    if (cuts_.isCarved() && moved->anew) stage_.showLive(cuts_.volume());
    for (const haptics::VoxelBox& box : moved->changed) stage_.carve(box);
    return {};
  }

  Recording& recording_;
  const VolumeOfScene& volume_;
  const FilmOptions& options_;
  const Timing& timing_;
  FilmStage& stage_;
  StepFinder finder_;
  CameraPath cameras_;
  std::optional<std::uint32_t> scene_;
  std::shared_ptr<const haptics::Volume> on_view_;  ///< of the scene; null: the tool alone
  CutsUntil cuts_;
  std::vector<float> forces_;  ///< N, of each frame; empty without a curve
  double most_force_ = 1.0;    ///< N
};

Expected<void> check(const FilmOptions& options) {
  const auto size = [](int pixels) { return pixels >= 64 && pixels <= 7680 && pixels % 2 == 0; };
  const bool sound = size(options.width) && size(options.height) &&
                     options.frames_per_second >= 1 && options.frames_per_second <= 240 &&
                     options.speed >= 0.001 && options.speed <= 1000.0;
  if (!sound) return refused({"film-options", {}}, "options");
  return {};
}

}  // namespace

std::vector<fs::path> filesOfFilm(const fs::path& out) {
  const std::string stem = stemOf(out).string();
  if (out.extension() == kOgg) return {stem + kTable, out};
  return {stem + kTable, stem + kMp4, stem + kOgg};
}

Expected<FilmResult> makeFilm(Recording& recording, const VolumeOfScene& volume,
                              const fs::path& out, const FilmOptions& options) {
  if (auto sound = check(options); !sound) return tl::unexpected(sound.error());
  const auto timing = Timing::of(recording, options);
  if (!timing) return tl::unexpected(timing.error());
  const std::vector<fs::path> names = filesOfFilm(out);
  if (!out.has_filename() || !std::ranges::all_of(names, canHold)) return unwritable(out);

  std::int64_t done = 0;
  const StillWanted wanted = [&] {
    return !options.goes_on || options.goes_on(double(done) / double(timing->count()));
  };
  auto stage = FilmStage::open(options.width, options.height, options.surface, options.look);
  if (!stage) return tl::unexpected(stage.error());
  Drawing drawing{recording, volume, options, *timing, **stage};
  if (auto begun = drawing.begin(); !begun) return tl::unexpected(begun.error());

  auto rows = haptics::OutputFile::open(names.front());
  if (!rows) return tl::unexpected(rows.error());
  rows->write("frame,sequence,time_ns,film_time_s\n");
  const FilmFormat format{options.width, options.height, options.frames_per_second};
  fs::path named = names[1];
  std::optional film{haptics::Output::at(named)};
  if (!*film) return tl::unexpected(film->error());
  std::optional<FilmFile> file;
  if (named.extension() == kOgg) {
    file.emplace(TheoraFile{(*film)->part(), format});
  } else if (auto ffmpeg = FfmpegFile::start(options.ffmpeg, (*film)->part(), format)) {
    file.emplace(std::move(*ffmpeg));
  } else if (out.extension() == kMp4) {
    return refused({"film-no-ffmpeg", {}}, "encoder");
  } else {
    named = names[2];
    // nobody named it
    std::error_code error;
    if (fs::exists(named, error))
      return refused({"film-other-name", {named.string()}}, "unwritable");
    film.emplace(haptics::Output::at(named));
    if (!*film) return tl::unexpected(film->error());
    file.emplace(TheoraFile{(*film)->part(), format});
  }
  auto* const ffmpeg = std::get_if<FfmpegFile>(&*file);
  auto* const theora = std::get_if<TheoraFile>(&*file);

  for (; done < timing->count(); ++done) {
    if (!wanted()) return filmCancelled();
    const auto drawn = drawing.draw(done);
    if (!drawn) return tl::unexpected(drawn.error());
    const auto written =
        ffmpeg != nullptr ? ffmpeg->write(drawn->picture, wanted) : theora->write(drawn->picture);
    if (!written) return tl::unexpected(written.error());
    rows->write(rowOf(done, drawn->step, double(done) / options.frames_per_second));
  }
  if (auto whole = ffmpeg != nullptr ? ffmpeg->finish(wanted) : theora->finish(); !whole)
    return tl::unexpected(whole.error());
  if (!wanted()) return filmCancelled();
  if (auto closed = rows->close(); !closed) return tl::unexpected(closed.error());
  if (auto whole = (*film)->finish(); !whole) return tl::unexpected(whole.error());
  if (auto whole = rows->finish(); !whole) {
    std::error_code ignored;
    fs::remove(named, ignored);  // not without its table
    return tl::unexpected(whole.error());
  }

  FilmResult result{.film = named,
                    .times = names.front(),
                    .frames = timing->count(),
                    .seconds = double(timing->count()) / options.frames_per_second,
                    .codec = ffmpeg != nullptr ? "h264" : "theora",
                    .surface = (*stage)->surfaceMode()};
  return result;
}

}  // namespace app
