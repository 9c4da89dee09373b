// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "datasets/readers/volume_reader.h"
#include "haptics/core/error.h"
#include "haptics/scene.h"
#include "ui/props/picture.h"

namespace app {

/// Which tool: one of ours, or a file.
struct ToolSource {
  std::string name = "probe";  ///< of a named tool
  std::optional<std::filesystem::path> file = {};
  std::string unit = "mm";  ///< of the file: m, mm, cm, in
};

/// What to load. Of path, phantom and keep, the first that is set counts.
struct LoadRequest {
  std::optional<std::filesystem::path> path = {};
  std::optional<int> series = {};
  datasets::Geometry geometry = datasets::Geometry::AsStored;
  std::optional<std::string> phantom = {};
  std::optional<ui::Picture> keep = {};  ///< the volume already shown, with another tool
  std::optional<ToolSource> tool = {};   ///< none: the one that fits a phantom, else `probe`
  std::optional<double> isovalue = {};
  haptics::SceneOptions options = {};
  /// The scene whose field is taken over where volume and kind are the same; or none.
  std::shared_ptr<const haptics::Scene> previous = {};
};

/// A volume and a tool, ready to be seen and touched.
struct Loaded {
  ui::Picture picture;
  std::shared_ptr<const haptics::Scene> scene;
  ToolSource tool;
  double isovalue = 0.0;
  haptics::Pose start = haptics::Pose::Identity();  ///< a legal pose in front of the surface, W
  QString title;
  QString note;  ///< a sentence worth saying although it was loaded, or empty
};

/// Reads and prepares on a thread of its own for each request; a new one cancels the last.
/// Signals arrive on the thread that owns the loader, and only for the newest request. No call
/// waits for a thread, except the destructor.
class Loader : public QObject {
  Q_OBJECT
 public:
  explicit Loader(QObject* parent = nullptr);
  ~Loader() override;

  void start(LoadRequest request);
  void cancel();

 signals:
  void progressed(double fraction);
  void loaded(const app::Loaded& loaded);
  /// `survey` lists the series where one must be chosen (reason "which-series"); else it is empty.
  void failed(const app::LoadRequest& request, const haptics::Error& error,
              const datasets::Survey& survey);

 private:
  void onThisThread(std::uint64_t number, std::function<void()> action);

  struct Job {
    std::atomic<bool> cancel{false};
    std::atomic<bool> done{false};  ///< its thread is about to end
    std::thread thread;
  };
  void work(Job& job, std::uint64_t number, const LoadRequest& request);
  std::list<Job> jobs_;       ///< the newest last; older ones are cancelled, and kept until done
  std::uint64_t number_ = 0;  ///< of the newest request
};

/// The work itself; any thread.
haptics::Expected<Loaded> load(const LoadRequest& request,
                               const std::function<void(double)>& advanced,
                               const std::atomic<bool>& cancel);

}  // namespace app
