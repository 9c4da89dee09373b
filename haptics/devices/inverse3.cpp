// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/inverse3.h"

#include <libwebsockets.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "haptics/core/clock.h"

namespace haptics {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLook{300};  // for a survey, in all
constexpr std::chrono::seconds kOpening{1};      // for each step of opening
constexpr double kFurthest = 10.0;               // m: no arm is as long
constexpr std::size_t kMostDevices = 16;
constexpr std::size_t kLongestId = 32;
const std::string kName = "Haply Inverse3";

/// From the service's axes into B: x right, y forward, z up.
Mat3 R_BS() {
  Mat3 R;
  R << 1, 0, 0,  //
      0, 0, 1,   //
      0, -1, 0;
  return R;
}

const json* member(const json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

template <std::size_t N>
std::optional<std::array<double, N>> numbers(const json* object,
                                             const std::array<const char*, N>& keys) {
  if (object == nullptr) return std::nullopt;
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const json* const value = member(*object, keys[i]);
    if (value == nullptr || !value->is_number()) return std::nullopt;
    values[i] = value->get<double>();
    if (!(std::abs(values[i]) <= kFurthest)) return std::nullopt;
  }
  return values;
}

bool isId(const std::string& id) {
  return !id.empty() && id.size() <= kLongestId && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
           c == '_';
  });
}

/// False: not as it is known.
bool readStatus(const json& status, Inverse3State& state) {
  if (!status.is_object()) return false;
  state.tells_status = true;
  struct Flag {
    const char* key;
    Trouble trouble;
    Message why;
  };
  static const std::array kFlags{
      Flag{"power_supply", Trouble::NotStarted, {"inverse3-no-power", {}}},
      Flag{"started", Trouble::NotStarted, {"inverse3-not-ready", {}}},
      Flag{"ready", Trouble::NotStarted, {"inverse3-not-ready", {}}},
      Flag{"calibrated", Trouble::NeedsCalibration, {"inverse3-not-calibrated", {}}}};
  for (const Flag& flag : kFlags) {
    const json* const value = member(status, flag.key);
    if (value == nullptr) continue;
    if (!value->is_boolean()) return false;
    if (value->get<bool>() || state.trouble != Trouble::None) continue;
    state.trouble = flag.trouble;
    state.why = flag.why;
  }
  return true;
}

std::optional<Inverse3State> readDevice(const json& device) {
  Inverse3State read;
  const json* const id = member(device, "device_id");
  if (id == nullptr || !id->is_string()) return std::nullopt;
  read.id = id->get_ref<const std::string&>();
  if (!isId(read.id)) return std::nullopt;

  const json* const state = member(device, "state");
  if (state == nullptr) return std::nullopt;
  const auto cursor = numbers<3>(member(*state, "cursor_position"), {"x", "y", "z"});
  if (!cursor) return std::nullopt;
  read.p_BD = R_BS() * Vec3{(*cursor)[0], (*cursor)[1], (*cursor)[2]};

  if (const json* const status = member(device, "status"))
    if (!readStatus(*status, read)) return std::nullopt;
  if (const json* const config = member(device, "config"))
    if (const json* const basis = member(*config, "basis"))
      if (const json* const permutation = member(*basis, "permutation"))
        read.axes_are_ours = *permutation == "XYZ";
  return read;
}

/// Whether this grip tells its orientation. One that sleeps does not.
bool readGrip(const json& grip, Inverse3Message& message) {
  const json* const state = member(grip, "state");
  if (state == nullptr) return false;
  const auto q = numbers<4>(member(*state, "orientation"), {"w", "x", "y", "z"});
  if (!q) return false;
  const Quat rotation{(*q)[0], (*q)[1], (*q)[2], (*q)[3]};
  if (rotation.norm() < 0.5 || rotation.norm() > 2.0) return false;
  message.R_BD = R_BS() * rotation.normalized().toRotationMatrix() * R_BS().transpose();

  const auto isDown = [](const json* button) {
    return button != nullptr && button->is_boolean() && button->get<bool>();
  };
  message.buttons = isDown(member(*state, "button")) ? 1u : 0u;
  if (const json* const buttons = member(*state, "buttons")) {
    constexpr std::array kButtons{"a", "b", "c"};
    for (std::size_t n = 0; n < kButtons.size(); ++n)
      if (isDown(member(*buttons, kButtons[n]))) message.buttons |= 1u << n;
  }
  return true;
}

