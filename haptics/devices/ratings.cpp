// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/ratings.h"

#include <array>

namespace haptics {
namespace {
constexpr std::array kRatings{
    DeviceRating{"falcon", 8.0, 0.0, 3000.0, 0.04, 20.0},
    DeviceRating{"delta.3", 20.0, 0.0, 5000.0, 0.15, 30.0},
    DeviceRating{"omega.3", 12.0, 0.0, 5000.0, 0.075, 30.0},
    DeviceRating{"omega.6", 12.0, 0.0, 5000.0, 0.075, 30.0},
    DeviceRating{"omega.7", 12.0, 0.0, 5000.0, 0.075, 30.0},
    DeviceRating{"sigma.7", 12.0, 0.2, 4000.0, 0.075, 30.0},
    DeviceRating{"lambda.7", 12.0, 0.2, 8000.0, 0.1125, 30.0},
    DeviceRating{"touch", 3.3, 0.0, 400.0, 0.075, 4.0},
    DeviceRating{"omni", 3.3, 0.0, 700.0, 0.10, 5.0},
    DeviceRating{"desktop", 7.9, 0.0, 1000.0, 0.10, 5.0},
    DeviceRating{"premium-1.5", 8.5, 0.188, 800.0, 0.12, 5.0},
    DeviceRating{"premium-3.0", 22.0, 0.188, 1000.0, 0.25, 5.0},
    DeviceRating{"inverse3", 10.0, 0.0, 1000.0, 0.10, 6.0},
    DeviceRating{"polhem", 5.0, 0.0, 2000.0, 0.15, 1.0},
    DeviceRating{"woodenhaptics", 5.0, 0.0, 1000.0, 0.10, 8.0},
};
}  // namespace

std::span<const DeviceRating> deviceRatings() { return kRatings; }

const DeviceRating* findRating(std::string_view name) {
  for (const DeviceRating& rating : kRatings)
    if (rating.name == name) return &rating;
  return nullptr;
}

}  // namespace haptics
