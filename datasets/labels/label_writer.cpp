// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/labels/label_writer.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <string>
#include <vector>

#include "datasets/readers/files/refusal.h"
#include "datasets/readers/nrrd/writer.h"
#include "haptics/process/output_file.h"

namespace datasets {

using haptics::Expected;

namespace {

/// Where a structure lies in the file.
struct Place {
  std::size_t layer = 0;
  int label = 1;
};

/// Which codes a map's voxels have.
std::bitset<256> codesIn(const LabelMap& labels) {
  std::bitset<256> used;
  for (std::int64_t n = 0; n < labels.grid().voxelCount(); ++n) used.set(labels.codes()[n]);
  return used;
}

/// Each structure into the first layer in which it meets none that it overlaps.
std::vector<Place> placesOf(const LabelMap& labels, const std::bitset<256>& used) {
  std::vector<std::bitset<256>> overlaps(labels.structures().size());
  for (std::size_t code = 0; code < used.size(); ++code)
    if (used[code])
      for (const std::uint8_t one : labels.structuresOf(std::uint8_t(code)))
        for (const std::uint8_t other : labels.structuresOf(std::uint8_t(code)))
          overlaps[one].set(other);
  std::vector<Place> places;
  std::vector<std::bitset<256>> layers;
  for (std::size_t n = 0; n < overlaps.size(); ++n) {
    std::size_t layer = 0;
    while (layer < layers.size() && (layers[layer] & overlaps[n]).any()) ++layer;
    if (layer == layers.size()) layers.emplace_back();
    places.push_back({layer, int(layers[layer].count()) + 1});
    layers[layer].set(n);
  }
  return places;
}

/// As the keys of an NRRD need it.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '\\' ? "\\\\" : std::string(1, c);
  return text;
}

std::string headerOf(const LabelMap& labels, const std::vector<Place>& places, std::size_t layers) {
  const auto& dims = labels.grid().dims;
  const bool several = layers > 1;
  std::string text = "NRRD0004\n# Palpate\ntype: uint8\ndimension: ";
  text += several ? "4\nsizes: " + std::to_string(layers) : "3\nsizes:";
  std::string extent;
  for (const std::int64_t n : dims) {
    text += " " + std::to_string(n);
    extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(n - 1);
  }
  text += "\n" + nrrdSpaceOf(labels.grid(), several) + "\nkinds:" + (several ? " list" : "") +
          " domain domain domain\nencoding: raw\n"
          "Segmentation_ContainedRepresentationNames:=Binary labelmap|\n"
          "Segmentation_MasterRepresentation:=Binary labelmap\n"
          "Segmentation_ReferenceImageExtentOffset:=0 0 0\n";
  for (std::size_t n = 0; n < places.size(); ++n) {
    const Structure& structure = labels.structures()[n];
    const auto key = [&](const char* name, const std::string& value) {
      text += "Segment" + std::to_string(n) + "_" + name + ":=" + value + "\n";
    };
    const auto& [red, green, blue] = structure.colour;
    key("ID", "Segment_" + std::to_string(n + 1));
    key("Name", escaped(structure.name));
    key("Color", exact(red) + " " + exact(green) + " " + exact(blue));
    key("LabelValue", std::to_string(places[n].label));
    key("Layer", std::to_string(places[n].layer));
    key("Extent", extent);
    key("Tags", "|");
  }
  return text + "\n";
}

}  // namespace

Expected<void> writeLabels(const LabelMap& labels, const std::filesystem::path& out,
                           const ReadProgress& progress) {
  const std::bitset<256> used = codesIn(labels);
  const std::vector<Place> places = placesOf(labels, used);
  std::size_t layers = 1;
  for (const Place& place : places) layers = std::max(layers, place.layer + 1);
  std::array<std::string, 256> voxels;  // what each code is in the file: a byte in each layer
  for (std::size_t code = 0; code < voxels.size(); ++code) {
    if (!used[code]) continue;
    voxels[code].resize(layers);
    for (const std::uint8_t number : labels.structuresOf(std::uint8_t(code)))
      voxels[code][places[number].layer] = char(places[number].label);
  }
  auto file = haptics::OutputFile::open(out);
  if (!file) return tl::unexpected(file.error());
  file->write(headerOf(labels, places, layers));
  const std::int64_t slice = labels.grid().dims[0] * labels.grid().dims[1];
  const std::uint8_t* code = labels.codes();
  for (std::int64_t k = 0; k < labels.grid().dims[2]; ++k) {
    if (progress.isCancelled()) return cancelled();
    std::string bytes;
    for (std::int64_t n = 0; n < slice; ++n) bytes += voxels[*code++];
    if (!file->write(bytes)) break;
  }
  if (auto closed = file->close(); !closed) return closed;
  if (auto finished = file->finish(); !finished) return tl::unexpected(finished.error());
  return {};
}

}  // namespace datasets
