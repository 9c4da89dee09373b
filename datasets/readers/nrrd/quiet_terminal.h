// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace datasets {

/// While it lives, what this thread prints to the C stream of errors is dropped: codecs complain
/// there on their way to a decoded image, and naming what is wrong is the reader's part. Other
/// threads go on printing.
class QuietTerminal {
 public:
  QuietTerminal();
  ~QuietTerminal();
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;
};

}  // namespace datasets
