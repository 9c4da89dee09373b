// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QString>

#include "ui/style/look.h"

class QApplication;
class QLabel;
class QTableWidget;

namespace ui::style {

/// Steps of the type scale.
enum class Type { Small, Body, Section, Figure, Force };

/// The name of a theme in the preferences, and back; what is not known is dark.
QString nameOf(Theme theme);
Theme themeOf(const QString& name);

/// Gives every window of the program its look: colours, type and the shapes of the controls.
void applyTheme(QApplication& application, Theme theme);
/// The theme that was applied last.
Theme theme();
/// Its colours. System is dark or light, as the desktop was at the start.
const Colours& colours();
const Colours& coloursOf(Theme theme);
/// For a widget that is in these colours whatever the theme is.
QPalette paletteOf(const Colours& colours);

/// The desktop's font in a size of the scale; digits are of one width, so that a number that
/// changes moves nothing.
QFont font(Type type);
/// The same font, or one whose digits are of one width.
QFont tabular(const QFont& font);
void setType(QLabel& label, Type type);
/// Words that step back: units, explanations.
void setDim(QWidget& widget);

/// A list of lines, of which one is chosen; Tab leaves it. While it has none, `empty` stands there.
void makeLines(QTableWidget& table, const QString& empty = {});

/// A symbol of resources/icons in the colours of the theme that is worn when it is painted: of
/// words, or of the accent while it is on.
QIcon icon(const char* name);

}  // namespace ui::style
