// SPDX-License-Identifier: BSD-3-Clause

// palpate-frames: the time of a picture of the ray-cast surface, beside VTK's own ray caster on the
// same voxels, camera and pixels. For machines with a graphics card.

#include <vtkOpenGLGPUVolumeRayCastMapper.h>

#include <QApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTemporaryDir>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/application.h"
#include "app/build_info/build_info.h"
#include "app/window/loader.h"
#include "app/window/session_recording.h"
#include "tests/bench/window.h"
#include "ui/main_window.h"
#include "ui/panels/device_panel.h"
#include "ui/volume_view.h"

namespace {

using bench::Clock;
using bench::median;
using bench::msSince;
using bench::waitFor;
using nlohmann::ordered_json;

constexpr int kWarm = 20;      // pictures before those that count
constexpr double kTurn = 1.5;  // degrees of the camera, for a picture

/// VTK's ray caster as it comes: one isosurface, shaded, no more.
class BareView : public ui::Viewport {
 public:
  explicit BareView(const ui::Picture& picture, double isovalue) {
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> caster;
    caster->SetInputData(picture.image);
    caster->SetBlendModeToIsoSurface();
    caster->SetAutoAdjustSampleDistances(0);
    caster->SetImageSampleDistance(1.0F);
    const haptics::Vec3 spacing = picture.volume->grid.spacing;
    caster->SetSampleDistance(static_cast<float>(spacing.minCoeff() * ui::kMmPerM));
    vtkNew<vtkVolume> volume;
    volume->SetMapper(caster);
    vtkNew<vtkMatrix4x4> X_WL;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        X_WL->SetElement(row, column, picture.X_WL_mm.matrix()(row, column));
    volume->SetUserMatrix(X_WL);
    vtkVolumeProperty* look = volume->GetProperty();
    look->GetIsoSurfaceValues()->SetValue(0, isovalue);
    look->SetInterpolationTypeToLinear();
    look->ShadeOn();
    vtkNew<vtkColorTransferFunction> colour;
    colour->AddRGBPoint(isovalue, 0.9, 0.85, 0.75);
    look->SetColor(colour);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(isovalue, 1.0);
    look->SetScalarOpacity(opacity);
    renderer_->AddVolume(volume);
    renderWindow()->AddRenderer(renderer_);
  }
  void look(vtkCamera* camera) {
    renderer_->GetActiveCamera()->DeepCopy(camera);
    renderer_->ResetCameraClippingRange();
  }

 private:
  vtkNew<vtkRenderer> renderer_;
};

/// Draws the view once and waits for the graphics card, ms.
double drawn(ui::Viewport& view) {
  const auto begun = Clock::now();
  view.redraw();
  view.repaint();
  view.makeCurrent();
  view.context()->functions()->glFinish();
  view.doneCurrent();
  return msSince(begun);
}

/// Both views in turn, the camera a little farther round for each pair.
ordered_json measured(const char* what, app::Application& application, BareView& bare,
                      int pictures) {
  ui::VolumeView& view = application.window().view();
  std::vector<double> ours, theirs, ratios;
  for (int n = -kWarm; n < pictures; ++n) {
    QCoreApplication::processEvents();  // the newest snapshot
    view.camera()->Azimuth(kTurn);
    bare.look(view.camera());
    // who begins changes, so that neither profits from the other
    const bool first = n % 2 == 0;
    const double before = first ? 0.0 : drawn(bare);
    const double mine = drawn(view);
    const double other = first ? drawn(bare) : before;
    if (n < 0) continue;
    ours.push_back(mine);
    theirs.push_back(other);
    ratios.push_back(mine / other);
  }
  std::printf("  %-12s %8.2f ms, VTK's ray caster alone %8.2f ms, ratio %.3f\n", what, median(ours),
              median(theirs), median(ratios));
  return {{"of", what},
          {"palpate_ms", median(ours)},
          {"vtk_ms", median(theirs)},
          {"ratio", median(ratios)}};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"The time of a picture of the ray-cast surface, beside VTK's own ray caster."};
  std::string path, size = "2560x1440", out;
  double isovalue = 0.0;
  int pictures = 200;
  cli.add_option("scan", path, "A scan; without one the demo skull");
  auto* isovalue_given = cli.add_option("--isovalue", isovalue, "Isovalue of the surface");
  cli.add_option("--size", size, "Pixels of the view")->check([](const std::string& text) {
    int width = 0, height = 0, end = 0;
    const bool read = std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &end) == 2;
    return read && std::size_t(end) == text.size() && width >= 64 && height >= 64
               ? std::string()
               : "a size is written as 2560x1440";
  });
  cli.add_option("--pictures", pictures, "Pictures that count")->check(CLI::Range(5, 10'000));
  cli.add_option("--out", out, "JSON, besides what is printed");
  CLI11_PARSE(cli, argc, argv);
  int width = 0, height = 0;
  std::sscanf(size.c_str(), "%dx%d", &width, &height);

  ui::Viewport::prepareApplication();
  int qt_argc = 1;
  QApplication qt(qt_argc, argv);
  const QTemporaryDir home;
  app::Arguments arguments = bench::unattended(home);
  if (path.empty())
    arguments.load.phantom = "demo";
  else
    arguments.load.path = path;
  if (*isovalue_given) arguments.load.isovalue = isovalue;
  arguments.surface = ui::SurfaceMode::RayCast;
  app::Application application(std::move(arguments));
  application.start();
  if (!waitFor([&] { return application.snapshot().scene != 0; })) {
    std::fprintf(stderr, "The scan was not opened within two minutes.\n");
    return 4;
  }
  ui::VolumeView& view = application.window().view();
  // pixels, whatever the scale of the screen
  const double scale = view.devicePixelRatioF();
  const QSize wanted(qRound(width / scale), qRound(height / scale));
  ui::MainWindow& window = application.window();
  window.views().arrange(ui::Arrangement::One);
  for (int n = 0; n < 2; ++n) {  // the panels may take what is left over
    window.resize(window.size() + wanted - view.size());
    waitFor([&] { return view.size() == wanted; }, 1.0);
  }
  BareView bare(application.shown()->picture, application.snapshot().isovalue);
  bare.resize(wanted);
  bare.show();
  waitFor([&] { return view.graphics() && bare.graphics() && view.frames() > 0; });
  std::printf("%s, %s, %d x %d pixels, %d pictures\n",
              path.empty() ? "demo skull" : std::filesystem::path(path).filename().c_str(),
              qPrintable(view.graphics()->renderer), qRound(view.width() * scale),
              qRound(view.height() * scale), pictures);

  ordered_json rows = ordered_json::array();
  rows.push_back(measured("picture", application, bare, pictures));
  emit application.window().findChild<ui::DevicePanel*>()->handChosen("slide");
  rows.push_back(measured("proxy", application, bare, pictures));
  const bool records = application.recording().start(application.shown()->scene, "").has_value();
  if (records) rows.push_back(measured("recording", application, bare, pictures));
  if (!out.empty())
    std::ofstream(out)
        << ordered_json{{"machine", app::machineHere()},
                        {"version", app::versionHere()},
                        {"renderer", view.graphics()->renderer.toStdString()},
                        {"of", path.empty() ? std::string("demo")
                                            : std::filesystem::path(path).filename().string()},
                        {"pixels", {qRound(view.width() * scale), qRound(view.height() * scale)}},
                        {"pictures", pictures},
                        {"rows", rows}}
               .dump(2)
        << '\n';
  return records ? 0 : 4;
}
