// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/preferences_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

#include "haptics/settings.h"
#include "ui/controls/language.h"
#include "ui/controls/number_box.h"
#include "ui/controls/warning_label.h"
#include "ui/dialogs/shortcut_list.h"
#include "ui/style/style.h"

namespace ui {
namespace {

constexpr double kUsualStiffness = 1000.0;  // N/m
constexpr int kSystemLanguage = -1;
constexpr int kTitlesWidth = 132;  // px

QLabel* explained(const QString& sentence) {
  auto* label = new QLabel(sentence);
  label->setWordWrap(true);
  style::setDim(*label);
  return label;
}

/// A choice of a few words, each with the value that it stands for.
QComboBox* choiceOf(const char* name, const QString& what, const QString& tip,
                    const QList<std::pair<QString, int>>& entries) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setAccessibleName(what);
  box->setToolTip(tip);
  for (const auto& [text, value] : entries) box->addItem(text, value);
  return box;
}

void choose(QComboBox& box, int value) { box.setCurrentIndex(box.findData(value)); }

}  // namespace

PreferencesWindow::PreferencesWindow(QWidget* parent)
    : QDialog(parent), titles_(new QListWidget), pages_(new QStackedWidget) {
  setObjectName("preferencesWindow");
  setWindowTitle(tr("Preferences"));
  titles_->setObjectName("preferencePages");
  titles_->setAccessibleName(tr("Pages"));
  titles_->setToolTip(tr("The arrow keys go from page to page"));
  titles_->setFixedWidth(kTitlesWidth);
  buildGeneral();
  buildMouse();
  buildTouch();
  buildRecordings();
  buildPrivacy();
  buildShortcuts();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* reset = buttons->addButton(tr("Reset to &defaults"), QDialogButtonBox::ResetRole);
  reset->setObjectName("resetPreferences");
  reset->setToolTip(tr("Sets all pages but the shortcuts as they are at first"));
  buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Closes the window; all is kept"));
  for (QPushButton* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(titles_);
  row->addWidget(pages_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(buttons);
  connect(titles_, &QListWidget::currentRowChanged, pages_, &QStackedWidget::setCurrentIndex);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(reset, &QPushButton::clicked, this, [this] {
    choices_ = {};
    showChoices();
    tell();
  });
  titles_->setCurrentRow(0);
  resize(800, 540);
}

QWidget* PreferencesWindow::addPage(const QString& title) {
  titles_->addItem(title);
  titles_->item(titles_->count() - 1)->setSizeHint({0, style::kControlHeight});
  auto* page = new QWidget;
  pages_->addWidget(page);
  return page;
}

void PreferencesWindow::buildGeneral() {
  auto* form = new QFormLayout(addPage(tr("General")));
  theme_ = choiceOf("themeChoice", tr("Theme"), tr("The colours of the window"),
                    {{tr("Dark"), int(style::Theme::Dark)},
                     {tr("Light"), int(style::Theme::Light)},
                     {tr("High contrast"), int(style::Theme::HighContrast)},
                     {tr("As the desktop"), int(style::Theme::System)}});
  QList<std::pair<QString, int>> languages{{tr("As the system"), kSystemLanguage}};
  for (const Language& language : kLanguages)
    languages.append({QString::fromUtf8(language.own_name), int(&language - kLanguages)});
  language_ = choiceOf("languageChoice", tr("Language"),
                       tr("The language of the window; the help is in English"), languages);
  lengths_ = choiceOf("lengthChoice", tr("Lengths"),
                      tr("The unit of measures, positions, slabs and rulers"),
                      {{tr("Millimetres"), int(LengthUnit::Millimetres)},
                       {tr("Centimetres"), int(LengthUnit::Centimetres)}});
  hints_ = new QCheckBox(tr("Show the mouse's functions below each view"));
  hints_->setObjectName("hintsChoice");
  hints_->setToolTip(tr("Shows a line of hints at the foot of each view"));
  form->addRow(tr("&Theme"), theme_);
  form->addRow(tr("L&anguage"), language_);
  form->addRow(explained(tr("The language changes at the next start.")));
  form->addRow(tr("&Lengths"), lengths_);
  form->addRow(
      explained(tr("In measures and slices. Voxels, tools and the fields of edits stay in "
                   "millimetres, forces in newtons.")));
  form->addRow(hints_);
  connect(theme_, &QComboBox::activated, this, [this] {
    choices_.theme = static_cast<style::Theme>(theme_->currentData().toInt());
    tell();
  });
  connect(language_, &QComboBox::activated, this, [this] {
    const int chosen = language_->currentData().toInt();
    choices_.language = chosen == kSystemLanguage ? "" : kLanguages[chosen].code;
    tell();
  });
  connect(lengths_, &QComboBox::activated, this, [this] {
    choices_.lengths = static_cast<LengthUnit>(lengths_->currentData().toInt());
    tell();
  });
  connect(hints_, &QCheckBox::clicked, this, [this](bool on) {
    choices_.hints = on;
    tell();
  });
}

void PreferencesWindow::buildMouse() {
  auto* form = new QFormLayout(addPage(tr("Mouse")));
  mouse_at_first_ =
      choiceOf("mouseChoice", tr("At first the mouse"),
               tr("Function of a drag in the 3-D view when the mouse becomes the hand"),
               {{tr("looks: a drag turns the picture"), int(MouseMode::Look)},
                {tr("takes the tool: a drag moves it"), int(MouseMode::Hand)}});
  slice_wheel_ = choiceOf("sliceWheelChoice", tr("Wheel over slices, turned away"),
                          tr("Slice that follows when the wheel is turned away from you"),
                          {{tr("next slice"), 0}, {tr("slice before"), 1}});
  zoom_wheel_ =
      choiceOf("zoomWheelChoice", tr("Wheel for the size, turned away"),
               tr("Zoom in 3-D, and with Ctrl over slices, when the wheel is turned away from you"),
               {{tr("zooms in"), 0}, {tr("zooms out"), 1}});
  form->addRow(tr("&At first the mouse"), mouse_at_first_);
  form->addRow(tr("Wheel over &slices, turned away"), slice_wheel_);
  form->addRow(tr("Wheel for the si&ze, turned away"), zoom_wheel_);
  form->addRow(explained(tr("All that the mouse does is in the list of shortcuts.")));
  connect(mouse_at_first_, &QComboBox::activated, this, [this] {
    choices_.mouse.at_first = static_cast<MouseMode>(mouse_at_first_->currentData().toInt());
    tell();
  });
  connect(slice_wheel_, &QComboBox::activated, this, [this] {
    choices_.mouse.slices_reversed = slice_wheel_->currentData().toInt() != 0;
    tell();
  });
  connect(zoom_wheel_, &QComboBox::activated, this, [this] {
    choices_.mouse.zoom_reversed = zoom_wheel_->currentData().toInt() != 0;
    tell();
  });
}

void PreferencesWindow::buildTouch() {
  auto* form = new QFormLayout(addPage(tr("Touch")));
  stiffness_always_ = new QCheckBox(tr("Begin each time with the &stiffness"));
  stiffness_always_->setObjectName("stiffnessAlways");
  stiffness_always_->setToolTip(tr("If not set, the stiffness of the last session is used"));
  stiffness_ = new NumberBox;
  stiffness_->setObjectName("stiffnessAtFirst");
  stiffness_->setAccessibleName(tr("Stiffness at first"));
  stiffness_->setToolTip(tr("The spring between hand and tool; a haptic device brings its own"));
  stiffness_->setDecimals(0);
  stiffness_->setRange(haptics::kStiffnessRange.least, haptics::kStiffnessRange.most);
  stiffness_->setSingleStep(100);
  stiffness_->setSuffix(tr(" N/m"));
  form->addRow(stiffness_always_);
  form->addRow(stiffness_);
  form->addRow(explained(tr("A haptic device begins with half of its rated stiffness.")));
  servo_rate_ = new QComboBox;
  servo_rate_->setObjectName("servoRate");
  servo_rate_->setToolTip(tr("How often in a second the touch is computed"));
  servo_rate_->addItem(tr("As the device allows"), 0);
  for (const int hz : kServoRateChoices)
    servo_rate_->addItem(tr("%1 times a second").arg(QLocale().toString(hz)), hz);
  form->addRow(tr("Touch is &computed"), servo_rate_);
  form->addRow(
      explained(tr("A higher rate allows a stiffer touch, and needs as much more of the processor. "
                   "It applies to the next device or hand that is opened; a device gets no more "
                   "than its link allows, the mouse 1 kHz unless you choose.")));
  connect(servo_rate_, &QComboBox::activated, this, [this] {
    const int hz = servo_rate_->currentData().toInt();
    choices_.servo_rate = hz > 0 ? std::optional{hz} : std::nullopt;
    tell();
  });
  const auto take = [this] {
    stiffness_->setEnabled(stiffness_always_->isChecked());
    choices_.stiffness =
        stiffness_always_->isChecked() ? std::optional{stiffness_->value()} : std::nullopt;
    tell();
  };
  connect(stiffness_always_, &QCheckBox::clicked, this, take);
  connect(stiffness_, &NumberBox::valueChanged, this, take);
}

void PreferencesWindow::buildRecordings() {
  auto* column = new QVBoxLayout(addPage(tr("Recordings")));
  folder_ = new QLabel;
  folder_->setObjectName("recordingsFolder");
  folder_->setWordWrap(true);
  folder_->setTextFormat(Qt::PlainText);
  folder_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* choose_folder = new QPushButton(tr("&Choose a folder…"));
  choose_folder->setObjectName("chooseRecordings");
  choose_folder->setToolTip(tr("New recordings are written there, and listed from there"));
  own_folder_button_ = new QPushButton(tr("&Own folder"));
  own_folder_button_->setObjectName("ownRecordings");
  own_folder_button_->setToolTip(tr("Takes Palpate's own folder among your files again"));
  refusal_ = new WarningLabel;
  refusal_->setObjectName("recordingsRefusal");
  refusal_->setWordWrap(true);
  refusal_->setTextFormat(Qt::PlainText);
  refusal_->setWarning(true);
  refusal_->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(choose_folder);
  row->addWidget(own_folder_button_);
  row->addStretch();
  column->addWidget(new QLabel(tr("Recordings are in")));
  column->addWidget(folder_);
  column->addLayout(row);
  column->addWidget(refusal_);
  column->addWidget(
      explained(tr("Recordings that are there stay where they are. A recording "
                   "that is running is finished where it began.")));
  column->addStretch();
  connect(choose_folder, &QPushButton::clicked, this, &PreferencesWindow::chooseFolder);
  connect(own_folder_button_, &QPushButton::clicked, this, [this] {
    choices_.recordings.clear();
    showFolder();
    tell();
  });
}

void PreferencesWindow::buildPrivacy() {
  auto* column = new QVBoxLayout(addPage(tr("Privacy")));
  places_ = new QCheckBox(tr("&Remember recent places"));
  places_->setObjectName("placesChoice");
  places_->setToolTip(
      tr("Keeps the eight newest folders and files for File > Open recent, and your work on scans "
         "until you save or discard it; off forgets both"));
  places_said_ = explained({});
  places_said_->setObjectName("placesSaid");
  auto* forget = new QPushButton(tr("&Forget them now"));
  forget->setObjectName("forgetPlacesNow");
  forget->setToolTip(tr("Removes the recent places and the work that was kept at once"));
  auto* row = new QHBoxLayout;
  row->addWidget(forget);
  row->addStretch();
  column->addWidget(places_);
  column->addWidget(places_said_);
  column->addLayout(row);
  column->addWidget(
      explained(tr("While you work, marks, notes and edits are kept in your own folder, for your "
                   "eyes alone, and offered again if Palpate ends before you saved them. Notes are "
                   "kept as you wrote them.")));
  column->addWidget(
      explained(tr("Palpate keeps no name, no date and no picture of a scan, and uses the network "
                   "only if you open a scan from a PACS. It asks before it saves or copies a "
                   "picture that may show a face.")));
  column->addStretch();
  connect(places_, &QCheckBox::clicked, this, [this](bool on) {
    choices_.places_remembered = on;
    tell();
  });
  connect(forget, &QPushButton::clicked, this, &PreferencesWindow::forgetPlacesWanted);
}

void PreferencesWindow::buildShortcuts() {
  auto* column = new QVBoxLayout(addPage(tr("Shortcuts")));
  auto* list = new ShortcutList;
  column->addWidget(list);
  connect(list, &ShortcutList::keysChanged, this, &PreferencesWindow::keysChanged);
}

void PreferencesWindow::show(const PreferenceChoices& choices, const QString& own_folder) {
  choices_ = choices;
  own_folder_ = own_folder;
  showRefusal({});
  showChoices();
}

void PreferencesWindow::showChoices() {
  choose(*theme_, int(choices_.theme));
  int language = kSystemLanguage;
  for (const Language& known : kLanguages)
    if (choices_.language == QLatin1String(known.code)) language = int(&known - kLanguages);
  choose(*language_, language);
  choose(*lengths_, int(choices_.lengths));
  hints_->setChecked(choices_.hints);
  choose(*mouse_at_first_, int(choices_.mouse.at_first));
  choose(*slice_wheel_, choices_.mouse.slices_reversed ? 1 : 0);
  choose(*zoom_wheel_, choices_.mouse.zoom_reversed ? 1 : 0);
  const QSignalBlocker quiet(stiffness_);
  stiffness_always_->setChecked(choices_.stiffness.has_value());
  stiffness_->setValue(choices_.stiffness.value_or(kUsualStiffness));
  stiffness_->setEnabled(choices_.stiffness.has_value());
  choose(*servo_rate_, choices_.servo_rate.value_or(0));
  places_->setChecked(choices_.places_remembered);
  showFolder();
}

void PreferencesWindow::showFolder() {
  folder_->setText(choices_.recordings.isEmpty() ? own_folder_ : choices_.recordings);
  own_folder_button_->setEnabled(!choices_.recordings.isEmpty());
}

void PreferencesWindow::showRefusal(const QString& sentence) {
  refusal_->setText(sentence);
  refusal_->setVisible(!sentence.isEmpty());
}

void PreferencesWindow::showPlaces(int count) {
  places_said_->setText(count == 0   ? tr("No place is remembered.")
                        : count == 1 ? tr("One place is remembered.")
                                     : tr("%1 places are remembered.").arg(count));
}

void PreferencesWindow::chooseFolder() {
  // Qt's own dialog: in a foreign one Escape would not reach the application
  QFileDialog dialog(this, tr("Folder of recordings"), folder_->text());
  dialog.setFileMode(QFileDialog::Directory);
  dialog.setOption(QFileDialog::ShowDirsOnly);
  dialog.setOption(QFileDialog::DontUseNativeDialog);
  if (dialog.exec() != QDialog::Accepted) return;
  choices_.recordings = dialog.selectedFiles().value(0);
  showFolder();
  tell();
}

void PreferencesWindow::tell() {
  showRefusal({});
  emit changed(choices_);
}

}  // namespace ui
