// SPDX-License-Identifier: BSD-3-Clause
// The USB side of the Falcon's driver, on a bus of the test's: this program defines the functions
// of libusb that the driver calls, so none of a real bus is touched.
#include <gtest/gtest.h>
#include <libusb-1.0/libusb.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "haptics/devices/catalogue.h"
#include "haptics/devices/falcon_packets.h"
#include "haptics/devices/falcon_port.h"
#include "tests/support/sentence.h"

namespace {

using haptics::falcon::FalconPort;
using haptics::falcon::findFalcons;
using haptics::falcon::openFalconPort;
using haptics::falcon::Sent;
using std::chrono::milliseconds;
using Bytes = std::vector<std::uint8_t>;

struct Plugged {
  std::uint16_t vendor, product;
  std::uint8_t bus;
  std::vector<std::uint8_t> ports;
};

/// The bus: what is plugged in, what is under way, and what goes wrong.
struct Bus {
  std::vector<Plugged> plugged{
      {0x0403, 0x6001, 1, {1}}, {0x0403, 0xcb48, 1, {2}}, {0x0403, 0xcb48, 3, {1, 4}}};
  int init_code = 0, open_code = 0, claim_code = 0, submit_fails_at = 1'000'000'000;
  bool deaf = false;       ///< does not take what is sent
  bool deaf_once = false;  ///< takes it one round of events later
  bool stuck = false;      ///< gives cancelled transfers never back
  bool broken = false;     ///< what is read comes with an error
  bool unplugged = false;
  std::function<void(Bus&, const Bytes&)> answer = [](Bus&, const Bytes&) {};

  int contexts = 0, handles = 0, claims = 0, submitted = 0;
  std::deque<Bytes> to_read;
  std::deque<libusb_transfer*> reads;
  libusb_transfer* out = nullptr;
  std::vector<libusb_transfer*> cancelled, leaked;
  std::vector<Bytes> sent;
  std::vector<std::array<int, 2>> requests;
  int allocated = 0, freed_in_flight = 0;

  bool isInFlight(const libusb_transfer* transfer) const {
    return transfer == out || std::find(reads.begin(), reads.end(), transfer) != reads.end();
  }
  void finish(libusb_transfer* transfer, libusb_transfer_status status, int length) {
    if (transfer == out)
      out = nullptr;
    else
      reads.erase(std::find(reads.begin(), reads.end(), transfer));
    transfer->status = status;
    transfer->actual_length = length;
    transfer->callback(transfer);
  }
  bool step() {
    bool worked = false;
    const auto given_back = std::exchange(cancelled, {});
    for (libusb_transfer* transfer : given_back)
      if (!stuck && isInFlight(transfer))
        finish(transfer, LIBUSB_TRANSFER_CANCELLED, 0), worked = true;
    if (unplugged) {
      if (out != nullptr) finish(out, LIBUSB_TRANSFER_NO_DEVICE, 0), worked = true;
      while (!reads.empty() && !stuck)
        finish(reads.front(), LIBUSB_TRANSFER_NO_DEVICE, 0), worked = true;
      return worked;
    }
    if (out != nullptr && !deaf && !std::exchange(deaf_once, false)) {
      const Bytes bytes{out->buffer, out->buffer + out->length};
      sent.push_back(bytes);
      finish(out, LIBUSB_TRANSFER_COMPLETED, out->length);
      answer(*this, bytes);
      worked = true;
    }
    if (broken && !reads.empty()) finish(reads.front(), LIBUSB_TRANSFER_STALL, 0), worked = true;
    // as many as are there now: what is submitted meanwhile waits for the next round
    for (std::size_t n = reads.size(); n > 0 && !to_read.empty() && !reads.empty(); --n) {
      const Bytes bytes = to_read.front();
      to_read.pop_front();
      std::copy(bytes.begin(), bytes.end(), reads.front()->buffer);
      finish(reads.front(), LIBUSB_TRANSFER_COMPLETED, int(bytes.size()));
      worked = true;
    }
    return worked;
  }
};

Bus bus;

class FalconUsb : public testing::Test {
 protected:
  void SetUp() override { bus = {}; }
  void TearDown() override {
    EXPECT_EQ(bus.contexts, 0);
    EXPECT_EQ(bus.handles, 0);
    EXPECT_EQ(bus.freed_in_flight, 0);
    EXPECT_EQ(bus.allocated, int(bus.leaked.size()));
    for (libusb_transfer* transfer : bus.leaked) std::free(transfer);
  }
  static std::unique_ptr<FalconPort> open(const std::string& where = "1-2") {
    auto port = openFalconPort(where);
    EXPECT_TRUE(port) << (port ? "" : sentence(port.error()));
    return port ? std::move(*port) : nullptr;
  }
  /// What is received, as text; "-" where nothing came, "gone" where nothing will.
  static std::string received(FalconPort& port, milliseconds wait = milliseconds{0}) {
    std::array<std::uint8_t, 64> transfer{};
    const auto length = port.receive(transfer, wait);
    if (!length) return "gone";
    return *length == 0 ? "-" : std::string(transfer.begin(), transfer.begin() + long(*length));
  }
  static void say(const std::string& text) { bus.to_read.emplace_back(text.begin(), text.end()); }
};

const Bytes kPacket{'a', 'b', 'c'};

}  // namespace

