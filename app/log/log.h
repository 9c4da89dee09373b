// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "haptics/core/error.h"

/// The log of the window: what the program did, in its own words and in numbers. A line holds no
/// sentence that the user sees, because those name files and servers. Never from the servo thread.
namespace app::log {

enum class Level { Debug, Info, Warning, Error, Off };

/// "debug", "info", …: the names of the command line. Another name is Off.
Level levelOf(std::string_view name);

/// A word that stands in the source, so nothing of a scan, a path or a server can be in it.
struct Word {
  consteval Word(const char* in_source) : text(in_source) {}
  std::string_view text;
};

/// A word that does not stand in the source. Only the functions below make one.
class Name {
 public:
  const std::string& text() const { return text_; }

 private:
  explicit Name(std::string text) : text_(std::move(text)) {}
  friend Name nameOfProgram(std::string_view name);
  friend Name nameOfMachine(std::string_view text);
  std::string text_;
};

/// A name that this program gave, of an error, a device or a type: at most 64 letters, digits, "-",
/// "_" and "."; all else is "?". The caller sees to it that it is no word of a user.
Name nameOfProgram(std::string_view name);
/// What a library or a driver says of itself: its printable ASCII, at most 120 characters.
Name nameOfMachine(std::string_view text);
/// The id of the error's sentence, or its reason where the sentence is plain text. Neither has a
/// word of the sentence's arguments.
Name nameOf(const haptics::Error& error);

/// A fact of a line: name=value.
struct Field {
  template <std::integral Number>
  Field(Word called, Number number) : name(called), value(static_cast<std::int64_t>(number)) {}
  template <std::floating_point Number>
  Field(Word called, Number number) : name(called), value(static_cast<double>(number)) {}
  Field(Word called, Word word) : name(called), value(word) {}
  Field(Word called, Name text) : name(called), value(std::move(text)) {}

  Word name;
  std::variant<std::int64_t, double, Word, Name> value;
};

/// Opens the log in this folder, which is made for the user's eyes alone; the log goes on where it
/// ended. It is at most three files of 1 MB. Where it cannot be written, false, and write() does
/// nothing. Call open() and close() while no other thread writes.
bool open(const std::filesystem::path& folder, Level level);
void close();

/// Writes one line: time, session, level, event and fields. Any thread but the servo's: it locks,
/// allocates and uses a file. A full disk costs the line, and nothing else.
void write(Level level, Word event, std::initializer_list<Field> fields = {});

/// One word for this process, which later ones with the same number do not have.
std::string session();

/// The lines of the log in this folder, oldest first; of one session, or of all (""). At most the
/// newest `most`.
std::vector<std::string> lines(const std::filesystem::path& folder, std::size_t most,
                               const std::string& session = {});

/// The user's folder for logs and crash reports: palpate in XDG_STATE_HOME, or in ~/.local/state if
/// that is not an absolute path. Empty where there is no home.
std::filesystem::path stateFolder();

}  // namespace app::log
