// The expression that is being read: its text, what is written of it, and what waits for a value.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/operators.hpp"
#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

struct OpenExpression {
  OpenExpression(Builder& to, const ExpressionRules& rules_of);

  const ExpressionRules& rules;
  Names& names;
  ValueWriter out;
  Scanner* s = nullptr;
  std::unique_ptr<Waiting[]> waiting;  // NOLINT(*-avoid-c-arrays): up to `last`
  Waiting* last = nullptr;
  int brackets = 0;
  int nots = 0;  // that wait

  void begin(Scanner& text, char address = 0) {
    s = &text;
    out.begin(address);
    last = waiting.get() + 1;
    brackets = nots = 0;
  }
  std::uint32_t offset(const char* at) const { return static_cast<std::uint32_t>(at - s->file); }

  /// Whether a number that was read as far as `at` ends there for certain: it may go on behind a
  /// gap and with another point.
  bool ends_at(const char* at) const {
    if (begins_gap(*at) || *at == '.') [[unlikely]]
      return at == s->end;
    return at <= s->end;
  }
  /// Reads the number behind a #, where it is digits and nothing else: where it ends, else null.
  /// (A branch: what is read next does not wait for what is asked here.)
  const char* plain_number(const char* at, std::uint32_t& number) const {
    const char* const first = at;
    number = 0;
    for (std::uint32_t digit = 0; (digit = static_cast<std::uint32_t>(*at - '0')) <= 9; ++at)
      number = number * 10 + digit;
    if (at == first || at - first > rules.most_variable_digits || !ends_at(at)) [[unlikely]]
      return nullptr;
    return at;
  }

  /// What is read next is the value of what waits.
  Value wait(Waiting::Kind kind, std::uint32_t at, const FunctionName* function = nullptr) {
    Waiting& of = *last++;
    of.level = kind <= Waiting::Kind::Not ? Waiting::kPrefix : Waiting::kOpening;
    of.kind = kind;
    of.at = at;
    of.function = function;
    of.second = false;
    return Value::awaited();
  }
  /// The bracket that stands here opens what is at `at`.
  Value open(Waiting::Kind kind, std::uint32_t at, const FunctionName* function = nullptr) {
    return opens() ? wait(kind, at, function) : Value{};
  }
  bool opens();
  bool closes();
};

// What is read from where the scanner stands.

/// An operand, or what opens before one.
Value operand(OpenExpression& e);
/// A word: a function, a value with a name, NOT.
Value word(OpenExpression& e);
/// A variable.
Value variable(OpenExpression& e);
/// The number of a variable that is not in brackets, where it is written behind the #; else
/// kComputed, and instructions give it.
std::optional<std::int64_t> variable_number(OpenExpression& e, std::uint32_t at);
constexpr std::int64_t kComputed = -1;

/// Gives an operand to the signs before it, and to NOT.
Value prefixed(OpenExpression& e, Value value);
/// What stands behind an argument or a value in brackets and does not close them: a comma, or the
/// expression is refused.
Value not_closed(OpenExpression& e, Waiting& of, bool argument);
/// What is made of the value in brackets that do not stand alone.
Value closed(OpenExpression& e, const Waiting& of, Value value);

}  // namespace cncsub
