// SPDX-License-Identifier: BSD-3-Clause
// The file that a film is, and why there may be none. Needs an X display with GLX, and ffmpeg.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "app/film/film.h"
#include "recorded_film.h"
#include "tests/support/sentence.h"

namespace {

using namespace film;

TEST_F(Film, TwiceTheSameHasTheSameFrames) {
  const Session session;
  auto recording = recorded(scratch, session);
  FilmOptions chosen = options();
  chosen.burn_in = true;
  const auto volume = [&](std::uint32_t) { return session.scene->volume; };
  const auto first = app::makeFilm(recording, volume, scratch / "a", chosen);
  // the second by another thread
  std::optional<haptics::Expected<app::FilmResult>> second;
  std::thread other([&] { second = app::makeFilm(recording, volume, scratch / "b", chosen); });
  other.join();
  ASSERT_TRUE(first && *second);
  EXPECT_EQ(decoded(first->film).frames, decoded((*second)->film).frames);
  std::ifstream a(first->film, std::ios::binary), b((*second)->film, std::ios::binary);
  const std::string bytes_a{std::istreambuf_iterator<char>(a), {}};
  const std::string bytes_b{std::istreambuf_iterator<char>(b), {}};
  EXPECT_GT(bytes_a.size(), 1000U);
  EXPECT_TRUE(bytes_a == bytes_b);
}

TEST_F(Film, WithoutFfmpegIsOggTheora) {
  auto recording = recorded(scratch, {});
  for (const char* program : {"", "no-such-program", "/no/such/program", "/"}) {
    FilmOptions chosen = options();
    chosen.ffmpeg = program;
    std::filesystem::remove(scratch / "f.ogv");
    const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
    ASSERT_TRUE(film) << sentence(film.error());
    EXPECT_EQ(film->film, scratch / "f.ogv");
    EXPECT_EQ(film->codec, "theora");
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"f.frames.csv", "f.ogv", "r.palpate"}));
    const Decoded pictures = decoded(film->film);
    ASSERT_EQ(pictures.frames.size(), 30U);
    for (const std::size_t i : {0U, 14U, 29U}) {
      const auto proxy = projected(front(), stepAt(std::int64_t(i) * 50).X_WP.translation());
      const auto seen = pictures.centroid(i, proxyColoured);
      EXPECT_NEAR(seen[0], proxy[0], 1.5) << i;
      EXPECT_NEAR(seen[1], proxy[1], 1.5) << i;
    }
  }
}

TEST_F(Film, WritesNoFileThatNobodyNamed) {
  auto recording = recorded(scratch, {});
  const auto mine = scratch.write("f.mp4", "mine");
  const auto ogg = app::makeFilm(recording, none, scratch / "f.ogv", options());
  ASSERT_TRUE(ogg) << sentence(ogg.error());
  EXPECT_EQ(ogg->film, scratch / "f.ogv");
  EXPECT_EQ(ogg->codec, "theora");
  EXPECT_EQ(std::filesystem::file_size(mine), 4U);
  // without ffmpeg it would be f.ogv, which is there
  FilmOptions bare = options();
  bare.ffmpeg = "";
  // an MP4 was asked for: it is that, or a sentence
  const auto no_mp4 = app::makeFilm(recording, none, scratch / "other.mp4", bare);
  ASSERT_FALSE(no_mp4);
  EXPECT_NE(sentence(no_mp4.error()).find("install the package ffmpeg"), std::string::npos);
  const auto refused = app::makeFilm(recording, none, scratch / "f", bare);
  ASSERT_FALSE(refused);
  EXPECT_NE(sentence(refused.error()).find("f.ogv\", which is there already"), std::string::npos);
  EXPECT_EQ(std::filesystem::file_size(mine), 4U);
}

/// What a program says on both outputs.
std::string saidBy(const std::string& command) {
  std::string said;
  FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
  std::array<char, 256> piece{};
  while (pipe != nullptr && std::fgets(piece.data(), int(piece.size()), pipe) != nullptr)
    said += piece.data();
  if (pipe != nullptr) pclose(pipe);
  return said;
}

TEST_F(Film, NothingIsSaidAgainstIt) {
  auto recording = recorded(scratch, {});
  // also where the picture fills no whole blocks, and with more than one key frame
  for (const auto& [width, rate] : {std::pair{640, 30}, std::pair{98, 240}})
    for (const char* program : {"ffmpeg", ""}) {
      FilmOptions chosen = options();
      chosen.ffmpeg = program;
      chosen.width = width;
      chosen.frames_per_second = rate;
      std::filesystem::remove(scratch / "f.ogv");
      const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
      ASSERT_TRUE(film) << sentence(film.error());
      const std::string named = " -i '" + film->film.string() + "'";
      EXPECT_EQ(saidBy("ffmpeg -nostdin -v warning" + named + " -f null -"), "") << film->film;
      EXPECT_EQ(saidBy("ffprobe -v warning -show_frames" + named + " > /dev/null"), "");
      const std::string size =
          saidBy("ffprobe -v warning -show_entries stream=width -of csv=p=0" + named);
      EXPECT_EQ(size, std::to_string(width) + "\n");
    }
}

TEST_F(Film, CancelledLeavesNothing) {
  auto recording = recorded(scratch, {});
  for (const char* program : {"ffmpeg", ""})
    for (const double until : {0.0, 0.4, 0.98}) {
      FilmOptions chosen = options();
      chosen.ffmpeg = program;
      chosen.goes_on = [&](double done) { return done < until; };
      const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
      ASSERT_FALSE(film);
      EXPECT_EQ(film.error().reason, "cancelled");
      EXPECT_EQ(scratch.names(), std::vector<std::string>{"r.palpate"});
      EXPECT_TRUE(childless());
    }
}