extern "C" {

int LIBUSB_CALL libusb_init(libusb_context** context) {
  if (bus.init_code != 0) return bus.init_code;
  ++bus.contexts;
  *context = reinterpret_cast<libusb_context*>(&bus);
  return 0;
}
void LIBUSB_CALL libusb_exit(libusb_context*) { --bus.contexts; }
ssize_t LIBUSB_CALL libusb_get_device_list(libusb_context*, libusb_device*** list) {
  *list = new libusb_device*[bus.plugged.size() + 1]();
  for (std::size_t i = 0; i < bus.plugged.size(); ++i)
    (*list)[i] = reinterpret_cast<libusb_device*>(&bus.plugged[i]);
  return ssize_t(bus.plugged.size());
}
void LIBUSB_CALL libusb_free_device_list(libusb_device** list, int) { delete[] list; }
int LIBUSB_CALL libusb_get_device_descriptor(libusb_device* device,
                                             libusb_device_descriptor* words) {
  *words = {};
  words->idVendor = reinterpret_cast<Plugged*>(device)->vendor;
  words->idProduct = reinterpret_cast<Plugged*>(device)->product;
  return 0;
}
std::uint8_t LIBUSB_CALL libusb_get_bus_number(libusb_device* device) {
  return reinterpret_cast<Plugged*>(device)->bus;
}
std::uint8_t LIBUSB_CALL libusb_get_device_address(libusb_device*) { return 255; }
int LIBUSB_CALL libusb_get_port_numbers(libusb_device* device, std::uint8_t* ports, int count) {
  const auto& all = reinterpret_cast<Plugged*>(device)->ports;
  std::copy_n(all.begin(), std::min(all.size(), std::size_t(count)), ports);
  return int(all.size());
}
int LIBUSB_CALL libusb_open(libusb_device* device, libusb_device_handle** handle) {
  if (bus.open_code != 0) return bus.open_code;
  ++bus.handles;
  *handle = reinterpret_cast<libusb_device_handle*>(device);
  return 0;
}
void LIBUSB_CALL libusb_close(libusb_device_handle*) { --bus.handles; }
int LIBUSB_CALL libusb_set_auto_detach_kernel_driver(libusb_device_handle*, int) { return 0; }
int LIBUSB_CALL libusb_claim_interface(libusb_device_handle*, int) {
  bus.claims += bus.claim_code == 0;
  return bus.claim_code;
}
int LIBUSB_CALL libusb_release_interface(libusb_device_handle*, int) {
  --bus.claims;
  return 0;
}
int LIBUSB_CALL libusb_control_transfer(libusb_device_handle*, std::uint8_t type,
                                        std::uint8_t request, std::uint16_t value, std::uint16_t,
                                        unsigned char*, std::uint16_t, unsigned) {
  if (bus.unplugged || type != 0x40) return LIBUSB_ERROR_NO_DEVICE;
  bus.requests.push_back({request, value});
  return 0;
}
libusb_transfer* LIBUSB_CALL libusb_alloc_transfer(int) {
  ++bus.allocated;
  return static_cast<libusb_transfer*>(std::calloc(1, sizeof(libusb_transfer)));
}
void LIBUSB_CALL libusb_free_transfer(libusb_transfer* transfer) {
  if (transfer == nullptr) return;
  bus.freed_in_flight += bus.isInFlight(transfer);
  --bus.allocated;
  std::free(transfer);
}
int LIBUSB_CALL libusb_submit_transfer(libusb_transfer* transfer) {
  if (++bus.submitted >= bus.submit_fails_at) return LIBUSB_ERROR_IO;
  if (bus.unplugged) return LIBUSB_ERROR_NO_DEVICE;
  if (transfer->endpoint == 0x02)
    bus.out = transfer;
  else
    bus.reads.push_back(transfer);
  return 0;
}
int LIBUSB_CALL libusb_cancel_transfer(libusb_transfer* transfer) {
  bus.cancelled.push_back(transfer);
  if (bus.stuck) bus.leaked.push_back(transfer);
  return 0;
}
int LIBUSB_CALL libusb_handle_events_timeout_completed(libusb_context*, timeval* wait, int*) {
  if (!bus.step() && (wait->tv_sec > 0 || wait->tv_usec > 0))
    std::this_thread::sleep_for(milliseconds{1});
  return 0;
}
const char* LIBUSB_CALL libusb_error_name(int) { return "LIBUSB_ERROR_OF_THE_TEST"; }

}  // extern "C"

