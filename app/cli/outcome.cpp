// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/outcome.h"

#include <csignal>
#include <iostream>

namespace app::cli {
namespace {

volatile std::sig_atomic_t stop_asked = 0;

/// The JSON as lines "name: value" for people.
std::string asLines(const nlohmann::ordered_json& json) {
  std::string lines;
  for (const auto& [name, value] : json.items())
    lines += name + ": " + (value.is_string() ? value.get<std::string>() : value.dump()) + "\n";
  return lines;
}

}  // namespace

Outcome refused(const haptics::Error& error, nlohmann::ordered_json known) {
  Outcome outcome{Exit::Refused, std::move(known), {}, error.what};
  if (error.kind == haptics::Error::Kind::Correctable) outcome.error += " Add --correct for that.";
  // a folder with several series and none named is a question of usage
  if (error.reason == "which-series" || error.reason == "no-such-series")
    outcome.code = Exit::Usage;
  if (outcome.json.is_null()) outcome.json = nlohmann::ordered_json::object();
  if (!error.reason.empty() && !outcome.json.contains("reasons") && outcome.code == Exit::Refused) {
    outcome.json["verdict"] =
        error.kind == haptics::Error::Kind::Correctable ? "correctable" : "refused";
    outcome.json["reasons"] = {error.reason};
  }
  return outcome;
}

Outcome usage(std::string what) { return {Exit::Usage, {}, {}, std::move(what)}; }

int print(const Outcome& outcome, bool json) {
  const int code = static_cast<int>(outcome.code);
  // a file's name may hold anything; what would steer the terminal is not printed
  std::string sentence = outcome.error;
  for (char& c : sentence)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  if (!sentence.empty()) std::cerr << sentence << '\n';
  if (json) {
    nlohmann::ordered_json object = outcome.json;
    if (object.is_null()) object = nlohmann::ordered_json::object();
    if (outcome.code != Exit::Done) object["error"] = {{"code", code}, {"message", outcome.error}};
    // a path may hold bytes that are no UTF-8: replaced, not thrown over
    std::cout << object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  } else if (outcome.code == Exit::Done || !outcome.json.empty()) {
    std::cout << (outcome.text.empty() ? asLines(outcome.json) : outcome.text);
  }
  std::cout.flush();
  return code;
}

bool interrupted() { return stop_asked != 0; }

void watchForInterrupts() {
  std::signal(SIGINT, [](int) { stop_asked = 1; });
  std::signal(SIGTERM, [](int) { stop_asked = 1; });
  // a file that may not grow further is an error like any other
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace app::cli
