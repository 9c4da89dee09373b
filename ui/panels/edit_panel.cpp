// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/edit_panel.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controls/bindings.h"
#include "ui/controls/hint_label.h"
#include "ui/controls/number_box.h"
#include "ui/style/look.h"

namespace ui {
namespace {

constexpr double kFarthest_mm = 2'000.0;
constexpr double kLargest_cm3 = 100'000.0;
constexpr int kToolsInRow = 3;
constexpr int kButtonRoom = 14;  // px beside the text of a button

QPushButton* buttonOf(const QString& text, const char* name) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  // less than the style's own least, so that three stand beside a scroll bar
  button->setMinimumWidth(button->fontMetrics().horizontalAdvance(text) + kButtonRoom);
  return button;
}

QWidget* emptyPage() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(
      hintLabel(EditPanel::tr("Choose a tool to remove parts. The file never changes.")));
  column->addStretch(1);
  return page;
}

}  // namespace

EditPanel::EditPanel(QWidget* parent)
    : QWidget(parent), tools_(new QButtonGroup(this)), pages_(new QStackedWidget) {
  auto* row = new QGridLayout;
  row->setSpacing(4);
  tools_->setExclusive(false);  // a second click switches a tool off
  const auto tool = [&](EditTool which, const QString& text, const QString& tip, const char* name) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const int n = static_cast<int>(which) - 1;
    tools_->addButton(button, static_cast<int>(which));
    row->addWidget(button, n / kToolsInRow, n % kToolsInRow);
    connect(button, &QToolButton::clicked, this,
            [this, which](bool on) { setTool(on ? which : EditTool::None); });
  };
  tool(EditTool::Crop, tr("Crop"), tr("Keeps the inside of a box"), "cropTool");
  tool(EditTool::Plane, tr("Plane"), tr("Cuts along a plane"), "planeTool");
  tool(EditTool::Pieces, tr("Pieces"), tr("Keeps or removes connected pieces"), "piecesTool");
  tool(EditTool::Holder, tr("Holder"), tr("Removes table and head holder"), "holderTool");
  tool(EditTool::Scalpel, tr("Scalpel"), tr("Cuts along an outline that you draw"), "scalpelTool");

  pages_->addWidget(emptyPage());
  pages_->addWidget(cropPage());
  pages_->addWidget(planePage());
  pages_->addWidget(piecesPage());
  pages_->addWidget(holderPage());
  pages_->addWidget(scalpelPage());
  showPage();

  undo_ = buttonOf(tr("Undo"), "undoEdit");
  redo_ = buttonOf(tr("Redo"), "redoEdit");
  reset_ = buttonOf(tr("Reset"), "resetEdits");
  reset_->setToolTip(tr("Takes all edits back"));
  whenKeysChange(*this, [this] {
    undo_->setToolTip(withKey(tr("Takes the last edit back"), Action::Undo));
    redo_->setToolTip(withKey(tr("Makes the edit again that was taken back"), Action::Redo));
  });
  steps_ = new QLabel;
  steps_->setObjectName("editSteps");
  auto* steps = new QHBoxLayout;
  steps->setSpacing(4);
  for (QPushButton* button : {undo_, redo_, reset_}) steps->addWidget(button);
  steps->addStretch(1);
  connect(undo_, &QPushButton::clicked, this, &EditPanel::undoWanted);
  connect(redo_, &QPushButton::clicked, this, &EditPanel::redoWanted);
  connect(reset_, &QPushButton::clicked, this, &EditPanel::resetWanted);

  wait_ = new QFrame;
  wait_words_ = hintLabel();
  wait_words_->setObjectName("editWait");
  auto* cancel = buttonOf(tr("Cancel"), "cancelEditWait");
  cancel->setToolTip(tr("Leaves everything as it is"));
  auto* wait = new QHBoxLayout(wait_);
  wait->setContentsMargins(0, 0, 0, 0);
  wait->addWidget(wait_words_, 1);
  wait->addWidget(cancel);
  wait_->hide();
  connect(cancel, &QPushButton::clicked, this, &EditPanel::waitCancelled);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(pages_);
  column->addWidget(preview_ = previewBar());
  column->addWidget(wait_);
  column->addLayout(steps);
  column->addWidget(steps_);
  setFocusProxy(tools_->button(static_cast<int>(EditTool::Crop)));
  show(EditSteps{});
  show(std::nullopt, 0);
  setReady(false);
}

