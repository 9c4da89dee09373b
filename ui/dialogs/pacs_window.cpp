// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/pacs_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/controls/number_box.h"
#include "ui/controls/warning_label.h"
#include "ui/style/style.h"

namespace ui {
namespace {

using Login = PacsServer::Login;

enum PacsColumn {
  PacsStudy,
  PacsModality,
  PacsDate,
  PacsNumber,
  PacsImages,
  PacsPatient,
  PacsPatientId,
  PacsStudyName,
  PacsSeriesName,
  kPacsColumns
};

QPushButton* button(const char* name, const QString& words, const QString& tip) {
  auto* made = new QPushButton(words);
  made->setObjectName(name);
  made->setToolTip(tip);
  made->setAutoDefault(false);
  return made;
}

QLineEdit* line(const char* name, const QString& words, const QString& tip) {
  auto* made = new QLineEdit;
  made->setObjectName(name);
  made->setAccessibleName(words);
  made->setToolTip(tip);
  return made;
}

/// "20240305" as the desktop writes dates; what is no date as it is.
QString dateWords(const QString& date) {
  const QDate day = QDate::fromString(date, QStringLiteral("yyyyMMdd"));
  return day.isValid() ? QLocale().toString(day, QLocale::ShortFormat) : date;
}

/// The desktop's, with the whole year.
QString dateFormat() {
  QString format = QLocale().dateFormat(QLocale::ShortFormat);
  if (!format.contains("yyyy")) format.replace("yy", "yyyy");
  return format;
}

/// A day, or a span of days, as an archive has it: "20240301-20240331". Days are taken as the
/// desktop writes them, as 2024-03-01 and as 20240301; other text stays.
QString storedDates(const QString& typed) {
  const auto dayOf = [](const QString& words) {
    QString format = dateFormat();
    if (!format.contains("MMM")) format.replace("dd", "d").replace("MM", "M");  // or two digits
    for (const QString& as : {format, QStringLiteral("yyyy-MM-dd"), QStringLiteral("yyyyMMdd")})
      if (const QDate day = QLocale().toDate(words.trimmed(), as); day.isValid())
        return day.toString(QStringLiteral("yyyyMMdd"));
    return QString{};
  };
  const QString text = typed.trimmed();
  if (const QString day = dayOf(text); !day.isEmpty()) return day;
  // each hyphen may be the one between two days
  for (qsizetype at = text.indexOf('-'); at >= 0; at = text.indexOf('-', at + 1)) {
    const QString first = text.left(at).trimmed(), last = text.mid(at + 1).trimmed();
    const QString from = dayOf(first), until = dayOf(last);
    if ((first.isEmpty() || !from.isEmpty()) && (last.isEmpty() || !until.isEmpty()) &&
        !(first.isEmpty() && last.isEmpty()))
      return from + '-' + until;
  }
  return text;
}

/// As a user of this desktop would type it.
QString exampleOfDates() {
  const auto words = [&](int day) { return QLocale().toString(QDate(2024, 3, day), dateFormat()); };
  return words(1) + " - " + words(31);
}

QString countWords(const std::optional<qint64>& count) {
  return count ? QLocale().toString(*count) : QString{};
}

}  // namespace

PacsServerDialog::PacsServerDialog(const PacsServer& server, QWidget* parent)
    : QDialog(parent), form_(new QFormLayout) {
  setObjectName("pacsServer");
  setWindowTitle(tr("Server"));
  name_ = field("pacsName", tr("&Name"), tr("Your name for the server"), server.name);
  kind_ = new QComboBox;
  kind_->setObjectName("pacsKind");
  kind_->addItem(tr("DICOMweb"), true);
  kind_->addItem(tr("DIMSE (C-FIND, C-GET)"), false);
  kind_->setCurrentIndex(server.web ? 0 : 1);
  kind_->setToolTip(tr("Protocol of the server; DICOMweb if the server has it"));
  form_->addRow(tr("&Protocol"), kind_);
  url_ = field("pacsUrl", tr("&Address"), tr("The URL that ends before /studies"), server.url);
  url_->setPlaceholderText(QStringLiteral("https://pacs.example.org/dicom-web"));
  host_ = field("pacsHost", tr("&Host"), tr("Name or address of the server"), server.host);
  port_ = new NumberBox;
  port_->setObjectName("pacsPort");
  port_->setDecimals(0);
  port_->setRange(1, 65535);
  port_->setValue(server.port);
  port_->setToolTip(tr("The server's port, often 104 or 11112"));
  form_->addRow(tr("P&ort"), port_);
  called_ = field("pacsCalled", tr("AE title of the &server"),
                  tr("As its administrator has named it"), server.called);
  calling_ = field("pacsCalling", tr("AE title of &Palpate"),
                   tr("The server must know this title and this computer"), server.calling);
  tls_ = new QCheckBox(tr("&TLS"));
  tls_->setObjectName("pacsTls");
  tls_->setChecked(server.tls);
  tls_->setToolTip(tr("Encrypts the connection and checks the server's certificate"));
  form_->addRow(tls_);
  moves_ = new QCheckBox(tr("Fetch by C-&MOVE, at"));
  moves_->setObjectName("pacsMoves");
  moves_->setChecked(!server.move.isEmpty());
  moves_->setToolTip(
      tr("For servers without C-GET. During a transfer, this computer then takes a connection from "
         "the server at this address"));
  move_ = line("pacsMove", tr("Address and port for C-MOVE"),
               tr("Address and port at which the server reaches this computer"));
  move_->setText(server.move);
  move_->setPlaceholderText(QStringLiteral("192.0.2.7:11113"));
  form_->addRow(moves_, move_);
  login_ = new QComboBox;
  login_->setObjectName("pacsLogin");
  login_->addItem(tr("none"), int(Login::None));
  login_->addItem(tr("user and password, asked each time"), int(Login::Basic));
  login_->addItem(tr("token, asked each time"), int(Login::Bearer));
  login_->addItem(tr("from the desktop's keyring"), int(Login::Keyring));
  login_->setCurrentIndex(login_->findData(int(server.login)));
  login_->setToolTip(tr("Sign-in at the server; Palpate stores no password"));
  form_->addRow(tr("&Login"), login_);
  user_ = field("pacsUser", tr("&User"), tr("The user's name at the server"), server.user);
  authority_ =
      file("pacsAuthority", tr("&Trusted certificates"),
           tr("Certificates (PEM) that are trusted beside the system's"), server.authority);
  certificate_ = file("pacsCertificate", tr("Own &certificate"),
                      tr("Certificate (PEM) of this computer, if the server requires one"),
                      server.certificate);
  key_ = file("pacsKey", tr("Its private &key"), tr("Private key (PEM) of that certificate"),
              server.key);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form_);
  column->addWidget(buttons);
  connect(kind_, &QComboBox::currentIndexChanged, this, &PacsServerDialog::showKind);
  connect(login_, &QComboBox::currentIndexChanged, this, &PacsServerDialog::showKind);
  connect(moves_, &QCheckBox::toggled, move_, &QWidget::setEnabled);
  move_->setEnabled(moves_->isChecked());
  showKind();
}

