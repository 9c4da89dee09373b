// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QSettings>
#include <QString>
#include <QStringList>
#include <optional>

#include "haptics/settings.h"

namespace app {

/// Numbers and switches of a settings file, in which anybody may have written. What cannot be read
/// whole, such as "2,5", or is out of its range, is as if it were not there, and is told of.
class StoredValues {
 public:
  explicit StoredValues(const QSettings& settings) : settings_(settings) {}

  std::optional<double> number(const char* key, haptics::Range range) {
    return read<double>(key, [&](const QString& text, bool& reads) {
      const double value = text.toDouble(&reads);
      reads = reads && range.holds(value);
      return value;
    });
  }
  std::optional<int> whole(const char* key, int least, int most) {
    return read<int>(key, [&](const QString& text, bool& reads) {
      const int value = text.toInt(&reads);
      reads = reads && value >= least && value <= most;
      return value;
    });
  }
  std::optional<bool> flag(const char* key) {
    return read<bool>(key, [](const QString& text, bool& reads) {
      reads = text == QLatin1String("true") || text == QLatin1String("false");
      return text == QLatin1String("true");
    });
  }
  /// The keys of those that could not be read.
  const QStringList& unread() const { return unread_; }

 private:
  template <class T, class F>
  std::optional<T> read(const char* key, F&& value_of) {
    const QVariant stored = settings_.value(key);
    if (!stored.isValid()) return {};
    bool reads = false;
    const T value = value_of(stored.toString(), reads);  // a list, "2,5", has no text
    if (reads) return value;
    unread_ << QString::fromLatin1(key);
    return {};
  }

  const QSettings& settings_;
  QStringList unread_;
};

}  // namespace app
