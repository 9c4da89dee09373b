// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/start_page.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controls/bindings.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kCardWidth = 264, kCardSymbol = 32;  // px
constexpr int kTileWidth = StartPage::kThumbnail + 2 * style::kGap;
constexpr int kLoadingWidth = 320;

/// A way to begin: a symbol, a title, a sentence and its buttons. A click beside the buttons is a
/// click on the first.
class Card : public QFrame {
 public:
  Card(const char* icon, const QString& title, const QString& sentence) : icon_(style::icon(icon)) {
    auto* head = new QLabel(title);
    head->setWordWrap(true);
    style::setType(*head, style::Type::Figure);
    auto* words = new QLabel(sentence);
    words->setWordWrap(true);
    style::setDim(*words);
    buttons_ = new QHBoxLayout;
    buttons_->setSpacing(style::kGap);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(style::kEdge, style::kEdge + kCardSymbol + style::kGap, style::kEdge,
                               style::kEdge);
    column->setSpacing(style::kGap);
    column->addWidget(head);
    column->addWidget(words);
    column->addStretch(1);
    column->addLayout(buttons_);
    setCursor(Qt::PointingHandCursor);
  }

  QPushButton* add(const char* name, const QString& words, const QString& tip = {}) {
    auto* button = new QPushButton(words);
    button->setObjectName(name);
    button->setToolTip(tip);
    buttons_->addWidget(button);
    if (first_ == nullptr) first_ = button;
    return button;
  }
  void finish() {
    buttons_->addStretch(1);
    // a word or a button may need more
    const int width = std::max(kCardWidth, minimumSizeHint().width());
    setMinimumWidth(width);
    setMaximumWidth(width + width / 4);
  }

 protected:
  // as high as its words need at this width: a scroll area asks for less
  void resizeEvent(QResizeEvent*) override {
    setMinimumHeight(layout()->totalHeightForWidth(width()));
  }
  void mouseReleaseEvent(QMouseEvent* event) override {
    if (event->button() == Qt::LeftButton && rect().contains(event->pos())) first_->click();
  }
  void paintEvent(QPaintEvent*) override {
    const style::Colours& c = style::colours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(c.line);
    painter.setBrush(c.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), style::kLargeCorner,
                            style::kLargeCorner);
    icon_.paint(&painter, QRect(style::kEdge, style::kEdge, kCardSymbol, kCardSymbol));
  }

 private:
  QIcon icon_;
  QHBoxLayout* buttons_;
  QPushButton* first_ = nullptr;
};

/// A square with the symbol of scans, for a scan without a picture.
QPixmap placeholder(qreal scale) {
  constexpr int kSide = StartPage::kThumbnail;
  QPixmap picture(QSize(kSide, kSide) * scale);
  picture.setDevicePixelRatio(scale);
  picture.fill(style::colours().control);
  QPainter painter(&picture);
  constexpr int kInset = (kSide - kCardSymbol) / 2;
  style::icon("scan").paint(&painter, QRect(kInset, kInset, kCardSymbol, kCardSymbol));
  return picture;
}

/// What a tile says of its scan. `of_picture`: a sentence, or empty.
void describe(QToolButton& tile, const QString& path, const QString& of_picture) {
  const QString name = QFileInfo(path).fileName();
  const QString tip = tile.isEnabled() ? PlaceTiles::tr("Opens %1 again").arg(path)
                                       : PlaceTiles::tr("%1 is no longer there").arg(path);
  tile.setAccessibleName(of_picture.isEmpty()
                             ? PlaceTiles::tr("Open %1").arg(name)
                             : PlaceTiles::tr("Open %1. %2").arg(name, of_picture));
  tile.setToolTip(of_picture.isEmpty() ? tip : tip + QLatin1Char('\n') + of_picture);
}

}  // namespace

PlaceTiles::PlaceTiles(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(style::kGap);
  row_->addStretch(1);
}

