// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>

namespace window {

/// A program of the system whose place a script takes, as long as this lives. It is the first in
/// the path, and `$here` is its folder.
class FakeProgram {
 public:
  FakeProgram(const QString& name, const QByteArray& script) {
    QFile program(folder_.filePath(name));
    EXPECT_TRUE(program.open(QIODevice::WriteOnly));
    program.write("#!/bin/sh\nhere='" + folder_.path().toUtf8() + "'\n" + script);
    program.close();
    program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    qputenv("PATH", folder_.path().toUtf8() + ':' + path_);
  }
  FakeProgram(const FakeProgram&) = delete;
  FakeProgram& operator=(const FakeProgram&) = delete;
  ~FakeProgram() { qputenv("PATH", path_); }

  /// What the script has written into a file of its folder.
  QByteArray written(const QString& name) const {
    QFile file(folder_.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
  }

 private:
  QByteArray path_ = qgetenv("PATH");
  QTemporaryDir folder_;
};

/// A player that keeps what it is given to play in `heard`, and how it was called in `called`.
inline constexpr const char* kKeepsWhatItReads =
    "echo \"$@\" >> \"$here/called\"\nexec cat >> \"$here/heard\"\n";

}  // namespace window
