// SPDX-License-Identifier: BSD-3-Clause
#include "app/fetch/keyring.h"

#include <libsecret/secret.h>

#include <memory>

#include "app/fetch/archive.h"

namespace app::fetch {

using haptics::Expected;

namespace {

// any schema: the entry may have been made by hand
const SecretSchema kSchema{"org.palpate.Server",
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

using Attributes = std::unique_ptr<GHashTable, decltype(&g_hash_table_unref)>;

Attributes attributesOf(const KeyringEntry& entry) {
  return {secret_attributes_build(&kSchema, "application", "palpate", "server",
                                  entry.server.c_str(), "user", entry.user.c_str(), nullptr),
          &g_hash_table_unref};
}

tl::unexpected<haptics::Error> noKeyring(GError* error) {
  g_error_free(error);
  return failed("keyring", {"fetch-no-keyring", {}});
}

/// Why nothing was found: there is no entry, or nobody unlocked it.
tl::unexpected<haptics::Error> noEntry(const KeyringEntry& entry) {
  GList* locked = secret_password_searchv_sync(&kSchema, attributesOf(entry).get(),
                                               SECRET_SEARCH_NONE, nullptr, nullptr);
  if (locked == nullptr) return refused("login", {"fetch-not-in-keyring", {entry.server}});
  g_list_free_full(locked, g_object_unref);
  return failed("keyring", {"fetch-no-keyring", {}});
}

}  // namespace

Expected<std::string> secretOf(const KeyringEntry& entry) {
  GError* error = nullptr;
  char* found = secret_password_lookupv_sync(&kSchema, attributesOf(entry).get(), nullptr, &error);
  if (error != nullptr) return noKeyring(error);
  if (found == nullptr) return noEntry(entry);
  std::string secret{found};
  secret_password_free(found);
  return secret;
}

Expected<void> remember(const KeyringEntry& entry, const std::string& secret) {
  // one that was made by hand has another schema, and would stay beside the new one
  if (const auto gone = forget(entry); !gone && gone.error().reason == "keyring") return gone;
  GError* error = nullptr;
  secret_password_storev_sync(&kSchema, attributesOf(entry).get(), SECRET_COLLECTION_DEFAULT,
                              ("PACS " + entry.server).c_str(), secret.c_str(), nullptr, &error);
  if (error != nullptr) return noKeyring(error);
  return {};
}

Expected<void> forget(const KeyringEntry& entry) {
  GError* error = nullptr;
  const bool gone =
      secret_password_clearv_sync(&kSchema, attributesOf(entry).get(), nullptr, &error) != FALSE;
  if (error != nullptr) return noKeyring(error);
  if (!gone) return noEntry(entry);
  return {};
}

}  // namespace app::fetch
