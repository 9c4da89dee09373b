// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QCoreApplication>
#include <algorithm>
#include <charconv>
#include <iostream>
#include <optional>
#include <string_view>

#include "app/cli/terminal.h"
#include "app/fetch/arrivals.h"
#include "app/fetch/folder.h"
#include "app/fetch/input.h"
#include "app/fetch/job.h"
#include "app/fetch/supervisor.h"
#include "haptics/process/input_file.h"
#include "resources/messages/messages.h"

namespace {

using namespace app::fetch;
using nlohmann::ordered_json;

/// The command line, before it is checked.
struct Options {
  std::string web, dimse, login = "none", move, out;
  Job job;
  bool json = false, attached = false;
};

/// HOST:PORT or [ADDRESS]:PORT.
bool split(const std::string& text, std::string& host, std::uint16_t& port) {
  const auto colon = text.rfind(':');
  if (colon == std::string::npos) return false;
  host = text.substr(0, colon);
  if (host.size() > 2 && host.starts_with('[') && host.ends_with(']'))
    host = host.substr(1, host.size() - 2);
  else if (host.find(':') != std::string::npos)
    return false;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, port);
  return error == std::errc{} && stop == end && port > 0 && !host.empty();
}

CLI::Validator aeTitle() {
  return {[](std::string& text) {
            const bool sound =
                !text.empty() && text.size() <= 16 && text.front() != ' ' && text.back() != ' ' &&
                std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
            return sound ? std::string{}
                         : "\"" + text + "\" is no AE title: up to 16 letters, digits and signs";
          },
          "TITLE"};
}

void addServer(CLI::App& command, Options& options) {
  Server& server = options.job.server;
  command.add_option("--dicomweb", options.web, "URL of a server of DICOMweb");
  command.add_option("--dimse", options.dimse, "Host and port of a server of DIMSE")
      ->type_name("HOST:PORT");
  command.add_option("--called", server.called, "AE title of the server (DIMSE)")->check(aeTitle());
  command
      .add_option("--calling", server.calling,
                  "AE title of this program (DIMSE); PALPATE by default")
      ->check(aeTitle());
  command.add_flag("--tls", server.tls, "TLS with DIMSE; a URL says it itself");
  command.add_option("--authority", server.authority,
                     "Certificates (PEM) to trust beside the system's");
  auto* certificate =
      command.add_option("--certificate", server.certificate, "Certificate (PEM) of this program");
  command.add_option("--key", server.key, "Its private key (PEM)")->needs(certificate);
  command
      .add_option("--login", options.login,
                  "basic or bearer: user and password or a token on standard input; keyring: the "
                  "desktop's")
      ->check(CLI::IsMember({"none", "basic", "bearer", "keyring"}));
  command.add_option("--user", options.job.keyring_user, "Whose password the keyring has");
  command
      .add_option("--patience", server.patience_s,
                  "Seconds that the server may be silent; 30 by default")
      ->check(CLI::Range(1.0, 600.0));
  command.add_flag("--attached", options.attached,
                   "A parent program holds standard input; its end stops this one");
  command.add_flag("--json", options.json, "Print JSON lines and nothing else");
}

haptics::Expected<void> complete(Options& options) {
  Server& server = options.job.server;
  const auto usage = [](haptics::Message message) {
    return tl::unexpected(
        haptics::Error{haptics::Error::Kind::Unsupported, std::move(message), "usage"});
  };
  if (options.web.empty() == options.dimse.empty()) return usage({"fetch-one-server", {}});
  server.url = options.web;
  if (!options.dimse.empty()) {
    if (!split(options.dimse, server.host, server.port))
      return usage({"fetch-host-and-port", {options.dimse}});
    if (server.called.empty()) return usage({"fetch-called-missing", {}});
    if (options.login != "none") return usage({"fetch-login-of-web", {}});
  } else if (server.tls || !server.called.empty() || !options.move.empty()) {
    return usage({"fetch-options-of-dimse", {}});
  }
  if (server.certificate.empty() != server.key.empty()) return usage({"fetch-key-missing", {}});
  // before a TLS library opens them, and waits for a pipe
  constexpr std::uintmax_t kLargest = 16 << 20;  // bytes
  for (const auto& [file, message] : {std::pair{server.authority, "fetch-certificate-file"},
                                      {server.certificate, "fetch-certificate-file"},
                                      {server.key, "fetch-key-file"}})
    if (!file.empty() && !haptics::openInput(file, kLargest))
      return refused("certificate-file", {message, {file}});
  if (!options.move.empty()) {
    server.move = true;
    if (!split(options.move, server.listen_address, server.listen_port))
      return usage({"fetch-host-and-port", {options.move}});
  }
  Job& job = options.job;
  const bool remembers = job.command == Job::Command::Remember;
  const bool of_keyring = remembers || job.command == Job::Command::Forget;
  if (of_keyring && (!server.isWeb() || (options.login != "none" && options.login != "keyring")))
    return usage({"fetch-keyring-of-web", {}});
  job.from_keyring = options.login == "keyring";
  if (options.login == "basic") job.login.kind = Login::Kind::Basic;
  if (options.login == "bearer") job.login.kind = Login::Kind::Bearer;
  if (job.command == Job::Command::Get && options.out.empty() && !options.attached)
    return usage({"fetch-out-missing", {}});
  // what is secret, or names somebody, comes on standard input
  const bool searches = job.command == Job::Command::Find || job.command == Job::Command::Get;
  if (!searches && !remembers && job.login.kind == Login::Kind::None) return {};
  const auto input = readInput(STDIN_FILENO);
  if (!input) return tl::unexpected(input.error());
  job.query = input->query;
  job.index = input->index;
  job.check = input->check;
  job.login.user = input->user;
  job.login.password = job.login.kind == Login::Kind::Bearer ? input->token : input->password;
  job.login.key_passphrase = input->key_passphrase;
  if (remembers) {
    job.login.password = job.keyring_user.empty() ? input->token : input->password;
    if (job.login.password.empty()) return usage({"fetch-login-missing", {}});
    return {};
  }
  if (job.login.kind == Login::Kind::Bearer
          ? input->token.empty()
          : job.login.kind == Login::Kind::Basic && input->user.empty())
    return usage({"fetch-login-missing", {}});
  if (searches && job.query.isEmpty()) return usage({"fetch-query-empty", {}});
  if (job.command == Job::Command::Get && !job.index) return usage({"fetch-index-missing", {}});
  return {};
}

