// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "haptics/devices/catalogue.h"
#include "ui/panels/haptic_device_panel.h"

namespace app {

/// How devices are looked for and opened. Called on DeviceWatch's thread, one call at a time.
struct DeviceCatalogue {
  std::function<std::vector<haptics::DeviceEntry>()> survey;
  std::function<haptics::Expected<std::unique_ptr<haptics::Device>>(const haptics::OpenRequest&)>
      open;
  /// Makes one of a device that is moved and one that turns it.
  std::function<std::unique_ptr<haptics::Device>(std::unique_ptr<haptics::Device> moved,
                                                 std::unique_ptr<haptics::Device> turning)>
      join;
};

/// All drivers that were built in; or none.
DeviceCatalogue builtInCatalogue();

/// Looks for devices and opens them on a thread of its own. All calls come from the GUI thread and
/// wait for nothing, whatever a driver does meanwhile; only the destructor waits, 2 s at most, and
/// leaves a driver that hangs behind with nobody to report to.
class DeviceWatch : public QObject {
  Q_OBJECT
 public:
  /// Passed by signal, so that it can be copied: who takes the device leaves null.
  using Opened = std::shared_ptr<std::unique_ptr<haptics::Device>>;

  explicit DeviceWatch(DeviceCatalogue catalogue = builtInCatalogue(), QObject* parent = nullptr);
  ~DeviceWatch() override;

  /// Whether it looks again a second after it last did, on and on; at once when switched on.
  void watch(bool on);
  void surveyNow();
  /// Takes the place of what was wished before: that is not opened any more, or closed where it
  /// was just being opened, and not reported.
  void open(const ui::DeviceWish& wish);
  /// Gives up what is being opened.
  void cancel();

 signals:
  /// Only when something changed, or the first time.
  void surveyed(const QList<ui::DeviceLine>& devices);
  void opened(const ui::DeviceWish& wish, const app::DeviceWatch::Opened& device);
  void refused(const ui::DeviceWish& wish, haptics::Trouble trouble, const QString& sentence);

 private:
  struct Shared;
  static void work(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;
};

}  // namespace app