QWidget* EditPanel::cropPage() {
  auto* page = new QWidget;
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const auto a = static_cast<std::size_t>(axis), s = static_cast<std::size_t>(side);
      crop_names_[a][s] = new QLabel;
      const QByteArray name = "crop" + QByteArray::number(axis) + (side == 0 ? "Low" : "High");
      crop_numbers_[a][s] =
          numberBox({name.constData(), {}, -kFarthest_mm, kFarthest_mm, 1.0, 1, tr(" mm")});
      crop_numbers_[a][s]->setToolTip(tr("Where the box ends on this side"));
      grid->addWidget(crop_names_[a][s], axis, 2 * side);
      grid->addWidget(crop_numbers_[a][s], axis, 2 * side + 1);
      connect(crop_numbers_[a][s], &NumberBox::valueChanged, this,
              [this, axis, side](double mm) { emit cropNumberChanged(axis, side == 1, mm); });
    }
  crop_axes_ = hintLabel();
  crop_axes_->setObjectName("cropAxes");
  auto* to_view = buttonOf(tr("Crop to view"), "cropToView");
  to_view->setToolTip(tr("The box that the slices show"));
  auto* whole = buttonOf(tr("Whole scan"), "cropReset");
  whole->setToolTip(tr("Takes the crop away"));
  auto* apply = buttonOf(tr("Apply"), "cropApply");
  apply->setToolTip(tr("Keeps the inside of the box"));
  connect(to_view, &QPushButton::clicked, this, &EditPanel::cropToViewWanted);
  connect(whole, &QPushButton::clicked, this, &EditPanel::cropResetWanted);
  connect(apply, &QPushButton::clicked, this, &EditPanel::cropApplyWanted);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(4);
  buttons->addWidget(to_view, 0, 0);
  buttons->addWidget(whole, 0, 1);
  buttons->addWidget(apply, 1, 0, 1, 2);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(grid);
  column->addWidget(crop_axes_);
  column->addLayout(buttons);
  column->addStretch(1);
  return page;
}

