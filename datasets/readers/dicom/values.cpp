// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom/values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace datasets {

using haptics::ScalarType;

namespace {

/// No value lies between these.
constexpr std::array<double, 2> kNoValues{std::numeric_limits<double>::infinity(), 0.0};

struct Interval {
  double least, greatest;
};

Interval rangeOf(ScalarType type) {
  return haptics::visitVoxels(type, nullptr, [](auto* v) {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(v)>>;
    return Interval{static_cast<double>(std::numeric_limits<T>::lowest()),
                    static_cast<double>(std::numeric_limits<T>::max())};
  });
}

bool covers(ScalarType type, Interval values) {
  const Interval range = rangeOf(type);
  return range.least <= values.least && values.greatest <= range.greatest;
}

bool isInteger(double number) { return std::nearbyint(number) == number; }

template <class From, class To>
bool rescaleAs(const From* from, To* to, const Window& window, const DicomFile& file) {
  const bool plain = file.slope == 1.0 && file.intercept == 0.0;
  const Interval range{static_cast<double>(std::numeric_limits<To>::lowest()),
                       static_cast<double>(std::numeric_limits<To>::max())};
  double least = 0.0, greatest = 0.0;
  for (std::int64_t j = 0; j < window.count[1]; ++j) {
    const From* row =
        from + (window.first[1] + j * window.step) * file.plane.columns + window.first[0];
    if constexpr (std::is_same_v<From, To>) {
      if (plain && window.step == 1) {
        to = std::copy_n(row, window.count[0], to);
        continue;
      }
    }
    for (std::int64_t i = 0; i < window.count[0]; ++i) {
      const double v = file.slope * static_cast<double>(row[i * window.step]) + file.intercept;
      if constexpr (std::is_integral_v<To>) {
        least = std::min(least, v);
        greatest = std::max(greatest, v);
        *to++ = static_cast<To>(std::clamp(v, range.least, range.greatest));
      } else {
        *to++ = static_cast<To>(v);
      }
    }
  }
  return !std::is_integral_v<To> || (range.least <= least && greatest <= range.greatest);
}

}  // namespace

ScalarType storedTypeOf(const DicomFile& file) {
  switch (file.bits_allocated) {
    case 1:
    case 8:
      return file.is_signed ? ScalarType::Int8 : ScalarType::UInt8;
    case 16:
      return file.is_signed ? ScalarType::Int16 : ScalarType::UInt16;
    default:
      return file.is_signed ? ScalarType::Int32 : ScalarType::UInt32;
  }
}

