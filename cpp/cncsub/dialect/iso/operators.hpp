// Operators of expressions: how tightly each binds, and what it makes of two values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

struct OperatorName {
  std::string_view text;
  Ins op;
  int alike, last;  // the level at which it binds where logic binds like arithmetic; where it binds
                    // last. Level 0 binds weakest
  Ins other = Ins::End;  // of logic: on two conditions; else with a constant on the right

  bool compares() const { return op >= Ins::Equal && op <= Ins::LessEqual; }
  bool is_logic() const { return last == 0; }
  bool is_arithmetic() const { return last >= 2; }
};

inline constexpr OperatorName kArithmetic[] = {{"+", Ins::Add, 1, 2, Ins::AddConstant},
                                               {"-", Ins::Subtract, 1, 2, Ins::SubtractConstant},
                                               {"*", Ins::Multiply, 2, 3, Ins::MultiplyConstant},
                                               {"/", Ins::Divide, 2, 3, Ins::DivideConstant}};

inline constexpr OperatorName kOperators[] = {{"AND", Ins::And, 2, 0, Ins::BothTrue},
                                              {"XOR", Ins::Xor, 1, 0, Ins::OneTrue},
                                              {"OR", Ins::Or, 1, 0, Ins::EitherTrue},
                                              {"MOD", Ins::Modulo, 2, 3},
                                              {"EQ", Ins::Equal, 0, 1},
                                              {"NE", Ins::NotEqual, 0, 1},
                                              {"GT", Ins::Greater, 0, 1},
                                              {"LT", Ins::Less, 0, 1},
                                              {"GE", Ins::GreaterEqual, 0, 1},
                                              {"LE", Ins::LessEqual, 0, 1}};

constexpr int kTightest = 3;  // of the levels where logic binds last
/// The level at which an operator binds, but for logic of numbers where that binds first.
inline int level_of(const ExpressionRules& rules, const OperatorName& of) {
  return rules.alike ? of.alike : of.last;
}

/// What waits for a value on its right.
struct Waiting {  // NOLINT(*-member-init): for its right value
  enum class Kind : std::uint8_t {
    Operator,
    Plus,
    Minus,
    Not,
    Bracket,         // [
    Indirect,        // #[
    Function,        // SIN[
    ArcTangent,      // ATAN[ whose second argument may stand in brackets behind a slash
    SecondArgument,  // and these
  };
  static constexpr int kOpening = -1, kPrefix = kTightest + 1;

  Value left;              // of an operator
  const OperatorName* of;  // of an operator
  const FunctionName* function;
  std::uint32_t at;
  int level;  // how tightly an operator binds; kPrefix of signs and NOT; kOpening
  Kind kind;
  bool second;  // of a function: the second argument is read
};

/// The operator that stands here; null where none does.
const OperatorName* find_operator(const ExpressionRules& rules, const Scanner& s);
/// Whether logic behind a value binds as that of numbers, which counts where that binds first. It
/// counts whether the value is the right side of a comparison: `#1EQ3AND#2EQ4` joins two,
/// `3EQ#1AND3` is one.
bool is_of_numbers(const Scanner& s, const OperatorName& of, const Value& value,
                   std::span<const Waiting> waiting);
/// Joins two values by the operator at `at`; `end`: behind them.
Value apply(ValueWriter& out, const OperatorName& of, std::uint32_t at, Value left, Value right,
            std::uint32_t end);

}  // namespace cncsub
