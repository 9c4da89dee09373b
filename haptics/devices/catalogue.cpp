// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/catalogue.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "haptics/devices/falcon.h"
#include "haptics/devices/force_dimension.h"
#include "haptics/devices/inverse3.h"
#include "haptics/devices/open_haptics.h"
#include "haptics/devices/polhem.h"
#include "haptics/devices/space_mouse.h"
#include "haptics/devices/spacenav_socket.h"
#include "haptics/devices/wooden_haptics.h"

namespace haptics {
namespace {

// one line a driver
constexpr std::array kDrivers{
    Driver{"spacenav", surveySpacenav, openSpacenav},
    Driver{"spacemouse", surveySpaceMice, openSpaceMouse},
    Driver{"falcon", surveyFalcon, openFalcon},
    Driver{"inverse3", surveyInverse3, openInverse3},
    Driver{"polhem", surveyPolhem, openPolhem},
    Driver{"woodenhaptics", surveyWoodenHaptics, openWoodenHaptics},
    Driver{"force-dimension", surveyForceDimension, openForceDimension},
    Driver{"openhaptics", surveyOpenHaptics, openOpenHaptics},
};

}  // namespace

std::span<const Driver> drivers() { return kDrivers; }

std::vector<DeviceEntry> surveyDevices() {
  std::vector<DeviceEntry> entries;
  for (const Driver& driver : drivers()) {
    std::vector<DeviceEntry> found = driver.survey();
    entries.insert(entries.end(), std::move_iterator{found.begin()},
                   std::move_iterator{found.end()});
  }
  return entries;
}

const DeviceRating* ratingOf(const DeviceEntry& entry) {
  const std::string_view id = entry.id;
  const std::size_t colon = std::min(id.find(':'), id.size());
  if (const DeviceRating* rating = findRating(id)) return rating;
  if (const DeviceRating* rating = findRating(id.substr(std::min(colon + 1, id.size()))))
    return rating;
  for (const DeviceRating& rating : deviceRatings())
    if (rating.name == entry.name) return &rating;
  return findRating(id.substr(0, colon));
}

Expected<std::unique_ptr<Device>> openDevice(const OpenRequest& request) {
  const std::string_view name = std::string_view{request.id}.substr(0, request.id.find(':'));
  for (const Driver& driver : drivers())
    if (driver.name == name) return driver.open(request);
  return tl::unexpected(
      Error{Error::Kind::NotFound, {"device-unknown", {request.id}}, "unknown-device"});
}

Error refusal(Trouble trouble, Message message) {
  return {trouble == Trouble::NotPluggedIn ? Error::Kind::NotFound : Error::Kind::Unsupported,
          std::move(message), std::string{wordOf(trouble)}};
}

}  // namespace haptics