TEST_F(Film, AnEncoderThatFailsIsOneSentence) {
  auto recording = recorded(scratch, {});
  const auto script = [&](const char* name, const std::string& text) {
    std::ofstream(scratch / name) << "#!/bin/sh\n" << text;
    fs::permissions(scratch / name, fs::perms::owner_all);
    return (scratch / name).string();
  };
  const std::array programs{
      script("dies", "echo 'no such thing as libx264' >&2; echo more >&2; exit 1\n"),
      script("killed", "head -c 2000000 > /dev/null; kill -9 $$\n"),
      script("shouts", "yes 'a very long complaint' | head -c 5000000 >&2; exit 3\n"),
      script("lies", "cat > /dev/null; for last; do :; done; echo film > \"${last#file:}\"\n"),
      script("deaf", "exec 0<&-; sleep 0.3; exit 1\n")};
  for (const std::string& program : programs) {
    SCOPED_TRACE(program);
    FilmOptions chosen = options();
    chosen.ffmpeg = program;
    const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
    ASSERT_FALSE(film);
    EXPECT_EQ(film.error().reason, "encoder");
    EXPECT_LT(sentence(film.error()).size(), 400U);
    EXPECT_EQ(sentence(film.error()).find('\n'), std::string::npos);
    EXPECT_TRUE(childless());
    EXPECT_EQ(scratch.names().size(), 1U + programs.size());
  }
  FilmOptions chosen = options();
  chosen.ffmpeg = programs[0];
  const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
  EXPECT_NE(sentence(film.error()).find("no such thing as libx264"), std::string::npos);
  // one that neither reads nor ends can be left
  chosen.ffmpeg = script("hangs", "exec sleep 1000\n");
  int asked = 0;
  chosen.goes_on = [&](double) { return ++asked < 20; };
  const auto left = app::makeFilm(recording, none, scratch / "f", chosen);
  ASSERT_FALSE(left);
  EXPECT_EQ(left.error().reason, "cancelled");
  EXPECT_TRUE(childless());
}

TEST_F(Film, AFullDiskLeavesNothing) {
  auto recording = recorded(scratch, {});
  // a file cannot grow beyond this: as on a full disk, but for the error's name
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  for (const char* program : {"ffmpeg", ""}) {
    FilmOptions chosen = options();
    chosen.ffmpeg = program;
    const auto whole = app::makeFilm(recording, none, scratch / "f", chosen);
    ASSERT_TRUE(whole) << sentence(whole.error());
    const rlim_t size = fs::file_size(whole->film);
    fs::remove(whole->film);
    fs::remove(whole->times);
    for (const rlim_t room : {rlim_t{10}, size / 10, size / 2, size * 9 / 10, size - 1}) {
      rlimit little = before;
      little.rlim_cur = room;
      setrlimit(RLIMIT_FSIZE, &little);
      const auto film = app::makeFilm(recording, none, scratch / "f", chosen);
      setrlimit(RLIMIT_FSIZE, &before);
      ASSERT_FALSE(film) << fs::file_size(film->film) << " bytes with room for " << room;
      EXPECT_TRUE(film.error().reason == "encoder" || film.error().reason == "unwritable");
      EXPECT_EQ(scratch.names(), std::vector<std::string>{"r.palpate"});
    }
  }
  std::signal(SIGXFSZ, SIG_DFL);
}

TEST_F(Film, WhatCannotBeIsRefused) {
  auto recording = recorded(scratch, {});
  const auto reason = [&](auto change, fs::path out = {}) {
    FilmOptions chosen = options();
    change(chosen);
    const auto film = app::makeFilm(recording, none, out.empty() ? scratch / "f" : out, chosen);
    return film ? std::string{} : film.error().reason;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reason([](FilmOptions& o) { o.width = 321; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.height = 1'000'000; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.height = 0; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.frames_per_second = 0; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.speed = 0.0; }), "options");
  EXPECT_EQ(reason([&](FilmOptions& o) { o.speed = nan; }), "options");
  EXPECT_EQ(reason([](FilmOptions& o) { o.from = 2.0; }), "nothing");
  EXPECT_EQ(reason([](FilmOptions& o) { o.to = -1.0; }), "nothing");
  EXPECT_EQ(reason([&](FilmOptions& o) { o.from = nan; }), "nothing");
  const auto as_is = [](FilmOptions&) {};
  EXPECT_EQ(reason(as_is, scratch / "nowhere" / "f"), "unwritable");
  EXPECT_EQ(reason(as_is, scratch.folder() / ""), "unwritable");
  fs::create_directory(scratch / "folder.mp4");
  EXPECT_EQ(reason(as_is, scratch / "folder"), "unwritable");
  EXPECT_EQ(scratch.names(), (std::vector<std::string>{"folder.mp4", "r.palpate"}));
  const std::string display = std::getenv("DISPLAY");
  unsetenv("DISPLAY");
  EXPECT_EQ(reason(as_is), "no-display");
  setenv("DISPLAY", ":65530", 1);
  EXPECT_EQ(reason(as_is), "no-display");
  setenv("DISPLAY", display.c_str(), 1);
  EXPECT_EQ(scratch.names(), (std::vector<std::string>{"folder.mp4", "r.palpate"}));
}

}  // namespace
