// SPDX-License-Identifier: BSD-3-Clause

// palpate-loading: how fast scans are found and read, beside reading the same bytes and beside
// vtk-dicom's own classes, in one process; what memory that takes, how soon a cancel returns, and
// whether the touch notices.

#include <sys/stat.h>
#include <vtkDICOMDirectory.h>
#include <vtkDICOMReader.h>
#include <vtkDICOMSorter.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

#include "app/build_info/build_info.h"
#include "datasets/phantoms/phantoms.h"
#include "datasets/readers/volume_reader.h"
#include "haptics/scene/scene.h"
#include "haptics/servo/servo_loop.h"
#include "haptics/session.h"
#include "haptics/simulation/simulated.h"
#include "resources/named_tools.h"
#include "tests/bench/ticks.h"
#include "tests/support/dicom_bytes.h"
#include "tests/support/sentence.h"
#include "ui/props/picture.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr int kSide = 512, kSlices = 361, kFiles = 2000;

struct Options {
  std::string folder, out;
  int runs = 7, cancels = 40;
  double minutes = 1.0;
};

double secondsOf(const std::function<void()>& work) {
  const Clock::time_point begun = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// Memory of this process that no file backs, bytes.
double anonymousMemory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word)
    if (word == "RssAnon:" && status >> kilobytes) return kilobytes * 1024.0;
  return 0.0;
}

/// The most that `work` holds beyond what was held before, bytes.
double mostMemoryOf(const std::function<void()>& work) {
  const double before = anonymousMemory();
  std::atomic<bool> done = false;
  double most = before;
  std::jthread watch([&] {
    for (; !done; std::this_thread::sleep_for(std::chrono::milliseconds{1}))
      most = std::max(most, anonymousMemory());
  });
  work();
  done = true;
  watch.join();
  return most - before;
}

/// A series of 512 x 512 x 361 in `series`, and beside it small ones, 2,000 files in all.
void makeFiles(const fs::path& folder) {
  std::minstd_rand noise{1};
  datasets::testing::DicomSlice slice;
  for (int n = 0; n < kFiles; ++n) {
    const bool large = n < kSlices;
    const int number = large ? n : (n - kSlices) % 100;
    slice.series = "1.2.3." + std::to_string(large ? 1 : 2 + (n - kSlices) / 100);
    slice.instance = "1.2.4." + std::to_string(n + 1);
    slice.position_mm = {0.0, 0.0, 0.5 * number};
    slice.rows = slice.columns = large ? kSide : 64;
    slice.pixels.resize(std::size_t(slice.rows) * std::size_t(slice.columns));
    for (std::int16_t& v : slice.pixels) v = std::int16_t(noise() % 4096 - 1024);
    const fs::path to = folder / (large ? "series" : "others");
    fs::create_directories(to);
    std::ofstream out(to / std::to_string((n * 7919) % 100'003), std::ios::binary);
    out << bytesOf(slice);
  }
}

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

/// All bytes of the files, one after the other.
void readBytes(const std::vector<fs::path>& paths) {
  std::vector<char> block(std::size_t{1} << 20);
  for (const fs::path& path : paths) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    while (file != nullptr && std::fread(block.data(), 1, block.size(), file) > 0) {
    }
    if (file != nullptr) std::fclose(file);
  }
}

/// Each way of doing it in turn, several times; the median of each in seconds.
Json sideBySide(const std::vector<std::pair<std::string, std::function<void()>>>& ways, int runs) {
  std::vector<std::vector<double>> seconds(ways.size());
  for (int run = 0; run <= runs; ++run)
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const double s = secondsOf(ways[w].second);
      if (run > 0) seconds[w].push_back(s);  // the first one warms up
    }
  Json json;
  for (std::size_t w = 0; w < ways.size(); ++w) json[ways[w].first + "_s"] = median(seconds[w]);
  for (std::size_t w = 1; w < ways.size(); ++w)
    json["palpate_over_" + ways[w].first] = median(seconds[0]) / median(seconds[w]);
  return json;
}

Json measureScan(const fs::path& folder, int runs) {
  const std::vector<fs::path> paths = filesBelow(folder);
  return sideBySide({{"palpate", [&] { datasets::survey(folder); }},
                     {"bytes", [&] { readBytes(paths); }},
                     {"vtk_dicom",
                      [&] {
                        vtkNew<vtkDICOMDirectory> directory;
                        directory->SetDirectoryName(folder.c_str());
                        directory->SetScanDepth(3);
                        directory->Update();
                      }}},
                    runs);
}

Json measureLoad(const fs::path& folder, int runs) {
  const std::vector<fs::path> paths = filesBelow(folder);
  Json json = sideBySide({{"palpate", [&] { datasets::readVolume(folder); }},
                          {"bytes", [&] { readBytes(paths); }},
                          {"vtk_dicom",
                           [&] {
                             vtkNew<vtkStringArray> names;
                             for (const fs::path& path : paths)
                               names->InsertNextValue(path.c_str());
                             vtkNew<vtkDICOMSorter> sorter;
                             sorter->SetInputFileNames(names);
                             sorter->Update();
                             vtkNew<vtkDICOMReader> reader;
                             reader->SetFileNames(sorter->GetFileNamesForSeries(0));
                             reader->Update();
                           }}},
                         runs);
  const double voxels = 2.0 * kSide * kSide * kSlices;
  json["most_memory_over_voxels"] = mostMemoryOf([&] { datasets::readVolume(folder); }) / voxels;
  return json;
}

