// SPDX-License-Identifier: BSD-3-Clause
#include "app/window/touch/tool_controller.h"

#include <algorithm>
#include <initializer_list>

#include "datasets/readers/meshes/tool_mesh.h"
#include "haptics/smoothing.h"
#include "resources/named_tools.h"
#include "ui/panels/tool_list.h"
#include "ui/panels/tool_tiles.h"

namespace app {
namespace {

constexpr int kRestMs = 300;
constexpr const char* kTrilinear = "trilinear";
constexpr const char* kSpline = "spline";

/// Along the tool's axis, m.
double lengthOf(const haptics::TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const auto [low, high] = std::ranges::minmax_element(
      mesh.vertices, {}, [](const haptics::Vec3& vertex) { return vertex.z(); });
  return high->z() - low->z();
}

}  // namespace

ToolController::ToolController(ui::DevicePanel& panel, ui::SidePanel& panels, SharedState& shared)
    : panel_(panel), shared_(shared) {
  panels.add(&panel.details(), tr("Details"), {}, "touchDetails", ui::Tab::Touch, ui::Fold::Folded);
  QList<ui::ToolEntry> tools;
  for (const resources::NamedTool& tool : resources::namedTools())
    tools.append({.id = QString::fromStdString(tool.name),
                  .use = tr(tool.use.c_str()),
                  .title = tr(tool.title.c_str()),
                  .length = tool.length,
                  .tip = tool.tip,
                  .mesh = resources::namedToolMesh(tool.name).value()});
  panel.tools().setTools(tools);
  panel.tiles().setTools(tools);
  for (QWidget* one : std::initializer_list<QWidget*>{&panel.tools(), &panel.tiles()})
    one->setEnabled(false);  // the first scan brings a tool
  panel.setFields({{kTrilinear, tr("As scanned")}, {kSpline, tr("Smoothed")}});
  connect(&panel, &ui::DevicePanel::toolChosen, this,
          [this](const QString& id) { changeTool(toolNamed(id.toStdString())); });
  connect(&panel.tiles(), &ui::ToolTiles::toolChosen, this,
          [this](const QString& id) { chooseTile(id.toStdString()); });
  connect(&panel, &ui::DevicePanel::toolFileFound, this, &ToolController::askForUnit);
  connect(&panel, &ui::DevicePanel::toolFileChosen, this,
          [this](const QString& path, const QString& unit) {
            changeTool({.name = path.toStdString(),
                        .file = std::filesystem::path(path.toStdString()),
                        .unit = unit.toStdString()});
          });
  connect(&panel, &ui::DevicePanel::fieldChosen, this, &ToolController::changeField);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &ToolController::showField);
}

void ToolController::show() {
  coming_.clear();
  if (!shared_.shown) return;
  panel_.tools().setEnabled(true);
  panel_.tiles().setEnabled(true);
  const ToolSource& tool = shared_.shown->tool;
  const haptics::TriangleMesh& mesh = shared_.shown->scene->tool.mesh;
  const ui::ToolEntry entry{.id = QString::fromStdString(tool.name),
                            .use = tr("From a file"),
                            .title = labelOf(tool),
                            .length = lengthOf(mesh),
                            .mesh = mesh};
  panel_.tiles().showTool(entry);
  if (!tool.file && resources::findNamedTool(tool.name) != nullptr)
    panel_.tools().showTool(entry.id);
  else
    panel_.tools().showOther(entry);
  showField();
}

ToolSource ToolController::toolNamed(const std::string& name) const {
  if (shared_.shown && shared_.shown->tool.name == name) return shared_.shown->tool;
  return {.name = name};
}

void ToolController::chooseTile(const std::string& name) {
  if (!shared_.shown) return;
  // while another is prepared, the one in use is wanted back
  if (name != (coming_.empty() ? shared_.shown->tool.name : coming_)) changeTool(toolNamed(name));
}

void ToolController::changeTool(const ToolSource& tool) {
  if (!shared_.shown) return;
  coming_ = tool.name;
  emit wanted(requestWith(tool), tr("Preparing the tool"));
}

void ToolController::askForUnit(const QString& path) {
  sizer_.start(
      [path](const background::Watch&) -> haptics::Expected<std::array<double, 3>> {
        const auto tool = datasets::readToolMesh(path.toStdString(), datasets::MeshUnit::Metre);
        if (!tool) return tl::unexpected(tool.error());
        haptics::Vec3 least = tool->mesh.vertices.front(), most = least;
        for (const haptics::Vec3& v : tool->mesh.vertices) {
          least = least.cwiseMin(v);
          most = most.cwiseMax(v);
        }
        const haptics::Vec3 sides = most - least;
        return std::array<double, 3>{sides.x(), sides.y(), sides.z()};
      },
      [this, path](const haptics::Expected<std::array<double, 3>>& numbers) {
        // the question waits for the user: outside of what delivers the result
        if (numbers)
          return QTimer::singleShot(
              0, this, [this, path, sides = *numbers] { panel_.askForUnit(path, sides); });
        // loading it says why it cannot be read
        changeTool({.name = path.toStdString(), .file = std::filesystem::path(path.toStdString())});
      });
}

void ToolController::changeField(const QString& id) {
  shared_.options.field =
      id == kSpline ? haptics::FieldKind::CubicSpline : haptics::FieldKind::Trilinear;
  if (shared_.shown) emit wanted(requestWith(shared_.shown->tool), tr("Preparing the field"));
}

LoadRequest ToolController::requestWith(const ToolSource& tool) const {
  const Loaded& shown = *shared_.shown;
  return {.keep = std::make_shared<const Kept>(Kept{shown.volume(), shown.picture, shown.title,
                                                    shown.place, shown.greys, shown.identity}),
          .tool = tool,
          .isovalue = shared_.settings.isovalue};
}

void ToolController::showField() {
  if (!shared_.shown) return;
  if (shared_.shown->scene->field.kind() == haptics::FieldKind::Trilinear)
    return panel_.showField(kTrilinear, {});
  const haptics::SmoothingEffect effect =
      haptics::smoothingEffect(*shared_.shown->volume(), shared_.settings.isovalue);
  panel_.showField(
      kSpline, tr("Smoothing erases %L1 % of this solid and adds %L2 %: touch and picture differ.")
                   .arg(effect.erased * 100.0, 0, 'f', 1)
                   .arg(effect.gained * 100.0, 0, 'f', 1));
}

}  // namespace app
