// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

class QMainWindow;
class QPushButton;
class QVBoxLayout;
class QWidget;

namespace ui {

class Banner;

/// What becomes of what is in no file.
enum class Unsaved { Save, Discard, Cancel };
/// What becomes of a file that is still being written.
enum class Unfinished { Finish, Stop, Cancel };
/// What a file is opened as.
enum class OpenedAs { Structures, Scan, Cancel };

/// Sentences above the views, each in a bar of its own kind, and questions that the user answers
/// before anything else. GUI thread.
class Messages : public QObject {
  Q_OBJECT
 public:
  explicit Messages(QMainWindow& window);

  /// Puts the bars into a column.
  void placeIn(QVBoxLayout& column);
  /// The window, for dialogs.
  QWidget* window();
  /// Shows a sentence until the user closes it, or until clear().
  void showMessage(const QString& sentence);
  /// Hides what showMessage() or showDone() shows.
  void clear();
  /// Shows a sentence in the status bar for some time [ms].
  void showBriefly(const QString& sentence, int ms);
  /// Shows in place of a message that something was written, with a button for its folder.
  void showDone(const QString& sentence, const QString& folder);
  /// Shows a sentence in a bar of its own, with a button that hides the bar and calls `take`.
  void showOffer(const QString& sentence, const QString& button, std::function<void()> take);
  void hideOffer();
  /// Shows in a bar of its own that work was kept: one button goes on with it, one drops it; each
  /// hides the bar.
  void showWork(const QString& sentence, const QString& button, std::function<void()> take,
                std::function<void()> drop);
  void hideWork();
  /// Shows a sentence in a separate bar, which only the user closes.
  void showFault(const QString& sentence);
  /// Names the place in the help that explains a sentence; empty: none. Where it names one, the bar
  /// with the sentence has the button "More".
  using Explainer = std::function<QString(const QString& sentence)>;
  void setExplainer(Explainer explainer) { explainer_ = std::move(explainer); }

  /// Asks whether to go on. Enter means Cancel. True if the user agrees.
  bool askWhether(const QString& what, const QString& consequence, const QString& yes);
  /// Asks what becomes of what is in no file. Enter means Cancel.
  Unsaved askToSave(const QString& what, const QString& consequence);
  /// Asks what becomes of a file that is being written. Enter means Cancel.
  Unfinished askToFinish();
  /// Asks whether a file has structures of the scan on view, or is a scan. Enter means Cancel.
  OpenedAs askHowToOpen(const QString& name);
  /// Asks whether a file's x points to the patient's left, true, or to the right; none: Cancel,
  /// which Enter means. `why`: a sentence.
  std::optional<bool> askIfLeft(const QString& why);
  /// Shows the safety notice, and returns when it was read.
  void showNotice();

 signals:
  /// The user wants to read the place of the help that explains a sentence.
  void helpWanted(const QString& place);
  /// The user wants to see this folder in a program for folders.
  void folderWanted(const QString& folder);

 private:
  /// Gives a bar with a sentence the button "More", for as long as the help explains it.
  void explain(QPushButton& more, const QString& sentence);

  QMainWindow& window_;
  Banner* fault_;
  Banner* message_;
  Banner* done_;
  Banner* offer_;
  Banner* work_;
  QPushButton* more_of_fault_;
  QPushButton* more_of_message_;
  QPushButton* take_offer_;
  QPushButton* take_work_;
  Explainer explainer_;
  QString done_folder_;  ///< of what done_ tells
  std::function<void()> offered_;
  std::function<void()> work_taken_, work_dropped_;
};

/// A name that was chosen to write to, with this ending (".stl"). If it had another, the file
/// dialog asked about another file: the user is asked whether to write over the one that is there.
/// None: not.
std::optional<QString> withEnding(Messages& messages, QString path, const QString& ending);

/// The safety notice that every user must read once.
QString noticeText();

}  // namespace ui
