// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/outcome.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <iostream>
#include <system_error>

#include "app/cli/terminal.h"
#include "resources/messages/messages.h"

namespace app::cli {
namespace {

/// A path may hold bytes that are no UTF-8: replaced, not thrown over.
std::string textOf(const nlohmann::ordered_json& json, int indent) {
  return printable(json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace), true);
}

std::string wordsOf(const nlohmann::ordered_json& value) {
  return printable(value.is_string() ? value.get<std::string>() : textOf(value, -1));
}

}  // namespace

std::string linesOf(const nlohmann::ordered_json& json) {
  std::string lines;
  for (const auto& [name, value] : json.items()) {
    if (!value.is_array() || value.empty() || !value.front().is_object()) {
      lines += name + ": " + wordsOf(value) + "\n";
      continue;
    }
    for (const nlohmann::ordered_json& one : value) {
      lines += name + ":";
      for (const auto& [part, of_part] : one.items())
        lines += (lines.back() == ':' ? " " : ", ") + part + " " + wordsOf(of_part);
      lines += "\n";
    }
  }
  return lines;
}

Outcome refused(const haptics::Error& error, nlohmann::ordered_json known) {
  if (error.reason == "cancelled") return stopped();
  Outcome outcome{Exit::Refused, std::move(known), {}, resources::sentence(error)};
  if (error.kind == haptics::Error::Kind::Correctable) outcome.error += " Add --correct for that.";
  // what cannot be written is not the input's fault; another scan is sound, but not the recorded
  // one
  const bool another = error.reason == "another-volume" || error.reason == "other-edits";
  if (another || error.reason == "unwritable") outcome.code = Exit::Failed;
  // a name that does not exist, or a folder with several series and none named, is wrong usage
  if (error.reason == "which-series" || error.reason == "no-such-series" ||
      error.reason == "unknown-name")
    outcome.code = Exit::Usage;
  if (outcome.json.is_null()) outcome.json = nlohmann::ordered_json::object();
  if (!error.reason.empty() && !outcome.json.contains("reasons") &&
      (outcome.code == Exit::Refused || another)) {
    if (!another)
      outcome.json["verdict"] =
          error.kind == haptics::Error::Kind::Correctable ? "correctable" : "refused";
    outcome.json["reasons"] = {error.reason};
  }
  return outcome;
}

Outcome usage(std::string what) { return {Exit::Usage, {}, {}, std::move(what)}; }

Outcome failed(std::string what) { return {Exit::Failed, {}, {}, std::move(what)}; }
Outcome stopped() { return {Exit::Interrupted, {}, {}, "Stopped; nothing was written."}; }

namespace {

std::atomic<bool> told{false};

int tellAll(const Outcome& outcome, bool json) {
  Exit code = outcome.code;
  if (!outcome.error.empty()) tell(outcome.error);
  std::ostream& out = outcome.aside ? std::cerr : std::cout;
  errno = 0;
  if (json) {
    nlohmann::ordered_json object = outcome.json;
    if (object.is_null()) object = nlohmann::ordered_json::object();
    if (code != Exit::Done)
      object["error"] = {{"code", static_cast<int>(code)}, {"message", outcome.error}};
    out << textOf(object, 2) << '\n';
  } else if (code == Exit::Done || !outcome.json.empty()) {
    out << (outcome.text.empty() ? linesOf(outcome.json) : printable(outcome.text, true));
  }
  out.flush();
  if (!out && code == Exit::Done) {
    code = Exit::Failed;
    tell("The answer could not be written to standard output (" +
         std::generic_category().message(errno != 0 ? errno : EIO) + ").");
  }
  return static_cast<int>(code);
}

}  // namespace

int print(const Outcome& outcome, bool json) {
  while (told.exchange(true)) ::pause();
  return tellAll(outcome, json);
}

void printUnlessPrinted(const Outcome& outcome, bool json) {
  if (!told.exchange(true)) tellAll(outcome, json);
}

}  // namespace app::cli