QWidget* EditPanel::planePage() {
  auto* page = new QWidget;
  plane_hint_ = hintLabel();
  plane_hint_->setObjectName("planeHint");
  auto* from = new QHBoxLayout;
  from->setSpacing(4);
  const auto slice = [&](Plane plane, const QString& text, const char* name) {
    QPushButton* button = buttonOf(text, name);
    button->setToolTip(tr("Lays the plane into this slice"));
    connect(button, &QPushButton::clicked, this,
            [this, plane] { emit planeFromSliceWanted(plane); });
    from->addWidget(button);
  };
  slice(Plane::Axial, tr("Axial"), "planeFromAxial");
  slice(Plane::Coronal, tr("Coronal"), "planeFromCoronal");
  slice(Plane::Sagittal, tr("Sagittal"), "planeFromSagittal");
  plane_position_ = numberBox({"planePosition", tr("Position of the plane"), -kFarthest_mm,
                               kFarthest_mm, 1.0, 1, tr(" mm")});
  plane_towards_ =
      numberBox({"planeTowards", tr("Direction of the cut"), -180.0, 180.0, 5.0, 1, tr("°")});
  plane_raised_ = numberBox({"planeRaised", tr("Slope of the cut"), -90.0, 90.0, 5.0, 1, tr("°")});
  plane_position_->setToolTip(tr("From the middle of the scan, towards the side to remove"));
  plane_towards_->setToolTip(
      tr("Direction of the side to remove: 0° is L, 90° is P, 180° is R, −90° is A"));
  plane_raised_->setToolTip(tr("Slope of the side to remove: 90° is S, −90° is I"));
  for (NumberBox* number : {plane_position_, plane_towards_, plane_raised_})
    connect(number, &NumberBox::valueChanged, this, &EditPanel::emitPlaneNumbers);
  auto* flip = buttonOf(tr("Flip"), "planeFlip");
  flip->setToolTip(tr("Takes the other side of the plane"));
  auto* again = buttonOf(tr("Place again"), "planeAgain");
  again->setToolTip(tr("Places the plane anew, with three clicks"));
  auto* apply = buttonOf(tr("Cut"), "planeApply");
  apply->setToolTip(tr("Cuts along the plane"));
  connect(flip, &QPushButton::clicked, this, &EditPanel::planeFlipWanted);
  connect(again, &QPushButton::clicked, this, &EditPanel::planeAgainWanted);
  connect(apply, &QPushButton::clicked, this, &EditPanel::planeApplyWanted);
  plane_controls_ = new QWidget;
  auto* form = new QFormLayout;
  form->setVerticalSpacing(4);
  form->addRow(tr("Position"), plane_position_);
  form->addRow(tr("Towards"), plane_towards_);
  form->addRow(tr("Raised"), plane_raised_);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(4);
  buttons->addWidget(flip, 0, 0);
  buttons->addWidget(again, 0, 1);
  buttons->addWidget(apply, 1, 0, 1, 2);
  auto* controls = new QVBoxLayout(plane_controls_);
  controls->setContentsMargins(0, 0, 0, 0);
  controls->addLayout(form);
  controls->addLayout(buttons);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plane_hint_);
  column->addWidget(new QLabel(tr("From slice:")));
  column->addLayout(from);
  column->addWidget(plane_controls_);
  column->addStretch(1);
  return page;
}

QWidget* EditPanel::piecesPage() {
  auto* page = new QWidget;
  small_ = numberBox(
      {"smallVolume", tr("Smallest piece that stays"), 0.001, kLargest_cm3, 1.0, 3, tr(" cm³")});
  small_->setValue(1.0);
  small_->setToolTip(tr("Pieces of a smaller volume go"));
  auto* show_small = buttonOf(tr("Show"), "showSmall");
  show_small->setToolTip(tr("Shows the small pieces before they go"));
  connect(show_small, &QPushButton::clicked, this, [this] { emit smallWanted(small_->value()); });
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(small_, 1);
  row->addWidget(show_small);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(hintLabel(
      tr("Click on a piece, in 3-D or in a slice. A piece is connected at the present isovalue.")));
  column->addWidget(new QLabel(tr("All pieces smaller than")));
  column->addLayout(row);
  column->addStretch(1);
  return page;
}

QWidget* EditPanel::holderPage() {
  auto* page = new QWidget;
  auto* find = buttonOf(tr("Show table and holder"), "showHolder");
  find->setToolTip(tr("Shows the parts to remove, with their volume"));
  connect(find, &QPushButton::clicked, this, &EditPanel::holderWanted);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(
      hintLabel(tr("Finds table and head holder by rule, and shows them before they are removed. "
                   "Check that no part of the patient is removed with them.")));
  column->addWidget(find);
  column->addStretch(1);
  return page;
}

QWidget* EditPanel::scalpelPage() {
  auto* page = new QWidget;
  depth_ =
      numberBox({"scalpelDepth", tr("Depth of the cut"), 0.0, kFarthest_mm, 1.0, 1, tr(" mm")});
  depth_->setSpecialValueText(tr("through everything"));
  depth_->setToolTip(
      tr("In 3-D from the nearest surface inside the outline; in a slice to both "
         "sides. 0 cuts through everything."));
  side_ = new QComboBox;
  side_->setObjectName("scalpelSide");
  side_->setToolTip(tr("Side of the outline to remove"));
  side_->addItem(tr("Remove the inside"));
  side_->addItem(tr("Remove the outside"));
  auto* form = new QFormLayout;
  form->setVerticalSpacing(4);
  form->addRow(tr("Depth"), depth_);
  form->addRow(tr("Cut"), side_);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(
      hintLabel(tr("Draw an outline with the left button, in 3-D or on a slice, or click its "
                   "corners; the last one twice. The cut is shown before it is made.")));
  connect(depth_, &NumberBox::valueChanged, this, &EditPanel::scalpelChanged);
  connect(side_, &QComboBox::currentIndexChanged, this, &EditPanel::scalpelChanged);
  column->addLayout(form);
  column->addStretch(1);
  return page;
}

