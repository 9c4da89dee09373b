// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a recording, and as each of its parts behind the checksums that would hide them.
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/recording/recording.h"
#include "app/recording/unfinished.h"
#include "datasets/edits/edit.h"
#include "tests/fuzz/require.h"
#include "tests/support/scratch_folder.h"

namespace {

using haptics::Error;

const support::ScratchFolder& folder() {
  static const support::ScratchFolder scratch;
  return scratch;
}

void requireWords(const Error& error) {
  fuzz::require(!error.message.empty() && !error.reason.empty(),
                "a refusal has a sentence and a reason");
}

std::vector<std::uint8_t> compressed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<std::uint8_t> out(size);
  compress2(out.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 1);
  out.resize(size);
  return out;
}

void readFile(std::string_view bytes) {
  const auto path = folder().write("r.palpate", bytes);
  if (const auto summary = app::summaryOf(path); !summary) requireWords(summary.error());
  auto recording = app::Recording::open(path);
  if (!recording) return requireWords(recording.error());
  std::int64_t steps = 0;
  const auto read = recording->forEach(-1e300, 1e300, [&](const app::RecordedStep& step) {
    fuzz::require(step.step.contacts.size() <= 6, "no more contacts than bear");
    return ++steps < 100'000;
  });
  if (!read) requireWords(read.error());
}

void recoverFile(std::string_view bytes) {
  const auto part = folder().write("p.palpate.part", bytes);
  const auto recovered = app::recover(part);
  if (!recovered) return requireWords(recovered.error());
  std::filesystem::remove(*recovered);
}

void readScene(std::string_view text) {
  const auto first = text.find('\n'), second = text.find('\n', first + 1);
  if (first == text.npos || second == text.npos) return;
  const auto points = compressed(text.substr(second + 1));
  const auto scene = app::sceneFrom({std::string(text.substr(0, first)),
                                     std::string(text.substr(first + 1, second - first - 1)),
                                     points, points, points});
  if (!scene) return requireWords(scene.error());
  fuzz::require(!scene->tool.shell.points.empty(), "a scene has a tool");
  for (const haptics::Vec3& point : scene->tool.shell.points)
    fuzz::require(point.allFinite(), "points are somewhere");
}

void readEdit(std::string_view text) {
  const auto edit = datasets::editFrom(text);
  if (!edit) return requireWords(edit.error());
  const auto again = datasets::editFrom(datasets::textOf(*edit));
  fuzz::require(again && datasets::textOf(*again) == datasets::textOf(*edit),
                "an edit is its text");
}

void readBlock(std::string_view bytes, app::Layout layout) {
  if (bytes.size() < 4) return;
  const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
  app::Block block;
  block.count = at(0);
  block.contact_count = at(1) + 256 * at(2);
  const std::size_t cut = std::min<std::size_t>(bytes.size() - 4, at(3) * 4U);
  if (cut > 0) block.contacts = compressed(bytes.substr(4, cut));
  block.steps = compressed(bytes.substr(4 + cut));
  const auto steps = app::decoded(block, layout);
  if (!steps) return requireWords(steps.error());
  fuzz::require(static_cast<std::int64_t>(steps->size()) == block.count, "as many as it says");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  switch (bytes[0] % 7) {
    case 0:
      readFile(rest);
      break;
    case 1:
      recoverFile(rest);
      break;
    case 2:
      if (const auto start = app::startFrom(std::string(rest)); !start) requireWords(start.error());
      break;
    case 3:
      readScene(rest);
      break;
    case 4:
      readBlock(rest, app::Layout::Exact);
      break;
    case 5:
      readEdit(rest);
      break;
    default:
      readBlock(rest, app::Layout::Rounded);
      break;
  }
  return 0;
}
