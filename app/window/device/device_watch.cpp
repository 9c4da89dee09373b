// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/device/device_watch.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "app/window/scan/sentence.h"
#include "haptics/devices/combined.h"

namespace app {
namespace {

using haptics::Device;
using haptics::Expected;
using haptics::Trouble;

constexpr std::chrono::seconds kPeriod{1};
constexpr std::chrono::seconds kLongestGoodbye{2};

/// What the window calls a device; a second one of its kind has a number behind it.
QString titleOf(const std::string& name) {
  const QString whole = QString::fromStdString(name).simplified();
  static const QRegularExpression number(QStringLiteral(" \\d+$"));
  const QString stem = QString(whole).remove(number);
  return QCoreApplication::translate("app::DeviceWatch", stem.toUtf8().constData()) +
         whole.mid(stem.size());
}

ui::DeviceLine lineOf(const haptics::DeviceEntry& entry) {
  const haptics::DeviceRating* rating = nullptr;
#ifdef PALPATE_DEVICES
  rating = haptics::ratingOf(entry);
#endif
  return {.id = QString::fromStdString(entry.id),
          .name = titleOf(entry.name),
          .sensed = entry.sensed,
          .actuated = entry.actuated,
          .present = entry.present,
          .trouble = entry.trouble,
          .why = sentenceOf(entry.why).simplified(),
          .force = rating != nullptr ? rating->force : 0.0,
          .stiffness = rating != nullptr ? rating->stiffness : 0.0};
}

// the word of a refusal as what it stands for
Trouble troubleNamed(const std::string& word) {
  for (int n = 0; n <= static_cast<int>(Trouble::Lost); ++n)
    if (haptics::wordOf(static_cast<Trouble>(n)) == word) return static_cast<Trouble>(n);
  return Trouble::Refused;
}

Expected<std::unique_ptr<Device>> openWished(const DeviceCatalogue& catalogue,
                                             const ui::DeviceWish& wish) {
  // no exception may leave the thread; what a driver throws is no memory, or its fault
  try {
    auto device =
        catalogue.open({.id = wish.id.toStdString(), .firmware = wish.firmware.toStdString()});
    if (!device || wish.turned_by.isEmpty()) return device;
    auto turner = catalogue.open({.id = wish.turned_by.toStdString()});
    if (!turner) return turner;
    return catalogue.join(std::move(*device), std::move(*turner));
  } catch (const std::exception&) {
    return tl::unexpected(haptics::Error{
        haptics::Error::Kind::Unsupported,
        DeviceWatch::tr("The device could not be opened: its driver failed. Unplug it, plug it in "
                        "and try again.")
            .toStdString(),
        std::string{haptics::wordOf(Trouble::Refused)}});
  }
}

}  // namespace

DeviceCatalogue builtInCatalogue() {
#ifdef PALPATE_DEVICES
  return {.survey = haptics::surveyDevices, .open = haptics::openDevice, .join = haptics::combined};
#else
  return {.survey = [] { return std::vector<haptics::DeviceEntry>{}; },
          .open = [](const haptics::OpenRequest&) -> Expected<std::unique_ptr<Device>> {
            return tl::unexpected(haptics::Error{
                haptics::Error::Kind::Unsupported,
                DeviceWatch::tr("This Palpate was built without drivers of haptic devices.")
                    .toStdString(),
                std::string{haptics::wordOf(Trouble::NoLibrary)}});
          },
          .join = [](auto moved, auto) { return moved; }};
#endif
}

/// What both threads know. Outlives the watch where a driver hangs.
struct DeviceWatch::Shared {
  const DeviceCatalogue catalogue;
  std::mutex mutex;
  std::condition_variable changed;
  DeviceWatch* watch = nullptr;  ///< null: it is gone
  bool watching = false;
  bool look = false;  ///< at once
  std::optional<ui::DeviceWish> wish;
  std::uint64_t wishes = 0;  ///< so many there were: of an older one nothing is reported
  std::optional<QList<ui::DeviceLine>> told;
  bool ended = false;

  explicit Shared(DeviceCatalogue given) : catalogue(std::move(given)) {}
  bool called() const { return watch == nullptr || look || wish.has_value(); }
};

DeviceWatch::DeviceWatch(DeviceCatalogue catalogue, QObject* parent)
    : QObject(parent), shared_(std::make_shared<Shared>(std::move(catalogue))) {
  shared_->watch = this;
  std::thread([shared = shared_] { work(shared); }).detach();
}

DeviceWatch::~DeviceWatch() {
  std::unique_lock lock(shared_->mutex);
  shared_->watch = nullptr;
  shared_->changed.notify_all();
  shared_->changed.wait_for(lock, kLongestGoodbye, [this] { return shared_->ended; });
}

void DeviceWatch::watch(bool on) {
  const std::lock_guard lock(shared_->mutex);
  if (on && !shared_->watching) shared_->look = true;
  shared_->watching = on;
  shared_->changed.notify_all();
}

void DeviceWatch::surveyNow() {
  const std::lock_guard lock(shared_->mutex);
  shared_->look = true;
  shared_->changed.notify_all();
}

void DeviceWatch::open(const ui::DeviceWish& wish) {
  const std::lock_guard lock(shared_->mutex);
  shared_->wish = wish;
  ++shared_->wishes;
  shared_->changed.notify_all();
}

void DeviceWatch::cancel() {
  const std::lock_guard lock(shared_->mutex);
  shared_->wish.reset();
  ++shared_->wishes;
}

void DeviceWatch::work(const std::shared_ptr<Shared>& shared) {
  std::unique_lock lock(shared->mutex);
  // what is reported while the lock is held finds the watch alive, or dies with its events
  const auto report = [&shared](auto how) {
    QMetaObject::invokeMethod(shared->watch, std::move(how), Qt::QueuedConnection);
  };
  while (shared->watch != nullptr) {
    if (shared->watching)
      shared->changed.wait_for(lock, kPeriod, [&] { return shared->called(); });
    else
      shared->changed.wait(lock, [&] { return shared->called(); });
    if (shared->watch == nullptr) break;

    if (shared->wish) {
      const ui::DeviceWish wish = *std::exchange(shared->wish, std::nullopt);
      const std::uint64_t number = shared->wishes;
      lock.unlock();
      auto result = openWished(shared->catalogue, wish);
      lock.lock();
      if (shared->watch == nullptr || number != shared->wishes) {
        lock.unlock();
        result = {};  // closing it may take a while
        lock.lock();
        continue;
      }
      shared->look = true;
      DeviceWatch* watch = shared->watch;
      if (result)
        report([watch, shared, number, wish,
                device = std::make_shared<std::unique_ptr<Device>>(std::move(*result))] {
          if (number == shared->wishes) emit watch->opened(wish, device);
        });
      else
        report([watch, shared, number, wish, error = std::move(result.error())] {
          if (number == shared->wishes)
            emit watch->refused(wish, troubleNamed(error.reason), sentenceOf(error));
        });
      continue;
    }

    if (!std::exchange(shared->look, false) && !shared->watching) continue;
    lock.unlock();
    QList<ui::DeviceLine> lines;
    bool well = true;
    try {
      for (const haptics::DeviceEntry& entry : shared->catalogue.survey()) lines << lineOf(entry);
    } catch (const std::exception&) {
      well = false;  // then what was told stands
    }
    lock.lock();
    if (!well || shared->watch == nullptr || shared->told == lines) continue;
    shared->told = lines;
    report([watch = shared->watch, lines] { emit watch->surveyed(lines); });
  }
  shared->ended = true;
  shared->changed.notify_all();
}

}  // namespace app