std::vector<ScalarType> voxelTypesFor(const DicomSeries& series) {
  const ScalarType stored = storedTypeOf(series.files.front());
  const bool alike = std::ranges::all_of(
      series.files, [&](const DicomFile& file) { return storedTypeOf(file) == stored; });
  const bool small = std::ranges::all_of(
      series.files, [](const DicomFile& file) { return file.bits_allocated <= 16; });
  bool plain = alike, integers = true;
  Interval values{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
  for (const DicomFile& file : series.files) {
    plain = plain && file.slope == 1.0 && file.intercept == 0.0;
    integers = integers && isInteger(file.slope) && isInteger(file.intercept);
    const int bits = std::clamp(file.bits_stored, 1, file.bits_allocated);
    const double low = file.is_signed ? -std::ldexp(1.0, bits - 1) : 0.0;
    const double high = std::ldexp(1.0, file.is_signed ? bits - 1 : bits) - 1.0;
    for (const double v : {low, high}) {
      values.least = std::min(values.least, file.slope * v + file.intercept);
      values.greatest = std::max(values.greatest, file.slope * v + file.intercept);
    }
  }
  if (plain) return {stored};
  std::vector<ScalarType> types;
  if (integers) {
    if (alike && covers(stored, values)) types.push_back(stored);
    if (small && (values.least < 0.0 || !alike)) types.push_back(ScalarType::Int16);
    if (small && values.least >= 0.0) types.push_back(ScalarType::UInt16);
    if (values.least >= 0.0) types.push_back(ScalarType::UInt32);
    types.push_back(ScalarType::Int32);
  }
  types.push_back(ScalarType::Float32);
  return types;
}

Pixels settled(const Pixels& pixels, const DicomFile& file, std::vector<std::byte>& room,
               UpperBits& upper) {
  const int below = file.high_bit + 1 - file.bits_stored;
  if (file.bits_stored == file.bits_allocated) return pixels;
  const auto count = static_cast<std::size_t>(file.plane.columns * file.plane.rows);
  room.resize(count * haptics::sizeOf(pixels.type));
  const std::array<double, 2> padding = below == 0 ? file.padding.value_or(kNoValues) : kNoValues;
  // coded with loss, values swing beyond the stored bits, which must not begin anew at the other
  // end
  const bool with_loss =
      std::ranges::any_of(std::array{".4.50", ".4.51", ".4.81", ".4.91"},
                          [&](const char* ending) { return file.syntax.ends_with(ending); });
  const bool swings = with_loss && (!file.is_signed || file.syntax.ends_with(".4.91"));
  const double low = file.is_signed ? -std::ldexp(1.0, file.bits_stored - 1) : 0.0;
  const double high = low + std::ldexp(1.0, file.bits_stored) - 1.0;
  haptics::visitVoxels(pixels.type, pixels.first, [&](const auto* from) {
    using T = std::remove_cvref_t<decltype(*from)>;
    if constexpr (std::is_integral_v<T>) {
      if (swings) {
        auto* to = reinterpret_cast<T*>(room.data());
        for (std::size_t n = 0; n < count; ++n)
          to[n] = std::clamp(from[n], static_cast<T>(low), static_cast<T>(high));
        return;
      }
      using Bits = std::make_unsigned_t<T>;
      auto* to = reinterpret_cast<T*>(room.data());
      const auto mask = static_cast<Bits>((std::uint64_t{1} << file.bits_stored) - 1);
      const auto sign = static_cast<Bits>(
          file.is_signed ? std::uint64_t{1} << (file.bits_stored - 1) : std::uint64_t{0});
      // one after the other: shifting by all bits of a word at once is undefined
      const auto all_above = static_cast<Bits>(static_cast<Bits>(~Bits{0}) >> file.high_bit >> 1);
      for (std::size_t n = 0; n < count; ++n) {
        const auto bits = static_cast<Bits>(static_cast<Bits>(from[n]) >> below & mask);
        const auto above = static_cast<Bits>(static_cast<Bits>(from[n]) >> file.high_bit >> 1);
        // what has the sign bit goes below zero
        to[n] = static_cast<T>(static_cast<Bits>((bits ^ sign) - sign));
        const auto whole = static_cast<double>(from[n]);
        if (padding[0] <= whole && whole <= padding[1]) {
          to[n] = from[n];
          continue;
        }
        const bool negative = (bits & sign) != 0;
        upper.extended += negative && above == all_above ? 1 : 0;
        upper.bare += negative && above == 0 ? 1 : 0;
        upper.other += above != 0 && !(negative && above == all_above) ? 1 : 0;
      }
    }
  });
  return {pixels.type, room.data()};
}

bool rescale(const Pixels& pixels, const DicomFile& file, const Window& window, ScalarType type,
             void* to) {
  return haptics::visitVoxels(pixels.type, pixels.first, [&](const auto* from) {
    return haptics::visitVoxels(type, to, [&](const auto* any) {
      using To = std::remove_const_t<std::remove_pointer_t<decltype(any)>>;
      return rescaleAs(from, static_cast<To*>(to), window, file);
    });
  });
}

double leastOf(const Pixels& pixels, const DicomFile& file) {
  const std::array<double, 2> padding = file.padding.value_or(kNoValues);
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  haptics::visitVoxels(pixels.type, pixels.first, [&](const auto* from) {
    for (std::int64_t i = 0; i < file.plane.columns * file.plane.rows; ++i) {
      const auto v = static_cast<double>(from[i]);
      if (padding[0] <= v && v <= padding[1]) continue;
      least = std::min(least, v);
      greatest = std::max(greatest, v);
    }
  });
  return file.slope * (file.slope > 0.0 ? least : greatest) + file.intercept;
}

std::int64_t makeAir(const DicomFile& file, ScalarType type, double air, std::int64_t count,
                     void* slice) {
  if (!file.padding) return 0;
  const Interval range = rangeOf(type);
  const double one = file.slope * file.padding->front() + file.intercept,
               other = file.slope * file.padding->back() + file.intercept;
  const double least = std::min(one, other), greatest = std::max(one, other);
  // beyond what the type holds there is no voxel to compare with
  if (greatest < range.least || least > range.greatest) return 0;
  return haptics::visitVoxels(type, slice, [&](const auto* any) {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(any)>>;
    const auto low = static_cast<T>(std::max(least, range.least));
    const auto high = static_cast<T>(std::min(greatest, range.greatest));
    const auto background = static_cast<T>(std::clamp(air, range.least, range.greatest));
    std::int64_t made = 0;
    T* voxels = static_cast<T*>(slice);
    for (T* p = voxels; p != voxels + count; ++p)
      if (low <= *p && *p <= high) {
        *p = background;
        ++made;
      }
    return made;
  });
}

}  // namespace datasets
