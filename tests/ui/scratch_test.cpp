#include <gtest/gtest.h>
#include <QElapsedTimer>
#include <QTest>
#include <cstdio>
#include <filesystem>
#include "datasets/readers/volume_reader.h"
#include "app/window/touched_surface.h"
#include "haptics/scene/scene.h"
#include "resources/named_tools.h"
#include "window_support.h"
namespace {
using haptics::Vec3;
std::shared_ptr<const haptics::Volume> load(const char* name) {
  auto v = datasets::readVolume(std::filesystem::path(PALPATE_SCANS) / name);
  return v ? std::make_shared<const haptics::Volume>(std::move(*v)) : nullptr;
}
void rate(ui::VolumeView& view, const char* what) {
  QElapsedTimer t; t.start(); const int f0 = view.frames();
  for (int i = 0; i < 20; ++i) {
    QTest::mousePress(&view, Qt::LeftButton, {}, {20, 300});
    QMouseEvent m(QEvent::MouseMove, QPointF(24, 300), view.mapToGlobal(QPointF(24,300)), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&view, &m);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {24, 300});
    const int f = view.frames();
    while (view.frames() == f && t.elapsed() < 60000) QCoreApplication::processEvents();
  }
  std::printf("%s: %.1f ms a picture (%d pictures)\n", what, double(t.elapsed()) / (view.frames() - f0), view.frames() - f0);
  const int f1 = view.frames(); t.restart();
  for (int i = 0; i < 20; ++i) {
    haptics::Snapshot s; s.X_WP.translation() = Vec3(0.001 * i, -0.1, 0); s.X_WD = s.X_WP;
    view.display(s);
    const int f = view.frames();
    while (view.frames() == f && t.elapsed() < 60000) QCoreApplication::processEvents();
  }
  std::printf("%s, tool alone: %.1f ms (%d)\n", what, double(t.elapsed()) / (view.frames() - f1), view.frames() - f1);
}
TEST(Scratch, Bunny) {
  const auto v = load("stanford_bunny/bunny_512x512x361_airflat.nrrd");
  if (!v) GTEST_SKIP();
  const auto p = ui::pictureOf(v);
  std::printf("unit '%s' %g..%g known %d\n", v->unit.c_str(), v->least, v->greatest, v->orientation_known);
  ui::VolumeView view; view.setSurfaceWish(ui::SurfaceMode::Mesh);
  window::showAndWait(view, {800, 600});
  const double iso = ui::isovalueOf(ui::Tissue::Skin, p);
  std::printf("skin %g bone %g\n", iso, ui::isovalueOf(ui::Tissue::Bone, p));
  view.show(p, iso);
  view.show(*resources::namedToolMesh("drill"));
  view.setMouseHand(true);
  rate(view, "bunny, one surface");
  window::keep(window::pictureAtRest(view), "s_bunny");
  view.setColouring(ui::Colouring::byTissue(p));
  view.setIsovalue(ui::isovalueOf(ui::Tissue::Bone, p));
  view.setSecondSurface(iso);
  rate(view, "bunny, with veil");
  window::keep(window::pictureAtRest(view), "s_bunny_veil");
}
TEST(Scratch, Head) {
  const auto v = load("visible_human_female_head/vhf_head_512x512x234.nrrd");
  if (!v) GTEST_SKIP();
  const auto p = ui::pictureOf(v);
  std::printf("unit '%s' known %d\n", v->unit.c_str(), v->orientation_known);
  auto tool = *haptics::makeTool("drill", *resources::namedToolMesh("drill"));
  auto scene = haptics::makeScene(v, tool);
  for (const auto mode : {ui::SurfaceMode::Mesh, ui::SurfaceMode::RayCast}) {
    const std::string tag = mode == ui::SurfaceMode::Mesh ? "mesh" : "cast";
    ui::VolumeView view; view.setSurfaceWish(mode);
    window::showAndWait(view, {700, 600});
    view.show(p, 300.0);
    view.setTouched(app::touchedSurfaceOf(*scene));
    view.show(tool.mesh);
    view.setMouseHand(true);
    view.setColouring(ui::Colouring::byTissue(p));
    haptics::Snapshot s;
    const auto box = view.surface().bounds_mm();
    s.X_WP.translation() = Vec3(box.center().x() * 1e-3 + 0.02, box.min().y() * 1e-3 - 0.01, box.center().z() * 1e-3);
    s.X_WD = s.X_WP; s.X_WD.translation().y() += 0.004;
    s.contacts = 2; 
    for (int i = 0; i < 2; ++i) { const Vec3 q = s.X_WP.translation() + Vec3(0.004 * i, 0.002, 0.0); s.places[i] = {{float(q.x()), float(q.y()), float(q.z())}, 1.0F}; }
    s.felt_W.force = Vec3(0.5, -2.0, 1.0);
    view.display(s);
    view.showContacts(true);
    if (mode == ui::SurfaceMode::Mesh) { view.showFine(ui::isosurfaceMesh(p.image, 300.0, p.mirrored()), 300.0); }
    window::keep(window::pictureAtRest(view), ("s_head_bone_" + tag).c_str());
    if (mode == ui::SurfaceMode::RayCast) { view.surface().setOcclusion(true); view.redraw(); window::keep(window::pictureAtRest(view), "s_head_ao"); view.surface().setOcclusion(false);}
    view.setSecondSurface(-300.0);
    view.resetCamera();
    if (mode == ui::SurfaceMode::Mesh) rate(view, "head, veil");
    view.resetCamera(); view.display(s);
    window::keep(window::pictureAtRest(view), ("s_head_veil_" + tag).c_str());
    if (mode == ui::SurfaceMode::Mesh) {
      for (const ui::Side side : ui::kSides) { view.lookFrom(side); window::keep(window::pictureAtRest(view), ("s_head_" + ui::letterOf(side).toStdString()).c_str()); }
      view.camera()->Azimuth(30); view.camera()->Elevation(20); view.camera()->OrthogonalizeViewUp(); view.setParallel(true);
      view.setSecondSurface({});
      view.setIsovalue(-300.0);
      window::keep(window::pictureAtRest(view), "s_head_skin_oblique_parallel");
      view.setParallel(false);
      view.lookAlongTool();
      window::keep(window::pictureAtRest(view), "s_head_along");
    }
    auto crop = std::make_shared<haptics::Volume>(*v);
    crop->crop = haptics::VoxelBox{{0, 0, 0}, {250, 512, 170}};
    view.setIsovalue(300.0);
    QElapsedTimer t; t.start();
    const auto cp = ui::pictureOf(crop);
    const auto made = t.elapsed();
    view.replace(cp);
    view.resetCamera(); view.camera()->Azimuth(40); view.camera()->Elevation(25); view.camera()->OrthogonalizeViewUp();
    window::keep(window::pictureAtRest(view), ("s_head_crop_" + tag).c_str());
    std::printf("crop picture %lld ms\n", (long long)made);
  }
}
}
