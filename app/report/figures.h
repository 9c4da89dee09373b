// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "haptics/core/fixed_vector.h"
#include "haptics/core/geometry.h"
#include "haptics/structures/nearness.h"

namespace app::report {

// The limits in the definitions of figures; report.cpp has the definitions in words.
inline constexpr std::int64_t kLongestTick_ns = 5'000'000;  ///< what lasts longer is a gap
inline constexpr std::int64_t kPiece_ns = 20'000'000;       ///< of the path
inline constexpr std::int64_t kPause_ns = 100'000'000;      ///< which parts two contacts
inline constexpr double kStill = 0.005;                     ///< m/s

/// How the tool and a structure were to each other in a tick.
struct TickOf {
  float tip = 0.0F, nearest = 0.0F;  ///< m, as haptics::Nearness
  bool touched = false;              ///< a contact bears on a voxel of it
  double push = 0.0;                 ///< N, of all contacts that do
  bool guarded = false;              ///< then
};

/// A tick, as far as figures need it.
struct Tick {
  std::int64_t time_ns = 0;  ///< since the recording began
  /// False: nothing below is known, for there was no scan, or another one, or a number is not
  /// finite.
  bool known = false;
  std::uint32_t scene = 0;  ///< another one may have another tool
  haptics::Vec3 tip_W = haptics::Vec3::Zero();
  double force = 0.0;    ///< N, on the hand
  bool touches = false;  ///< a contact bears on the tool
  bool cuts = false;     ///< its burr turns
  double removed = 0.0;  ///< m3, by the cut that began then
  haptics::FixedVector<TickOf, haptics::kMostWatched> structures = {};
};

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A value, and when it was [s]; kNone where there is none.
struct Moment {
  double value = kNone, at = kNone;
};

/// A time in which the tool touched a structure or was inside it. It ends where the guard begins or
/// ends.
struct Encounter {
  double from = 0.0, to = 0.0;  ///< s, of the first and the last tick
  double nearest = 0.0;         ///< m
  double push = 0.0;            ///< N, the largest
  bool guarded = false;         ///< so it is an injury
  bool cut = false;             ///< the burr turned
};

/// Figures of a structure, in SI.
struct FiguresOf {
  static constexpr std::size_t kMostEncounters = 1000;  ///< that are kept

  Moment nearest, nearest_of_tip;  ///< as far as distances are told; then without a time
  std::vector<double> within;      ///< for each margin
  double touch_time = 0.0, mean_push = kNone;
  Moment largest_push;
  std::int64_t encounter_count = 0, injury_count = 0;
  std::int64_t burr_injury_count = 0;
  double encounter_time = 0.0;
  double removed = kNone, exposed = kNone;  ///< m3, m2; not of ticks: CutStructures
  std::vector<Encounter> encounters;        ///< the first of them
};

/// Figures of a session, in SI.
struct Figures {
  std::int64_t ticks = 0;
  double time = 0.0, unknown = 0.0;
  double path = 0.0, economy = kNone, idle = 0.0;
  std::int64_t contacts = 0;
  double contact_time = 0.0, contact_share = kNone;
  double mean_force = kNone;
  Moment largest_force;
  std::int64_t strokes = 0;
  double cut_time = 0.0, removed = 0.0;
  double mean_cut_force = kNone, mean_cut_speed = kNone;
  std::vector<FiguresOf> structures;
};

/// Computes every figure of a session from its ticks, one after another.
class Tally {
 public:
  struct Structure {
    std::vector<double> margins;  ///< m
    double told = 0.0;            ///< m: greater distances are told as this
  };
  explicit Tally(std::vector<Structure> structures);

  /// With as many structures as there are. Ticks come in order of time.
  void add(const Tick& tick);
  Figures figures() const;

 private:
  /// Contacts that only short pauses part are one.
  struct Run {
    std::optional<std::int64_t> last_ns = {};
    bool guarded = false;
    bool cut = false;  ///< the burr turned in it
    bool begins(std::int64_t time_ns, bool now_guarded = false);
  };
  void weigh(const Tick& tick, double seconds);
  void look(const Tick& tick);
  void follow(const Tick& tick);
  void endPiece(const Tick& tick);

  std::vector<Structure> structures_;
  Figures figures_;
  std::optional<Tick> first_, last_;
  std::optional<Tick> piece_;                    ///< the tick that begins a piece of the path
  bool piece_touches_ = false;                   ///< in any of its ticks
  double cut_path_ = 0.0, cut_path_time_ = 0.0;  ///< m, s: of pieces that began while it turned
  haptics::Vec3 least_, most_;                   ///< of the box around the ends of the pieces
  double force_seconds_ = 0.0;                   ///< N s, in contact
  double cut_force_seconds_ = 0.0;               ///< N s, while the burr turned
  Run contact_, stroke_;
  std::vector<double> push_seconds_;  ///< N s, of each structure
  std::vector<Run> encounter_;
};

}  // namespace app::report
