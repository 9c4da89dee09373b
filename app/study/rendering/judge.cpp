// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/rendering/judge.h"

#include <algorithm>
#include <cmath>

#include "app/study/accuracy/work_precision.h"
#include "app/study/comparison/measures.h"

namespace study {
namespace {

using comparison::median;

std::string settingOf(const Drawn& drawn) {
  if (!(drawn.sample_distance > 0.0)) return "";
  return shortly(drawn.sample_distance) + " voxels";
}

/// An error of each view.
template <class Measure>
std::vector<double> errorsOf(const Drawn& drawn, const Reference& reference, Measure&& measure) {
  std::vector<double> errors;
  for (std::size_t n = 0; n < reference.views.size(); ++n)
    errors.push_back(n < drawn.views.size() ? measure(drawn.views[n].image, reference.views[n])
                                            : NAN);
  return errors;
}

std::vector<std::string> backEndsOf(const std::vector<Drawn>& drawn) {
  std::vector<std::string> names;
  for (const Drawn& d : drawn)
    if (std::ranges::find(names, d.back_end) == names.end()) names.push_back(d.back_end);
  return names;
}

/// Middle of what is shown, pixels.
Eigen::Vector2d centroid(const Image& image) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.shows(x, y)) sum += Eigen::Vector2d{x, y};
  return sum / image.shown();
}

}  // namespace

Outcome judged(const std::string& scene, const Reference& reference,
               const std::vector<Drawn>& drawn) {
  Outcome outcome;
  const std::string against = scene + " against " + reference.name;
  accuracy::WorkPrecision squares{
      against + ": root mean square error",
      "A point is a sample distance; its errors are those of the views, its "
      "times those of all their frames.",
      "frame time [ms]", "RMSE [grey levels]"};
  accuracy::WorkPrecision structure{against + ": structure", squares.description,
                                    squares.cost_label, "1 - SSIM"};
  for (const Drawn& d : drawn) {
    std::vector<double> times;
    for (const Shot& shot : d.views)
      times.insert(times.end(), shot.frames_ms.begin(), shot.frames_ms.end());
    squares.points.push_back({d.back_end, settingOf(d), times, errorsOf(d, reference, rmse)});
    structure.points.push_back(
        {d.back_end, settingOf(d), times,
         errorsOf(d, reference, [](const Image& a, const Image& b) { return 1.0 - ssim(a, b); })});
  }
  accuracy::addTo(outcome, squares);
  accuracy::addTo(outcome, structure);

  for (const std::string& back_end : backEndsOf(drawn)) {
    double least_shown = INFINITY, greatest_rise = 0.0, before = INFINITY;
    int distances = 0;
    for (const Drawn& d : drawn) {
      if (d.back_end != back_end) continue;
      for (const double shown : errorsOf(d, reference, [](const Image&a, const Image&b) {
             return double(a.shown()) / b.shown();
           }))
        least_shown = std::isnan(shown) ? NAN : std::min(least_shown, shown);
      const double error = median(errorsOf(d, reference, rmse));
      if (distances++ > 0) greatest_rise = worse(greatest_rise, error - before);
      before = error;
    }
    outcome.cases.push_back({against + ": " + back_end + " shows the object", least_shown, 0.5, "",
                             Case::Sense::AtLeast,
                             "Pixels that show it, of those of the reference; the least of all "
                             "settings and views."});
    if (distances > 1)
      outcome.cases.push_back(
          {against + ": " + back_end + ", rise of the error with a shorter sample distance",
           greatest_rise, 0.5, "grey levels", Case::Sense::AtMost,
           "Of the views' median, from one sample distance to the next. Half a grey level is what "
           "rounding may do."});
  }
  return outcome;
}

Outcome convergence(const std::string& scene, const std::string& refined, const std::string& coarse,
                    const std::vector<Drawn>& drawn) {
  std::vector<double> distances, differences;
  for (const Drawn& d : drawn) {
    if (d.back_end != coarse) continue;
    Reference same_rays{refined};
    for (const Drawn& r : drawn)
      if (r.back_end == refined && r.sample_distance == d.sample_distance)
        for (const Shot& view : r.views) same_rays.views.push_back(view.image);
    distances.push_back(d.sample_distance);
    differences.push_back(median(errorsOf(d, same_rays, rmse)));
  }
  Outcome outcome;
  if (distances.empty()) distances = differences = {NAN};
  const double finer = distances.back() / distances.front();
  outcome.cases.push_back(
      {scene + ": what the refinement of hits corrects, at the shortest sample distance over the "
               "longest",
       differences.back() / differences.front(), 1.5 * finer, "", Case::Sense::AtMost,
       "An unrefined hit lies half a sample behind the surface in the mean, so what it is off by "
       "goes with the sample distance, here " +
           shortly(finer) + " of the longest; half as much again is allowed."});
  return outcome;
}

Outcome silhouettes(const SphereScene& scene, const std::vector<Drawn>& drawn) {
  Outcome outcome;
  for (const Drawn& d : drawn) {
    double off_mm = 0.0, shift = 0.0;
    if (d.views.size() != scene.cameras.size()) off_mm = shift = NAN;
    for (std::size_t n = 0; n < d.views.size() && n < scene.cameras.size(); ++n) {
      const Image& image = d.views[n].image;
      const Image meant = imageOf(scene.sphere, {}, scene.cameras[n], image.width);
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
          const double clearance = clearance_mm(scene.sphere, scene.cameras[n], image.width, x, y);
          if (image.shows(x, y) != (clearance < 0.0)) off_mm = worse(off_mm, std::abs(clearance));
        }
      shift = worse(shift, (centroid(image) - centroid(meant)).norm());
    }
    const std::string what =
        "Sphere: " + d.back_end + (settingOf(d).empty() ? "" : " at " + settingOf(d));
    outcome.cases.push_back(
        {what + ", silhouette off the formula's", off_mm / scene.voxel_mm, 0.05, "voxels",
         Case::Sense::AtMost,
         "The farthest pixel on the wrong side of the outline. With a radius of 18 voxels "
         "trilinear interpolation sinks by 0.014, and a chord shorter than a voxel is 0.007 deep: "
         "twice their sum."});
    outcome.cases.push_back({what + ", left is left: middle off the formula's", shift, 0.5,
                             "pixels", Case::Sense::AtMost,
                             "The sphere stands beside the middle of the picture, so that a "
                             "mirrored one is far off."});
  }
  return outcome;
}

Outcome agreement(const Reference& formula, const Reference& finest) {
  double difference = 0.0, structure = INFINITY;
  for (std::size_t n = 0; n < formula.views.size(); ++n) {
    difference = worse(difference, rmse(formula.views[n], finest.views.at(n)));
    const double similarity = ssim(formula.views[n], finest.views.at(n));
    structure = std::isnan(similarity) ? NAN : std::min(structure, similarity);
  }
  Outcome outcome;
  outcome.cases.push_back(
      {"Sphere: the two references agree, RMSE", difference, 3.0, "grey levels",
       Case::Sense::AtMost,
       "The rim alone makes 1.2: it is dark, 33 grey levels over none, and a silhouette that sinks "
       "by 0.014 voxels loses a thousandth of the pixels."});
  outcome.cases.push_back({"Sphere: the two references agree, SSIM", structure, 0.98, "",
                           Case::Sense::AtLeast, "The least of the views."});
  return outcome;
}

}  // namespace study
