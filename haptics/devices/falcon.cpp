// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/falcon.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <optional>
#include <thread>
#include <utility>

#include "haptics/devices/falcon_kinematics.h"
#include "haptics/devices/falcon_packets.h"

namespace haptics {
namespace falcon {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using Bytes = std::span<const std::uint8_t>;

// one less than the longest exchange, because waiting is rounded up to whole milliseconds
constexpr milliseconds kReplyWait = Transport::kLongestWait - milliseconds{1};
// older readings count as missing; an exchange takes one to five milliseconds
constexpr milliseconds kFresh{12};
// four times what the greatest file takes at 14 kB/s
constexpr milliseconds kLongestLoad{80'000};

// the chip's requests
constexpr std::uint8_t kReset = 0, kModem = 1, kFlow = 2, kBaud = 3, kLine = 4, kLatency = 9;
constexpr std::uint16_t kPurgeReceived = 1, kPurgeToSend = 2;
constexpr std::uint16_t kDtrLow = 0x0100, kDtrHigh = 0x0101, kRtsLow = 0x0200;
constexpr std::uint16_t kBaud9600 = 0x4138, kBaud140000 = 0x15, kBaud1400000 = 2;

struct Request {
  std::uint8_t request;
  std::uint16_t value;
};

bool requestAll(FalconPort& port, std::initializer_list<Request> requests) {
  return std::all_of(requests.begin(), requests.end(),
                     [&](const Request& r) { return port.request(r.request, r.value); });
}

bool enterNormalMode(FalconPort& port) {
  return requestAll(
      port,
      {{kLatency, 1}, {kBaud, kBaud1400000}, {kReset, kPurgeReceived}, {kReset, kPurgeToSend}});
}

/// What came of one step of opening.
enum class Step { Done, Failed, Gone };

/// Hands the bytes over; a tenth of a second for those before.
Step say(FalconPort& port, Bytes bytes) {
  const std::int64_t end = port.now() + nanoseconds{milliseconds{100}}.count();
  std::array<std::uint8_t, kUsbPacket> ignored;
  for (;;) {
    const Sent sent = port.send(bytes);
    if (sent == Sent::Taken) return Step::Done;
    if (sent == Sent::Gone) return Step::Gone;
    if (port.now() >= end) return Step::Failed;
    if (!port.receive(ignored, milliseconds{1})) return Step::Gone;
  }
}

/// Whether exactly these bytes come within `wait`; zeros before them are passed over if `lenient`.
Step hear(FalconPort& port, Bytes expected, milliseconds wait, bool lenient) {
  const std::int64_t end = port.now() + nanoseconds{wait}.count();
  std::array<std::uint8_t, kUsbPacket> transfer;
  std::size_t heard = 0;
  while (heard < expected.size()) {
    const std::int64_t left = end - port.now();
    if (left <= 0) return Step::Failed;
    const auto length = port.receive(transfer, nanoseconds{left});
    if (!length) return Step::Gone;
    for (const std::uint8_t byte : withoutStatus(Bytes{transfer}.first(*length))) {
      if (lenient && heard == 0 && byte == 0) continue;
      if (heard == expected.size() || byte != expected[heard]) return Step::Failed;
      ++heard;
    }
  }
  return Step::Done;
}

/// Throws away what has come.
void drop(FalconPort& port) {
  std::array<std::uint8_t, kUsbPacket> ignored;
  for (int i = 0; i < 64 && port.receive(ignored, nanoseconds{0}).value_or(0) > 0; ++i) {
  }
}

/// Whether firmware answers a packet of zeros.
Step probe(FalconPort& port) {
  if (!enterNormalMode(port)) return Step::Gone;
  const Packet nothing = encoded({.homing = true, .red = true});
  std::array<std::uint8_t, kUsbPacket> transfer;
  ReplyStream stream;
  Reply reply;
  for (int i = 0; i < 10; ++i) {
    if (say(port, nothing) == Step::Gone) return Step::Gone;
    const std::int64_t end = port.now() + nanoseconds{milliseconds{20}}.count();
    for (std::int64_t left = end - port.now(); left > 0; left = end - port.now()) {
      const auto length = port.receive(transfer, nanoseconds{left});
      if (!length) return Step::Gone;
      if (stream.take(Bytes{transfer}.first(*length), reply) > 0) return Step::Done;
    }
  }
  return Step::Failed;
}

/// Why loading ended.
enum class Load { Done, NoHandshake, WrongEcho, Gone };

/// One try. The chip's lines start the device anew; it then echoes every byte that it takes.
Load load(FalconPort& port, Bytes firmware) {
  if (!requestAll(port, {{kReset, kPurgeReceived},
                         {kReset, kPurgeToSend},
                         {kLatency, 16},
                         {kBaud, kBaud9600},
                         {kLine, 8},
                         {kFlow, 0},
                         {kModem, kRtsLow},
                         {kModem, kDtrLow},
                         {kModem, kDtrHigh}}))
    return Load::Gone;
  constexpr std::array<std::uint8_t, 3> kHello{0x0a, 0x43, 0x0d};
  constexpr std::array<std::uint8_t, 4> kHelloBack{0x0a, 0x44, 0x2c, 0x0d};
  constexpr std::array<std::uint8_t, 1> kBegin{0x41};
  Step step = Step::Failed;
  for (int i = 0; i < 100 && step == Step::Failed; ++i) {
    drop(port);
    step = say(port, kHello);
    if (step == Step::Done) step = hear(port, kHelloBack, milliseconds{32}, true);
  }
  if (step != Step::Done) return step == Step::Gone ? Load::Gone : Load::NoHandshake;

  if (!requestAll(port, {{kModem, kDtrLow}, {kBaud, kBaud140000}})) return Load::Gone;
  drop(port);
  step = say(port, kBegin);
  if (step == Step::Done) step = hear(port, kBegin, milliseconds{500}, true);
  if (step != Step::Done) return step == Step::Gone ? Load::Gone : Load::NoHandshake;

  constexpr std::size_t kChunk = 62;  // its echo and the status fill one USB packet
  const std::int64_t end = port.now() + nanoseconds{kLongestLoad}.count();
  while (!firmware.empty()) {
    if (port.now() > end) return Load::WrongEcho;
    const Bytes chunk = firmware.first(std::min(kChunk, firmware.size()));
    step = say(port, chunk);
    if (step == Step::Done) step = hear(port, chunk, milliseconds{500}, false);
    if (step != Step::Done) return step == Step::Gone ? Load::Gone : Load::WrongEcho;
    firmware = firmware.subspan(chunk.size());
  }
  return Load::Done;
}

/// The link to a Falcon whose firmware runs.
class Link final : public Transport {
 public:
  explicit Link(std::unique_ptr<FalconPort> port) : port_{std::move(port)} {}
  ~Link() override {
    // zeros, until the device has confirmed some
    const Packet zeros = encoded({.homing = true});
    for (int i = 0; i < 3; ++i) {
      stream_.clear();
      drop(*port_);
      const Sent sent = port_->send(zeros);
      if (sent == Sent::Gone) return;
      const auto replies = listen(milliseconds{20}, 1);
      if (sent == Sent::Taken && (!replies || *replies > 0)) return;
      // what is under way goes out meanwhile
      if (!replies) std::this_thread::sleep_for(milliseconds{5});
    }
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  DeviceStatus exchange(const Wrench& wrench_B, DeviceReading& reading) noexcept override {
    const bool trusted = std::exchange(trusted_, false);
    // what came too late, or twice, is not the answer to what is asked now
    const auto late = listen(nanoseconds{0}, 0);
    if (!late) {
      port_->send(encoded({.homing = true}));  // it may yet be told to let go
      return lost(reading);
    }

    const Command command{
        .motors = trusted ? motorsFor(torquesFor(legs_, wrench_B.force)) : Motors{},
        .homing = true,
        .red = !homed_,
        .blue = homed_};
    const Sent sent = port_->send(encoded(command));
    if (sent == Sent::Gone) return lost(reading);
    owed_ = std::min(std::max(owed_ - *late, 0) + (sent == Sent::Taken ? 1 : 0), kMostOwed);

    const auto replies = listen(kReplyWait, owed_);
    if (!replies) return lost(reading);
    if (*replies == 0) return DeviceStatus::Stale;
    owed_ = 0;  // who has not answered by now never will
    return judge(reading);
  }

 private:
  static constexpr int kMostOwed = 3;

  static DeviceStatus lost(DeviceReading& reading) noexcept {
    reading.trouble = Trouble::Lost;
    return DeviceStatus::Lost;
  }

  /// Takes what comes until `wanted` replies are there or `wait` is over, into newest_; with
  /// neither, what is there already. Returns how many; nothing: the device is gone.
  std::optional<int> listen(nanoseconds wait, int wanted) noexcept {
    constexpr int kMostTransfers = 512;
    std::array<std::uint8_t, kUsbPacket> transfer;
    const std::int64_t end = port_->now() + wait.count();
    int replies = 0;
    for (int i = 0; i < kMostTransfers; ++i) {
      const std::int64_t left = end - port_->now();
      const auto length = port_->receive(transfer, nanoseconds{std::max<std::int64_t>(left, 0)});
      if (!length) return std::nullopt;
      if (*length == 0 && left <= 0) break;
      const int came =
          stream_.take(Bytes{transfer}.first(std::min(*length, transfer.size())), newest_);
      if (came > 0) newest_ns_ = port_->now();
      replies += came;
      if (wanted > 0 && (replies >= wanted || left <= 0)) break;
    }
    return replies;
  }

  /// What the newest reply says, if it can be believed.
  DeviceStatus judge(DeviceReading& reading) noexcept {
    homed_ = newest_.isHomed();
    if (!homed_) {
      last_ns_ = 0;
      reading = {.buttons = newest_.buttons, .time_ns = newest_ns_, .trouble = Trouble::NotHomed};
      return DeviceStatus::NotReady;
    }
    Vec3 theta1;
    for (int i = 0; i < 3; ++i) theta1[i] = angleOf(newest_.encoders[std::size_t(i)]);
    const bool follows = last_ns_ != 0;
    // from reply to reply: an encoder that stays where it jumped does not become true in time
    const double gap = 1e-9 * static_cast<double>(newest_ns_ - last_ns_);
    if (follows) last_ns_ = newest_ns_;
    const auto p_B = positionOf(theta1, follows ? p_B_ : Vec3::Zero());
    if (!p_B) return DeviceStatus::Stale;
    // further than a hand goes is an encoder's fault
    constexpr double kFastest = 5.0, kSlack = 2e-3;  // m/s, m
    if (follows && (*p_B - p_B_).norm() > kFastest * gap + kSlack) return DeviceStatus::Stale;
    const auto legs = legsAt(*p_B);
    if (!legs) return DeviceStatus::Stale;

    legs_ = *legs;
    p_B_ = *p_B;
    last_ns_ = newest_ns_;
    trusted_ = true;
    reading = {.buttons = newest_.buttons, .time_ns = newest_ns_};
    reading.X_BD.translation() = p_B_;
    return DeviceStatus::Ok;
  }

  std::unique_ptr<FalconPort> port_;
  ReplyStream stream_;
  Reply newest_;
  std::int64_t newest_ns_ = 0;  ///< when it came
  LegAngles legs_;              ///< of the last reading that was taken
  Vec3 p_B_ = Vec3::Zero();     ///< likewise
  std::int64_t last_ns_ =
      0;          ///< of the last reply since that; 0: none was taken since it was homed
  int owed_ = 0;  ///< replies to commands that have not come
  bool homed_ = false;
  bool trusted_ = false;  ///< the last exchange brought a reading: the next may carry force
};

Error lostWhileOpening() { return refusal(Trouble::Lost, {"device-gone", {kFalcon}}); }

}  // namespace

std::vector<DeviceEntry> entriesOf(std::span<const FalconPlace> places) {
  const DeviceEntry absent{.id = "falcon",
                           .name = kFalcon,
                           .sensed = 3,
                           .actuated = 3,
                           .trouble = Trouble::NotPluggedIn,
                           .why = {"device-not-plugged-in", {kFalcon}}};
  if (places.empty()) return {absent};
  std::vector<DeviceEntry> entries;
  for (const FalconPlace& place : places) {
    DeviceEntry entry = absent;
    entry.id += ":" + place.where;
    entry.present = true;
    entry.trouble = Trouble::None;
    entry.why = {};
    if (!place.permitted) {
      entry.trouble = Trouble::NoPermission;
      entry.why = {"device-not-permitted", {kFalcon}};
    } else if (place.claimed) {
      entry.trouble = Trouble::InUse;
      entry.why = {"device-in-use", {kFalcon}};
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

Expected<std::vector<std::uint8_t>> readFirmware(const std::filesystem::path& file) {
  const auto refused = [](Message why) {
    return tl::unexpected(refusal(Trouble::NoFirmware, std::move(why)));
  };
  std::error_code absent;
  std::ifstream stream;
  // what is not a file, a pipe say, could keep the reader waiting
  if (std::filesystem::is_regular_file(file, absent)) stream.open(file, std::ios::binary);
  if (!stream.is_open()) return refused({"falcon-firmware-unusable", {file.string()}});
  std::vector<std::uint8_t> bytes(kMostFirmware + 1);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (stream.bad()) return refused({"falcon-firmware-unusable", {file.string()}});
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) return refused({"falcon-firmware-unusable", {file.string()}});
  if (bytes.size() > kMostFirmware) return refused({"falcon-firmware-unusable", {file.string()}});
  return bytes;
}

Expected<std::unique_ptr<Transport>> linkTo(std::unique_ptr<FalconPort> port,
                                            const std::filesystem::path& firmware) {
  Step running = probe(*port);
  if (running == Step::Gone) return tl::unexpected(lostWhileOpening());
  if (running == Step::Failed) {
    if (firmware.empty())
      return tl::unexpected(refusal(Trouble::NoFirmware, {"falcon-no-firmware", {}}));
    const auto bytes = readFirmware(firmware);
    if (!bytes) return tl::unexpected(bytes.error());
    Load loaded = Load::NoHandshake;
    for (int i = 0; i < 3 && loaded != Load::Done && loaded != Load::Gone; ++i)
      loaded = load(*port, *bytes);
    if (loaded == Load::Gone) return tl::unexpected(lostWhileOpening());
    if (loaded == Load::NoHandshake)
      return tl::unexpected(refusal(Trouble::Refused, {"falcon-no-answer", {}}));
    if (loaded == Load::WrongEcho)
      return tl::unexpected(refusal(Trouble::Refused, {"falcon-firmware-not-taken", {}}));
    running = probe(*port);
    if (running == Step::Gone) return tl::unexpected(lostWhileOpening());
    if (running == Step::Failed)
      return tl::unexpected(
          refusal(Trouble::NoFirmware, {"falcon-firmware-not-running", {firmware.string()}}));
  }
  return std::make_unique<Link>(std::move(port));
}

}  // namespace falcon

std::vector<DeviceEntry> surveyFalcon() { return falcon::entriesOf(falcon::findFalcons()); }

Expected<std::unique_ptr<Device>> openFalcon(const OpenRequest& request) {
  const auto colon = request.id.find(':');
  std::string where = colon == std::string::npos ? "" : request.id.substr(colon + 1);
  if (where.empty())
    if (const auto places = falcon::findFalcons(); !places.empty()) where = places.front().where;
  auto port = falcon::openFalconPort(where);
  if (!port) return tl::unexpected(port.error());
  auto link = falcon::linkTo(std::move(*port), request.firmware);
  if (!link) return tl::unexpected(link.error());
  return threaded(std::move(*link), *findRating("falcon"), falcon::kFresh);
}

}  // namespace haptics
