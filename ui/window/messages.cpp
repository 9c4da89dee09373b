// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/messages.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QVBoxLayout>
#include <utility>

#include "ui/window/banner.h"

namespace ui {

Messages::Messages(QMainWindow& window)
    : QObject(&window),
      window_(window),
      fault_(new Banner(Banner::Kind::Fault, "fault")),
      message_(new Banner(Banner::Kind::Attention, "message")),
      done_(new Banner(Banner::Kind::Done, "done")),
      offer_(new Banner(Banner::Kind::Attention, "offer")),
      work_(new Banner(Banner::Kind::Attention, "work")),
      more_of_fault_(fault_->addButton("faultMore")),
      more_of_message_(message_->addButton("messageMore")),
      take_offer_(offer_->addButton("takeOffer")),
      take_work_(work_->addButton("takeWork")) {
  for (QPushButton* more : {more_of_fault_, more_of_message_}) {
    more->setText(tr("More"));
    more->setToolTip(tr("Shows the cause and the remedy in the help"));
    connect(more, &QPushButton::clicked, this,
            [this, more] { emit helpWanted(more->property("place").toString()); });
  }
  QPushButton* folder = done_->addButton("showInFolder");
  folder->setText(tr("Show in folder"));
  connect(folder, &QPushButton::clicked, this, [this] { emit folderWanted(done_folder_); });
  connect(take_offer_, &QPushButton::clicked, this, [this] {
    offer_->hide();
    const auto take = offered_;  // what it does may offer something else
    take();
  });
  QPushButton* drop = work_->addButton("dropWork");
  drop->setText(tr("&Discard"));
  const auto answer = [this](QPushButton* button, std::function<void()> Messages::*done) {
    connect(button, &QPushButton::clicked, this, [this, done] {
      work_->hide();
      const auto call = this->*done;  // which may show another
      call();
    });
  };
  answer(take_work_, &Messages::work_taken_);
  answer(drop, &Messages::work_dropped_);
  for (Banner* banner : {fault_, message_, done_, offer_, work_}) banner->addClose();
}

void Messages::placeIn(QVBoxLayout& column) {
  for (Banner* banner : {fault_, message_, done_, offer_, work_}) column.addWidget(banner);
}

QWidget* Messages::window() { return &window_; }

void Messages::showMessage(const QString& sentence) {
  done_->hide();
  explain(*more_of_message_, sentence);
  message_->setSentence(sentence);
  message_->show();
}

void Messages::showBriefly(const QString& sentence, int ms) {
  window_.statusBar()->showMessage(sentence, ms);
}

void Messages::clear() {
  message_->hide();
  done_->hide();
}

void Messages::showDone(const QString& sentence, const QString& folder) {
  message_->hide();
  done_->setSentence(sentence);
  done_folder_ = folder;
  done_->show();
}

void Messages::showOffer(const QString& sentence, const QString& button,
                         std::function<void()> take) {
  offer_->setSentence(sentence);
  take_offer_->setText(button);
  offered_ = std::move(take);
  offer_->show();
}

void Messages::hideOffer() { offer_->hide(); }

void Messages::showWork(const QString& sentence, const QString& button, std::function<void()> take,
                        std::function<void()> drop) {
  work_->setSentence(sentence);
  take_work_->setText(button);
  work_taken_ = std::move(take);
  work_dropped_ = std::move(drop);
  work_->show();
}

void Messages::hideWork() { work_->hide(); }

void Messages::showFault(const QString& sentence) {
  explain(*more_of_fault_, sentence);
  fault_->setSentence(sentence);
  fault_->show();
}

void Messages::explain(QPushButton& more, const QString& sentence) {
  const QString place = explainer_ ? explainer_(sentence) : QString{};
  more.setProperty("place", place);
  more.setVisible(!place.isEmpty());
}

bool Messages::askWhether(const QString& what, const QString& consequence, const QString& yes) {
  QMessageBox question(QMessageBox::Question, tr("Please confirm"), what, QMessageBox::Cancel,
                       window());
  question.setInformativeText(consequence);
  const QAbstractButton* agree = question.addButton(yes, QMessageBox::AcceptRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  return question.clickedButton() == agree;
}

Unsaved Messages::askToSave(const QString& what, const QString& consequence) {
  QMessageBox question(QMessageBox::Question, tr("Not saved"), what, QMessageBox::Cancel, window());
  question.setInformativeText(consequence);
  const QAbstractButton* save = question.addButton(tr("&Save view…"), QMessageBox::AcceptRole);
  const QAbstractButton* discard = question.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() == save) return Unsaved::Save;
  return question.clickedButton() == discard ? Unsaved::Discard : Unsaved::Cancel;
}

Unfinished Messages::askToFinish() {
  QMessageBox question(QMessageBox::Question, tr("Not finished"),
                       tr("A file is still being written."), QMessageBox::Cancel, window());
  question.setInformativeText(
      tr("The window can close while it is finished in the background. If it is stopped, no file "
         "remains."));
  const QAbstractButton* finish =
      question.addButton(tr("&Finish in the background"), QMessageBox::AcceptRole);
  const QAbstractButton* stop = question.addButton(tr("&Stop it"), QMessageBox::DestructiveRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() == finish) return Unfinished::Finish;
  return question.clickedButton() == stop ? Unfinished::Stop : Unfinished::Cancel;
}

OpenedAs Messages::askHowToOpen(const QString& name) {
  QMessageBox question(QMessageBox::Question, tr("Structures, or a scan"),
                       tr("\"%1\" has the same voxels as the scan on view.").arg(name),
                       QMessageBox::Cancel, window());
  question.setInformativeText(
      tr("Structures are shown in the scan on view. A scan takes its place."));
  const QAbstractButton* structures =
      question.addButton(tr("Show s&tructures"), QMessageBox::AcceptRole);
  const QAbstractButton* scan = question.addButton(tr("&Open as a scan"), QMessageBox::AcceptRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() == structures) return OpenedAs::Structures;
  return question.clickedButton() == scan ? OpenedAs::Scan : OpenedAs::Cancel;
}

std::optional<bool> Messages::askIfLeft(const QString& why) {
  QMessageBox question(QMessageBox::Question, tr("Left or right"), why, QMessageBox::Cancel,
                       window());
  question.setInformativeText(
      tr("The program that wrote the file knows. A wrong answer mirrors the structure."));
  const QAbstractButton* left =
      question.addButton(tr("x points to the &left (LPS)"), QMessageBox::AcceptRole);
  const QAbstractButton* right =
      question.addButton(tr("x points to the &right (RAS)"), QMessageBox::AcceptRole);
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() == left) return true;
  if (question.clickedButton() == right) return false;
  return {};
}

std::optional<QString> withEnding(Messages& messages, QString path, const QString& ending) {
  if (path.endsWith(ending, Qt::CaseInsensitive)) return path;
  path += ending;
  if (QFileInfo::exists(path) &&
      !messages.askWhether(Messages::tr("\"%1\" is there already.").arg(QFileInfo(path).fileName()),
                           Messages::tr("It is written over."), Messages::tr("Write over it")))
    return {};
  return path;
}

QString noticeText() {
  return Messages::tr(
      "Not a medical device. Not for diagnosis. Force feedback hardware can move suddenly.");
}

void Messages::showNotice() {
  QMessageBox box(QMessageBox::Warning, tr("Before you begin"), noticeText(), QMessageBox::Ok,
                  window());
  box.setInformativeText(
      tr("Keep hands and face clear of a device until it is at rest. Escape takes the force away "
         "at any time."));
  box.exec();
}

}  // namespace ui