/// The whole way of the window, with picture and scene, cancelled at random moments.
Json measureCancel(const fs::path& path, int count) {
  const auto tool = haptics::makeTool("probe", resources::namedToolMesh("probe").value()).value();
  const auto load = [&](const std::atomic<bool>& cancel) {
    auto volume = datasets::readVolume(path, {}, {.advanced = [](double) {}, .cancel = &cancel});
    if (!volume) return false;
    const ui::Picture picture =
        ui::pictureOf(std::make_shared<const haptics::Volume>(std::move(*volume)), &cancel);
    if (cancel) return false;
    return haptics::makeScene(picture.volume, tool, {.cancel = &cancel}).has_value();
  };
  const std::atomic<bool> never = false;
  const double whole = secondsOf([&] { load(never); });
  const double before = anonymousMemory();
  std::minstd_rand noise{2};
  std::vector<double> waits;
  for (int n = 0; n < count; ++n) {
    std::atomic<bool> cancel = false;
    bool cancelled = false;
    std::jthread loader([&] { cancelled = !load(cancel); });
    std::this_thread::sleep_for(
        std::chrono::duration<double>{whole * (n + noise() / double(noise.max())) / count});
    const double wait = secondsOf([&] {
      cancel = true;
      loader.join();
    });
    if (cancelled) waits.push_back(wait);
  }
  Json json{{"whole_s", whole}, {"cancelled", waits.size()}};
  if (!waits.empty())
    json.update({{"median_s", median(waits)}, {"longest_s", *std::ranges::max_element(waits)}});
  json["left_over_MB"] = (anonymousMemory() - before) / 1e6;
  return json;
}

/// A touch and an empty loop of the same policy, beside each other in the same minute, with a scan
/// being loaded in every other second and without.
Json measureDisturbance(const fs::path& path, double seconds) {
  auto phantom = datasets::makePhantom("demo").value();
  auto tool = haptics::makeTool(phantom.tool, resources::namedToolMesh(phantom.tool).value());
  const auto scene =
      haptics::makeScene(std::make_shared<const haptics::Volume>(std::move(phantom.volume)),
                         std::move(*tool))
          .value();
  haptics::Session touch;
  haptics::Settings settings;
  settings.isovalue = phantom.isovalue;
  touch.set(settings);
  touch.adopt(scene, haptics::Pose::Identity());
  if (const auto opened = touch.open(haptics::HandKind::Slide); !opened)
    return {{"failed", sentence(opened.error())}};
  haptics::LatestValue<haptics::Pose> nowhere;
  haptics::ServoLoop empty{haptics::openMouse(nowhere, {}, haptics::ServoRate{}.period()),
                           settings};
  empty.start();
  haptics::Snapshot touching, turning;
  const auto counted = [&] {
    touch.latest(touching);
    empty.snapshots.take(turning);
    return std::array{ticksOf(touching), ticksOf(turning)};
  };
  Ticks of[2][2];  // touch and empty loop, without and with loading
  int loads = 0;
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>{seconds});
  for (int turn = 0; Clock::now() < end; ++turn) {
    const bool loading = turn % 2 == 1;
    const std::array<Ticks, 2> before = counted();
    const Clock::time_point until = Clock::now() + std::chrono::seconds{1};
    for (; loading && Clock::now() < until; ++loads) datasets::readVolume(path);
    std::this_thread::sleep_until(until);
    const std::array<Ticks, 2> after = counted();
    for (std::size_t loop = 0; loop < 2; ++loop) of[loop][turn % 2] += after[loop] - before[loop];
  }
  return {{"loads", loads},
          {"touch", {{"idle", jsonOf(of[0][0])}, {"loading", jsonOf(of[0][1])}}},
          {"empty", {{"idle", jsonOf(of[1][0])}, {"loading", jsonOf(of[1][1])}}}};
}

int run(const Options& options) {
  const fs::path folder = options.folder;
  if (!fs::exists(folder / "series")) makeFiles(folder);
  Json json{{"machine", app::machineHere()}, {"version", app::versionHere()}};
  json["scan_2000_files"] = measureScan(folder, options.runs);
  json["load_512x512x361"] = measureLoad(folder / "series", options.runs);
  json["cancel"] = measureCancel(folder / "series", options.cancels);
  if (options.minutes > 0.0)
    json["disturbance"] = measureDisturbance(folder / "series", 60.0 * options.minutes);
  std::puts(json.dump(2).c_str());
  if (!options.out.empty()) std::ofstream(options.out) << json.dump(2) << '\n';
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Options options;
  CLI::App program{"How fast scans are found and read, and what else notices"};
  program.add_option("folder", options.folder, "For 230 MB of files, made there once")->required();
  program.add_option("--runs", options.runs, "Of each way, after one to warm up");
  program.add_option("--cancels", options.cancels, "At moments of their own");
  program.add_option("--minutes", options.minutes, "Of touching beside the loading; 0: none");
  program.add_option("--out", options.out, "JSON, besides what is printed");
  CLI11_PARSE(program, argc, argv);
  return bench::run(options);
}
