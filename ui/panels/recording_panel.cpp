// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/recording_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/controls/bindings.h"
#include "ui/controls/figure.h"
#include "ui/controls/time_words.h"
#include "ui/controls/warning_label.h"
#include "ui/panels/recording_lines.h"
#include "ui/style/look.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kWords = 0, kForce = 1, kListColumns = 2;

constexpr int kLongestNote = 200;
constexpr int kLongestLabel = 60;
constexpr int kConfirmed_ms = 5'000;
constexpr double kLittleRoom = 600.0;  // s

WarningLabel* label(const char* name) {
  auto* made = new WarningLabel;
  made->setObjectName(name);
  made->setTextFormat(Qt::PlainText);
  return made;
}

WarningLabel* wrappedLabel(const char* name) {
  WarningLabel* made = label(name);
  made->setWordWrap(true);
  made->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return made;
}

QLabel* dim(const QString& words) {
  auto* made = new QLabel(words);
  style::setDim(*made);
  return made;
}

QString sizeOf(qint64 bytes) {
  return QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
}

QString roomFor(double seconds) {
  constexpr double kHour = 3600.0;
  // rounded down: rather too little than too much
  if (seconds < kHour)
    return RecordingPanel::tr("room for %1 min").arg(std::floor(std::max(0.0, seconds) / 60.0));
  const double hours = seconds / kHour;
  const double shown = hours < 10.0 ? std::floor(hours * 10.0) / 10.0 : std::floor(hours);
  return RecordingPanel::tr("room for %1 h").arg(QLocale().toString(shown, 'f', hours < 10.0));
}

QTableWidgetItem* itemOf(const QString& text, const QString& tip) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  item->setToolTip(QStringLiteral("<qt>%1</qt>").arg(tip.toHtmlEscaped().replace('\n', "<br>")));
  return item;
}

/// A recording in three lines: label or name; date and scan; what else is known.
QString linesOf(const PastRecording& recording) {
  const QString first = recording.label.isEmpty()
                            ? recording.name
                            : RecordingPanel::tr("%1 (%2)", "a label and the name of the file")
                                  .arg(recording.label, recording.name);
  const QString duration =
      recording.finished ? clockTime(recording.duration, 1) : RecordingPanel::tr("unfinished");
  QStringList about{duration};
  if (!recording.tool.isEmpty()) about << recording.tool;
  about << sizeOf(recording.bytes);
  QString date = QLocale().toString(recording.changed, QLocale::ShortFormat);
  if (!recording.scan.isEmpty()) date += QStringLiteral(" · ") + recording.scan.simplified();
  return QStringList{first.simplified(), date, about.join(QStringLiteral(" · "))}.join('\n');
}

}  // namespace

RecordingPanel::RecordingPanel(QWidget* parent)
    : QWidget(parent),
      record_(new QPushButton),
      when_(new QCheckBox(tr("State when it began"))),
      scan_(new QCheckBox(tr("State which scan it is"))),
      elapsed_(new Figure(tr("Time recorded"))),
      state_(wrappedLabel("recordState")),
      samples_(label("recordSamples")),
      gaps_(label("recordGaps")),
      bytes_(label("recordSize")),
      room_(label("recordRoom")),
      lost_(wrappedLabel("recordLost")),
      note_(new QLineEdit),
      mark_(new QPushButton),
      marked_(label("marked")),
      mark_action_(new QAction(tr("Mark"), this)),
      list_(new QTableWidget),
      label_(new QLineEdit),
      open_(new QPushButton),
      export_(new QPushButton(tr("Export…"))),
      report_(new QPushButton(tr("Report…"))),
      delete_(new QPushButton(tr("Delete"))) {
  note_->setObjectName("markNote");
  note_->setMaxLength(kLongestNote);
  note_->setPlaceholderText(tr("Note: write no names"));
  note_->setAccessibleName(tr("Note of the mark"));
  note_->setToolTip(
      tr("Note for this mark. Everyone with the recording can read it: do not write names of "
         "patients or staff."));
  mark_->setObjectName("mark");
  whenKeysChange(*this, [this] {
    const QString key = keyOf(Action::SetMark);
    mark_->setText(tr("Mark (%1)").arg(key));
    mark_->setToolTip(
        tr("Sets a mark at this moment, with the note (%1, or Enter in the note)").arg(key));
    mark_action_->setShortcuts(shortcutsOf(Action::SetMark));
  });
  mark_action_->setShortcutContext(Qt::ApplicationShortcut);
  mark_action_->setAutoRepeat(false);
  auto* marking = new QHBoxLayout;
  marking->addWidget(note_, 1);
  marking->addWidget(mark_);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(buildFigures());
  column->addLayout(marking);
  column->addWidget(marked_);
  column->addWidget(buildList(), 1);

  setFocusProxy(record_);
  confirmation_.setSingleShot(true);
  confirmation_.setObjectName("confirmation");
  connect(&confirmation_, &QTimer::timeout, marked_, &QLabel::clear);
  connect(mark_, &QPushButton::clicked, this, &RecordingPanel::mark);
  connect(note_, &QLineEdit::returnPressed, this, &RecordingPanel::mark);
  connect(mark_action_, &QAction::triggered, this, &RecordingPanel::mark);
  showState();
  showSelected();
}