void PlaceTiles::setPlaces(const QList<Place>& places) {
  qDeleteAll(tiles_);
  tiles_.clear();
  for (const Place& place : places) {
    auto* tile = new QToolButton;
    tile->setObjectName("lastScan");
    tile->setProperty("path", place.path);
    tile->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    tile->setAutoRaise(true);
    tile->setFixedWidth(kTileWidth);
    tile->setIconSize({StartPage::kThumbnail, StartPage::kThumbnail});
    tile->setIcon(placeholder(devicePixelRatioF()));
    const QString name = QFileInfo(place.path).fileName();
    tile->setText(
        fontMetrics().elidedText(name, Qt::ElideMiddle, StartPage::kThumbnail).replace('&', "&&"));
    tile->setEnabled(place.exists);
    describe(*tile, place.path, {});
    connect(tile, &QToolButton::clicked, this, [this, path = place.path] { emit wanted(path); });
    row_->insertWidget(int(tiles_.size()), tile);
    tiles_ << tile;
  }
  showThoseThatFit();
}

void PlaceTiles::setThumbnail(const QString& path, const SmallPicture& picture) {
  for (QToolButton* tile : tiles_) {
    if (tile->property("path") != path) continue;
    tile->setIcon(
        squareOf(picture, StartPage::kThumbnail, devicePixelRatioF(), style::colours().ground));
    describe(*tile, path, wordsOf(picture));
  }
}

QSize PlaceTiles::minimumSizeHint() const {
  return {kTileWidth, tiles_.isEmpty() ? 0 : tiles_.front()->sizeHint().height()};
}

void PlaceTiles::resizeEvent(QResizeEvent*) { showThoseThatFit(); }

void PlaceTiles::showThoseThatFit() {
  const qsizetype room = std::max(1, (width() + style::kGap) / (kTileWidth + style::kGap));
  for (qsizetype i = 0; i < tiles_.size(); ++i) tiles_[i]->setVisible(i < room);
}

StartPage::StartPage(QWidget* parent)
    : QScrollArea(parent),
      cards_(makeCards()),
      last_(new QLabel),
      tiles_(new PlaceTiles),
      loading_what_(new QLabel),
      progress_(new QProgressBar),
      loading_(makeLoading()) {
  setObjectName("startPage");
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
  style::setType(*last_, style::Type::Section);
  style::setDim(*last_);
  last_->setObjectName("lastScans");
  last_->setWordWrap(true);
  connect(tiles_, &PlaceTiles::wanted, this, &StartPage::placeWanted);
  auto* page = new QWidget;
  page->setAutoFillBackground(true);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(2 * style::kEdge, 2 * style::kEdge, 2 * style::kEdge,
                             2 * style::kEdge);
  column->setSpacing(style::kEdge);
  column->addStretch(1);
  column->addWidget(cards_);
  column->addSpacing(style::kEdge);
  column->addWidget(last_);
  column->addWidget(tiles_);
  column->addWidget(loading_, 0, Qt::AlignCenter);
  column->addStretch(2);
  setWidget(page);
  loading_->hide();
  setPlaces({}, true);
}

QWidget* StartPage::makeCards() {
  auto* open = new Card("open", tr("Open your CT"),
                        tr("A folder of DICOM slices, an archive, or an NRRD, MetaImage or NIfTI "
                           "file. It can also be dropped on the window."));
  auto* folder = open->add("startFolder", tr("Open folder…"));
  auto* file = open->add("startFile", tr("Open file…"));
  whenKeysChange(*this, [folder, file] {
    folder->setToolTip(withKey(tr("Opens a folder of slices"), Action::OpenFolder));
    file->setToolTip(withKey(tr("Opens an archive or a volume in one file"), Action::OpenFile));
  });
  connect(folder, &QPushButton::clicked, this, &StartPage::folderWanted);
  connect(file, &QPushButton::clicked, this, &StartPage::fileWanted);
  auto* demo = new Card("touch", tr("Try the demo skull"),
                        tr("A skull made by a formula, and a drill to touch it with. The mouse is "
                           "the hand, so nothing else is needed."));
  connect(demo->add("startDemo", tr("Try it"), tr("Shows the demo skull with a drill")),
          &QPushButton::clicked, this, &StartPage::demoWanted);
  auto* device = new Card("device", tr("Connect a haptic device"),
                          tr("Feel the scan: a Falcon, Touch, Inverse3 and others. The list shows "
                             "the devices found and their needs."));
  connect(device->add("startDevice", tr("Show devices"),
                      tr("Shows the list of haptic devices on the tab Device")),
          &QPushButton::clicked, this, &StartPage::deviceWanted);
  auto* purpose = new QLabel(tr("See a CT scan, and feel its surface."));
  purpose->setObjectName("purpose");
  purpose->setWordWrap(true);
  style::setType(*purpose, style::Type::Figure);
  auto* cards = new QWidget;
  auto* column = new QVBoxLayout(cards);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(style::kEdge);
  column->addWidget(purpose);
  row_ = new QHBoxLayout;
  row_->addStretch(1);  // what the cards leave stays empty
  column->addLayout(row_);
  for (Card* card : {open, demo, device}) {
    card->finish();
    all_ << card;
  }
  arrange(int(all_.size()));
  return cards;
}

