// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <locale.h>
#include <clocale>

namespace datasets {

/// While it lives, this thread parses "0.5" with a point, whatever the desktop's language. It is
/// needed because teem and VTK parse numbers with the C library, and a window toolkit sets the
/// locale of that library.
class CLocale {
 public:
  CLocale() : plain_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(plain_)) {}
  ~CLocale() {
    uselocale(before_);
    if (plain_ != nullptr) freelocale(plain_);
  }
  CLocale(const CLocale&) = delete;
  CLocale& operator=(const CLocale&) = delete;

 private:
  locale_t plain_;
  locale_t before_;
};

}  // namespace datasets