namespace {

TEST_F(FalconUsb, FindsFalconsAndNoOtherChipOfThatMaker) {
  const auto places = findFalcons();
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].where, "1-2");
  EXPECT_EQ(places[1].where, "3-1.4");
  EXPECT_EQ(bus.submitted, 0);
  bus.init_code = LIBUSB_ERROR_OTHER;  // a system without USB
  EXPECT_TRUE(findFalcons().empty());
}

TEST_F(FalconUsb, SaysWhyItCannotBeOpened) {
  const auto reasonOf = [](int open_code, int claim_code, const std::string& where = "1-2") {
    bus.open_code = open_code;
    bus.claim_code = claim_code;
    const auto port = openFalconPort(where);
    EXPECT_FALSE(port);
    return port ? std::string{} : port.error().reason;
  };
  EXPECT_EQ(reasonOf(LIBUSB_ERROR_ACCESS, 0), "no-permission");
  EXPECT_EQ(reasonOf(LIBUSB_ERROR_NO_DEVICE, 0), "not-plugged-in");
  EXPECT_EQ(reasonOf(LIBUSB_ERROR_IO, 0), "refused");
  EXPECT_EQ(reasonOf(0, LIBUSB_ERROR_BUSY), "in-use");
  EXPECT_EQ(reasonOf(0, LIBUSB_ERROR_NO_DEVICE), "not-plugged-in");
  EXPECT_EQ(reasonOf(0, LIBUSB_ERROR_OTHER), "refused");
  EXPECT_EQ(reasonOf(0, 0, "1-1"), "not-plugged-in");  // another chip
  EXPECT_EQ(reasonOf(0, 0, ""), "not-plugged-in");
  bus.submit_fails_at = 3;
  EXPECT_EQ(reasonOf(0, 0), "refused");
  EXPECT_EQ(bus.claims, 0);
}

TEST_F(FalconUsb, KeepsFourReadsInFlightAndGivesThemInOrder) {
  const auto port = open("3-1.4");
  EXPECT_EQ(bus.reads.size(), 4u);
  for (int n = 0; n < 10; ++n) say("s" + std::string(1, char('A' + n)) + "payload");
  for (int n = 0; n < 10; ++n)
    EXPECT_EQ(received(*port), "s" + std::string(1, char('A' + n)) + "payload");
  EXPECT_EQ(received(*port), "-");
  EXPECT_EQ(bus.reads.size(), 4u);
}

TEST_F(FalconUsb, TheChipsStatusAloneIsNotHandedOn) {
  const auto port = open();
  for (int n = 0; n < 50; ++n) say("ss");
  say("");
  say("sspayload");
  EXPECT_EQ(received(*port, milliseconds{2000}), "sspayload");
  EXPECT_EQ(bus.reads.size(), 4u);
  EXPECT_EQ(received(*port, milliseconds{3}), "-");
}

TEST_F(FalconUsb, ALongTransferIsCutToTheRoomThatThereIs) {
  const auto port = open();
  say(std::string(64, 'x'));
  std::array<std::uint8_t, 10> little{};
  EXPECT_EQ(port->receive(little, milliseconds{0}), std::optional<std::size_t>{10});
}

TEST_F(FalconUsb, TakesTheNextPacketWhenTheLastHasGoneOut) {
  const auto port = open();
  EXPECT_EQ(port->send(kPacket), Sent::Taken);
  EXPECT_EQ(port->send(kPacket), Sent::Taken);  // events are handled before
  bus.deaf = true;
  EXPECT_EQ(port->send(kPacket), Sent::Busy);
  EXPECT_EQ(port->send(kPacket), Sent::Busy);
  bus.deaf = false;
  EXPECT_EQ(port->send(Bytes(65, 'x')), Sent::Busy);  // more than a packet of the bus
  EXPECT_EQ(port->send({}), Sent::Taken);
  received(*port);
  EXPECT_EQ(bus.sent, (std::vector<Bytes>{kPacket, kPacket, {}}));
  EXPECT_TRUE(port->request(9, 1));
  EXPECT_EQ(bus.requests, (std::vector<std::array<int, 2>>{{9, 1}}));
}