QLineEdit* PacsServerDialog::field(const char* name, const QString& words, const QString& tip,
                                   const QString& text) {
  auto* made = line(name, QString(words).remove('&'), tip);
  made->setText(text);
  form_->addRow(words, made);
  return made;
}

QLineEdit* PacsServerDialog::file(const char* name, const QString& words, const QString& tip,
                                  const QString& text) {
  auto* made = line(name, QString(words).remove('&'), tip);
  made->setText(text);
  auto* choose = button("", tr("…"), tr("Chooses a file"));
  choose->setAccessibleName(tr("Choose: %1").arg(QString(words).remove('&')));
  connect(choose, &QPushButton::clicked, this, [this, made, words] {
    // Qt's own dialog: in a foreign one Escape would not reach the application
    QFileDialog dialog(this, QString(words).remove('&'));
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.setFileMode(QFileDialog::ExistingFile);
    if (dialog.exec() == QDialog::Accepted) made->setText(dialog.selectedFiles().value(0));
  });
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(made, 1);
  layout->addWidget(choose);
  form_->addRow(words, row);
  form_->labelForField(row)->setObjectName(QString(name) + "Words");
  return made;
}

void PacsServerDialog::showKind() {
  const bool web = kind_->currentData().toBool();
  const auto show = [this](QWidget* part, bool shown) { form_->setRowVisible(part, shown); };
  show(url_, web);
  show(login_, web);
  const auto login = static_cast<Login>(login_->currentData().toInt());
  show(user_, web && (login == Login::Basic || login == Login::Keyring));
  for (QWidget* part :
       {static_cast<QWidget*>(host_), static_cast<QWidget*>(port_), static_cast<QWidget*>(called_),
        static_cast<QWidget*>(calling_), static_cast<QWidget*>(tls_), static_cast<QWidget*>(move_)})
    show(part, !web);
  adjustSize();
}

