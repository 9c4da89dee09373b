// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <QObject>
#include <QPointer>
#include <optional>

#include "app/background/task.h"
#include "ui/views/volume_view.h"

class vtkPolyData;

namespace app {

/// Makes the fine meshes that a 3-D view without a usable GPU asks for, on another thread. GUI
/// thread.
class FineMesher : public QObject {
  Q_OBJECT
 public:
  /// Of this view, in place of the one before, as long as it is there.
  void serve(ui::VolumeView& view);

 private:
  void make(double isovalue);

  QPointer<ui::VolumeView> view_;
  background::Task<vtkSmartPointer<vtkPolyData>> task_;
  std::optional<double> next_;  ///< isovalue of the next mesh, while another is being made
};

}  // namespace app
