// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace datasets {

/// While it lives, this thread's output to stderr is dropped. Codecs print there even when they
/// succeed, and the reader reports errors itself. Other threads go on printing.
class QuietTerminal {
 public:
  QuietTerminal();
  ~QuietTerminal();
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;
};

}  // namespace datasets
