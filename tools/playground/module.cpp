// SPDX-License-Identifier: MIT
// What a page sees of the module: text goes in through room(), and what a call has made is read where the functions say
// that it lies, until the next call.
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <typeinfo>

#include "playground/controls.hpp"
#include "playground/flown.hpp"

namespace fantail::playground {
namespace {

std::string words;                 // NOLINT: the module is one call after the other
std::string answer;                // NOLINT
Flown flown;                       // NOLINT
std::array<char, 4096> refused{};  // NOLINT: of a fixed size, because there may be no memory left

/// Ends the module: it can be read, but no longer called. Whoever owns it starts another.
[[noreturn]] void end_with(const char* sentence) {
  std::strncpy(refused.data(), sentence, refused.size() - 1);
  __builtin_trap();
}

}  // namespace
}  // namespace fantail::playground

// This libc++ can throw, but nobody can catch. All that is thrown here is an exception with a sentence for a person.
extern "C" {
void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }  // NOLINT: the ABI's names
[[noreturn]] void __cxa_throw(void* thrown, std::type_info* /*type*/, void (* /*destroy*/)(void*)) {  // NOLINT
  fantail::playground::end_with(static_cast<const std::exception*>(thrown)->what());
}
}

#define FANTAIL_EXPORT(name) [[gnu::used, clang::export_name(#name)]]

namespace fantail::playground {
extern "C" {

/// Where so many bytes of text are to be put before a call.
FANTAIL_EXPORT(room) char* room(std::size_t bytes) {
  std::set_new_handler([] { end_with("this flight needs more memory than a page may have"); });
  words.assign(bytes, '\0');
  return words.data();
}

/// Flies the text in room(), see playground::fly().
FANTAIL_EXPORT(fly) void fly_words() {
  flown = {};  // before the next one is made: never two of them
  flown = fly(words);
  answer = flown.summary;
}

/// Which settings the scenario in room() offers, as JSON.
FANTAIL_EXPORT(controls) void controls_of_words() { answer = controls(words); }

/// The names of all scenarios, one a line, and those of all columns behind an empty one.
FANTAIL_EXPORT(about) void about() { answer = playground::names(); }

FANTAIL_EXPORT(answer) const char* answer_text() { return answer.data(); }
FANTAIL_EXPORT(answer_size) std::size_t answer_size() { return answer.size(); }
FANTAIL_EXPORT(refusal) const char* refusal_text() { return refused.data(); }
FANTAIL_EXPORT(refusal_size) std::size_t refusal_size() { return std::strlen(refused.data()); }
FANTAIL_EXPORT(columns) const float* columns() { return flown.columns.data(); }
FANTAIL_EXPORT(rows) std::size_t rows() { return flown.rows; }
}
}  // namespace fantail::playground
