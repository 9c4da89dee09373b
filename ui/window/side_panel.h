// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractButton>
#include <QStringList>
#include <QWidget>
#include <array>
#include <vector>

#include "ui/controls/spoken.h"

class QMenu;
class QStackedWidget;
class QVBoxLayout;

namespace ui {

class Section;

/// What the user is about: each has its panels.
enum class Tab { Scan, Touch, Device, Record };
inline constexpr std::array kTabs{Tab::Scan, Tab::Touch, Tab::Device, Tab::Record};

/// Whether a section is folded at the first start.
enum class Fold { Open, Folded };

/// How the panels stand, for the preferences.
struct PanelState {
  QString tab = {};           ///< name of the tab in front; empty: the first start's
  QStringList folded = {};    ///< names of the sections that are folded
  QStringList unfolded = {};  ///< and of those that are not
  bool operator==(const PanelState&) const = default;
};

/// A tab on the rail: a symbol above its word.
class RailButton : public QAbstractButton, public Spoken {
  Q_OBJECT
 public:
  RailButton(const QString& word, const char* icon, QWidget* parent = nullptr);
  QSize sizeHint() const override;

  QAccessible::Role spokenRole() const override { return QAccessible::PageTab; }
  QString spokenName() const override { return text(); }
  void spokenState(QAccessible::State& state) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// The panels at the left: four tabs, each a column of sections that fold. The tabs stand on a
/// rail, which is a widget of its own.
class SidePanel : public QWidget {
  Q_OBJECT
 public:
  /// `entries`: the menu that has an entry for each panel.
  explicit SidePanel(QMenu& entries, QWidget* parent = nullptr);

  QWidget& rail() { return *rail_; }
  /// Adds a panel as a section below those of its tab, with an entry in the menu unless it is
  /// empty. `name` is the name of the section, under which the preferences know it.
  void add(QWidget* panel, const QString& title, const QString& entry, const char* name, Tab tab,
           Fold fold = Fold::Open);
  /// Brings the section of a panel into view.
  void reveal(const QWidget* panel);
  Tab tab() const;
  void setTab(Tab tab);
  PanelState state() const;
  /// Sections that are not known are left out, and so is an unknown tab.
  void restore(const PanelState& state);
  /// As at the first start.
  void reset();

 signals:
  /// The user chose another tab, or folded a section.
  void changed();

 private:
  QMenu& entries_;
  QWidget* rail_;
  QStackedWidget* pages_;
  std::array<RailButton*, kTabs.size()> buttons_{};
  std::array<QVBoxLayout*, kTabs.size()> columns_{};
  std::vector<Section*> sections_;
};

}  // namespace ui
