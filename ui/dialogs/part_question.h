// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <array>
#include <cstdint>
#include <optional>

class QLabel;
class QPushButton;

namespace ui {

class NumberBox;

/// Required memory divided by the memory of the voxels. Picture and touch need memory too.
inline constexpr double kMemoryPerVoxel = 1.25;

/// A volume that may be larger than the memory.
struct LargeVolume {
  std::array<std::int64_t, 3> dims{};  ///< voxels, each at least 1
  std::int64_t bytes = 0;              ///< size of all voxels
  double free_bytes = 0.0;             ///< memory that may be used

  /// Size in bytes of a part with `count` voxels along the axes.
  double bytesOf(const std::array<std::int64_t, 3>& count) const;
  bool holds(double bytes_of_voxels) const {
    return bytes_of_voxels * kMemoryPerVoxel <= free_bytes;
  }
};

/// Which voxels to read: a box, or every n-th along each axis.
struct VoxelChoice {
  struct Box {
    std::array<std::int64_t, 3> first{}, end{};  ///< each axis from its first to one after its last
  };
  int step = 1;
  std::optional<Box> box = {};
};

/// Voxels along each axis when every `step`th is taken, from the first.
std::array<std::int64_t, 3> everyNth(const std::array<std::int64_t, 3>& dims, int step);

/// The smallest step from 2 to 20 with which the volume fits; empty if none does.
std::optional<int> stepThatFits(const LargeVolume& volume);

/// "2nd", "3rd", "4th", … for a step from 2 to 20, in the user's language.
QString ordinal(int step);

/// Asks for a box of voxels, counted from 1, and shows the memory it takes. At first it is the
/// middle half along each axis. A box that does not fit cannot be chosen.
class BoxDialog : public QDialog {
  Q_OBJECT
 public:
  explicit BoxDialog(const LargeVolume& volume, QWidget* parent = nullptr);
  VoxelChoice::Box box() const;

 private:
  void addAxis(std::size_t axis, const QString& name);
  void showSize();

  LargeVolume volume_;
  std::array<NumberBox*, 3> first_{}, last_{};
  QLabel* size_;
  QPushButton* read_ = nullptr;
};

/// Asks which part to read of a volume that is larger than the memory. `sentence` is the message.
/// Enter means Cancel. Nullopt if the user cancels.
std::optional<VoxelChoice> askForPart(QWidget* parent, const QString& sentence,
                                      const LargeVolume& volume);

}  // namespace ui
