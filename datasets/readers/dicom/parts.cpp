// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "datasets/readers/dicom/numbers.h"
#include "datasets/readers/dicom/stack.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

using haptics::Message;

namespace {

std::size_t indexOf(Attribute attribute) { return static_cast<std::size_t>(attribute); }

/// Numbers by their size and before all else, the rest as text.
struct ByValue {
  bool operator()(const std::string& a, const std::string& b) const {
    const auto x = decimalString(a), y = decimalString(b);
    if (x && y && *x != *y) return *x < *y;
    if (x.has_value() != y.has_value()) return x.has_value();
    return a < b;
  }
};

/// The values of one attribute: which of them each slice has.
struct Values {
  Attribute attribute;
  std::vector<std::string> all;    ///< in order
  std::vector<std::size_t> which;  ///< for each slice
};

/// None where there are fewer than two values, or too many for parts of several slices.
std::optional<Values> valuesOf(Attribute attribute, const std::vector<DicomFile>& slices) {
  std::map<std::string, std::size_t> number;
  for (const DicomFile& slice : slices) {
    number[slice.attributes[indexOf(attribute)]] = 0;
    if (number.size() * 2 > slices.size()) return {};
  }
  if (number.size() < 2) return {};
  Values values{attribute, {}, {}};
  for (const auto& [value, n] : number) values.all.push_back(value);
  std::ranges::sort(values.all, ByValue());
  for (std::size_t n = 0; n < values.all.size(); ++n) number[values.all[n]] = n;
  for (const DicomFile& slice : slices)
    values.which.push_back(number[slice.attributes[indexOf(attribute)]]);
  return values;
}

std::vector<SlicePlane> planesOf(const std::vector<DicomFile>& slices,
                                 const std::vector<std::size_t>& some) {
  std::vector<SlicePlane> planes;
  for (const std::size_t n : some) planes.push_back(slices[n].plane);
  return planes;
}

bool isEven(const std::vector<DicomFile>& slices, const std::vector<std::size_t>& some) {
  const auto stack = stackOf(planesOf(slices, some));
  return stack && (!stack->crooked || !stack->crooked->uneven);
}

std::vector<std::size_t> allOf(const std::vector<DicomFile>& slices) {
  std::vector<std::size_t> all(slices.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Heights of slices along the normal of the first, with their indices, in order.
std::vector<std::pair<double, std::size_t>> heightsOf(const std::vector<DicomFile>& slices) {
  const SlicePlane& any = slices.front().plane;
  const haptics::Vec3 normal = any.along_row.cross(any.along_column);
  std::vector<std::pair<double, std::size_t>> heights_mm;
  for (std::size_t n = 0; n < slices.size(); ++n)
    heights_mm.emplace_back(normal.dot(slices[n].plane.position_mm), n);
  std::ranges::sort(heights_mm);
  return heights_mm;
}

/// The slices at each place, from the lowest place on.
std::vector<std::vector<std::size_t>> placesOf(const std::vector<DicomFile>& slices) {
  const auto heights_mm = heightsOf(slices);
  double largest_mm = 0.0;
  for (std::size_t k = 1; k < heights_mm.size(); ++k)
    largest_mm = std::max(largest_mm, heights_mm[k].first - heights_mm[k - 1].first);
  const double none_mm = samePlaceWithin_mm(largest_mm);
  std::vector<std::vector<std::size_t>> places;
  double last_mm = -std::numeric_limits<double>::infinity();
  for (const auto& [height_mm, n] : heights_mm) {
    if (places.empty() || height_mm - last_mm >= none_mm) places.emplace_back();
    places.back().push_back(n);
    last_mm = height_mm;
  }
  return places;
}

/// A way to part slices into volumes.
struct Parting {
  std::vector<std::vector<std::size_t>> parts;
  std::vector<const Values*> by;  ///< none: passes of the scanner
  std::size_t even_slices = 0;    ///< in parts that are even stacks

  bool isWhole(std::size_t all) const { return even_slices == all; }
};

/// What is known of all slices together.
struct Union {
  const std::vector<DicomFile>& slices;
  bool repeated;             ///< several lie at one place
  std::size_t least_slices;  ///< of a part that counts as even: two always are
};

enum class Wanted { AllEven, SomeEven };

/// Parts of equal `which`, none of them empty, with what is even among them. Where all are wanted
/// even, the rest is not judged behind one that is not.
Parting partedBy(const Union& all, const std::vector<std::size_t>& which,
                 std::vector<const Values*> by, Wanted wanted) {
  Parting parting{{}, std::move(by), 0};
  std::map<std::size_t, std::vector<std::size_t>> parts;
  for (std::size_t n = 0; n < which.size(); ++n) parts[which[n]].push_back(n);
  bool judged = true;
  for (auto& [number, part] : parts) {
    const bool even = judged && part.size() >= all.least_slices && isEven(all.slices, part);
    parting.even_slices += even ? part.size() : 0;
    judged = judged && (even || wanted == Wanted::SomeEven);
    parting.parts.push_back(std::move(part));
  }
  return parting;
}

/// Whether no part reaches into the place of another along the normal.
bool areApart(const Union& all, const Parting& parting) {
  const auto heights_mm = heightsOf(all.slices);
  std::vector<std::size_t> part_of(all.slices.size());
  for (std::size_t p = 0; p < parting.parts.size(); ++p)
    for (const std::size_t n : parting.parts[p]) part_of[n] = p;
  std::size_t changes = 0;
  for (std::size_t k = 1; k < heights_mm.size(); ++k)
    changes += part_of[heights_mm[k].second] != part_of[heights_mm[k - 1].second] ? 1 : 0;
  return changes + 1 == parting.parts.size();
}

/// Whether parts that follow each other are pieces of one stack and no volumes: it changes its step
/// between them, or lacks a slice or so where they meet.
bool arePieces(const Union& all, const Parting& parting) {
  if (!areApart(all, parting)) return false;
  const auto stack = stackOf(planesOf(all.slices, allOf(all.slices)));
  if (stack) return stack->crooked && stack->crooked->two_steps;
  if (stack.error().reason != "missing-slices") return false;
  const auto heights_mm = heightsOf(all.slices);
  std::vector<double> steps_mm;
  for (std::size_t k = 1; k < heights_mm.size(); ++k)
    steps_mm.push_back(heights_mm[k].first - heights_mm[k - 1].first);
  std::ranges::nth_element(steps_mm, steps_mm.begin() + std::ssize(steps_mm) / 2);
  const double extent_mm = heights_mm.back().first - heights_mm.front().first;
  const double missing = std::round(extent_mm / steps_mm[steps_mm.size() / 2]) + 1.0 -
                         static_cast<double>(heights_mm.size());
  return missing <= static_cast<double>(parting.parts.size());
}

/// By one attribute or by two, the fewest parts that are all even.
std::optional<Parting> evenParts(const Union& all, const std::vector<Values>& values) {
  const std::size_t count = all.slices.size();
  std::optional<Parting> best;
  const auto consider = [&](const std::vector<std::size_t>& which, std::vector<const Values*> by) {
    Parting parting = partedBy(all, which, std::move(by), Wanted::AllEven);
    if (parting.parts.size() < 2 || !parting.isWhole(count) || arePieces(all, parting)) return;
    if (!best || parting.parts.size() < best->parts.size()) best = std::move(parting);
  };
  for (const Values& one : values) consider(one.which, {&one});
  if (best) return best;
  for (std::size_t a = 0; a < values.size(); ++a)
    for (std::size_t b = a + 1; b < values.size(); ++b) {
      std::vector<std::size_t> which;
      for (std::size_t n = 0; n < count; ++n)
        which.push_back(values[a].which[n] * values[b].all.size() + values[b].which[n]);
      consider(which, {&values[a], &values[b]});
    }
  return best;
}

/// The n-th image at each place, in the order of a time that differs from image to image.
std::optional<Parting> partsInTime(const Union& all) {
  const auto places = placesOf(all.slices);
  const std::size_t images = imagesAtEachPlace(all.slices);
  if (images < 2 || places.size() < 2) return {};
  for (std::size_t a = 0; a < kAttributes; ++a) {
    if (!traitsOf(static_cast<Attribute>(a)).timed) continue;
    std::vector<std::size_t> which(all.slices.size());
    bool ordered = true;
    for (const auto& place : places) {
      std::map<double, std::size_t> by_time;
      for (const std::size_t n : place)
        if (const auto time = decimalString(all.slices[n].attributes[a])) by_time[*time] = n;
      ordered = ordered && by_time.size() == images;
      std::size_t rank = 0;
      for (const auto& [time, n] : by_time) which[n] = rank++;
    }
    if (!ordered) continue;
    Parting parting = partedBy(all, which, {}, Wanted::AllEven);
    if (parting.isWhole(all.slices.size())) return parting;
  }
  return {};
}

/// Numbers of parts for images in the order of a time: a new part begins where the images turn back
/// along the normal, or, if `at_pause`, behind the longest pause.
std::vector<std::size_t> passesOf(const Union& all, std::size_t attribute, bool at_pause) {
  std::vector<double> height_mm(all.slices.size());
  for (const auto& [height, n] : heightsOf(all.slices)) height_mm[n] = height;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t n = 0; n < all.slices.size(); ++n) {
    const auto time = decimalString(all.slices[n].attributes[attribute]);
    if (!time) return {};
    order.emplace_back(*time, n);
  }
  std::ranges::sort(order);
  std::size_t longest = 1, part = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const double pause = order[k].first - order[k - 1].first;
    if (pause <= 0.0) return {};  // not a time of each image
    if (pause > order[longest].first - order[longest - 1].first) longest = k;
  }
  std::vector<std::size_t> which(order.size());
  double ahead = 0.0;  // the way of the part so far
  for (std::size_t k = 1; k < order.size(); ++k) {
    const double way = height_mm[order[k].second] - height_mm[order[k - 1].second];
    const bool begins = at_pause ? k == longest : ahead * way < 0.0;
    part += begins ? 1 : 0;
    ahead = begins ? 0.0 : way;
    which[order[k].second] = part;
  }
  return which;
}

/// Passes of a scanner, one after the other in time.
std::optional<Parting> passesInTime(const Union& all) {
  for (std::size_t a = 0; a < kAttributes; ++a) {
    if (!traitsOf(static_cast<Attribute>(a)).timed) continue;
    for (const bool at_pause : {false, true}) {
      const auto which = passesOf(all, a, at_pause);
      if (which.empty()) continue;
      Parting parting = partedBy(all, which, {}, Wanted::AllEven);
      if (parting.parts.size() > 1 && parting.isWhole(all.slices.size()) &&
          !arePieces(all, parting))
        return parting;
    }
  }
  return {};
}

/// Two passes that nothing tells apart but their places: the slices at equal steps from the lowest
/// on, and the others, each even, where both lie in each other's place.
std::optional<Parting> passesBetween(const Union& all) {
  constexpr std::size_t kMostBetween = 3;  // candidates for the second slice of the lowest pass
  constexpr double kOnStep = 0.1;          // of the step
  const auto stack = stackOf(planesOf(all.slices, allOf(all.slices)));
  if (!stack || !stack->crooked || stack->crooked->two_steps) return {};
  const auto heights_mm = heightsOf(all.slices);
  for (std::size_t second = 1; second <= kMostBetween && second < heights_mm.size(); ++second) {
    const double step_mm = heights_mm[second].first - heights_mm.front().first;
    double next_mm = heights_mm.front().first;
    std::vector<std::size_t> which(all.slices.size(), 1);
    for (const auto& [height_mm, n] : heights_mm) {
      if (std::abs(height_mm - next_mm) > kOnStep * step_mm) continue;
      which[n] = 0;
      next_mm = height_mm + step_mm;
    }
    Parting parting = partedBy(all, which, {}, Wanted::AllEven);
    if (parting.parts.size() == 2 && parting.isWhole(all.slices.size()) && !areApart(all, parting))
      return parting;
  }
  return {};
}

/// By one attribute, so that no part has two images at one place, though none may be even.
std::optional<Parting> partsOfOneImageEach(const Union& all, const std::vector<Values>& values) {
  if (!all.repeated) return {};
  std::optional<Parting> best;
  for (const Values& one : values) {
    Parting parting = partedBy(all, one.which, {&one}, Wanted::SomeEven);
    const bool apart = std::ranges::all_of(parting.parts, [&](const auto& part) {
      const auto stack = stackOf(planesOf(all.slices, part));
      return part.size() > 1 && (stack || stack.error().reason != "duplicate");
    });
    if (apart && (!best || parting.parts.size() < best->parts.size())) best = std::move(parting);
  }
  return best;
}

/// By one attribute, of which some parts are even stacks, and the others none that could lack the
/// slices of these.
std::optional<Parting> someEvenParts(const Union& all, const std::vector<Values>& values) {
  std::optional<Parting> best;
  for (const Values& one : values) {
    Parting parting = partedBy(all, one.which, {&one}, Wanted::SomeEven);
    if (parting.even_slices == 0 ||
        !(traitsOf(one.attribute).strong || all.repeated || areApart(all, parting)) ||
        arePieces(all, parting))
      continue;
    if (!best || parting.even_slices > best->even_slices) best = std::move(parting);
  }
  return best;
}

/// "phase 2 of 3 (40 %)".
Message nameOf(const Values& values, std::size_t which) {
  const AttributeTraits& traits = traitsOf(values.attribute);
  const std::string number = std::to_string(which + 1), count = std::to_string(values.all.size());
  const std::string& value = values.all[which];
  if (traits.unit == nullptr || !decimalString(value))
    return {"part-of", {traits.name, number, count}};
  const Message shown = *traits.unit == '\0'
                            ? Message::numbers(value)
                            : Message{"part-measure", {Message::numbers(value), traits.unit}};
  return {"part-of-with", {traits.name, number, count, shown}};
}

Message nameOf(const Parting& parting, std::size_t part) {
  if (parting.by.empty())
    return {"part-of",
            {Message{"attribute-pass", {}}, std::to_string(part + 1),
             std::to_string(parting.parts.size())}};
  const std::size_t slice = parting.parts[part].front();
  Message name = nameOf(*parting.by.front(), parting.by.front()->which[slice]);
  if (parting.by.size() > 1)
    name = {"part-and", {std::move(name), nameOf(*parting.by[1], parting.by[1]->which[slice])}};
  return name;
}

std::vector<VolumePart> named(const Parting& parting) {
  std::vector<VolumePart> parts;
  for (std::size_t p = 0; p < parting.parts.size(); ++p)
    parts.push_back({parting.parts[p], nameOf(parting, p)});
  return parts;
}

}  // namespace