/// A WebSocket to the service. One thread at a time; nothing here waits longer than it is told.
class Link {
 public:
  explicit Link(std::uint16_t port) {
    static std::once_flag silent;
    std::call_once(silent, [] { lws_set_log_level(0, nullptr); });
    lws_context_creation_info creation{};
    creation.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
    creation.port = CONTEXT_PORT_NO_LISTEN;
    creation.protocols = kProtocols;
    creation.uid = creation.gid = static_cast<unsigned>(-1);
    creation.fd_limit_per_thread = 16;
    creation.user = this;
    context_ = lws_create_context(&creation);
    if (context_ == nullptr) return;
    lws_vhost* const vhost = lws_create_vhost(context_, &creation);
    if (vhost == nullptr) return;
    // what http_proxy says is for the net, not for this machine
    lws_set_proxy(vhost, ":0");

    const std::string host = "localhost:" + std::to_string(port);
    lws_client_connect_info connection{};
    connection.context = context_;
    connection.vhost = vhost;
    connection.address = "127.0.0.1";
    connection.port = port;
    connection.path = "/";
    connection.host = host.c_str();
    connection.ssl_connection = LCCSCF_HTTP_NO_FOLLOW_REDIRECT;
    connection.ietf_version_or_minus_one = -1;
    connection.local_protocol_name = kProtocols[0].name;
    connection.pwsi = &socket_;
    partial_.reserve(kInverse3LongestMessage);
    connecting_ = true;
    if (lws_client_connect_via_info(&connection) == nullptr) connecting_ = false;
  }
  ~Link() {
    if (context_ != nullptr) lws_context_destroy(context_);
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  bool isOpen() const { return open_; }
  bool isConnecting() const { return connecting_; }
  bool wasReached() const { return reached_; }

  /// Serves the connection until `done`, or it is closed, or it is time.
  template <class Done>
  bool serve(Clock::time_point end, Done&& done) {
    while (context_ != nullptr) {
      lws_service(context_, -1);
      if (done()) return true;
      if (!open_ && !connecting_) return false;
      const auto left = end - Clock::now();
      if (left <= Clock::duration::zero()) return false;
      // bytes that are here already, but not yet looked at
      if (lws_service_adjust_timeout(context_, 1, 0) == 0) continue;
      wait(std::chrono::duration_cast<std::chrono::nanoseconds>(left));
    }
    return false;
  }

  /// Serves until a whole message is there, that nobody has taken.
  std::optional<std::string_view> next(Clock::time_point end) {
    if (!serve(end, [this] { return arrived_; })) return std::nullopt;
    arrived_ = false;
    return message_;
  }

  /// Sends, and serves until all that was sent has its answer. The answer to this message, or
  /// nothing: it was late, or the connection is closed.
  std::optional<std::string_view> ask(std::string_view text, Clock::time_point end) {
    if (!open_ || text.size() > kLongestCommand) return std::nullopt;
    // an answer that was late answers nothing any more
    lws_service(context_, -1);
    arrived_ = false;
    if (!open_) return std::nullopt;
    std::memcpy(out_.data() + LWS_PRE, text.data(), text.size());
    to_send_ = text.size();
    lws_callback_on_writable(socket_);
    if (!serve(end, [this] { return arrived_ && to_send_ == 0 && unanswered_ == 0; }))
      return std::nullopt;
    arrived_ = false;
    return message_;
  }

 private:
  static constexpr std::size_t kLongestCommand = 512;
  static const lws_protocols kProtocols[];

  void wait(std::chrono::nanoseconds longest) {
    // while it connects the library has sockets of its own
    if (!open_) return std::this_thread::sleep_for(std::chrono::milliseconds{1});
    pollfd polled{lws_get_socket_fd(socket_), POLLIN, 0};
    if (to_send_ > 0) polled.events |= POLLOUT;
    const timespec time{longest.count() / 1'000'000'000, longest.count() % 1'000'000'000};
    ppoll(&polled, 1, &time, nullptr);
  }

  /// False: the connection is to be closed.
  bool receive(std::string_view part, bool first, bool last, bool binary) {
    if (first) partial_.clear();
    if (binary || partial_.size() + part.size() > kInverse3LongestMessage) return false;
    partial_.append(part);
    if (!last) return true;
    std::swap(message_, partial_);
    arrived_ = true;
    if (unanswered_ > 0) --unanswered_;
    lws_validity_confirmed(socket_);  // or the library would ask for a pong every five minutes
    return true;
  }

  bool send() {
    if (to_send_ == 0) return true;
    const auto length = static_cast<int>(std::exchange(to_send_, 0));
    ++unanswered_;
    return lws_write(socket_, out_.data() + LWS_PRE, static_cast<std::size_t>(length),
                     LWS_WRITE_TEXT) >= length;
  }

  void close() {
    open_ = connecting_ = false;
    socket_ = nullptr;
  }

  static int told(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t length) {
    auto* const self = static_cast<Link*>(lws_context_user(lws_get_context(socket)));
    switch (reason) {
      case LWS_CALLBACK_CLIENT_APPEND_HANDSHAKE_HEADER:
        self->reached_ = true;
        break;
      case LWS_CALLBACK_CLIENT_ESTABLISHED:
        self->open_ = true;
        self->connecting_ = false;
        break;
      case LWS_CALLBACK_CLIENT_RECEIVE:
        return self->receive({static_cast<const char*>(in), length},
                             lws_is_first_fragment(socket) != 0, lws_is_final_fragment(socket) != 0,
                             lws_frame_is_binary(socket) != 0)
                   ? 0
                   : -1;
      case LWS_CALLBACK_CLIENT_WRITEABLE:
        return self->send() ? 0 : -1;
      case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
      case LWS_CALLBACK_CLIENT_CLOSED:
        self->close();
        break;
      default:
        break;
    }
    return 0;
  }

  lws_context* context_ = nullptr;
  lws* socket_ = nullptr;
  bool connecting_ = false, open_ = false;
  bool reached_ = false;  ///< something listens
  std::array<unsigned char, LWS_PRE + kLongestCommand> out_{};
  std::size_t to_send_ = 0;
  int unanswered_ = 0;
  std::string partial_, message_;
  bool arrived_ = false;  ///< message_ is new
};

const lws_protocols Link::kProtocols[] = {{"palpate", &Link::told, 0, 8192, 0, nullptr, 0},
                                          {nullptr, nullptr, 0, 0, 0, nullptr, 0}};

class Inverse3 final : public Transport {
 public:
  Inverse3(std::unique_ptr<Link> link, const Inverse3State& device,
           std::chrono::milliseconds answer)
      : link_{std::move(link)}, id_{device.id}, trouble_{device.trouble}, answer_{answer} {}

  DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept override {
    return exchange(wrench_B, reading, answer_);
  }

  DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading,
                        std::chrono::milliseconds answer) noexcept {
    const auto text = link_->ask(inverse3Command(id_, wrench_B.force), Clock::now() + answer);
    if (!link_->isOpen()) {
      reading.trouble = Trouble::Lost;
      return DeviceStatus::Lost;
    }
    answered_ = text.has_value();
    if (!text) return DeviceStatus::Stale;
    const auto message = readInverse3(*text);
    if (!message) return DeviceStatus::Stale;
    const auto at = std::find_if(message->devices.begin(), message->devices.end(),
                                 [&](const Inverse3State& device) { return device.id == id_; });
    if (at == message->devices.end()) return DeviceStatus::Stale;

    if (at->tells_status) trouble_ = at->trouble;
    reading.X_BD.translation() = at->p_BD;
    if (message->R_BD) reading.X_BD.linear() = *message->R_BD;
    reading.buttons = message->buttons;
    reading.time_ns = monotonicNs();
    reading.trouble = trouble_;
    return trouble_ == Trouble::None ? DeviceStatus::Ok : DeviceStatus::NotReady;
  }

  bool answered() const { return answered_; }

 private:
  std::unique_ptr<Link> link_;
  const std::string id_;
  Trouble trouble_;  ///< by the last status told
  const std::chrono::milliseconds answer_;
  bool answered_ = false;  ///< the last exchange, understood or not
};

Error noService() { return refusal(Trouble::NoService, {"inverse3-no-service", {}}); }

Error notUnderstood() { return refusal(Trouble::Refused, {"inverse3-service-unknown", {}}); }

struct Greeted {
  std::unique_ptr<Link> link;
  Inverse3Message inventory;
};

Expected<Greeted> greet(std::uint16_t port, Clock::time_point end) {
  auto link = std::make_unique<Link>(port);
  if (!link->serve(end, [&] { return link->isOpen(); }))
    return tl::unexpected(link->wasReached() && !link->isConnecting() ? notUnderstood()
                                                                      : noService());
  const auto text = link->next(end);
  if (!text) return tl::unexpected(link->isOpen() ? noService() : notUnderstood());
  auto inventory = readInverse3(*text);
  if (!inventory) return tl::unexpected(notUnderstood());
  return Greeted{std::move(link), std::move(*inventory)};
}

Error notPluggedIn() { return refusal(Trouble::NotPluggedIn, {"inverse3-not-plugged-in", {}}); }

Error otherAxes(const Inverse3State& device) {
  return refusal(Trouble::Refused, {"inverse3-other-axes", {device.id}});
}

