// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/background/task.h"
#include "app/device_watch.h"
#include "app/export_task.h"
#include "app/loader.h"
#include "app/measurement.h"
#include "app/preferences.h"
#include "app/recordings.h"
#include "app/replay.h"
#include "app/session_recording.h"
#include "app/thumbnails.h"
#include "app/volume_identity.h"
#include "datasets/readers/refusal.h"
#include "haptics/session.h"
#include "ui/main_window.h"
#include "ui/panels/haptic_device_panel.h"

namespace ui {
class SeriesBrowser;
}

namespace app {

/// What the command line asks for.
struct Arguments {
  LoadRequest load = {};  ///< nothing to load: the demo phantom
  std::string hand = "mouse";
  std::optional<ui::SurfaceMode> surface = {};
  std::string screenshot = {};    ///< a PNG to write, then quit; or empty
  double screenshot_after = 3.0;  ///< s of running with a scene
  bool notice = true;
  std::function<double()> free_memory = datasets::freeMemory;  ///< bytes; any thread
  DeviceCatalogue devices = builtInCatalogue();
  std::filesystem::path recordings = {};  ///< where sessions are kept; empty: the user's folder
};

/// What the user reads for a tool: its name, or its file's.
QString labelOf(const ToolSource& tool);

/// The names of the hands, as the command line knows them.
std::optional<haptics::HandKind> handNamed(const std::string& name);

/// Owns the window, the session and the loader, and makes every connection between them.
class Application : public QObject {
  Q_OBJECT
 public:
  explicit Application(Arguments arguments);
  ~Application() override;

  void start();
  ui::MainWindow& window() { return window_; }
  haptics::Session& session() { return session_; }
  const haptics::Snapshot& snapshot() const { return snapshot_; }
  /// What is seen and touched; none before the first volume.
  const std::optional<Loaded>& shown() const { return shown_; }
  SessionRecording& recording() { return recording_; }
  /// As the user does who has answered every question.
  void exportTo(ExportRequest request);
  ExportTask& exportTask() { return export_; }
  /// The recording that is being replayed; null: the hand is at work.
  Replay* replay() { return replay_.get(); }

 signals:
  /// The screenshot was written, or could not be.
  void finished(int exit_code);
  /// A scene is being touched.
  void adopted();

 private:
  void connectWindow();
  void connectOpening();
  void connectChoosing();
  void connectLoader();
  void connectMeasurement();
  void connectDevices();
  void connectRecording();
  void showRecordings();
  void offerRecovery();
  void record(bool record);
  void deleteRecording(const QString& id);
  void recoverRecording(const QString& id);
  void openRecording(const std::filesystem::path& path);
  void closeReplay();
  void compareVolumes();
  void connectExport();
  void exportRecording(const QString& id);
  FilmCamera cameraNow();
  void noteCamera();
  void showReplayed(double time);
  void load(LoadRequest request, const QString& what);
  void adopt(const Loaded& loaded);
  void onFailed(const LoadRequest& request, const haptics::Error& error);
  void open(const QString& path);
  void openDropped(const QStringList& paths);
  void keepPlace(const std::filesystem::path& place);
  void forgetPlaces();
  void showPlaces();
  void browseSeries();
  void closeBrowser();
  void loadChosen(int row);
  void offerCorrection(LoadRequest request, const QString& why);
  /// False if no part of it is without a gap.
  bool offerLargestPart(LoadRequest request);
  /// False if no part of it can be read either.
  bool offerPart(LoadRequest request, const QString& why);
  /// False, with the reason in the window, if the hand that was open goes on.
  bool openHand(const std::string& name);
  void showHand(const std::string& id, const QString& label, bool is_mouse);
  QString nameOfDevice(const QString& id) const;
  void watchDevices();
  void takeDevice(const ui::DeviceWish& wish, const DeviceWatch::Opened& device);
  void letGoOfDevice(const QString& why);
  /// Once it is closed: the stiffness that was set before it comes back.
  void forgetDevice(const QString& why);
  void setStiffness(double stiffness);
  void restoreStiffness();
  void scaleAsMapped();
  void handleDevice();
  void tellOfForce();
  void tellOfFault(haptics::ForceReason why);
  void changeTool(const ToolSource& tool);
  void changeField(const QString& id);
  /// Of what is shown.
  Kept kept() const;
  void showField();
  void refresh();
  void measure();
  void endMeasuring(const QString& why);
  void showMeasured(const study::Here& here);
  void makeFineMesh(double isovalue);
  void takeScreenshot();
  void remember();

  Arguments arguments_;
  Preferences preferences_;
  ui::MainWindow window_;
  haptics::Session session_;
  Loader loader_;
  Thumbnails thumbnails_;
  std::optional<Surveyed> surveyed_;  ///< what was last found where there was something to find
  QPointer<ui::SeriesBrowser> browser_;
  Measurement measurement_;
  haptics::Settings settings_;
  haptics::Snapshot snapshot_;
  haptics::Snapshot before_measuring_;
  QString measured_;  ///< with what and how the measurement under way is made
  std::optional<Loaded> shown_;
  haptics::SceneOptions options_;  ///< of the next scene
  QTimer field_rest_;              ///< since the isovalue last moved
  std::string hand_;               ///< which holds the device: one of ours, or a device's id
  QString hand_label_;
  DeviceWatch watch_;
  QList<ui::DeviceLine> devices_;
  std::optional<ui::DeviceWish> connected_;  ///< the real device that is open
  QString connected_name_;
  std::optional<double> own_stiffness_;  ///< N/m, as it was before a device was connected
  bool devices_seen_ = false;
  ui::Mapping mapping_;
  haptics::Handling handling_;
  bool look_from_tool_ = false;  ///< at the next snapshot
  Recordings recordings_;
  VolumeIdentity identity_;
  SessionRecording recording_;
  std::string camera_noted_;    ///< the last that was recorded
  QElapsedTimer since_camera_;  ///< and when
  ExportTask export_;
  std::unique_ptr<Replay> replay_;
  std::optional<std::uint32_t> replayed_scene_;  ///< whose tool is on view
  std::optional<double> replayed_isovalue_;
  double replayed_to_ = 0.0;  ///< s: what the plot of the force shows
  bool same_volume_ = false;  ///< on view is what was touched, as far as can be told
  QTimer display_;
  std::vector<haptics::ForceSample> samples_;
  std::vector<ui::ForcePoint> points_;
  background::Task<vtkSmartPointer<vtkPolyData>> mesher_;
  background::Task<std::filesystem::path> recoverer_;
  std::optional<double> mesh_next_;  ///< the isovalue asked for while another was being meshed
};

}  // namespace app