QWidget* RecordingPanel::buildFigures() {
  record_->setObjectName("record");
  record_->setCheckable(true);
  record_->setToolTip(tr("Begins a recording of every tick, or ends it"));
  connect(record_, &QPushButton::clicked, this, [this] {
    const bool records = status_.state == RecordingStatus::State::Recording;
    record_->setChecked(records);  // until it is told otherwise
    emit recordWanted(!records);
  });
  when_->setObjectName("recordWhen");
  when_->setToolTip(
      tr("The next recording and its exports then hold date and time, to join them with other "
         "devices. A date can tell who the patient is."));
  scan_->setObjectName("recordScan");
  scan_->setToolTip(
      tr("The next recording and its exports then hold an open hash, by which anybody who has this "
         "scan recognises it."));
  style::setType(*elapsed_, style::Type::Figure);
  elapsed_->setObjectName("recordElapsed");
  lost_->setWarning(true);

  auto* figures = new QWidget;
  auto* grid = new QGridLayout(figures);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(record_, 0, 0, 1, 2);
  grid->addWidget(elapsed_, 0, 2, 1, 2, Qt::AlignRight);
  grid->addWidget(state_, 1, 0, 1, 4);
  grid->addWidget(dim(tr("Recorded ticks")), 2, 0);
  grid->addWidget(samples_, 2, 1);
  grid->addWidget(dim(tr("Breaks")), 2, 2);
  grid->addWidget(gaps_, 2, 3, Qt::AlignRight);
  grid->addWidget(dim(tr("Size")), 3, 0);
  grid->addWidget(bytes_, 3, 1);
  grid->addWidget(room_, 3, 2, 1, 2, Qt::AlignRight);
  grid->addWidget(lost_, 4, 0, 1, 4);
  grid->addWidget(when_, 5, 0, 1, 4);
  grid->addWidget(scan_, 6, 0, 1, 4);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  return figures;
}

