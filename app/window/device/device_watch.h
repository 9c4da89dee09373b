// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/window/device/device_catalogue.h"
#include "ui/panels/haptic_device_panel.h"

namespace app {

/// Finds and opens devices on its own thread. All calls come from the GUI thread and never wait for
/// a driver. Only the destructor waits, for at most 2 s; then it abandons the thread of a driver
/// that hangs.
class DeviceWatch : public QObject {
  Q_OBJECT
 public:
  /// Copyable, since it is passed by signal. The receiver takes the device and leaves null.
  using Opened = std::shared_ptr<std::unique_ptr<haptics::Device>>;

  explicit DeviceWatch(DeviceCatalogue catalogue = builtInCatalogue(), QObject* parent = nullptr);
  ~DeviceWatch() override;

  /// Switches the survey on or off. While on, devices are surveyed at once and then a second after
  /// each survey.
  void watch(bool on);
  void surveyNow();
  /// Replaces an earlier wish: its device is not opened, or is closed if it was being opened, and
  /// is not reported.
  void open(const ui::DeviceWish& wish);
  /// Cancels the opening.
  void cancel();

 signals:
  /// Emitted at the first survey, and when something has changed.
  void surveyed(const QList<ui::DeviceLine>& devices);
  void opened(const ui::DeviceWish& wish, const app::DeviceWatch::Opened& device);
  void refused(const ui::DeviceWish& wish, haptics::Trouble trouble, const QString& sentence);

 private:
  struct Shared;
  static void work(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;
};

}  // namespace app
