// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "app/study/report/outcome.h"
#include "datasets/phantoms/making.h"
#include "haptics/field/scalar_field.h"

/// How far each field is from what was scanned: solids whose edge is blurred over three voxels,
/// with noise or without, and thin plates.
namespace study::accuracy {

/// How voxels become a field.
enum class Interpolation { Trilinear, SplineApproximating, SplineInterpolating };
const char* nameOf(Interpolation kind);
/// The interpolating spline's coefficients come from the recursive filter of [Unser 1999].
haptics::ScalarField fieldOf(Interpolation kind, const haptics::Volume& volume);

/// A solid by its distance in voxels, negative inside, at least to first order at the surface.
struct Shape {
  std::string name;
  std::function<double(const haptics::Vec3&)> distance;
};
/// A ball of 12, a ring of 22 and 7, and a gyroid of 24 voxels; voxels of 1 mm.
const std::vector<Shape>& shapes();
/// The shape with its edge blurred over three voxels, and noise of so much of the step.
haptics::Volume blurred(const Shape& shape, double noise);

/// Errors of a field at places on the surface, one for each place.
struct SurfaceErrors {
  std::vector<double> position;                             ///< voxels
  std::vector<double> cell, central, spline;                ///< of the normals, degrees
  double value_ns = 0.0;                                    ///< of looking F up
  double cell_ns = 0.0, central_ns = 0.0, spline_ns = 0.0;  ///< of a gradient, F included
};
SurfaceErrors surfaceErrors(const haptics::ScalarField& field, const Shape& shape, int places,
                            datasets::Random& random);

/// The share of a plate of this thickness [voxels] at which each field, in the order of
/// Interpolation, still has a surface, over plates that lie at random, each with so many places.
std::array<double, 3> keptOfPlates(double thickness, int plates, int places,
                                   datasets::Random& random);

/// Makes a field of voxels; a test may plant a wrong one.
using FieldMade = std::function<haptics::ScalarField(Interpolation, const haptics::Volume&)>;
/// Position and normals of every field and normal on the shapes, against time.
Outcome fieldErrors(double noise, int places, unsigned seed, const FieldMade& made = fieldOf);
/// What is left of thin plates.
Outcome plateErrors(int plates, int places, unsigned seed);

}  // namespace study::accuracy