bool isEven(const std::vector<DicomFile>& slices) { return isEven(slices, allOf(slices)); }

std::size_t imagesAtEachPlace(const std::vector<DicomFile>& slices) {
  const auto places = placesOf(slices);
  const bool equal = std::ranges::all_of(
      places, [&](const auto& place) { return place.size() == places.front().size(); });
  return equal ? places.front().size() : 0;
}

std::vector<VolumePart> partsOf(const std::vector<DicomFile>& slices) {
  if (slices.size() < 2 || isEven(slices)) return {{allOf(slices), {}}};
  const bool repeated = placesOf(slices).size() < slices.size();
  const Union all{slices, repeated, repeated ? 2u : 3u};
  std::vector<Values> values;
  for (std::size_t a = 0; a < kAttributes; ++a)
    if (auto some = valuesOf(static_cast<Attribute>(a), slices)) values.push_back(std::move(*some));
  if (const auto parting = evenParts(all, values)) return named(*parting);
  if (const auto parting = partsInTime(all)) return named(*parting);
  if (const auto parting = passesInTime(all)) return named(*parting);
  if (const auto parting = passesBetween(all)) return named(*parting);
  if (const auto parting = someEvenParts(all, values)) return named(*parting);
  if (const auto parting = partsOfOneImageEach(all, values)) return named(*parting);
  return {{allOf(slices), {}}};
}