QFrame* EditPanel::previewBar() {
  auto* bar = new QFrame;
  preview_words_ = hintLabel();
  preview_words_->setObjectName("editPreview");
  // what is said of a button moves none
  preview_words_->setMinimumHeight(2 * preview_words_->fontMetrics().lineSpacing());
  keep_ = buttonOf(tr("Keep only this"), "keepPiece");
  keep_->setToolTip(tr("Removes all but the piece that is shown"));
  remove_piece_ = buttonOf(tr("Remove this"), "removePiece");
  remove_piece_->setToolTip(tr("Removes the piece that is shown"));
  // which of the two, before it is done
  for (QPushButton* fate : {keep_, remove_piece_}) fate->installEventFilter(this);
  remove_ = buttonOf(tr("Remove"), "applyRemoval");
  auto* cancel = buttonOf(tr("Cancel"), "cancelPreview");
  cancel->setToolTip(tr("Keeps the parts shown"));
  connect(keep_, &QPushButton::clicked, this, &EditPanel::keepPieceWanted);
  connect(remove_piece_, &QPushButton::clicked, this, &EditPanel::removePieceWanted);
  connect(remove_, &QPushButton::clicked, this, &EditPanel::removalWanted);
  connect(cancel, &QPushButton::clicked, this, &EditPanel::previewCancelled);
  // of a piece two buttons and Cancel below, else Remove and Cancel; as wide in either case
  remove_->setMinimumWidth(keep_->minimumWidth());
  cancel->setMinimumWidth(std::max(cancel->minimumWidth(), remove_piece_->minimumWidth()));
  auto* buttons = new QGridLayout;
  buttons->setSpacing(4);
  buttons->addWidget(keep_, 0, 0);
  buttons->addWidget(remove_piece_, 0, 1);
  buttons->addWidget(remove_, 1, 0);
  buttons->addWidget(cancel, 1, 1);
  auto* column = new QVBoxLayout(bar);
  column->setContentsMargins(0, 4, 0, 0);
  column->addWidget(preview_words_);
  column->addLayout(buttons);
  bar->hide();
  return bar;
}

void EditPanel::setReady(bool ready) { setEnabled(ready); }

void EditPanel::setTool(EditTool tool) {
  for (QAbstractButton* button : tools_->buttons())
    button->setChecked(tools_->id(button) == static_cast<int>(tool));
  if (tool == tool_) return;
  tool_ = tool;
  showPage();
  keepInSight(*pages_);
  emit toolChosen(tool);
}

void EditPanel::showPage() {
  const int shown = static_cast<int>(tool_);
  // as tall as the page that is shown, so that what stands below needs no scrolling
  for (int n = 0; n < pages_->count(); ++n)
    pages_->widget(n)->setSizePolicy(QSizePolicy::Preferred,
                                     n == shown ? QSizePolicy::Preferred : QSizePolicy::Ignored);
  pages_->setCurrentIndex(shown);
}

void EditPanel::show(const std::array<CropRange, 3>& ranges, const QString& axes_told) {
  crop_axes_->setText(axes_told);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t side = 0; side < 2; ++side) {
      const CropRange& range = ranges[a];
      NumberBox& number = *crop_numbers_[a][side];
      const QSignalBlocker quiet(number);
      crop_names_[a][side]->setText(side == 0 ? tr("%1 from").arg(range.axis) : tr("to"));
      number.setAccessibleName((side == 0 ? tr("Box, %1 from") : tr("Box, %1 to")).arg(range.axis));
      number.setRange(range.least, range.most);
      number.setSingleStep(range.step);
      number.setValue(side == 0 ? range.from : range.to);
    }
}

