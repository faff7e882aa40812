// Operators of the ISO family: the spelling of each, its precedence, and its result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "cncsub/code/operators.hpp"
#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// An operator. `level` is its precedence where logic comes last, `alike` where logic binds like
/// arithmetic. `other` is the instruction of logic on two conditions, or of arithmetic with a
/// constant on the right.
struct IsoOperator : OperatorRow {
  int alike;

  constexpr bool compares() const { return op >= Ins::Equal && op <= Ins::LessEqual; }
  constexpr bool is_arithmetic() const { return level >= 2; }
};

inline constexpr IsoOperator kArithmetic[] = {{{"+", 2, Ins::Add, Ins::AddConstant}, 1},
                                              {{"-", 2, Ins::Subtract, Ins::SubtractConstant}, 1},
                                              {{"*", 3, Ins::Multiply, Ins::MultiplyConstant}, 2},
                                              {{"/", 3, Ins::Divide, Ins::DivideConstant}, 2}};

inline constexpr IsoOperator kNamedOperators[] = {{{"AND", 0, Ins::And, Ins::BothTrue}, 2},
                                                  {{"XOR", 0, Ins::Xor, Ins::OneTrue}, 1},
                                                  {{"OR", 0, Ins::Or, Ins::EitherTrue}, 1},
                                                  {{"MOD", 3, Ins::Modulo}, 2},
                                                  {{"EQ", 1, Ins::Equal}, 0},
                                                  {{"NE", 1, Ins::NotEqual}, 0},
                                                  {{"GT", 1, Ins::Greater}, 0},
                                                  {{"LT", 1, Ins::Less}, 0},
                                                  {{"GE", 1, Ins::GreaterEqual}, 0},
                                                  {{"LE", 1, Ins::LessEqual}, 0}};

/// Return all operators, with their precedence on a control.
std::span<const OperatorRow> iso_operators(LogicOrder order);
/// Return the operator at `s`; null if there is none. Blanks may part its letters.
const IsoOperator* find_operator(const ExpressionRules& rules, const Scanner& s);
/// Return whether a condition follows a logic operator, as in `AND #2 EQ 4` and `AND [#2 EQ 4]`,
/// but not in `AND 3`.
bool is_before_condition(const Scanner& at, const IsoOperator& of);

Value compare(ValueWriter& out, Ins op, std::uint32_t at, Value left, Value right,
              std::uint32_t end);
Value join_by_logic(ValueWriter& out, const IsoOperator& of, std::uint32_t at, Value left,
                    Value right, std::uint32_t end);

/// Join two values by the operator at `at`; they end before `end`. There is room for an
/// instruction.
inline Value apply(ValueWriter& out, const IsoOperator& of, std::uint32_t at, Value left,
                   Value right, std::uint32_t end) {
  if (!of.is_arithmetic())
    return of.compares() ? compare(out, of.op, at, left, right, end)
                         : join_by_logic(out, of, at, left, right, end);
  const bool constant = right.is_constant() && of.other != Ins::End;
  const std::uint32_t last = constant ? right.place() : 0;
  if (!out.arithmetic(left, end) || !out.arithmetic(right, end)) return {};
  OpenInstructions& written = out.instructions();
  if (!constant || (of.op == Ins::Divide && written.value(last) == 0)) {
    written.put(ExpressionCell::of(of.op, out.address(), at));
  } else {
    written.set_op(last, of.other);
    written.set_at(last, at);
  }
  return Value::number();
}

}  // namespace cncsub
