// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QList>
#include <QString>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace ui {

class NumberBox;
class WarningLabel;

/// An archive of a hospital, as the user describes it. Without secrets.
struct PacsServer {
  enum class Login { None, Basic, Bearer, Keyring };

  QString name = {};  ///< what the user calls it
  bool web = true;
  QString url = {};   ///< of DICOMweb
  QString host = {};  ///< of DIMSE
  int port = 104;
  QString called = {}, calling = QStringLiteral("PALPATE");  ///< AE titles: the server's, ours
  bool tls = false;                                          ///< of DIMSE
  QString authority = {}, certificate = {}, key = {};        ///< PEM files, or empty
  Login login = Login::None;                                 ///< of DICOMweb
  QString user = {};
  QString move = {};  ///< C-MOVE: ADDRESS:PORT of this computer for the server; empty: C-GET

  bool operator==(const PacsServer&) const = default;
};

/// What is searched. Empty fields match everything.
struct PacsQuery {
  QString patient_id, patient_name, accession_number, study_date, modality;
};

/// A series that was found. Texts that name somebody are empty unless they were asked for.
struct PacsSeries {
  int study = 0;  ///< which of the studies of the list
  QString modality, date;
  std::optional<qint64> number, images;
  QString patient, patient_id, study_name, series_name;
};

/// Describes one server.
class PacsServerDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PacsServerDialog(const PacsServer& server, QWidget* parent = nullptr);
  PacsServer server() const;

 private:
  void showKind();
  QLineEdit* field(const char* name, const QString& words, const QString& tip, const QString& text);
  QLineEdit* file(const char* name, const QString& words, const QString& tip, const QString& text);

  QFormLayout* form_;
  QLineEdit *name_, *url_, *host_, *called_, *calling_, *authority_, *certificate_, *key_, *user_,
      *move_;
  QComboBox *kind_, *login_;
  NumberBox* port_;
  QCheckBox *tls_, *moves_;
};

/// Scans from a PACS: the servers, a search, the series that were found, and the one that is
/// fetched. Not modal. Patients' names are hidden in each list until the user asks for them. It is
/// given answers and emits wishes; it opens no connection.
class PacsWindow : public QDialog {
  Q_OBJECT
 public:
  explicit PacsWindow(QWidget* parent = nullptr);

  void showServers(const QList<PacsServer>& servers, int chosen);
  /// What came of a test, a search or a fetch, in one sentence.
  void showAnswer(const QString& sentence, bool well);
  void showSeries(const QList<PacsSeries>& series, bool names);
  /// Images and bytes of a fetch; `of` is empty while their number is not known.
  void showProgress(qint64 images, std::optional<qint64> of, qint64 bytes);
  /// Whether a test, a search or a fetch is under way; it can be cancelled.
  void setBusy(const QString& what);
  /// The password or token as it was typed; kept in this window alone.
  QString secret() const;
  void clearSecret();
  PacsQuery query() const;
  bool namesWanted() const;
  int chosenServer() const;

 signals:
  void serversChanged(const QList<ui::PacsServer>& servers, int chosen);
  void testWanted();
  void rememberWanted();  ///< what was typed goes into the keyring
  void forgetWanted();    ///< what the keyring has goes
  void searchWanted();
  void fetchWanted(int series);
  void cancelWanted();

 private:
  QWidget* buildServers();
  QWidget* buildSearch();
  QWidget* buildResults();
  void edit(bool fresh);
  void remove();
  void fill();
  void showChosen();
  void showOther();

  QList<PacsServer> servers_;
  QList<PacsSeries> series_;
  bool names_ = false;
  QString busy_;
  QComboBox *server_, *modality_;
  QPushButton *add_, *edit_, *remove_, *test_, *search_, *fetch_, *cancel_, *remember_, *forget_;
  QLineEdit *secret_, *patient_id_, *patient_name_, *accession_, *date_;
  QLabel* secret_words_;
  QCheckBox* names_wanted_;
  QTableWidget* list_;
  QProgressBar* progress_;
  QLabel* progress_words_;
  WarningLabel* answer_;
};

}  // namespace ui
