// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/devices/shared_library.h"

#include <dlfcn.h>

#include <optional>

#include "haptics/devices/catalogue.h"

namespace haptics {

void SharedLibrary::Close::operator()(void* handle) const { dlclose(handle); }

void* SharedLibrary::address(const char* symbol) const { return dlsym(handle_.get(), symbol); }

Expected<SharedLibrary> SharedLibrary::open(std::span<const std::string> names,
                                            const Message& product) {
  std::string looked_for;
  std::optional<Message> fault;
  for (const std::string& name : names) {
    if (void* const handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE))
      return SharedLibrary{handle, name};
    looked_for += (looked_for.empty() ? "" : ", ") + name;

    // the loader names the file that it did not find: another one is what this one needs
    const char* const said = dlerror();
    const std::string why = said != nullptr ? said : "";
    const bool absent = why.starts_with(name + ": cannot open shared object file: No such file");
    if (!absent && !fault) fault = Message{"library-not-loadable", {product, name, why}};
  }
  if (fault) return tl::unexpected(refusal(Trouble::NoLibrary, *fault));
  return tl::unexpected(
      refusal(Trouble::NoLibrary, {"library-not-installed", {product, looked_for}}));
}

}  // namespace haptics
