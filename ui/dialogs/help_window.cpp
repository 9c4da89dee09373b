// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/help_window.h"

#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "ui/controls/language.h"

namespace ui {
namespace {

constexpr int kPlace = Qt::UserRole;

/// The part of a window, by its object's name, and its page.
constexpr std::pair<const char*, const char*> kPages[] = {{"surfaceSection", "isovalue"},
                                                          {"toolSection", "tools"},
                                                          {"performanceSection", "performance"},
                                                          {"editSection", "edits"},
                                                          {"cutSection", "cutting"},
                                                          {"marksSection", "measures"},
                                                          {"structuresSection", "structures"},
                                                          {"deviceSection", "devices"},
                                                          {"recordingSection", "recording"},
                                                          {"replayBar", "recording"},
                                                          {"startPage", "first-touch"},
                                                          {"views", "views"},
                                                          {"preferencesWindow", "preferences"},
                                                          {"series", "opening"}};

QString contentOf(const QString& file_name) {
  QFile file(file_name);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
}

QString englishOf(const QString& page) {
  return contentOf(QStringLiteral(":/help/%1.md").arg(page));
}

/// A page in the language of the window; empty if it is in English alone.
QString translatedOf(const QString& page) {
  return contentOf(QStringLiteral(":/help/%1/%2.md").arg(language(), page));
}

QString textOf(const QString& page) {
  const QString translated = translatedOf(page);
  return translated.isEmpty() ? englishOf(page) : translated;
}

QString titleOf(const QString& page) { return textOf(page).section('\n', 0, 0).mid(2); }

QUrl urlOf(const QString& place) {
  QUrl url(QStringLiteral("qrc:/help/%1.md").arg(place.section('#', 0, 0)));
  if (place.contains('#')) url.setFragment(place.section('#', 1));
  return url;
}

/// A heading as links name it.
QString anchorOf(const QString& heading) {
  static const QRegularExpression other(QStringLiteral("[^\\w\\- ]"),
                                        QRegularExpression::UseUnicodePropertiesOption);
  return heading.toLower().remove(other).replace(' ', '-');
}

/// The number of the heading that links name so, from 0; -1: there is none. Links name the English
/// headings, and a translated page has as many, in their order.
int headingOf(const QString& page, const QString& anchor) {
  int number = 0;
  for (const QString& line : englishOf(page).split('\n')) {
    const qsizetype text = line.indexOf(QLatin1String("# "));
    if (text < 0 || line.left(text).count('#') != text) continue;
    if (anchorOf(line.mid(text + 2).remove('`')) == anchor) return number;
    ++number;
  }
  return -1;
}

/// How well a page answers these words: 0 where one of them is not there at all, more for each that
/// stands as a word by itself, in a heading, or in the title.
int fitOf(const QStringList& words, const QString& text) {
  int fit = 1;
  for (const QString& word : words) {
    if (!text.contains(word, Qt::CaseInsensitive)) return 0;
    const QString alone = QStringLiteral("\\b%1\\b").arg(QRegularExpression::escape(word));
    for (const auto& [where, weight] :
         {std::pair{QStringLiteral(""), 1}, std::pair{QStringLiteral("^#.*"), 2},
          std::pair{QStringLiteral("\\A# .*"), 4}})
      if (text.contains(QRegularExpression(
              where + alone,
              QRegularExpression::MultilineOption | QRegularExpression::CaseInsensitiveOption)))
        fit += weight;
  }
  return fit;
}

}  // namespace

QString helpPageOf(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget())
    for (const auto& [part, page] : kPages)
      if (widget->objectName() == QLatin1String(part)) return page;
  return QStringLiteral("index");
}

QString helpPlaceOf(std::string_view reason) {
  if (reason.empty()) return {};
  const QString word = QStringLiteral("`%1`").arg(QLatin1String(reason.data(), reason.size()));
  QString heading;
  for (const QString& line : englishOf("messages").split('\n'))
    if (line.startsWith(QLatin1String("## ")))
      heading = line.mid(3);
    else if (line.startsWith('`') && line.contains(word))
      return "messages#" + anchorOf(heading);
  return {};
}

QStringList helpPages() {
  static const QRegularExpression link(QStringLiteral("\\]\\(([a-z0-9-]+)\\.md"));
  QStringList pages{"index"};
  for (auto found = link.globalMatch(textOf("index")); found.hasNext();)
    pages.append(found.next().captured(1));
  pages.removeDuplicates();
  return pages;
}

HelpPage::HelpPage(QWidget* parent) : QTextBrowser(parent) {
  setObjectName("helpPage");
  setAccessibleName(tr("Page of the help"));
  setToolTip(tr("The arrow keys move through the page, Tab selects the next link"));
}

bool HelpPage::open(const QString& place) {
  if (textOf(place.section('#', 0, 0)).isEmpty()) return false;
  setSource(urlOf(place), QTextDocument::MarkdownResource);
  return found_;
}

QString HelpPage::page() const { return source().fileName().section('.', 0, 0); }

void HelpPage::doSetSource(const QUrl& url, QTextDocument::ResourceType) {
  QTextBrowser::doSetSource(url, QTextDocument::MarkdownResource);
  found_ = goTo(source().fragment());
}

