// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/fetch/archive.h"
#include "app/fetch/supervisor.h"

namespace app::fetch {

/// One command, whole.
struct Job {
  enum class Command { Echo, Find, Get, Remember, Forget };
  Command command = Command::Echo;
  Server server;
  Login login;  ///< of Remember its password alone, whatever it is
  bool from_keyring = false;
  std::string keyring_user;  ///< empty: the keyring has a token
  Query query;
  std::optional<std::size_t> index;
  std::string check;
  bool names = false;  ///< patients and descriptions are shown
  bool json = false;
  std::filesystem::path folder;  ///< of the images
  int progress_to = -1;          ///< descriptor
};

/// How long a command may take at most [s].
double longestOf(const Job& job);

/// Carries the command out, in the child. Needs a QCoreApplication.
Outcome done(Job job);

}  // namespace app::fetch
