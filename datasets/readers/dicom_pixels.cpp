// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/dicom_pixels.h"

#include <dlfcn.h>
#include <vtkDICOMReader.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include "datasets/readers/c_locale.h"
#include "datasets/readers/inflated_file.h"
#include "datasets/readers/refusal.h"
#include "datasets/readers/straighten.h"
#include "datasets/readers/vtk_errors.h"

namespace datasets {

using haptics::Expected;
using haptics::ScalarType;

namespace {

std::optional<ScalarType> typeOf(int vtk_type) {
  switch (vtk_type) {
    case VTK_UNSIGNED_CHAR:
      return ScalarType::UInt8;
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return ScalarType::Int8;
    case VTK_UNSIGNED_SHORT:
      return ScalarType::UInt16;
    case VTK_SHORT:
      return ScalarType::Int16;
    case VTK_UNSIGNED_INT:
      return ScalarType::UInt32;
    case VTK_INT:
      return ScalarType::Int32;
    case VTK_FLOAT:
      return ScalarType::Float32;
    default:
      return {};
  }
}

ScalarType storedType(const DicomFile& file) {
  switch (file.bits_allocated) {
    case 8:
      return file.is_signed ? ScalarType::Int8 : ScalarType::UInt8;
    case 16:
      return file.is_signed ? ScalarType::Int16 : ScalarType::UInt16;
    default:
      return file.is_signed ? ScalarType::Int32 : ScalarType::UInt32;
  }
}

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

/// The types to try, in order: the header's bits may allow more than the voxels use, so a 16-bit
/// type comes before a 32-bit one, and the next is tried when a voxel does not fit.
std::vector<ScalarType> candidates(const DicomSeries& series) {
  const DicomFile& first = series.files.front();
  const ScalarType stored = storedType(first);
  bool plain = true, integers = true;
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
    if (covers(stored, values)) types.push_back(stored);
    if (haptics::sizeOf(stored) <= 2 && values.least < 0.0) types.push_back(ScalarType::Int16);
    if (haptics::sizeOf(stored) <= 2 && values.least >= 0.0) types.push_back(ScalarType::UInt16);
    if (values.least >= 0.0) types.push_back(ScalarType::UInt32);
    types.push_back(ScalarType::Int32);
  }
  types.push_back(ScalarType::Float32);
  return types;
}

/// One slice rescaled; false if a value does not fit an integer type.
template <class From, class To>
bool rescale(const From* from, To* to, std::int64_t count, const DicomFile& file) {
  if constexpr (std::is_same_v<From, To>) {
    if (file.slope == 1.0 && file.intercept == 0.0) {
      std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(To));
      return true;
    }
  }
  if constexpr (std::is_integral_v<To>) {
    double least = 0.0, greatest = 0.0;
    const Interval range{static_cast<double>(std::numeric_limits<To>::lowest()),
                         static_cast<double>(std::numeric_limits<To>::max())};
    for (std::int64_t i = 0; i < count; ++i) {
      const double v = file.slope * static_cast<double>(from[i]) + file.intercept;
      least = std::min(least, v);
      greatest = std::max(greatest, v);
      to[i] = static_cast<To>(std::clamp(v, range.least, range.greatest));
    }
    return range.least <= least && greatest <= range.greatest;
  } else {
    for (std::int64_t i = 0; i < count; ++i)
      to[i] = static_cast<To>(file.slope * static_cast<double>(from[i]) + file.intercept);
    return true;
  }
}

/// The codec library under vtk-dicom writes its warnings to standard error; it comes without
/// headers, so its switches are looked up by name and missing ones are no harm.
void silenceCodecs() {
  for (const char* name :
       {"_ZN4gdcm5Trace10WarningOffEv", "_ZN4gdcm5Trace8DebugOffEv", "_ZN4gdcm5Trace8ErrorOffEv"})
    if (void* off = dlsym(RTLD_DEFAULT, name)) reinterpret_cast<void (*)()>(off)();
}

/// Pixels of one slice, as stored.
struct Pixels {
  ScalarType type;
  const void* first;
};

/// The pixels of one slice at a time, in the file's own row order; a file of frames is decoded
/// once.
class SliceDecoder {
 public:
  SliceDecoder() {
    silenceCodecs();
    errors_->watch(reader_);
    reader_->SetMemoryRowOrderToFileNative();
    reader_->SetAutoRescale(0);
    reader_->SetAutoYBRToRGB(0);
    reader_->SetSorting(0);
  }

  Expected<Pixels> decode(const DicomFile& file) {
    if (file.path != decoded_) {
      errors_->forget();
      std::optional<InflatedFile> inflated;
      if (file.deflated) {
        auto copy = InflatedFile::of(file.path);
        if (!copy) return tl::unexpected(copy.error());
        inflated.emplace(std::move(*copy));
      }
      reader_->SetFileName(inflated ? inflated->path().c_str() : file.path.c_str());
      reader_->Update();
      decoded_ = file.path;
    }
    vtkImageData* image = reader_->GetOutput();
    int dims[3] = {0, 0, 0};
    if (image != nullptr) image->GetDimensions(dims);
    const bool whole = errors_->errors() == 0 && reader_->GetErrorCode() == 0 && image != nullptr &&
                       dims[0] == file.plane.columns && dims[1] == file.plane.rows &&
                       dims[2] == file.frame_count && image->GetScalarPointer() != nullptr &&
                       image->GetNumberOfScalarComponents() == 1 &&
                       typeOf(image->GetScalarType()).has_value();
    if (!whole)
      return malformed("truncated",
                       "The pixels of " + quoted(file.path) +
                           " cannot be decoded: they are cut off, damaged or in a form "
                           "unknown here; fetch the file again or export it as explicit "
                           "little endian.");
    const ScalarType type = *typeOf(image->GetScalarType());
    const std::int64_t before = file.frame * file.plane.columns * file.plane.rows;
    return Pixels{type, static_cast<const char*>(image->GetScalarPointer()) +
                            before * static_cast<std::int64_t>(haptics::sizeOf(type))};
  }