TEST_F(FalconUsb, WhatIsUnderWayGoesOutBeforeItCloses) {
  auto port = open();
  bus.deaf_once = true;
  EXPECT_EQ(port->send(kPacket), Sent::Taken);
  port.reset();
  EXPECT_EQ(bus.sent, std::vector<Bytes>{kPacket});
  EXPECT_EQ(bus.claims, 0);
}

TEST_F(FalconUsb, ClosesThoughTheBytesNeverGoOut) {
  auto port = open();
  bus.deaf = true;
  EXPECT_EQ(port->send(kPacket), Sent::Taken);
  port.reset();
  EXPECT_TRUE(bus.sent.empty());
  EXPECT_EQ(bus.allocated, 0);
}

TEST_F(FalconUsb, ClosesThoughTheBusGivesNothingBackAndFreesNoneOfThat) {
  auto port = open();
  bus.stuck = true;
  port.reset();
  EXPECT_EQ(bus.allocated, 4);  // the reads; TearDown compares
}

TEST_F(FalconUsb, UnpluggedIsGoneButWhatCameBeforeIsHandedOn) {
  const auto port = open();
  say("sslast");
  bus.answer = [](Bus& self, const Bytes&) { self.unplugged = true; };
  EXPECT_EQ(port->send(kPacket), Sent::Taken);
  EXPECT_EQ(received(*port), "sslast");
  EXPECT_EQ(received(*port, milliseconds{2000}), "gone");
  EXPECT_EQ(port->send(kPacket), Sent::Gone);
  EXPECT_FALSE(port->request(9, 1));
  EXPECT_EQ(received(*port), "gone");
}

TEST_F(FalconUsb, WithNothingToBeReadAnyMoreItStillSends) {
  auto port = open();
  say("sslast");
  bus.broken = true;
  EXPECT_EQ(received(*port, milliseconds{2000}), "sslast");
  EXPECT_EQ(received(*port, milliseconds{2000}), "gone");
  for (int n = 0; n < 3; ++n) {
    EXPECT_EQ(port->send(kPacket), Sent::Taken);
    EXPECT_EQ(received(*port), "gone");
  }
  port.reset();
  EXPECT_EQ(bus.sent, std::vector<Bytes>(3, kPacket));
}

TEST_F(FalconUsb, UnpluggedInTheMiddleOfAPacketIsGone) {
  const auto port = open();
  bus.deaf = true;
  EXPECT_EQ(port->send(kPacket), Sent::Taken);
  bus.unplugged = true;
  EXPECT_EQ(port->send(kPacket), Sent::Gone);
  EXPECT_EQ(received(*port), "gone");
}

// from the catalogue to the bus and back
TEST_F(FalconUsb, ADeviceOfTheCatalogueReadsAndEndsWithZeros) {
  bus.answer = [](Bus& self, const Bytes& bytes) {
    EXPECT_EQ(bytes.size(), 16u);
    // homed, all arms at 35 degrees, in two pieces
    const std::string reply = std::string{"<AAAAAAAAAAAA"} + char('A' + 112) + "A>";
    for (const std::string& half :
         {"ss" + reply.substr(0, 6), std::string{"ss"}, "ss" + reply.substr(6)})
      self.to_read.emplace_back(half.begin(), half.end());
  };
  auto device = haptics::openDevice({.id = "falcon:3-1.4"});
  ASSERT_TRUE(device) << sentence(device.error());
  EXPECT_EQ((*device)->rating().id, "falcon");
  haptics::DeviceReading reading;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  while ((*device)->read(reading) != haptics::DeviceStatus::Ok &&
         std::chrono::steady_clock::now() < end)
    std::this_thread::yield();
  EXPECT_NEAR(reading.X_BD.translation().x(), 0.0, 1e-9);
  EXPECT_NEAR(reading.X_BD.translation().z(), 0.0095, 2e-3);
  for (int n = 0; n < 20; ++n) {
    (*device)->write({.force = {0.0, 0.0, 1.0}});
    std::this_thread::sleep_for(milliseconds{1});
  }
  device->reset();
  const auto pushes = [](const Bytes& bytes) {
    return std::any_of(bytes.begin() + 1, bytes.begin() + 13,
                       [](auto byte) { return byte != 'A'; });
  };
  ASSERT_GT(bus.sent.size(), 2u);
  EXPECT_GT(std::count_if(bus.sent.begin(), bus.sent.end(), pushes), 0);
  EXPECT_FALSE(pushes(bus.sent.back()));
  EXPECT_FALSE(pushes(bus.sent.front()));
}

}  // namespace
