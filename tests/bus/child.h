// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace bus {

/// Who a child runs as. The user has no rights beyond those of anybody.
enum class As { Root, User };

/// This program once more, in a process of its own, with words for childMain.
class Child {
 public:
  Child(As who, const std::vector<std::string>& words);
  ~Child();  ///< kills it
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void kill();  ///< SIGKILL: it has no say; waits until it is gone
  /// The next line that it says, without its end; empty where it has ended.
  std::string line();
  /// All that it says until it ends.
  std::string said();

 private:
  pid_t process_ = -1;
  int words_ = -1;  // its standard output
};

/// What a child does and says: "survey": one line a device, its id, word of trouble and sentence;
/// "open ID": "opened", or word of trouble and sentence; "feel ID": renders the sphere without end,
/// armed, and says "armed".
int childMain(const std::string& what, const std::string& id = {});

/// The line of a survey about this device, or empty.
std::string lineOf(const std::string& survey, const std::string& id);

}  // namespace bus
