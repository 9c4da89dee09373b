// SPDX-License-Identifier: BSD-3-Clause
// The part of the application that is told what to open, and remembers where it was.
#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/application.h"
#include "app/recent_places.h"

namespace app {

void Application::connectOpening() {
  connect(&window_, &ui::MainWindow::openWanted, this, &Application::open);
  connect(&window_, &ui::MainWindow::dropped, this, &Application::openDropped);
  connect(&window_, &ui::MainWindow::recentPlacesSought, this, &Application::showPlaces);
  connect(&window_, &ui::MainWindow::rememberPlacesChanged, this, [this](bool remember) {
    preferences_.places_remembered = remember;
    forgetPlaces();
  });
  connect(&window_, &ui::MainWindow::forgetPlacesWanted, this, &Application::forgetPlaces);
  showPlaces();
}

void Application::open(const QString& path) {
  if (path.endsWith(".palpate")) return openRecording(path.toStdString());
  load({.path = std::filesystem::path(path.toStdString())}, tr("Reading"));
}

void Application::openDropped(const QStringList& paths) {
  if (paths.size() == 1) return open(paths.first());
  // the slices of a series, say, with whatever lies between them: their folder lists them all
  const QString folder = QFileInfo(paths.first()).absolutePath();
  if (std::ranges::all_of(paths, [&](const QString& path) {
        const QFileInfo file(path);
        return file.isFile() && file.absolutePath() == folder;
      }))
    return open(folder);
  open(paths.first());
  window_.showMessage(
      tr("%1 things were dropped that are not files of one folder: only the first, \"%2\", is "
         "opened; drop the folder that holds them all to choose among its series.")
          .arg(paths.size())
          .arg(QDir(paths.first()).dirName()));
}

void Application::keepPlace(const std::filesystem::path& place) {
  if (place.empty() || !preferences_.places_remembered) return;
  preferences_.places = withPlace(preferences_.places, QString::fromStdString(place.string()));
  remember();
}

void Application::forgetPlaces() {
  preferences_.places.clear();
  remember();
}

void Application::showPlaces() {
  QList<ui::Place> places;
  for (const QString& path : preferences_.places)
    places.append({.path = path, .exists = QFileInfo::exists(path)});
  window_.setRecentPlaces(places, preferences_.places_remembered);
}

}  // namespace app