QWidget* RecordingPanel::buildList() {
  list_->setObjectName("recordings");
  list_->setAccessibleName(tr("Recordings"));
  list_->setColumnCount(kListColumns);
  list_->setItemDelegate(new RecordingLines(list_));
  style::makeLines(*list_, tr("No recordings yet"));
  list_->setMinimumHeight(180);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setToolTip(tr("Enter or a double-click opens a recording"));
  list_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->hide();
  list_->horizontalHeader()->setSectionResizeMode(kForce, QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(kWords, QHeaderView::Stretch);
  label_->setObjectName("recordingLabel");
  label_->setMaxLength(kLongestLabel);
  label_->setAccessibleName(tr("Label of the recording"));
  label_->setPlaceholderText(tr("Label: stays on this computer"));
  label_->setToolTip(
      tr("Your own words for this recording. They are kept on this computer only: neither the "
         "recording nor an export contains them."));
  open_->setObjectName("openRecording");
  export_->setObjectName("exportRecording");
  export_->setToolTip(tr("Writes the chosen recording as tables or as a film"));
  report_->setObjectName("reportRecording");
  report_->setToolTip(tr(
      "Writes what the session had to do with the structures on view: times, forces, distances"));
  delete_->setObjectName("deleteRecording");
  delete_->setToolTip(tr("Deletes the chosen recording, after a question"));
  auto* buttons = new QGridLayout;
  buttons->addWidget(open_, 0, 0);
  buttons->addWidget(export_, 0, 1);
  buttons->addWidget(report_, 1, 0);
  buttons->addWidget(delete_, 1, 1);

  auto* all = new QWidget;
  auto* column = new QVBoxLayout(all);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(list_, 1);
  column->addWidget(label_);
  column->addLayout(buttons);
  connect(label_, &QLineEdit::editingFinished, this, &RecordingPanel::takeLabel);
  connect(list_, &QTableWidget::itemSelectionChanged, this, &RecordingPanel::showSelected);
  connect(list_, &QTableWidget::cellActivated, this, &RecordingPanel::openSelected);
  connect(open_, &QPushButton::clicked, this, &RecordingPanel::openSelected);
  connect(export_, &QPushButton::clicked, this, [this] {
    if (const PastRecording* recording = selected()) emit exportWanted(recording->id);
  });
  connect(report_, &QPushButton::clicked, this, [this] {
    if (const PastRecording* recording = selected()) emit reportWanted(recording->id);
  });
  connect(delete_, &QPushButton::clicked, this, &RecordingPanel::askToDelete);
  return all;
}

RecordingStates RecordingPanel::states() const {
  return {.when = when_->isChecked(), .scan = scan_->isChecked()};
}

void RecordingPanel::setReady(bool ready) {
  ready_ = ready;
  showState();
}

void RecordingPanel::show(const RecordingStatus& status) {
  status_ = status;
  since_status_.start();
  showState();
}

void RecordingPanel::showState() {
  using State = RecordingStatus::State;
  const bool records = status_.state == State::Recording;
  record_->setText(records ? tr("&Stop") : tr("&Record"));
  record_->setChecked(records);
  // what has begun can be ended whatever else is
  record_->setEnabled(records || (ready_ && status_.state != State::Finishing));
  for (QCheckBox* states : {when_, scan_}) states->setEnabled(!records);
  mark_action_->setEnabled(records);
  mark_->setEnabled(records);
  note_->setEnabled(records);
  switch (status_.state) {
    case State::Off:
      state_->setText(tr("Not recording"));
      break;
    case State::Recording:
      state_->setText(tr("Recording"));
      break;
    case State::Finishing:
      state_->setText(tr("Finishing…"));
      break;
    case State::Stopped:
      state_->setText(tr("Stopped by itself: %1").arg(status_.failure));
      break;
  }
  state_->setWarning(status_.state == State::Stopped);
  elapsed_->setText(clockTime(status_.elapsed, 1));
  samples_->setText(QLocale().toString(status_.samples));
  gaps_->setText(QLocale().toString(status_.gaps));
  gaps_->setWarning(status_.gaps != 0);
  lost_->setText(tr("%1 samples were lost: the recording is not whole.")
                     .arg(QLocale().toString(status_.gaps)));
  lost_->setVisible(status_.gaps != 0);
  bytes_->setText(sizeOf(status_.bytes));
  room_->setText(status_.room ? roomFor(*status_.room) : QString{});
  room_->setWarning(status_.room && *status_.room < kLittleRoom);
}

void RecordingPanel::mark() {
  if (status_.state != RecordingStatus::State::Recording) return;
  const QString note = note_->text().trimmed();
  note_->clear();
  const double now = status_.elapsed + 1e-3 * static_cast<double>(since_status_.elapsed());
  marked_->setText(tr("Marked at %1").arg(clockTime(now, 1)));
  confirmation_.start(kConfirmed_ms);
  emit markWanted(note);
}

void RecordingPanel::show(const QList<PastRecording>& recordings) {
  std::optional<QString> before;
  if (const PastRecording* recording = selected()) before = recording->id;
  recordings_ = recordings;
  const QSignalBlocker quiet(list_);
  list_->clearSelection();
  list_->setRowCount(static_cast<int>(recordings_.size()));
  for (int row = 0; row < list_->rowCount(); ++row) {
    fillRow(row);
    if (before == recordings_[row].id) list_->selectRow(row);
  }
  showSelected();
}

void RecordingPanel::fillRow(int row) {
  const PastRecording& recording = recordings_[row];
  const QString words = linesOf(recording);
  list_->setItem(row, kWords, itemOf(words, words));
  const QString force = recording.curve.isEmpty()
                            ? tr("force not known")
                            : tr("force up to %L1 N")
                                  .arg(static_cast<double>(greatestOf(recording.curve)), 0, 'f', 1);
  QTableWidgetItem* curve = itemOf({}, force);
  curve->setData(Qt::AccessibleTextRole, force);
  if (!recording.curve.isEmpty())
    curve->setData(RecordingLines::kCurve, QVariant::fromValue(recording.curve));
  list_->setItem(row, kForce, curve);
}

void RecordingPanel::showCurve(const QString& id, const QList<float>& curve) {
  const auto found = std::ranges::find(recordings_, id, &PastRecording::id);
  if (found == recordings_.end()) return;
  found->curve = curve;
  const QSignalBlocker quiet(list_);
  fillRow(static_cast<int>(found - recordings_.begin()));
}

void RecordingPanel::takeLabel() {
  const auto found = std::ranges::find(recordings_, labelled_, &PastRecording::id);
  const QString label = label_->text().simplified();
  if (found == recordings_.end() || found->label == label) return;
  found->label = label;
  {
    const QSignalBlocker quiet(list_);
    fillRow(static_cast<int>(found - recordings_.begin()));
  }
  emit labelChanged(labelled_, label);
}

void RecordingPanel::choose(const QString& id) {
  for (int row = 0; row < list_->rowCount(); ++row)
    if (recordings_[row].id == id) list_->selectRow(row);
}

bool RecordingPanel::exportChosen() {
  if (!export_->isEnabled()) return false;
  export_->click();
  return true;
}

const PastRecording* RecordingPanel::selected() const {
  const QList<QTableWidgetSelectionRange> ranges = list_->selectedRanges();
  if (ranges.isEmpty() || ranges.first().topRow() >= recordings_.size()) return nullptr;
  return &recordings_[ranges.first().topRow()];
}

void RecordingPanel::showSelected() {
  const PastRecording* recording = selected();
  const bool finished = recording == nullptr || recording->finished;
  open_->setText(finished ? tr("Open") : tr("Recover"));
  open_->setToolTip(finished ? tr("Replays the chosen recording in the scene")
                             : tr("Restores a recording that was never finished"));
  open_->setEnabled(recording != nullptr);
  for (QPushButton* button : {export_, report_})
    button->setEnabled(recording != nullptr && finished);
  delete_->setEnabled(recording != nullptr);
  label_->setEnabled(recording != nullptr);
  const QString id = recording == nullptr ? QString{} : recording->id;
  // what is being typed stays while the list is told anew
  if (id == labelled_ && label_->hasFocus()) return;
  labelled_ = id;
  label_->setText(recording == nullptr ? QString{} : recording->label);
}

void RecordingPanel::openSelected() {
  const PastRecording* recording = selected();
  if (recording == nullptr) return;
  if (recording->finished)
    emit openWanted(recording->id);
  else
    emit recoverWanted(recording->id);
}

void RecordingPanel::askToDelete() {
  const PastRecording* recording = selected();
  if (recording == nullptr) return;
  const QString id = recording->id;  // the list may change while the question is open
  QMessageBox question(QMessageBox::Question, tr("Delete it?"),
                       tr("Delete the recording %1?").arg(linesOf(*recording).section('\n', 0, 0)),
                       QMessageBox::Cancel, this);
  question.setTextFormat(Qt::PlainText);
  question.setInformativeText(tr("It cannot be brought back."));
  const QAbstractButton* agree = question.addButton(tr("Delete"), QMessageBox::DestructiveRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() == agree) emit deleteWanted(id);
}

void RecordingPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit seen();
}

}  // namespace ui
