// Codes that are registered to call programs: `M50=call:9001 G101=macro-call:9010 T=call:9000`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/control/list.hpp"

namespace cncsub {

/// The ways in which a code calls a program.
enum class CodeCallKind : std::uint8_t { Subprogram, Macro, Modal, ModalEveryBlock };
/// The names of these kinds, which call as M98, G65, G66 and G66.1 do.
inline constexpr std::string_view kCodeCallNames[] = {"call", "macro-call", "modal-call",
                                                      "modal-call-every-block"};

struct RegisteredEntry {
  struct Entry {
    std::int32_t program = 0;
    std::int16_t code = 0;  // 0 = every code of the letter
    char letter = 0;
    CodeCallKind kind{};
    bool operator==(const Entry&) const = default;
  };
  static constexpr std::size_t kMost = 64;
  static constexpr std::optional<Entry> read(std::string_view text) {
    const auto equals = std::min(text.find('='), text.size());
    const auto colon = std::min(text.find(':'), text.size());
    if (equals == 0 || equals > colon || colon == text.size()) return std::nullopt;
    const auto kind =
        named<CodeCallKind>(kCodeCallNames, text.substr(equals + 1, colon - equals - 1));
    const auto program = number(text.substr(colon + 1), 99'999'999);
    if (!kind || !program) return std::nullopt;
    const char letter = text[0];
    const bool numbered = letter == 'G' || letter == 'M';
    const auto code = numbered ? number(text.substr(1, equals - 1), 9999) : std::optional(0);
    if (!code || (!numbered && !is_whole_letter(text.substr(0, equals)))) return std::nullopt;
    return Entry{*program, static_cast<std::int16_t>(*code), letter, *kind};
  }
  static constexpr bool same(const Entry& a, const Entry& b) {
    return a.letter == b.letter && a.code == b.code;
  }
  static std::string text(const Entry& entry) {
    return entry.letter + (entry.code == 0 ? "" : std::to_string(entry.code)) + "=" +
           std::string(kCodeCallNames[static_cast<std::size_t>(entry.kind)]) + ":" +
           std::to_string(entry.program);
  }
  static std::string wrong(std::string_view text);

 private:
  /// Return whether every S, T or B calls the same program.
  static constexpr bool is_whole_letter(std::string_view text) {
    return text == "S" || text == "T" || text == "B";
  }
  static constexpr std::optional<int> number(std::string_view text, int most) {
    std::int64_t value = 0;
    for (const char c : text) {
      if (c < '0' || c > '9') return std::nullopt;
      value = value * 10 + (c - '0');
      if (value > most) return std::nullopt;
    }
    return value == 0 ? std::nullopt : std::optional(static_cast<int>(value));
  }
};

using RegisteredCodes = List<RegisteredEntry>;

}  // namespace cncsub
