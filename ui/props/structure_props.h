// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>
#include <vector>

#include "ui/props/structures.h"

class vtkActor;
class vtkCamera;
class vtkPolyData;
class vtkRenderer;

namespace ui {

/// The structures in 3-D: each as a surface, and flat for the outlines that are seen through bone
/// (ThroughPass).
///
/// A surface that is not opaque is a screen of dots: it has a depth like any other, so nothing must
/// be sorted, and the ray caster, which reads depth alone, draws bone before and behind it.
class StructureProps {
 public:
  /// `surfaces`: also holds the isosurface; `outlines`: has a ThroughPass.
  StructureProps(vtkRenderer& surfaces, vtkRenderer& outlines);
  ~StructureProps();

  /// Other structures than before have no shape yet.
  void show(const Structures& shown);
  void showShape(std::size_t number, vtkPolyData* mesh);
  /// Brings the surfaces nearer to the camera by what a voxel's place is off, in a picture that is
  /// the same otherwise: where a structure and the scan have the same surface, that of the
  /// structure is seen, not stripes of both.
  void bringForward(vtkCamera& camera);
  const Structures& shown() const { return shown_; }

 private:
  struct Prop {
    vtkSmartPointer<vtkActor> surface, flat;
  };
  void look(std::size_t number);

  vtkRenderer& surfaces_;
  vtkRenderer& outlines_;
  Structures shown_;
  std::vector<Prop> props_;  ///< by number; both null until there is a shape
};

}  // namespace ui