QVariant HelpPage::loadResource(int type, const QUrl& name) {
  if (!name.path().endsWith(QLatin1String(".md"))) return QTextBrowser::loadResource(type, name);
  const QString page = name.fileName().section('.', 0, 0);
  const QString text = textOf(page);
  if (language() == QLatin1String("en") || !translatedOf(page).isEmpty()) return text.toUtf8();
  return QString(text)
      .insert(text.indexOf('\n') + 1, "\n> " + tr("This page is in English only.") + '\n')
      .toUtf8();
}

bool HelpPage::goTo(const QString& anchor) {
  if (anchor.isEmpty()) return true;
  int wanted = headingOf(page(), anchor);
  if (wanted < 0) return false;
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || wanted-- > 0) continue;
    const QTextCursor cursor(block);
    // from the end, so that the place comes to the top of the page
    moveCursor(QTextCursor::End);
    setTextCursor(cursor);
    verticalScrollBar()->setValue(verticalScrollBar()->value() +
                                  cursorRect(QTextCursor(block)).top());
    return true;
  }
  return false;
}

HelpWindow::HelpWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      back_(new QToolButton),
      forward_(new QToolButton),
      search_(new QLineEdit),
      contents_(new QListWidget),
      page_(new HelpPage) {
  setObjectName("helpWindow");
  setWindowTitle(tr("Help"));
  const auto button = [](QToolButton* made, const char* name, const QString& text,
                         const QString& tip) {
    made->setObjectName(name);
    made->setText(text);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setEnabled(false);
  };
  button(back_, "helpBack", tr("Back"), tr("The page before (Alt+Left)"));
  button(forward_, "helpForward", tr("Forward"), tr("The page after (Alt+Right)"));
  connect(back_, &QToolButton::clicked, page_, &QTextBrowser::backward);
  connect(forward_, &QToolButton::clicked, page_, &QTextBrowser::forward);
  connect(page_, &QTextBrowser::backwardAvailable, back_, &QWidget::setEnabled);
  connect(page_, &QTextBrowser::forwardAvailable, forward_, &QWidget::setEnabled);
  // the source is the new one only once the history has it
  connect(page_, &QTextBrowser::historyChanged, this, &HelpWindow::showWhere);
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this,
          &QWidget::close);
  search_->setObjectName("helpSearch");
  search_->setPlaceholderText(tr("Search"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Words to look for in all pages"));
  search_->setToolTip(tr("Lists the pages that have all these words; Enter shows the next place"));
  connect(search_, &QLineEdit::textChanged, this, &HelpWindow::search);
  connect(search_, &QLineEdit::returnPressed, this, &HelpWindow::markFound);
  contents_->setObjectName("helpContents");
  contents_->setAccessibleName(tr("Contents of the help"));
  contents_->setToolTip(tr("The pages of the help"));
  connect(contents_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr) page_->open(item->data(kPlace).toString());
  });
  for (const auto& [keys, target] : {std::pair{QKeySequence(Qt::ALT | Qt::Key_Left), back_},
                                     std::pair{QKeySequence(Qt::ALT | Qt::Key_Right), forward_}})
    connect(new QShortcut(keys, this), &QShortcut::activated, target, &QToolButton::click);

  auto* left = new QWidget;
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(search_);
  column->addWidget(contents_, 1);
  auto* right = new QWidget;
  auto* page_column = new QVBoxLayout(right);
  page_column->setContentsMargins(0, 0, 0, 0);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(back_);
  buttons->addWidget(forward_);
  buttons->addStretch(1);
  page_column->addLayout(buttons);
  page_column->addWidget(page_, 1);
  auto* split = new QSplitter;
  split->addWidget(left);
  split->addWidget(right);
  split->setStretchFactor(1, 1);
  split->setSizes({340, 680});
  auto* whole = new QVBoxLayout(this);
  whole->addWidget(split);
  search();
  resize(1040, 680);
}

void HelpWindow::open(const QString& place) {
  search_->clear();
  // first: a text that is shown goes to an anchor of Qt's own, or to the top
  show();
  page_->open(place);
  raise();
  activateWindow();
  page_->setFocus();
}

void HelpWindow::search() {
  const QStringList words = search_->text().split(' ', Qt::SkipEmptyParts);
  const QSignalBlocker block(contents_);
  contents_->clear();
  std::vector<std::pair<int, QString>> found;
  for (const QString& page : helpPages())
    if (const int fit = fitOf(words, textOf(page))) found.emplace_back(fit, page);
  std::ranges::stable_sort(found, std::ranges::greater{}, &std::pair<int, QString>::first);
  for (const auto& [fit, page] : found) {
    auto* item = new QListWidgetItem(titleOf(page), contents_);
    item->setData(kPlace, page);
    item->setToolTip(item->text());
  }
  showWhere();
}

void HelpWindow::markFound() {
  const QStringList words = search_->text().split(' ', Qt::SkipEmptyParts);
  if (words.isEmpty() || contents_->count() == 0) return;
  if (contents_->currentItem() == nullptr) {
    contents_->setCurrentRow(0);
  } else if (page_->find(words.first())) {
    return;
  } else {
    contents_->setCurrentRow((contents_->currentRow() + 1) % contents_->count());
  }
  page_->moveCursor(QTextCursor::Start);
  page_->find(words.first());
}

void HelpWindow::showWhere() {
  const QSignalBlocker block(contents_);
  contents_->setCurrentItem(nullptr);
  for (int row = 0; row < contents_->count(); ++row)
    if (contents_->item(row)->data(kPlace) == page_->page()) contents_->setCurrentRow(row);
}

}  // namespace ui
