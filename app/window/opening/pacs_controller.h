// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QObject>
#include <QProcess>
#include <functional>
#include <memory>

#include "ui/dialogs/pacs_window.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"

class QJsonObject;

namespace app {

/// The servers of the preferences, without secrets.
QList<ui::PacsServer> loadPacsServers();
void savePacsServers(const QList<ui::PacsServer>& servers);

/// Scans from a PACS: asks palpate-fetch, a program of its own, and opens what it brought. The
/// window itself opens no connection. GUI thread.
class PacsController : public QObject {
  Q_OBJECT
 public:
  /// `program`: palpate-fetch; empty: it is looked for (haptics::helperProgram).
  explicit PacsController(ui::Messages& messages, ui::Menus& menus, QString program = {});
  ~PacsController() override;

 signals:
  /// A folder of slices that was fetched, and what it is called. It stays until another is fetched,
  /// or to the end.
  void openWanted(const QString& folder, const QString& name);

 private:
  using Answer = std::function<void(const QJsonObject& answer)>;

  void open();
  void search();
  void fetch(int series);
  /// Starts the program for the chosen server; `input` goes to its standard input.
  void ask(const QString& command, const QJsonObject& input, const QStringList& options,
           const QString& what, Answer done);
  void read();
  void take(const QJsonObject& line);
  void end(const QString& sentence);
  /// Lets a program that has answered end by itself.
  void letGo(std::unique_ptr<QProcess> process);
  /// Ends the program, which removes its folder.
  static void release(std::unique_ptr<QProcess> process);

  ui::Messages& messages_;
  QString program_;
  ui::PacsWindow* shown_ = nullptr;  ///< the main window's; null before it is opened
  QList<ui::PacsServer> servers_;
  QList<QByteArray> checks_;                ///< of the series that were found
  ui::PacsQuery searched_;                  ///< what found them
  std::unique_ptr<QProcess> process_;       ///< what is asked now
  std::unique_ptr<QProcess> holds_folder_;  ///< what keeps the folder of the scan on view
  QByteArray heard_;
  Answer done_;
  bool answered_ = false, cancelled_ = false;
};

}  // namespace app
