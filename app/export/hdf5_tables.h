// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/export/text.h"
#include "haptics/core/geometry.h"

namespace app::exporting {

inline constexpr std::size_t kChunk = 4096;  // rows
inline constexpr unsigned kDeflation = 4;

/// One of the library's ids, closed with the object.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closing)(hid_t)) : id_{id}, close_{closing} {}
  Handle(Handle&& other) noexcept : id_{std::exchange(other.id_, -1)}, close_{other.close_} {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() { close(); }
  operator hid_t() const { return id_; }
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

template <class T>
hid_t typeOf() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
  if constexpr (std::is_same_v<T, std::uint32_t>) return H5T_NATIVE_UINT32;
  if constexpr (std::is_same_v<T, std::uint16_t>) return H5T_NATIVE_UINT16;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

inline Handle textType() {
  Handle type{H5Tcopy(H5T_C_S1), H5Tclose};
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

inline void attach(hid_t object, const char* name, hid_t type, hid_t space, const void* value) {
  const Handle attribute{H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
  H5Awrite(attribute, type, value);
}
inline void attach(hid_t object, const char* name, const std::string& value) {
  const std::string text = plain(value);
  const char* words = text.c_str();
  attach(object, name, textType(), Handle{H5Screate(H5S_SCALAR), H5Sclose}, &words);
}
template <class T>
void attach(hid_t object, const char* name, T value) {
  attach(object, name, typeOf<T>(), Handle{H5Screate(H5S_SCALAR), H5Sclose}, &value);
}
template <class T>
void attach(hid_t object, const char* name, const T* values, std::initializer_list<hsize_t> sides) {
  const Handle space{H5Screate_simple(int(sides.size()), sides.begin(), nullptr), H5Sclose};
  attach(object, name, typeOf<T>(), space, values);
}

/// A dataset that grows by rows of `width` values; 0: by single values. Rows are kept until a chunk
/// is full.
template <class T>
class Table {
 public:
  Table(hid_t file, const char* path, hsize_t width, const char* unit, const char* meaning)
      : Table{file, path, width, unit, meaning, typeOf<T>()} {}

  void add(T value) { add(&value); }
  void add(const haptics::Vec3& v) requires std::is_floating_point_v<T> {
    const T values[] = {static_cast<T>(v.x()), static_cast<T>(v.y()), static_cast<T>(v.z())};
    add(values);
  }
  /// As many values as a row is wide.
  void add(const T* row) {
    const std::size_t width = rank_ == 1 ? 1 : width_;
    kept_.insert(kept_.end(), row, row + width);
    if (kept_.size() >= kChunk * width) flush();
  }
  /// False if this, or anything before, could not be written.
  bool flush() {
    if (kept_.empty() || !sound_) return sound_;
    const hsize_t rows = kept_.size() / (rank_ == 1 ? 1 : width_);
    const hsize_t size[] = {written_ + rows, width_}, start[] = {written_, 0},
                  count[] = {rows, width_};
    sound_ = H5Dset_extent(dataset_, size) >= 0;
    const Handle there{H5Dget_space(dataset_), H5Sclose};
    H5Sselect_hyperslab(there, H5S_SELECT_SET, start, nullptr, count, nullptr);
    const Handle here{H5Screate_simple(rank_, count, nullptr), H5Sclose};
    sound_ = sound_ && H5Dwrite(dataset_, type_, here, there, H5P_DEFAULT, kept_.data()) >= 0;
    written_ += rows;
    kept_.clear();
    return sound_;
  }
  bool sound() const { return sound_; }
  std::int64_t rows() const {
    return static_cast<std::int64_t>(written_ + kept_.size() / (rank_ == 1 ? 1 : width_));
  }

 protected:
  Table(hid_t file, const char* path, hsize_t width, const char* unit, const char* meaning,
        hid_t type)
      : width_{width}, rank_{width == 0 ? 1 : 2}, type_{type}, dataset_{made(file, path)} {
    attach(dataset_, "unit", std::string{unit});
    attach(dataset_, "meaning", std::string{meaning});
  }

 private:
  Handle made(hid_t file, const char* path) const {
    const hsize_t none[] = {0, width_}, any[] = {H5S_UNLIMITED, width_}, chunk[] = {kChunk, width_};
    const Handle space{H5Screate_simple(rank_, none, any), H5Sclose};
    const Handle layout{H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
    H5Pset_chunk(layout, rank_, chunk);
    H5Pset_shuffle(layout);
    H5Pset_deflate(layout, kDeflation);
    // no date in the file
    H5Pset_obj_track_times(layout, false);
    const Handle way{H5Pcreate(H5P_LINK_CREATE), H5Pclose};
    H5Pset_create_intermediate_group(way, 1);
    return {H5Dcreate2(file, path, type_, space, way, layout, H5P_DEFAULT), H5Dclose};
  }

  hsize_t width_;
  int rank_;
  hid_t type_;
  Handle dataset_;
  std::vector<T> kept_;
  hsize_t written_ = 0;
  bool sound_ = true;
};

}  // namespace app::exporting
