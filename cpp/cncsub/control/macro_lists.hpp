// The lists of a control's macros: its functions, its statements, the numbers of its variables.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/control/list.hpp"

namespace cncsub {

// clang-format off
#define CNCSUB_FUNCTIONS(F) \
  F(Pi, "PI") F(True, "TRUE") F(False, "FALSE") F(Mod, "MOD") F(Sin, "SIN") F(Cos, "COS") F(Tan, "TAN") F(Asin, "ASIN") \
  F(Acos, "ACOS") F(Atan, "ATAN") F(Atan2, "ATAN2") F(Sqrt, "SQRT") F(Sqr, "SQR") F(Abs, "ABS") F(Round, "ROUND") \
  F(Rnd, "RND") F(Fix, "FIX") F(Int, "INT") F(Fup, "FUP") F(Ln, "LN") F(Exp, "EXP") F(Pow, "POW") F(Bin, "BIN") \
  F(Bcd, "BCD") F(Adp, "ADP") F(Prm, "PRM") F(Sign, "SIGN") F(Rand, "RAND") F(Srand, "SRAND") F(Ar, "AR")
// clang-format on

/// A function of expressions, an operator that some controls have not, or a word that is a value.
enum class Function : std::uint8_t {
#define CNCSUB_FUNCTION(function, name) function,
  CNCSUB_FUNCTIONS(CNCSUB_FUNCTION)
#undef CNCSUB_FUNCTION
};
inline constexpr std::string_view kFunctionNames[] = {
#define CNCSUB_FUNCTION(function, name) name,
    CNCSUB_FUNCTIONS(CNCSUB_FUNCTION)
#undef CNCSUB_FUNCTION
};
constexpr std::string_view name_of(Function function) {
  return kFunctionNames[static_cast<std::size_t>(function)];
}

/// The kinds of macro statements. END and END IF belong to DO and IF.
enum class StatementKind : std::uint8_t {
  Variables,
  Brackets,
  If,
  While,
  Do,
  Goto,
  Dprnt,
  Bprnt,
  Popen,
  Pclos,
  Count
};
inline constexpr std::string_view kStatementNames[] = {"#",    "[",     "IF",    "WHILE", "DO",
                                                       "GOTO", "DPRNT", "BPRNT", "POPEN", "PCLOS"};
constexpr std::string_view name_of(StatementKind kind) {
  return kStatementNames[static_cast<std::size_t>(kind)];
}

/// An entry of a list of functions.
struct FunctionEntry {
  using Entry = Function;
  static constexpr std::size_t kMost = std::size(kFunctionNames);
  static constexpr std::optional<Function> read(std::string_view text) {
    return named<Function>(kFunctionNames, text);
  }
  static constexpr bool same(Function a, Function b) { return a == b; }
  static std::string text(Function function) { return std::string(name_of(function)); }
  static std::string wrong(std::string_view text);
};

/// An entry as `GOTO`, or `GOTO?` where no source says whether the control has it.
struct StatementEntry {
  struct Entry {
    StatementKind kind{};
    bool unsure = false;
    bool operator==(const Entry&) const = default;
  };
  static constexpr std::size_t kMost = std::size(kStatementNames);
  static constexpr std::optional<Entry> read(std::string_view text) {
    const bool unsure = text.ends_with('?');
    if (unsure) text.remove_suffix(1);
    const auto kind = named<StatementKind>(kStatementNames, text);
    return kind ? std::optional(Entry{*kind, unsure}) : std::nullopt;
  }
  static constexpr bool same(const Entry& a, const Entry& b) { return a.kind == b.kind; }
  static std::string text(const Entry& entry) {
    return std::string(name_of(entry.kind)) + (entry.unsure ? "?" : "");
  }
  static std::string wrong(std::string_view text);
};

/// Numbers of variables: `100-199`, or `100`.
struct Span {
  std::int32_t first = 0;
  std::int32_t last = 0;

  static constexpr std::int32_t kLargest = 999'999'999;
  /// Read a span; nothing where the text is none. One that ends before it begins is read.
  static constexpr std::optional<Span> read(std::string_view text) {
    const auto dash = std::min(text.find('-'), text.size());
    const auto first = number(text.substr(0, dash));
    const auto last = dash == text.size() ? first : number(text.substr(dash + 1));
    return first && last ? std::optional(Span{*first, *last}) : std::nullopt;
  }
  constexpr bool has(std::int32_t of) const { return first <= of && of <= last; }
  constexpr bool meets(const Span& other) const {
    return first <= other.last && other.first <= last;
  }
  std::string text() const {
    return std::to_string(first) + (first == last ? "" : "-" + std::to_string(last));
  }
  bool operator==(const Span&) const = default;

 private:
  static constexpr std::optional<std::int32_t> number(std::string_view text) {
    std::int64_t value = 0;
    for (const char c : text) {
      if (c < '0' || c > '9') return std::nullopt;
      value = value * 10 + (c - '0');
      if (value > kLargest) return std::nullopt;
    }
    return text.empty() ? std::nullopt : std::optional(static_cast<std::int32_t>(value));
  }
};

/// Spans that do not meet each other.
struct SpanEntry {
  using Entry = Span;
  static constexpr std::size_t kMost = 128;
  static constexpr std::optional<Span> read(std::string_view text) {
    const auto span = Span::read(text);
    return span && span->first <= span->last ? span : std::nullopt;
  }
  static constexpr bool same(const Span& a, const Span& b) { return a.meets(b); }
  static std::string text(const Span& span) { return span.text(); }
};

using Functions = List<FunctionEntry>;
using Statements = List<StatementEntry>;
using Ranges = List<SpanEntry>;

}  // namespace cncsub
