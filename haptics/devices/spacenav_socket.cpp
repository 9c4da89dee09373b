// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/spacenav_socket.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace haptics {
namespace {

// types of events; what is greater than kRawButton does not exist
constexpr std::int32_t kMotion = 0, kPress = 1, kRelease = 2, kRawButton = 6;
constexpr std::int32_t kReply = 0x7faa;  // upper half of the type of what answers a request
constexpr std::int32_t kButtons = 32;
constexpr std::string_view kName = "SpaceMouse through spacenavd";

/// A socket, closed with its owner.
class Socket {
 public:
  explicit Socket(int number) : number_{number} {}
  Socket(Socket&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
  Socket& operator=(Socket&&) = delete;
  ~Socket() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const noexcept { return number_; }

 private:
  int number_;
};

/// Three values along the axes of B: the service's third axis points away from the user.
Vec3 inBase(const SpacenavEvent& event, std::size_t first) noexcept {
  return {static_cast<double>(event[first]), static_cast<double>(event[first + 1]),
          -static_cast<double>(event[first + 2])};
}

class Spacenav final : public Device {
 public:
  Spacenav(Socket socket, MonotonicClock clock) : socket_{std::move(socket)}, clock_{clock} {}

  const DeviceRating& rating() const noexcept override { return rating_; }

  DeviceStatus read(DeviceReading& reading) noexcept override {
    const std::int64_t now = clock_();
    for (int i = 0; i < kMostReads && trouble_ == Trouble::None; ++i)
      if (!take(now)) break;
    if (trouble_ != Trouble::None) {
      control_.rest();
      buttons_ = 0;
    }
    reading.X_BD = control_.step(now);
    reading.buttons = buttons_;
    reading.time_ns = now;
    reading.trouble = trouble_;
    return trouble_ == Trouble::None ? DeviceStatus::Ok : DeviceStatus::Lost;
  }
  DeviceStatus write(const Wrench&) noexcept override { return DeviceStatus::Ok; }
  void stop() noexcept override {}
  void resume() noexcept override {}

 private:
  static constexpr int kMostReads = 4;
  static constexpr std::size_t kBytes = 32 * sizeof(SpacenavEvent);  // a read

  /// What has come; false: there is no more.
  bool take(std::int64_t now) noexcept {
    const ssize_t count = ::recv(socket_.number(), bytes_.data(), bytes_.size(), MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return false;
    if (count <= 0) {
      trouble_ = Trouble::Lost;
      return false;
    }
    std::span<const std::uint8_t> bytes = std::span{bytes_}.first(static_cast<std::size_t>(count));
    while (const auto event = stream_.take(bytes))
      if (applySpacenav(*event, now, control_, buttons_) == SpacenavStep::Refused) {
        trouble_ = Trouble::Refused;
        return false;
      }
    return static_cast<std::size_t>(count) == bytes_.size();
  }

  const DeviceRating rating_ = *findRating("spacemouse");
  Socket socket_;
  const MonotonicClock clock_;
  std::array<std::uint8_t, kBytes> bytes_{};
  SpacenavStream stream_;
  RateControl control_;
  std::uint32_t buttons_ = 0;
  Trouble trouble_ = Trouble::None;
};

/// A connection to the service, which costs it nothing if it is closed again.
Expected<Socket> connected(const std::string& place) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const Error silent = refusal(Trouble::NoService, {"spacenav-no-answer", {place}});
  if (place.size() >= sizeof(address.sun_path)) return tl::unexpected(silent);
  std::memcpy(address.sun_path, place.data(), place.size());
  Socket socket{::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  if (::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0)
    return socket;
  if (errno == EACCES || errno == EPERM)
    return tl::unexpected(refusal(Trouble::NoPermission, {"spacenav-not-permitted", {place}}));
  return tl::unexpected(silent);
}

}  // namespace

std::optional<SpacenavEvent> SpacenavStream::take(std::span<const std::uint8_t>& bytes) noexcept {
  const std::size_t count = std::min(bytes.size(), part_.size() - have_);
  std::copy_n(bytes.begin(), count, part_.begin() + static_cast<std::ptrdiff_t>(have_));
  bytes = bytes.subspan(count);
  have_ += count;
  if (have_ < part_.size()) return std::nullopt;
  have_ = 0;
  SpacenavEvent event;
  std::memcpy(event.data(), part_.data(), part_.size());
  return event;
}

SpacenavStep applySpacenav(const SpacenavEvent& event, std::int64_t now_ns, RateControl& control,
                           std::uint32_t& buttons) noexcept {
  const std::int32_t type = event[0];
  if (type == kMotion) {
    control.shift(inBase(event, 1), now_ns);
    control.turn(inBase(event, 4), now_ns);
    return SpacenavStep::Taken;
  }
  if (type == kPress || type == kRelease) {
    const std::int32_t number = event[1];
    if (number < 0 || number >= kButtons) return SpacenavStep::PassedOver;
    const std::uint32_t bit = std::uint32_t{1} << number;
    buttons = type == kPress ? buttons | bit : buttons & ~bit;
    return SpacenavStep::Taken;
  }
  const bool known = (type > kRelease && type <= kRawButton) || type >> 16 == kReply;
  return known ? SpacenavStep::PassedOver : SpacenavStep::Refused;
}

std::string spacenavPlace() {
  const char* const place = std::getenv("SPNAV_SOCKET");
  return place != nullptr && *place != '\0' ? place : "/var/run/spnav.sock";
}

Expected<std::unique_ptr<Device>> spacenavAt(const std::string& place, MonotonicClock clock) {
  auto socket = connected(place);
  if (!socket) return tl::unexpected(socket.error());
  return std::make_unique<Spacenav>(std::move(*socket), clock);
}

std::vector<DeviceEntry> surveySpacenav() {
  DeviceEntry entry{"spacenav", std::string{kName}, 6, 0, true, Trouble::None};
  const auto socket = connected(spacenavPlace());
  if (!socket) {
    // refused by permission alone, the service is there
    entry.present = socket.error().reason == wordOf(Trouble::NoPermission);
    entry.trouble = entry.present ? Trouble::NoPermission : Trouble::NoService;
    entry.why = socket.error().message;
  }
  return {std::move(entry)};
}

Expected<std::unique_ptr<Device>> openSpacenav(const OpenRequest&) {
  return spacenavAt(spacenavPlace());
}

}  // namespace haptics
