// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// Where this clone's files are. One small file knows it, so that all other object files of the
/// tests are the same in every clone, and a compiler cache finds them.
namespace places {

/// A file or folder of the real scans, which stand beside the checkout or nowhere.
std::string scan(const std::string& name = {});
/// A file of the sources, by its path from the top of the tree.
std::string source(const std::string& name);
/// A file that the build has made, by its path from the top of the build.
std::string built(const std::string& name);

}  // namespace places
