// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string>

#include "haptics/core/error.h"

namespace haptics {

/// A maker's library, opened at run time if it is installed; nothing of it is built in. Not for the
/// GUI or servo thread.
///
/// Its code stays in memory until the program ends, also after this object is destroyed, because
/// such a library may leave a running thread behind.
class SharedLibrary {
 public:
  /// The first of `names` that the system's loader finds and can load; a name with a slash is a
  /// path. Refused as Trouble::NoLibrary, in words that begin with `product`, what it is a library
  /// of: none is installed, or one is that cannot be loaded, and why.
  static Expected<SharedLibrary> open(std::span<const std::string> names, const Message& product);

  /// The name that was found.
  const std::string& name() const { return name_; }

  /// Points `function` at the library's function of this name: null if it has none.
  template <class F>
  void find(F*& function, const char* symbol) const {
    function = reinterpret_cast<F*>(address(symbol));
  }
  /// The same for a required function. The name of the first missing one is kept.
  template <class F>
  void need(F*& function, const char* symbol) {
    find(function, symbol);
    if (function == nullptr && lacks_.empty()) lacks_ = symbol;
  }
  /// The name of the first required function that is missing; empty if there is none.
  const std::string& lacks() const { return lacks_; }

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  SharedLibrary(void* handle, std::string name) : handle_{handle}, name_{std::move(name)} {}
  void* address(const char* symbol) const;

  std::unique_ptr<void, Close> handle_;
  std::string name_, lacks_;
};

}  // namespace haptics
