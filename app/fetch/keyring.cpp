// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/keyring.h"

#include <libsecret/secret.h>

#include <memory>

#include "app/fetch/archive.h"

namespace app::fetch {

haptics::Expected<std::string> secretOf(const std::string& server, const std::string& user) {
  // any schema: the entry may have been made by hand
  static const SecretSchema schema{"org.palpate.Server",
                                   SECRET_SCHEMA_DONT_MATCH_NAME,
                                   {{"application", SECRET_SCHEMA_ATTRIBUTE_STRING},
                                    {"server", SECRET_SCHEMA_ATTRIBUTE_STRING},
                                    {"user", SECRET_SCHEMA_ATTRIBUTE_STRING}},
                                   0,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr};
  GError* error = nullptr;
  char* found =
      user.empty()
          ? secret_password_lookup_sync(&schema, nullptr, &error, "application", "palpate",
                                        "server", server.c_str(), nullptr)
          : secret_password_lookup_sync(&schema, nullptr, &error, "application", "palpate",
                                        "server", server.c_str(), "user", user.c_str(), nullptr);
  if (error != nullptr) {
    g_error_free(error);
    return failed("keyring", {"fetch-no-keyring", {}});
  }
  if (found == nullptr) return refused("login", {"fetch-not-in-keyring", {server}});
  std::string secret{found};
  secret_password_free(found);
  return secret;
}

}  // namespace app::fetch
