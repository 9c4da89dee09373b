// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/letters.h"

#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>

#include "ui/props/orientation.h"
#include "ui/style/scene_colours.h"

namespace ui {

Letters::Letters(vtkRenderer* renderer) {
  for (std::size_t n = 0; n < actors_.size(); ++n) {
    actors_[n] = vtkSmartPointer<vtkTextActor>::New();
    vtkTextProperty* look = actors_[n]->GetTextProperty();
    look->SetFontSize(22);
    look->SetBold(1);
    look->SetColor(style::kFilmLetter[0], style::kFilmLetter[1], style::kFilmLetter[2]);
    const QColor& ground = style::kViewGround;
    look->SetBackgroundColor(ground.redF(), ground.greenF(), ground.blueF());
    look->SetBackgroundOpacity(1.0);
    look->SetJustificationToCentered();
    look->SetVerticalJustificationToCentered();
    if (n == 0) look->SetJustificationToLeft();
    if (n == 1) look->SetJustificationToRight();
    if (n == 2) look->SetVerticalJustificationToTop();
    if (n == 3) look->SetVerticalJustificationToBottom();
    renderer->AddActor2D(actors_[n]);
  }
  setVisible(false);
}

Letters::~Letters() = default;

void Letters::setVisible(bool visible) {
  for (const auto& actor : actors_) actor->SetVisibility(visible);
}

void Letters::show(const Eigen::Matrix3d& axes, int width, int height) {
  const std::array<QString, 4> letters = edgeLettersOf(axes);
  const int margin = std::min(width, height) / 45;
  for (std::size_t n = 0; n < letters.size(); ++n)
    actors_[n]->SetInput(letters[n].toUtf8().constData());
  actors_[0]->SetDisplayPosition(margin, height / 2);
  actors_[1]->SetDisplayPosition(width - margin, height / 2);
  actors_[2]->SetDisplayPosition(width / 2, height - margin);
  actors_[3]->SetDisplayPosition(width / 2, margin);
}

}  // namespace ui
