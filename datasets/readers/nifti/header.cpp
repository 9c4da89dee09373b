// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/readers/nifti/header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "datasets/readers/files/file_geometry.h"
#include "datasets/readers/files/header_words.h"
#include "datasets/readers/files/refusal.h"

namespace datasets {

namespace fs = std::filesystem;
using haptics::Expected;
using haptics::Mat3;
using haptics::ScalarType;
using haptics::Vec3;

namespace {

constexpr std::string_view kGzip = "\x1f\x8b";          // how a compressed file begins
constexpr std::int64_t kHeader1 = 348, kHeader2 = 540;  // bytes
constexpr std::int64_t kFirstVoxel1 = 352, kFirstVoxel2 = 544;

/// The fields that matter, of either version.
struct Fields {
  std::array<std::int64_t, 8> dim{};
  std::array<double, 8> pixdim{};
  int datatype = 0, bits = 0;
  double first_voxel = 0.0, slope = 0.0, intercept = 0.0;  // first_voxel: bytes
  int quaternion_code = 0, matrix_code = 0, units = 0;
  std::array<double, 3> quaternion{}, offset{};
  std::array<double, 12> matrix{};  ///< by rows
  bool swapped = false;
  bool deflated = false;          ///< the file is a gzip file
  std::int64_t least_offset = 0;  ///< bytes
};

/// Numbers at places of the header, in its byte order.
class NiftiHeader {
 public:
  NiftiHeader(const std::array<char, kHeader2>& bytes, bool swapped)
      : bytes_(bytes), swapped_(swapped) {}
  template <class T>
  T at(std::size_t place) const {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + place, sizeof raw);
    if (swapped_) std::reverse(raw, raw + sizeof raw);
    T value;
    std::memcpy(&value, raw, sizeof value);
    return value;
  }
  template <class T, class Out, std::size_t N>
  void fill(std::array<Out, N>& out, std::size_t place) const {
    for (std::size_t i = 0; i < N; ++i) out[i] = static_cast<Out>(at<T>(place + i * sizeof(T)));
  }

