// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>

namespace datasets {

/// Takes the errors and warnings of a VTK object, so that they are counted and not printed:
/// their texts name files and are not for the user.
class VtkErrors : public vtkCommand {
 public:
  static VtkErrors* New() { return new VtkErrors; }
  void Execute(vtkObject*, unsigned long event, void*) override {
    if (event == vtkCommand::ErrorEvent) ++errors_;
  }
  void watch(vtkObject* object) {
    object->AddObserver(vtkCommand::ErrorEvent, this);
    object->AddObserver(vtkCommand::WarningEvent, this);
  }
  int errors() const { return errors_; }
  void forget() { errors_ = 0; }

 private:
  int errors_ = 0;
};

}  // namespace datasets