std::vector<Message> differencesAmong(const std::vector<DicomFile>& slices) {
  std::vector<Message> names;
  const auto tell = [&](const Message& name, const auto& of) {
    std::set<std::string> values;
    for (const DicomFile& slice : slices) values.insert(of(slice));
    if (values.size() > 1)
      names.push_back({"attribute-values", {name, std::to_string(values.size())}});
  };
  for (std::size_t a = 0; a < kAttributes; ++a) {
    const AttributeTraits& traits = traitsOf(static_cast<Attribute>(a));
    if (traits.told) tell(traits.name, [&](const DicomFile& f) { return f.attributes[a]; });
  }
  tell({"attribute-name", {}}, [](const DicomFile& f) { return f.name; });
  tell({"attribute-birth-date", {}}, [](const DicomFile& f) { return f.birth_date; });
  tell({"attribute-issuer", {}}, [](const DicomFile& f) { return f.issuer; });
  tell({"attribute-patient", {}}, [](const DicomFile& f) { return f.identity.patient; });
  tell({"attribute-study", {}}, [](const DicomFile& f) { return f.identity.study; });
  tell({"attribute-modality", {}}, [](const DicomFile& f) { return f.identity.modality; });
  tell({"attribute-series", {}}, [](const DicomFile& f) { return f.series; });
  return names;
}

}  // namespace datasets
