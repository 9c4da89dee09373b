// SPDX-License-Identifier: BSD-3-Clause
#include "ui/props/letters.h"

#include <vtkBillboardTextActor3D.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <cmath>

#include "ui/style/scene_colours.h"

namespace ui {
namespace {

constexpr char kLetters[] = "LRPASI";  // towards +x, -x, +y, -y, +z, -z of patient LPS

}  // namespace

Letters::Letters(vtkRenderer* renderer) {
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    auto actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    const char text[2] = {kLetters[i], '\0'};
    actor->SetInput(text);
    vtkTextProperty* look = actor->GetTextProperty();
    look->SetFontSize(22);
    look->SetBold(1);
    look->SetColor(style::kFilmLetter[0], style::kFilmLetter[1], style::kFilmLetter[2]);
    look->SetJustificationToCentered();
    look->SetVerticalJustificationToCentered();
    actor->VisibilityOff();
    renderer->AddActor(actor);
    actors_[i] = actor;
  }
}

Letters::~Letters() = default;

void Letters::place(const Eigen::AlignedBox3d& box_mm) {
  const Eigen::Vector3d centre = box_mm.center();
  const double room = 0.06 * box_mm.diagonal().norm();
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i / 2);
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    Eigen::Vector3d p = centre;
    p[axis] += side * (0.5 * box_mm.sizes()[axis] + room);
    actors_[i]->SetPosition(p.data());
  }
}

void Letters::face(const Eigen::Vector3d& view_direction) {
  for (std::size_t i = 0; i < actors_.size(); ++i) {
    const double along = std::abs(view_direction[static_cast<Eigen::Index>(i / 2)]);
    actors_[i]->SetVisibility(visible_ && along < 0.93);
  }
}

Eigen::Vector3d Letters::positionOf(char letter) const {
  for (std::size_t i = 0; i < actors_.size(); ++i)
    if (kLetters[i] == letter) return Eigen::Vector3d{actors_[i]->GetPosition()};
  return Eigen::Vector3d::Zero();
}

}  // namespace ui
