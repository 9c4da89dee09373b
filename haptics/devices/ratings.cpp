// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/ratings.h"

#include <array>

namespace haptics {
namespace {
constexpr std::array kRatings{
    DeviceRating{"falcon", 8.0, 0.0, 3000.0, 0.04},
    DeviceRating{"delta.3", 20.0, 0.0, 5000.0, 0.15},
    DeviceRating{"omega.3", 12.0, 0.0, 5000.0, 0.075},
    DeviceRating{"omega.6", 12.0, 0.0, 5000.0, 0.075},
    DeviceRating{"omega.7", 12.0, 0.0, 5000.0, 0.075},
    DeviceRating{"sigma.7", 12.0, 0.2, 4000.0, 0.075},
    DeviceRating{"lambda.7", 12.0, 0.2, 8000.0, 0.1125},
    DeviceRating{"touch", 3.3, 0.0, 400.0, 0.075},
    DeviceRating{"omni", 3.3, 0.0, 700.0, 0.10},
    DeviceRating{"desktop", 7.9, 0.0, 1000.0, 0.10},
    DeviceRating{"premium-1.5", 8.5, 0.188, 800.0, 0.12},
    DeviceRating{"premium-3.0", 22.0, 0.188, 1000.0, 0.25},
    DeviceRating{"inverse3", 10.0, 0.0, 1000.0, 0.10},
    DeviceRating{"polhem", 5.0, 0.0, 2000.0, 0.15},
    DeviceRating{"woodenhaptics", 5.0, 0.0, 1000.0, 0.10},
};
}  // namespace

std::span<const DeviceRating> deviceRatings() { return kRatings; }

const DeviceRating* findRating(std::string_view name) {
  for (const DeviceRating& rating : kRatings)
    if (rating.name == name) return &rating;
  return nullptr;
}

}  // namespace haptics
