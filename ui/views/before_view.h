// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>

#include "ui/views/volume_view.h"

namespace ui {

/// The unedited scan beside what is left of it: a 3-D view that looks as that one does, with the
/// same camera, isovalue and colours. It is for looking alone; of its signals only those about
/// camera and force are of use. Both have a caption while it is there.
class BeforeView : public VolumeView {
  Q_OBJECT
 public:
  BeforeView(VolumeView& after, const Picture& scan);
  ~BeforeView() override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void takeLook();

  QPointer<VolumeView> after_;  ///< null: the window goes, and it went first
};

}  // namespace ui
