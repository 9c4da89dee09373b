// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/replay_bar.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>

#include "ui/controls/bindings.h"
#include "ui/controls/figure.h"
#include "ui/controls/time_words.h"
#include "ui/controls/warning_label.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr int kListedNote = 60;  // characters in the list of marks
constexpr std::array<double, 7> kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0};

}  // namespace

ReplayBar::ReplayBar(QWidget* parent)
    : QFrame(parent),
      warning_(new WarningLabel),
      timeline_(new ReplayTimeline),
      play_(button("replayPlay", tr("Pause"), {})),
      speeds_(new QComboBox),
      marks_(new QComboBox),
      time_(new Figure(tr("Time"))) {
  warning_->setObjectName("replayWarning");
  warning_->setWordWrap(true);
  warning_->setTextFormat(Qt::PlainText);
  warning_->setWarning(true);
  warning_->hide();
  timeline_->setObjectName("replayTimeline");
  // both words fit, so nothing moves when they change
  play_->setMinimumWidth(play_->sizeHint().width());
  auto* back = button("replayBack", tr("Step back"), {});
  auto* forward = button("replayForward", tr("Step on"), {});
  back->setAutoRepeat(true);
  forward->setAutoRepeat(true);
  back->setAccessibleName(tr("One tick back"));
  forward->setAccessibleName(tr("One tick forward"));
  whenKeysChange(*this, [this, back, forward] {
    play_->setToolTip(
        tr("Play or pause (%1 while the bar has the focus)").arg(keyOf(Action::PlayPause)));
    back->setToolTip(withKey(tr("One tick back"), Action::TickBack));
    forward->setToolTip(withKey(tr("One tick forward"), Action::TickForward));
  });
  auto* close = button("replayClose", tr("Close"), tr("Back to the live session"));
  speeds_->setObjectName("replaySpeed");
  speeds_->setAccessibleName(tr("Speed"));
  speeds_->setToolTip(tr("How fast the recording plays"));
  for (const double speed : kSpeeds) speeds_->addItem(tr("%L1 ×").arg(speed), speed);
  speeds_->setCurrentIndex(speeds_->findData(1.0));
  marks_->setObjectName("replayMarks");
  marks_->setAccessibleName(tr("Marks"));
  marks_->setToolTip(tr("Shows a mark that was set during the recording"));
  marks_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  marks_->setMinimumContentsLength(12);
  time_->setObjectName("replayTime");
  time_->setFont(style::tabular(time_->font()));

  auto* row = new QHBoxLayout;
  row->addWidget(play_);
  row->addWidget(back);
  row->addWidget(forward);
  row->addSpacing(8);
  auto* speed_label = new QLabel(tr("Speed"));
  // a combo box is known by its label
  speed_label->setBuddy(speeds_);
  row->addWidget(speed_label);
  row->addWidget(speeds_);
  row->addSpacing(8);
  auto* marks_label = new QLabel(tr("Marks"));
  marks_label->setBuddy(marks_);
  row->addWidget(marks_label);
  row->addWidget(marks_);
  row->addSpacing(8);
  row->addWidget(time_);
  row->addStretch();
  row->addWidget(close);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(4);
  column->addWidget(warning_);
  column->addWidget(timeline_);
  column->addLayout(row);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  setFocusProxy(timeline_);

  const auto toggle = [this] { emit playWanted(!playing_); };
  connect(play_, &QToolButton::clicked, this, toggle);
  connect(timeline_, &ReplayTimeline::playToggled, this, toggle);
  connect(timeline_, &ReplayTimeline::timeWanted, this, &ReplayBar::timeWanted);
  connect(timeline_, &ReplayTimeline::stepWanted, this, &ReplayBar::stepWanted);
  connect(back, &QToolButton::clicked, this, [this] { emit stepWanted(-1); });
  connect(forward, &QToolButton::clicked, this, [this] { emit stepWanted(1); });
  connect(speeds_, &QComboBox::activated, this, [this] { emit speedChosen(speed()); });
  connect(marks_, &QComboBox::activated, this, [this](int chosen) {
    const double time = marks_->itemData(chosen).toDouble();
    marks_->setCurrentIndex(-1);  // so that the same mark may be chosen again
    emit timeWanted(time);
  });
  connect(close, &QToolButton::clicked, this, &ReplayBar::closeWanted);
  setPlaying(false);
}

QToolButton* ReplayBar::button(const char* name, const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setObjectName(name);
  made->setText(text);
  made->setToolTip(tip);
  made->installEventFilter(this);
  return made;
}

bool ReplayBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
  // on a button, too, the arrows mean ticks and not the button beside it
  const Binding* meaning = meaningOf(Where::ReplayBar, *static_cast<QKeyEvent*>(event));
  if (meaning == nullptr ||
      (meaning->action != Action::TickBack && meaning->action != Action::TickForward))
    return false;
  emit stepWanted(meaning->action == Action::TickBack ? -1 : 1);
  return true;
}

double ReplayBar::speed() const { return speeds_->currentData().toDouble(); }

void ReplayBar::show(ReplayTrack track) {
  timeline_->show(std::move(track));
  listMarks();
  setTime(timeline_->track().begin);
  setPlaying(false);
  showWarning({});
  show();
}

void ReplayBar::listMarks() {
  marks_->clear();
  for (const ReplayMark& mark : timeline_->track().marks) {
    if (mark.kind != QLatin1String("mark")) continue;
    const QString note = mark.note.simplified();
    const QString shown =
        note.size() > kListedNote ? note.left(kListedNote) + QStringLiteral("…") : note;
    marks_->addItem(tr("%1  %2").arg(clockTime(mark.time, 1), shown).trimmed(), mark.time);
  }
  marks_->setCurrentIndex(-1);
  marks_->setEnabled(marks_->count() > 0);
  marks_->setPlaceholderText(marks_->count() > 0 ? tr("Marks (%1)").arg(marks_->count())
                                                 : tr("No marks"));
  marks_->view()->setMinimumWidth(marks_->count() > 0 ? marks_->view()->sizeHintForColumn(0) + 24
                                                      : 0);
}

void ReplayBar::setTime(double time) {
  timeline_->setTime(time);
  time_->setText(tr("%1 / %2").arg(clockTime(time, 3), clockTime(timeline_->track().end, 3)));
}

void ReplayBar::setPlaying(bool playing) {
  playing_ = playing;
  play_->setText(playing ? tr("Pause") : tr("Play"));
}

void ReplayBar::showWarning(const QString& sentence) {
  warning_->setText(sentence);
  warning_->setVisible(!sentence.isEmpty());
}

}  // namespace ui