DeviceEntry entryOf(const Inverse3State& device, bool grip) {
  const DeviceRating& rating = *findRating("inverse3");
  DeviceEntry entry{.id = "inverse3:" + device.id,
                    .name = kName,
                    .sensed = grip ? 6 : rating.sensed,
                    .actuated = rating.actuated,
                    .present = true,
                    .trouble = device.trouble,
                    .why = device.why};
  if (!device.axes_are_ours) {
    entry.trouble = Trouble::Refused;
    entry.why = otherAxes(device).message;
  }
  return entry;
}

}  // namespace

std::optional<Inverse3Message> readInverse3(std::string_view text) {
  if (text.size() > kInverse3LongestMessage) return std::nullopt;
  const json read = json::parse(text, nullptr, false);
  const json* const devices = member(read, "inverse3");
  if (devices == nullptr || !devices->is_array() || devices->size() > kMostDevices)
    return std::nullopt;
  Inverse3Message message;
  for (const json& device : *devices) {
    auto state = readDevice(device);
    if (!state) return std::nullopt;
    message.devices.push_back(std::move(*state));
  }
  for (const char* const key : {"verse_grip", "wireless_verse_grip"}) {
    const json* const grips = member(read, key);
    if (grips == nullptr || !grips->is_array()) continue;
    for (const json& grip : *grips)
      if (readGrip(grip, message)) return message;
  }
  return message;
}

std::string inverse3Command(std::string_view id, const Vec3& force_B) {
  const Vec3 force_S = force_B.allFinite() ? Vec3{R_BS().transpose() * force_B} : Vec3::Zero();
  // the same in every language: a comma would be another number
  std::string text = R"({"inverse3":[{"device_id":")";
  text.append(id).append(R"(","commands":{"set_cursor_force":{"vector":{)");
  constexpr std::array kAxes{R"("x":)", R"(,"y":)", R"(,"z":)"};
  for (int axis = 0; axis < 3; ++axis) {
    std::array<char, 32> number;
    const auto end = std::to_chars(number.data(), number.data() + number.size(), force_S[axis]);
    text.append(kAxes[static_cast<std::size_t>(axis)]).append(number.data(), end.ptr);
  }
  return text.append("}}}}]}");
}

std::vector<DeviceEntry> surveyInverse3(const Inverse3Address& address) {
  const DeviceRating& rating = *findRating("inverse3");
  DeviceEntry none{
      .id = "inverse3", .name = kName, .sensed = rating.sensed, .actuated = rating.actuated};
  const auto greeted = greet(address.port, Clock::now() + kLook);
  if (!greeted) {
    const Error& error = greeted.error();
    none.trouble = error.reason == wordOf(Trouble::Refused) ? Trouble::Refused : Trouble::NoService;
    none.why = error.message;
    return {none};
  }
  if (greeted->inventory.devices.empty()) {
    none.trouble = Trouble::NotPluggedIn;
    none.why = notPluggedIn().message;
    return {none};
  }
  std::vector<DeviceEntry> entries;
  for (const Inverse3State& device : greeted->inventory.devices)
    entries.push_back(entryOf(device, greeted->inventory.R_BD.has_value()));
  return entries;
}

std::vector<DeviceEntry> surveyInverse3() { return surveyInverse3(Inverse3Address{}); }

Expected<std::unique_ptr<Device>> openInverse3(const OpenRequest& request,
                                               const Inverse3Address& address) {
  auto greeted = greet(address.port, Clock::now() + kOpening);
  if (!greeted) return tl::unexpected(greeted.error());
  const auto& devices = greeted->inventory.devices;
  const std::size_t colon = request.id.find(':');
  const auto device = std::find_if(devices.begin(), devices.end(), [&](const Inverse3State& state) {
    return colon == std::string::npos || state.id == request.id.substr(colon + 1);
  });
  if (device == devices.end()) return tl::unexpected(notPluggedIn());
  if (!device->axes_are_ours) return tl::unexpected(otherAxes(*device));

  // one exchange without force says whether it is spoken here as it is known
  auto transport = std::make_unique<Inverse3>(std::move(greeted->link), *device, address.answer);
  DeviceReading reading;
  const DeviceStatus tried = transport->exchange(Wrench{}, reading, kOpening);
  if (tried == DeviceStatus::Lost) return tl::unexpected(notUnderstood());
  if (tried == DeviceStatus::Stale)
    return tl::unexpected(transport->answered() ? notUnderstood() : noService());

  DeviceRating rating = *findRating("inverse3");
  if (greeted->inventory.R_BD) rating.sensed = 6;
  return threaded(std::move(transport), rating, 3 * address.answer);
}

Expected<std::unique_ptr<Device>> openInverse3(const OpenRequest& request) {
  return openInverse3(request, Inverse3Address{});
}

}  // namespace haptics