 private:
  std::filesystem::path decoded_;
  vtkNew<vtkDICOMReader> reader_;
  vtkNew<VtkErrors> errors_;
};

/// Of one slice.
std::int64_t pixelsOf(const DicomSeries& series) {
  const SlicePlane& any = series.files.front().plane;
  return any.columns * any.rows;
}

enum class Outcome { Done, DoesNotFit };

Expected<Outcome> decodeAll(const DicomSeries& series, ScalarType type, void* voxels,
                            const ReadProgress& progress) {
  SliceDecoder decoder;
  const std::vector<std::size_t>& order = series.stack->order;
  const std::int64_t slice = pixelsOf(series);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (progress.isCancelled()) return cancelled();
    progress.advanced(static_cast<double>(k) / static_cast<double>(order.size()));
    const DicomFile& file = series.files[order[k]];
    const auto pixels = decoder.decode(file);
    if (!pixels) return tl::unexpected(pixels.error());
    const bool fits = haptics::visitVoxels(pixels->type, pixels->first, [&](const auto* from) {
      return haptics::visitVoxels(type, voxels, [&](const auto* to) {
        using To = std::remove_const_t<std::remove_pointer_t<decltype(to)>>;
        return rescale(from, static_cast<To*>(voxels) + static_cast<std::int64_t>(k) * slice, slice,
                       file);
      });
    });
    if (!fits) return Outcome::DoesNotFit;
  }
  return Outcome::Done;
}

/// Makes air of what a slice pads its pixels with: the least of all other values. How many.
std::int64_t padWithAir(const DicomSeries& series, ScalarType type, void* voxels) {
  if (std::ranges::none_of(series.files, [](const DicomFile& f) { return f.padding.has_value(); }))
    return 0;
  return haptics::visitVoxels(type, voxels, [&](const auto* any) {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(any)>>;
    const std::int64_t pixels = pixelsOf(series);
    const Interval range = rangeOf(type);
    const auto eachSlice = [&](auto&& visit) {
      T* slice = static_cast<T*>(voxels);
      for (const std::size_t index : series.stack->order) {
        const DicomFile& file = series.files[index];
        // what no voxel can be, where the slice has no padding
        T low = std::numeric_limits<T>::max(), high = std::numeric_limits<T>::lowest();
        if (file.padding) {
          const auto [least, greatest] =
              std::minmax({file.slope * file.padding->front() + file.intercept,
                           file.slope * file.padding->back() + file.intercept});
          // beyond what the type holds there is no voxel to compare with
          if (greatest >= range.least && least <= range.greatest) {
            low = static_cast<T>(std::max(least, range.least));
            high = static_cast<T>(std::min(greatest, range.greatest));
          }
        }
        for (T* p = slice; p != slice + pixels; ++p) visit(*p, low <= *p && *p <= high);
        slice += pixels;
      }
    };
    std::optional<T> air;
    eachSlice([&](T& value, bool padding) {
      if (!padding && (!air || value < *air)) air = value;
    });
    std::int64_t count = 0;
    if (!air) return count;
    eachSlice([&](T& value, bool padding) {
      if (!padding) return;
      value = *air;
      ++count;
    });
    return count;
  });
}

}  // namespace

Expected<haptics::Volume> readSeries(const DicomSeries& series, Geometry geometry,
                                     const ReadProgress& progress) {
  if (!series.stack) return tl::unexpected(series.stack.error());
  const Stack& stack = *series.stack;
  if (stack.crooked && geometry == Geometry::AsStored) return tl::unexpected(stack.crooked->why);
  const auto grid = gridOf(stack.geometry);
  if (!grid) return tl::unexpected(grid.error());
  const CLocale numbers_with_points;
  const std::int64_t stored = pixelsOf(series) * static_cast<std::int64_t>(stack.order.size());
  const double decoded = stack.crooked ? 0.8 : 1.0;  // of the progress

  for (const ScalarType type : candidates(series)) {
    const auto room = checkRoom(stored + (stack.crooked ? grid->voxelCount() : 0),
                                static_cast<std::int64_t>(haptics::sizeOf(type)));
    if (!room) return tl::unexpected(room.error());
    auto voxels = haptics::allocateVoxels(stored, type);
    if (!voxels) return tl::unexpected(std::move(voxels.error()));
    const auto outcome = decodeAll(series, type, voxels->get(), progress.part(0.0, decoded));
    if (!outcome) return tl::unexpected(outcome.error());
    if (*outcome == Outcome::DoesNotFit) continue;
    const std::int64_t padded = padWithAir(series, type, voxels->get());
    if (stack.crooked) {
      auto box = haptics::allocateVoxels(grid->voxelCount(), type);
      if (!box) return tl::unexpected(std::move(box.error()));
      if (!straighten(stack, type, voxels->get(), box->get(), progress.part(decoded, 1.0)))
        return cancelled();
      voxels = std::move(box);
    }
    const bool hounsfield = std::ranges::all_of(series.files, &DicomFile::hounsfield);
    return haptics::makeVolume(*grid, type, std::move(*voxels),
                               {.unit = hounsfield ? "HU" : "",
                                .modality = series.files.front().modality,
                                .orientation_known = true,
                                .padded = padded,
                                .resampled = stack.crooked.has_value()});
  }
  return unsupported("bad-header",
                     "The series' rescaled values fit no voxel type; export it again.");
}

}  // namespace datasets
