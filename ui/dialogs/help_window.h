// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStringList>
#include <QTextBrowser>
#include <QWidget>
#include <string_view>

class QLineEdit;
class QListWidget;
class QToolButton;

namespace ui {

/// The page of the help for the part of a window in which `widget` is, such as "isovalue"; "index"
/// where a part has none. `widget` may be null.
QString helpPageOf(const QWidget* widget);

/// The entry of a reason (haptics::Error::reason) on the page of messages; empty if it has none.
QString helpPlaceOf(std::string_view reason);

/// The names of all pages, in the order of the contents.
QStringList helpPages();

/// Shows one page of resources/help, in the window's language where there is one. A place is a
/// page, and behind a "#" its English heading in small letters with hyphens.
class HelpPage : public QTextBrowser {
  Q_OBJECT
 public:
  explicit HelpPage(QWidget* parent = nullptr);
  /// False if there is no such page, or no such place on it; then the page is shown from its top.
  bool open(const QString& place);
  QString page() const;
  QVariant loadResource(int type, const QUrl& name) override;

 protected:
  void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;

 private:
  bool goTo(const QString& anchor);
  bool found_ = true;
};

/// The help: contents with a search at the left, a page at the right, back and forward above. Not
/// modal; the touch goes on. Escape closes it.
class HelpWindow : public QWidget {
  Q_OBJECT
 public:
  explicit HelpWindow(QWidget* parent = nullptr);
  /// Shows the window at a place, as in HelpPage.
  void open(const QString& place);
  HelpPage& page() { return *page_; }

 private:
  /// Lists the pages that have all words that are searched.
  void search();
  void markFound();
  void showWhere();

  QToolButton* back_;
  QToolButton* forward_;
  QLineEdit* search_;
  QListWidget* contents_;
  HelpPage* page_;
};

}  // namespace ui
