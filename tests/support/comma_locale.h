// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace support {

/// Numbers with a decimal comma for this process, while it lives. No such locale need be
/// installed: glibc's own table of numbers is copied, with a comma in place of the point.
class CommaLocale {
 public:
  /// `folder`: one of the test's own.
  explicit CommaLocale(const std::filesystem::path& folder) {
    std::ifstream in("/usr/lib/locale/C.utf8/LC_NUMERIC", std::ios::binary);
    std::string table{std::istreambuf_iterator<char>(in), {}};
    // two numbers of 32 bits, the places of the texts, and the texts
    for (std::size_t at = table.size() > 8 ? std::size_t(table[8]) : 0; at < table.size(); ++at)
      if (table[at] == '.') table[at] = ',';
    std::filesystem::create_directories(folder / "comma");
    std::ofstream(folder / "comma" / "LC_NUMERIC", std::ios::binary) << table;
    setenv("LOCPATH", folder.c_str(), 1);
    std::setlocale(LC_NUMERIC, "comma");
    unsetenv("LOCPATH");
  }
  ~CommaLocale() { std::setlocale(LC_NUMERIC, "C"); }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  /// Whether it is in force: the test must fail otherwise.
  static bool isSet() { return std::localeconv()->decimal_point == std::string{","}; }
};

}  // namespace support