 private:
  const std::array<char, kHeader2>& bytes_;
  bool swapped_;
};

Fields version1(const NiftiHeader& b) {
  Fields f;
  b.fill<std::int16_t>(f.dim, 40);
  f.datatype = b.at<std::int16_t>(70);
  f.bits = b.at<std::int16_t>(72);
  b.fill<float>(f.pixdim, 76);
  f.first_voxel = b.at<float>(108);
  f.slope = b.at<float>(112);
  f.intercept = b.at<float>(116);
  f.units = b.at<std::uint8_t>(123);
  f.quaternion_code = b.at<std::int16_t>(252);
  f.matrix_code = b.at<std::int16_t>(254);
  b.fill<float>(f.quaternion, 256);
  b.fill<float>(f.offset, 268);
  b.fill<float>(f.matrix, 280);
  f.least_offset = kFirstVoxel1;
  return f;
}

Fields version2(const NiftiHeader& b) {
  Fields f;
  f.datatype = b.at<std::int16_t>(12);
  f.bits = b.at<std::int16_t>(14);
  b.fill<std::int64_t>(f.dim, 16);
  b.fill<double>(f.pixdim, 104);
  f.first_voxel = static_cast<double>(b.at<std::int64_t>(168));
  f.slope = b.at<double>(176);
  f.intercept = b.at<double>(184);
  f.quaternion_code = b.at<std::int32_t>(344);
  f.matrix_code = b.at<std::int32_t>(348);
  b.fill<double>(f.quaternion, 352);
  b.fill<double>(f.offset, 376);
  b.fill<double>(f.matrix, 400);
  f.units = b.at<std::int32_t>(500);
  f.least_offset = kFirstVoxel2;
  return f;
}

std::optional<Fields> fieldsOf(const std::array<char, kHeader2>& bytes) {
  for (const bool swapped : {false, true}) {
    const NiftiHeader b(bytes, swapped);
    const auto size = b.at<std::int32_t>(0);
    std::optional<Fields> fields;
    if (size == kHeader1 && std::memcmp(bytes.data() + 344, "n+1", 4) == 0) fields = version1(b);
    if (size == kHeader2 && std::memcmp(bytes.data() + 4, "n+2", 4) == 0) fields = version2(b);
    if (!fields) continue;
    fields->swapped = swapped;
    return fields;
  }
  return {};
}

std::optional<Fields> readFields(const fs::path& path, bool deflated) {
  const auto stream = openBytes(path, 0, deflated);
  std::array<char, kHeader2> bytes{};
  // the shorter header may be all there is
  if (!stream->read(bytes.data(), kHeader1)) return {};
  static_cast<void>(stream->read(bytes.data() + kHeader1, kHeader2 - kHeader1));
  auto fields = fieldsOf(bytes);
  if (fields) fields->deflated = deflated;
  return fields;
}

struct DataType {
  int code, bits;
  ScalarType type;
  bool is_double;
};

constexpr DataType kNiftiTypes[] = {
    {2, 8, ScalarType::UInt8, false},     {4, 16, ScalarType::Int16, false},
    {8, 32, ScalarType::Int32, false},    {16, 32, ScalarType::Float32, false},
    {64, 64, ScalarType::Float32, true},  {256, 8, ScalarType::Int8, false},
    {512, 16, ScalarType::UInt16, false}, {768, 32, ScalarType::UInt32, false}};

Expected<void> readNiftiType(const fs::path& path, const Fields& fields, StoredVolumes& stored) {
  for (const DataType& known : kNiftiTypes)
    if (fields.datatype == known.code) {
      // some writers leave it at 0
      if (fields.bits != 0 && fields.bits != known.bits) return wrongField(path, "bitpix");
      stored.voxels.layout.type = known.type;
      stored.voxels.layout.doubles = known.is_double;
      stored.voxels.layout.swapped = fields.swapped && known.bits > 8;
      return {};
    }
  const bool composed = fields.datatype == 32 || fields.datatype == 128 ||
                        fields.datatype == 1792 || fields.datatype == 2304;
  if (composed) return unsupported("not-scalar", {"volume-colours-or-vectors", {quoted(path)}});
  return unsupported("unsupported-type", {"volume-type-unsupported", {quoted(path)}});
}

Expected<void> readNiftiSizes(const fs::path& path, const Fields& fields, StoredVolumes& stored) {
  const std::int64_t axes = fields.dim[0];
  if (axes < 1 || axes > 7) return wrongField(path, "dim");
  if (axes < 3)
    return unsupported("not-scalar", {"volume-axis-count", {quoted(path), std::to_string(axes)}});
  for (std::size_t a = 4; a < static_cast<std::size_t>(axes); ++a)
    if (fields.dim[a + 1] != 1)
      return unsupported("not-scalar", {"volume-colours-or-vectors", {quoted(path)}});
  for (std::size_t a = 0; a < static_cast<std::size_t>(std::min<std::int64_t>(axes, 4)); ++a)
    stored.voxels.layout.sizes[a] = fields.dim[a + 1];
  return {};
}

Expected<void> readNiftiPlace(const fs::path& path, const Fields& fields, StoredVolumes& stored) {
  // some writers leave it at 0
  const double first =
      fields.first_voxel == 0.0 ? static_cast<double>(fields.least_offset) : fields.first_voxel;
  if (!(first >= static_cast<double>(fields.least_offset)) || first > 1e15 ||
      std::floor(first) != first)
    return wrongField(path, "vox_offset");
  stored.voxels.file = path;
  stored.voxels.deflated = fields.deflated;
  (stored.voxels.deflated ? stored.voxels.skip : stored.voxels.offset) =
      static_cast<std::int64_t>(first);
  return checkStored(stored.voxels, path);
}

/// Millimetres in the unit of the axes; unstated: millimetres.
std::optional<double> millimetresIn(int units) {
  switch (units & 7) {
    case 0:
    case 2:
      return 1.0;
    case 1:
      return 1e3;
    case 3:
      return 1e-3;
    default:
      return {};
  }
}

/// Steps and origin, in the unit of the file.
struct Affine {
  Mat3 steps;
  Vec3 origin;
};

std::optional<Affine> byQuaternion(const Fields& fields) {
  const Vec3 v(fields.quaternion[0], fields.quaternion[1], fields.quaternion[2]);
  const double rest = 1.0 - v.squaredNorm();
  if (!(rest > -1e-4)) return {};
  const Eigen::Quaterniond q(std::sqrt(std::max(rest, 0.0)), v.x(), v.y(), v.z());
  const double mirror = fields.pixdim[0] < 0.0 ? -1.0 : 1.0;
  const Vec3 spacing(fields.pixdim[1], fields.pixdim[2], mirror * fields.pixdim[3]);
  return Affine{q.normalized().toRotationMatrix() * spacing.asDiagonal(),
                {fields.offset[0], fields.offset[1], fields.offset[2]}};
}

Affine byMatrix(const Fields& fields) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> rows(fields.matrix.data());
  return {rows.leftCols<3>(), rows.col(3)};
}