PacsServer PacsServerDialog::server() const {
  PacsServer server;
  server.name = name_->text().simplified();
  server.web = kind_->currentData().toBool();
  server.authority = authority_->text().trimmed();
  server.certificate = certificate_->text().trimmed();
  server.key = key_->text().trimmed();
  if (server.web) {
    server.url = url_->text().trimmed();
    server.login = static_cast<Login>(login_->currentData().toInt());
    server.user = user_->text().trimmed();
  } else {
    server.host = host_->text().trimmed();
    server.port = static_cast<int>(port_->value());
    server.called = called_->text().trimmed();
    server.calling = calling_->text().trimmed();
    server.tls = tls_->isChecked();
    if (moves_->isChecked()) server.move = move_->text().trimmed();
  }
  if (server.name.isEmpty()) server.name = server.web ? server.url : server.host;
  return server;
}

PacsWindow::PacsWindow(QWidget* parent) : QDialog(parent) {
  setObjectName("pacsWindow");
  setWindowTitle(tr("From PACS"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(buildServers());
  column->addWidget(buildSearch());
  column->addWidget(buildResults(), 1);
  resize(820, 620);
  setBusy({});
  showSeries({}, false);
  showServers({}, 0);
}

QWidget* PacsWindow::buildServers() {
  server_ = new QComboBox;
  server_->setObjectName("pacsServers");
  server_->setAccessibleName(tr("Server"));
  server_->setToolTip(tr("The archive to search"));
  server_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  server_->setMinimumContentsLength(24);
  add_ = button("pacsAdd", tr("&Add…"), tr("Describes another server"));
  edit_ = button("pacsEdit", tr("&Edit…"), tr("Changes the entries for the server"));
  remove_ = button("pacsRemove", tr("&Remove"), tr("Forgets the server"));
  test_ = button("pacsTest", tr("&Test"), tr("Tests the connection and names the fault"));
  secret_words_ = new QLabel;
  secret_ = line("pacsSecret", tr("Password or token"),
                 tr("For the server; it is stored in no file of Palpate, and forgotten when the "
                    "window closes"));
  secret_->setEchoMode(QLineEdit::Password);
  remember_ = button("pacsRemember", tr("&Keep"), tr("Stores it in the desktop's keyring"));
  forget_ = button("pacsForget", tr("For&get"), tr("Removes it from the desktop's keyring"));
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Server")));
  row->addWidget(server_, 1);
  for (QPushButton* one : {add_, edit_, remove_, test_}) row->addWidget(one);
  auto* second = new QHBoxLayout;
  second->addWidget(secret_words_);
  second->addWidget(secret_, 1);
  second->addWidget(remember_);
  second->addWidget(forget_);
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addLayout(second);
  connect(server_, &QComboBox::activated, this, [this](int chosen) {
    showOther();
    emit serversChanged(servers_, chosen);
  });
  connect(add_, &QPushButton::clicked, this, [this] { edit(true); });
  connect(edit_, &QPushButton::clicked, this, [this] { edit(false); });
  connect(remove_, &QPushButton::clicked, this, &PacsWindow::remove);
  connect(test_, &QPushButton::clicked, this, &PacsWindow::testWanted);
  connect(remember_, &QPushButton::clicked, this, &PacsWindow::rememberWanted);
  connect(forget_, &QPushButton::clicked, this, &PacsWindow::forgetWanted);
  connect(secret_, &QLineEdit::textChanged, this, &PacsWindow::showChosen);
  return part;
}

QWidget* PacsWindow::buildSearch() {
  const QString wild = tr("; * and ? stand for any letters");
  patient_id_ =
      line("pacsPatientId", tr("Patient's number"), tr("The number of the patient") + wild);
  patient_name_ =
      line("pacsPatientName", tr("Patient's name"), tr("FAMILY^GIVEN, as in the archive") + wild);
  accession_ = line("pacsAccession", tr("Accession number"), tr("The number of the order") + wild);
  date_ =
      line("pacsDate", tr("Date"),
           tr("A day, or the first and the last with a hyphen between them, either left out: %1")
               .arg(exampleOfDates()));
  date_->setPlaceholderText(exampleOfDates());
  modality_ = new QComboBox;
  modality_->setObjectName("pacsModality");
  modality_->setAccessibleName(tr("Modality"));
  modality_->setToolTip(tr("Kind of scan to search for"));
  modality_->addItem(tr("CT"), "CT");
  modality_->addItem(tr("MR"), "MR");
  modality_->addItem(tr("any"), "");
  search_ = button("pacsSearch", tr("&Search"), tr("Lists the series that match"));
  names_wanted_ = new QCheckBox(tr("Show patients' &names"));
  names_wanted_->setObjectName("pacsNames");
  names_wanted_->setToolTip(tr("Lists patients and descriptions too; searches again"));
  auto* grid = new QGridLayout;
  const auto add = [&](int row, int at, const QString& words, QWidget* part) {
    auto* label = new QLabel(words);
    label->setBuddy(part);
    grid->addWidget(label, row, 2 * at);
    grid->addWidget(part, row, 2 * at + 1);
  };
  add(0, 0, tr("Patient's n&umber"), patient_id_);
  add(0, 1, tr("Patient's na&me"), patient_name_);
  add(1, 0, tr("A&ccession number"), accession_);
  add(1, 1, tr("&Date"), date_);
  add(2, 0, tr("M&odality"), modality_);
  grid->addWidget(search_, 2, 3);
  for (QLineEdit* one : {patient_id_, patient_name_, accession_, date_})
    connect(one, &QLineEdit::returnPressed, search_, &QPushButton::click);
  connect(search_, &QPushButton::clicked, this, &PacsWindow::searchWanted);
  connect(names_wanted_, &QCheckBox::clicked, this, [this] {
    if (!series_.isEmpty()) emit searchWanted();
  });
  auto* part = new QWidget;
  part->setLayout(grid);
  grid->setContentsMargins(0, 0, 0, 0);
  return part;
}

QWidget* PacsWindow::buildResults() {
  list_ = new QTableWidget;
  list_->setObjectName("pacsSeries");
  list_->setAccessibleName(tr("Series"));
  list_->setToolTip(tr("Enter or a double-click fetches a series"));
  list_->setColumnCount(kPacsColumns);
  list_->setHorizontalHeaderLabels({tr("Study"), tr("Modality"), tr("Date"), tr("Series"),
                                    tr("Images"), tr("Patient"), tr("Number"), tr("Study's name"),
                                    tr("Series' name")});
  style::makeLines(*list_, tr("No series yet: choose a server, then search"));
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setStretchLastSection(true);
  list_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  answer_ = new WarningLabel;
  answer_->setObjectName("pacsAnswer");
  answer_->setWordWrap(true);
  answer_->setTextFormat(Qt::PlainText);
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_words_ = new QLabel;
  progress_words_->setObjectName("pacsProgress");
  fetch_ =
      button("pacsFetch", tr("&Fetch and open"),
             tr("Fetches the chosen series into a folder that is emptied in the end, and opens "
                "it"));
  cancel_ = button("pacsCancel", tr("Cancel"), tr("Cancels the request to the server"));
  auto* close = button("pacsClose", tr("Close"), tr("Closes this window"));
  auto* row = new QHBoxLayout;
  row->addWidget(names_wanted_);
  row->addStretch();
  for (QPushButton* one : {cancel_, fetch_, close}) row->addWidget(one);
  auto* under = new QHBoxLayout;
  under->addWidget(progress_, 1);
  under->addWidget(progress_words_);
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(list_, 1);
  column->addWidget(answer_);
  column->addLayout(under);
  column->addLayout(row);
  connect(list_, &QTableWidget::itemSelectionChanged, this, &PacsWindow::showChosen);
  connect(list_, &QTableWidget::cellActivated, this, [this] { fetch_->click(); });
  connect(fetch_, &QPushButton::clicked, this, [this] { emit fetchWanted(list_->currentRow()); });
  connect(cancel_, &QPushButton::clicked, this, &PacsWindow::cancelWanted);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  return part;
}

void PacsWindow::edit(bool fresh) {
  const int at = fresh ? static_cast<int>(servers_.size()) : chosenServer();
  PacsServerDialog dialog(fresh ? PacsServer{} : servers_.value(at), this);
  if (dialog.exec() != QDialog::Accepted) return;
  if (fresh)
    servers_ << dialog.server();
  else
    servers_[at] = dialog.server();
  showServers(servers_, at);
  emit serversChanged(servers_, at);
}

void PacsWindow::remove() {
  const int at = chosenServer();
  if (at < 0) return;
  servers_.removeAt(at);
  const int chosen = std::max(0, at - 1);
  showServers(servers_, chosen);
  emit serversChanged(servers_, chosen);
}

void PacsWindow::showServers(const QList<PacsServer>& servers, int chosen) {
  servers_ = servers;
  server_->clear();
  for (const PacsServer& server : servers_) server_->addItem(server.name);
  server_->setCurrentIndex(servers_.isEmpty() ? -1 : chosen);
  showOther();
  if (servers_.isEmpty()) showAnswer(tr("Add the server of your archive first."), true);
}

/// Nothing stays that was typed for, or said of, another server or other settings.
void PacsWindow::showOther() {
  clearSecret();
  showAnswer({}, true);
  showChosen();
}

void PacsWindow::showAnswer(const QString& sentence, bool well) {
  answer_->setText(sentence);
  answer_->setWarning(!well);
}

void PacsWindow::showSeries(const QList<PacsSeries>& series, bool names) {
  series_ = series;
  names_ = names;
  fill();
  if (!series_.isEmpty()) list_->selectRow(0);
  showChosen();
}

void PacsWindow::fill() {
  for (const int column : {PacsPatient, PacsPatientId, PacsStudyName, PacsSeriesName})
    list_->setColumnHidden(column, !names_);
  list_->setRowCount(static_cast<int>(series_.size()));
  for (int row = 0; row < list_->rowCount(); ++row) {
    const PacsSeries& one = series_[row];
    const QString cells[] = {QString::number(one.study),
                             one.modality,
                             dateWords(one.date),
                             countWords(one.number),
                             countWords(one.images),
                             one.patient,
                             one.patient_id,
                             one.study_name,
                             one.series_name};
    for (int column = 0; column < kPacsColumns; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
      list_->setItem(row, column, item);
    }
  }
}

void PacsWindow::showProgress(qint64 images, std::optional<qint64> of, qint64 bytes) {
  progress_->setRange(0, of ? static_cast<int>(std::max<qint64>(1, *of)) : 0);
  progress_->setValue(static_cast<int>(images));
  const QString size = QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
  progress_words_->setText(of ? tr("%1 of %2 images, %3").arg(images).arg(*of).arg(size)
                              : tr("%1 images, %2").arg(images).arg(size));
}

void PacsWindow::setBusy(const QString& what) {
  busy_ = what;
  const bool busy = !what.isEmpty();
  progress_->setVisible(busy);
  progress_->setRange(0, 0);
  progress_words_->setText(what);
  cancel_->setEnabled(busy);
  if (busy) showAnswer({}, true);
  showChosen();
}

void PacsWindow::showChosen() {
  const int at = chosenServer();
  const bool busy = !busy_.isEmpty(), known = at >= 0 && at < servers_.size();
  for (QPushButton* one : {edit_, remove_, test_, search_}) one->setEnabled(known && !busy);
  add_->setEnabled(!busy);
  server_->setEnabled(!busy && known);
  fetch_->setEnabled(known && !busy && list_->currentRow() >= 0 &&
                     !list_->selectedItems().isEmpty());
  const Login login = known && servers_[at].web ? servers_[at].login : Login::None;
  const QString user = servers_.value(at).user;
  for (QWidget* one : {static_cast<QWidget*>(secret_), static_cast<QWidget*>(secret_words_)})
    one->setVisible(login != Login::None);
  for (QPushButton* one : {remember_, forget_}) {
    one->setVisible(login == Login::Keyring);
    one->setEnabled(!busy);
  }
  remember_->setEnabled(!busy && !secret_->text().isEmpty());
  const bool token = login == Login::Bearer || (login == Login::Keyring && user.isEmpty());
  secret_words_->setText(token ? tr("Token") : tr("Password of %1").arg(user));
  secret_->setPlaceholderText(login == Login::Keyring ? tr("from the keyring") : QString{});
}

QString PacsWindow::secret() const { return secret_->text(); }
void PacsWindow::clearSecret() { secret_->clear(); }
int PacsWindow::chosenServer() const { return server_->currentIndex(); }
bool PacsWindow::namesWanted() const { return names_wanted_->isChecked(); }

PacsQuery PacsWindow::query() const {
  return {patient_id_->text().trimmed(), patient_name_->text().trimmed(),
          accession_->text().trimmed(), storedDates(date_->text()),
          modality_->currentData().toString()};
}

}  // namespace ui