void StartPage::arrange(int columns) {
  if (columns == columns_) return;
  delete grid_;  // one that had more columns keeps their room
  grid_ = new QGridLayout;
  grid_->setSpacing(style::kEdge);
  for (int n = 0; n < all_.size(); ++n) {
    grid_->addWidget(all_[n], n / columns, n % columns);
    grid_->setColumnStretch(n % columns, 1);
  }
  row_->insertLayout(0, grid_, 1000);
  columns_ = columns;
}

void StartPage::resizeEvent(QResizeEvent* event) {
  const int room = width() - 4 * style::kEdge - verticalScrollBar()->sizeHint().width();
  int widest = 0;
  for (const QWidget* card : all_) widest = std::max(widest, card->minimumWidth());
  arrange(std::clamp((room + style::kEdge) / (widest + style::kEdge), 1, int(all_.size())));
  QScrollArea::resizeEvent(event);
}

QWidget* StartPage::makeLoading() {
  loading_what_->setObjectName("startLoading");
  loading_what_->setAlignment(Qt::AlignCenter);
  style::setType(*loading_what_, style::Type::Figure);
  progress_->setTextVisible(false);
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setObjectName("startCancel");
  cancel->setToolTip(tr("Cancels loading and shows the start page"));
  connect(cancel, &QPushButton::clicked, this, &StartPage::cancelWanted);
  auto* loading = new QWidget;
  loading->setFixedWidth(kLoadingWidth);
  loading->setFocusProxy(cancel);
  auto* column = new QVBoxLayout(loading);
  column->setSpacing(style::kEdge);
  column->addWidget(loading_what_);
  column->addWidget(progress_);
  column->addWidget(cancel, 0, Qt::AlignCenter);
  return loading;
}

void StartPage::setPlaces(const QList<Place>& places, bool remembered) {
  if (places != places_) tiles_->setPlaces(places);
  places_ = places;
  tiles_->setVisible(!places.isEmpty());
  last_->setText(!remembered        ? tr("Recent places are not remembered (File > Open recent)")
                 : places.isEmpty() ? tr("The scans that you open will stand here")
                                    : tr("Last scans"));
}

void StartPage::setThumbnail(const QString& path, const SmallPicture& picture) {
  if (!picture.image.isNull()) tiles_->setThumbnail(path, picture);
}

void StartPage::setLoading(const QString& what) {
  const bool loading = !what.isEmpty();
  if (loading ? what == loading_what_->text() && !loading_->isHidden() : loading_->isHidden())
    return;
  if (loading) {
    loading_what_->setText(what);
    progress_->setRange(0, 0);  // busy, until a fraction is known; paints the window at once
  }
  const bool led = isAncestorOf(QApplication::focusWidget());
  cards_->setVisible(!loading);
  last_->setVisible(!loading);
  tiles_->setVisible(!loading && tiles_->minimumSizeHint().height() > 0);
  loading_->setVisible(loading);
  if (loading && led) loading_->setFocus();
}

void StartPage::setProgress(double fraction) {
  progress_->setRange(0, 1000);
  progress_->setValue(qRound(fraction * 1000.0));
}

}  // namespace ui