void EditPanel::show(const std::optional<PlaneNumbers>& plane, std::size_t clicks) {
  plane_controls_->setVisible(plane.has_value());
  plane_hint_->setVisible(!plane);
  plane_hint_->setText(
      clicks == 0 ? tr("Click three places on the surface: everything on your side of the plane is "
                       "removed. Or three in one slice: two on a line, and the third on the side "
                       "to remove.")
      : clicks == 1 ? tr("One place is set: click two more.")
                    : tr("Two places are set: click the third, in a slice on the side to remove."));
  if (!plane) return;
  const QSignalBlocker quiet_position(plane_position_), quiet_towards(plane_towards_),
      quiet_raised(plane_raised_);
  plane_position_->setValue(plane->position_mm);
  plane_towards_->setValue(plane->towards_deg);
  plane_raised_->setValue(plane->raised_deg);
}

void EditPanel::emitPlaneNumbers() {
  emit planeNumbersChanged(plane_position_->value(), plane_towards_->value(),
                           plane_raised_->value());
}

void EditPanel::showPreview(const QString& words, EditConfirm confirm) {
  preview_words_->setText(words);
  const bool cut = confirm == EditConfirm::Cut;
  remove_->setText(cut ? tr("Cut") : tr("Remove"));
  remove_->setToolTip(cut ? withKey(tr("Removes what is hatched"), Action::SetPlaceOfEdit)
                          : tr("Removes the parts shown"));
  keep_->setVisible(confirm == EditConfirm::Piece);
  remove_piece_->setVisible(confirm == EditConfirm::Piece);
  remove_->setVisible(confirm != EditConfirm::Piece);
  preview_->show();
  keepInSight(*preview_);
}

/// With its buttons, wherever the panel was scrolled to.
void EditPanel::keepInSight(QWidget& what) {
  QTimer::singleShot(0, this, [this, &what] {
    for (QWidget* part = parentWidget(); part != nullptr; part = part->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(part)) {
        scroll->ensureWidgetVisible(&what, 0, style::kGap);
        return;
      } else if (part->layout() != nullptr) {
        part->layout()->activate();
      }
  });
}

bool EditPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool keep = watched == keep_;
  if (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn) {
    preview_words_->setText(keep ? tr("Only this piece stays. What is hatched goes.")
                                 : tr("This piece goes: it is hatched."));
    keepInSight(*preview_);
    emit fateShown(keep);
  }
  return QWidget::eventFilter(watched, event);
}

/// Also of what is hidden now: the panel is as wide when it is said.
QSize EditPanel::minimumSizeHint() const {
  QSize least = QWidget::minimumSizeHint();
  for (const QWidget* part : std::initializer_list<const QWidget*>{preview_, wait_})
    least.setWidth(std::max(least.width(), part->minimumSizeHint().width()));
  return least;
}

void EditPanel::hidePreview() { preview_->hide(); }

void EditPanel::show(const EditSteps& steps) {
  undo_->setEnabled(steps.undo);
  redo_->setEnabled(steps.redo);
  reset_->setEnabled(steps.in_force > 0);
  steps_->setText(steps.in_force == 0   ? QString()
                  : steps.in_force == 1 ? tr("1 edit")
                                        : tr("%L1 edits").arg(steps.in_force));
  steps_->setVisible(steps.in_force > 0);
}

void EditPanel::showWait(const QString& sentence) {
  wait_words_->setText(sentence);
  wait_->setVisible(!sentence.isEmpty());
}

std::optional<double> EditPanel::depth_mm() const {
  if (depth_->value() <= 0.0) return {};
  return depth_->value();
}

bool EditPanel::cutsInside() const { return side_->currentIndex() == 0; }

}  // namespace ui