int print(const Outcome& outcome, bool json) {
  const std::string sentence = resources::sentence(outcome.error);
  if (!sentence.empty()) app::cli::tell(sentence);
  if (json) {
    ordered_json object = outcome.json;
    if (outcome.code != Exit::Done)
      object["error"] = {{"code", static_cast<int>(outcome.code)},
                         {"reason", outcome.reason},
                         {"message", sentence},
                         {"words", jsonOf(outcome.error)}};
    std::cout << app::cli::printable(
                     object.dump(-1, ' ', false, ordered_json::error_handler_t::replace))
              << '\n';
  } else {
    std::cout << app::cli::printable(outcome.text, true);
  }
  std::cout.flush();
  return static_cast<int>(std::cout ? outcome.code : std::max(outcome.code, Exit::Failed));
}

int run(Options& options) {
  Supervisor supervisor{options.attached};
  sweepFolders();
  if (auto completed = complete(options); !completed)
    return print(outcomeOf(completed.error()), options.json);
  std::optional<Folder> folder;
  Job& job = options.job;
  if (job.command == Job::Command::Get) {
    auto made = options.out.empty() ? Folder::temporary() : Folder::at(options.out);
    if (!made) return print(outcomeOf(made.error()), options.json);
    folder.emplace(std::move(*made));
    job.folder = folder->path();
  }
  job.progress_to = fcntl(options.json ? STDOUT_FILENO : STDERR_FILENO, F_DUPFD_CLOEXEC, 10);
  job.json = options.json;
  const Outcome outcome = supervisor.run(
      [&job] {
        int count = 1;
        char name[] = "palpate-fetch";
        char* arguments[] = {name, nullptr};
        const QCoreApplication application{count, arguments};
        return done(job);
      },
      longestOf(job));
  if (outcome.code != Exit::Done && folder) folder->discard();
  const int code = print(outcome, options.json);
  // the parent reads the folder until it says that it has done so
  if (outcome.code == Exit::Done && folder && folder->isTemporary()) supervisor.waitForStop();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  app::cli::openStandardStreams();
  Options options;
  CLI::App program{
      "Fetches scans for Palpate from a PACS. What to search for, and every secret, comes as JSON "
      "on\n"
      "standard input. Not a medical device, not for diagnosis.",
      "palpate-fetch"};
  program.set_version_flag("--version", PALPATE_VERSION);
  program.require_subcommand(1);
  auto* echo = program.add_subcommand("echo", "Say whether the server answers and lets one search");
  auto* find = program.add_subcommand("find", "List the series that match, each with an index");
  auto* get = program.add_subcommand("get", "Fetch the series of an index");
  auto* remember = program.add_subcommand(
      "remember", "Store a password or token for a server in the desktop's keyring");
  auto* forget = program.add_subcommand("forget", "Remove it from there");
  for (auto* command : {echo, find, get, remember, forget}) addServer(*command, options);
  find->add_flag("--names", options.job.names, "Show patients and descriptions too");
  get->add_option("--out", options.out,
                  "A new or empty folder for the images. Without it they lie in a temporary one, "
                  "which is emptied when the parent ends standard input");
  get->add_option("--move", options.move,
                  "C-MOVE instead of C-GET: address and port at which the server reaches this "
                  "machine, open during the transfer")
      ->type_name("ADDRESS:PORT");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return program.exit(asked);
  } catch (const CLI::ParseError& error) {
    for (int i = 1; i < argc; ++i)
      options.json = options.json || std::string_view(argv[i]) == "--json";
    Outcome outcome{Exit::Usage};
    outcome.error = std::string{error.what()} + " (see palpate-fetch --help).";
    outcome.reason = "usage";
    return print(outcome, options.json);
  }
  options.job.command = *echo       ? Job::Command::Echo
                        : *find     ? Job::Command::Find
                        : *get      ? Job::Command::Get
                        : *remember ? Job::Command::Remember
                                    : Job::Command::Forget;
  return run(options);
}