/// Axes that point nearly alike, in equal steps: a scan that was aligned with another keeps the
/// scanner's orientation in its qform and has the aligned one in its sform. Which side is which is
/// then the same in both.
bool agree(const Affine& a, const Affine& b) {
  constexpr double kAngle = 20.0 * std::numbers::pi / 180.0, kStep = 1e-3;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 u = a.steps.col(axis), v = b.steps.col(axis);
    const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
    if (!(angle <= kAngle) || !(std::abs(u.norm() - v.norm()) <= kStep * v.norm())) return false;
  }
  return true;
}

/// The sform before the qform, unless its axes are not at right angles and the qform's are: then
/// that is used, and noted.
Expected<Affine> affineOf(const fs::path& path, const Fields& fields,
                          std::vector<haptics::Message>& notes) {
  const auto turned = byQuaternion(fields);
  const Affine placed = byMatrix(fields);
  const bool by_quaternion = fields.quaternion_code > 0, by_matrix = fields.matrix_code > 0;
  if (by_quaternion && !turned) return wrongField(path, "quatern");
  constexpr double kLeastStep = 1e-9;  // of the file's unit
  const bool places = placed.steps.allFinite() && placed.origin.allFinite() &&
                      placed.steps.colwise().norm().minCoeff() > kLeastStep;
  if (by_quaternion && by_matrix && !places) {
    notes.push_back({"nifti-sform-senseless", {}});
    return *turned;
  }
  if (by_quaternion && by_matrix && !agree(*turned, placed))
    return unsupported("ambiguous-orientation", {"nifti-orientation-ambiguous", {quoted(path)}});
  if (by_matrix && by_quaternion && !isSquareEnough(placed.steps)) {
    notes.push_back({"nifti-qform-used", {brief(shear_deg(placed.steps))}});
    return *turned;
  }
  if (by_matrix) return placed;
  if (by_quaternion) return *turned;
  Affine plain{Mat3::Zero(), Vec3::Zero()};
  for (int axis = 0; axis < 3; ++axis) {
    const double step = fields.pixdim[static_cast<std::size_t>(axis) + 1];
    plain.steps(axis, axis) = step == 0.0 ? 1.0 : step;
  }
  return plain;
}

Expected<void> readNiftiGeometry(const fs::path& path, const Fields& fields,
                                 StoredVolumes& stored) {
  const auto unit = millimetresIn(fields.units);
  if (!unit) return malformed("bad-header", {"header-unit-unknown", {quoted(path)}});
  FileGeometry geometry;
  geometry.dims = stored.voxels.layout.dims();
  const auto affine = affineOf(path, fields, stored.notes);
  if (!affine) return tl::unexpected(affine.error());
  const bool placed = fields.quaternion_code > 0 || fields.matrix_code > 0;
  const auto steps = std::span(fields.pixdim).subspan(1, 3);
  if (fields.matrix_code <= 0 && std::ranges::any_of(steps, [](double p) { return p < 0.0; }))
    return wrongField(path, "pixdim");
  stored.spacing_stated = placed || std::ranges::none_of(steps, [](double p) { return p == 0.0; });
  geometry.steps_mm = *unit * affine->steps;
  geometry.origin_mm = *unit * affine->origin;
  geometry.space = placed ? FileSpace::RightAnteriorSuperior : FileSpace::Unknown;
  stored.facts.orientation_known = placed;
  return place(stored, geometry);
}

Expected<void> readNiftiValues(const fs::path& path, const Fields& fields, StoredVolumes& stored) {
  // a slope of 0, or of none, says that nothing is to be rescaled
  if (!std::isfinite(fields.slope) || fields.slope == 0.0) return {};
  if (!std::isfinite(fields.intercept)) return wrongField(path, "scl_inter");
  stored.slope = fields.slope;
  stored.intercept = fields.intercept;
  return {};
}

}  // namespace

bool looksLikeNifti(const Beginning& file) {
  const std::string name = lowered(file.path.filename().string());
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return true;
  if (file.bytes.starts_with(kGzip)) return readFields(file.path, true).has_value();
  // the marks of both versions
  return file.bytes.size() >= std::size_t{kHeader1} &&
         (file.bytes.compare(344, 4, std::string("n+1\0", 4)) == 0 ||
          file.bytes.compare(4, 4, std::string("n+2\0", 4)) == 0);
}

Expected<StoredVolumes> describeNifti(const fs::path& path) {
  const Beginning beginning(path);
  if (!beginning.is_open) return notFound(path);
  const auto fields = readFields(path, beginning.bytes.starts_with(kGzip));
  if (!fields) return malformed("bad-header", {"header-unreadable", {quoted(path)}});
  StoredVolumes stored;
  for (const auto step :
       {readNiftiType, readNiftiSizes, readNiftiPlace, readNiftiGeometry, readNiftiValues})
    if (auto done = step(path, *fields, stored); !done)
      return tl::unexpected(std::move(done.error()));
  return stored;
}

}  // namespace datasets
