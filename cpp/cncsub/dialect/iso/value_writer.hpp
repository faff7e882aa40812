// The instructions of one expression, and what kind of value the last of them left.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/expression_rules.hpp"

namespace cncsub {

/// What a part of an expression gives: a number, or whether a condition holds. Neither where it was
/// refused, or where what was read waits for an operand.
class Value {
 public:
  Value() = default;
  static Value number() { return Value(kNumber); }
  static Value condition() { return Value(kCondition); }
  static Value awaited() { return Value(kAwaited); }
  /// That of the instruction at a place, which is one variable and may still be vacant.
  static Value variable(std::uint32_t place) { return Value(static_cast<std::int32_t>(place)); }

  explicit operator bool() const { return of_ >= kCondition; }
  bool is_number() const { return of_ >= kNumber; }
  bool is_condition() const { return of_ == kCondition; }
  bool is_awaited() const { return of_ == kAwaited; }
  bool is_variable() const { return of_ >= 0; }
  std::uint32_t place() const { return static_cast<std::uint32_t>(of_); }

 private:
  static constexpr std::int32_t kNone = -4, kAwaited = -3, kCondition = -2, kNumber = -1;

  explicit Value(std::int32_t of) : of_(of) {}

  std::int32_t of_ = kNone;
};

/// What is returned where something was refused: nothing, of whatever is asked for.
struct Refused {
  // NOLINTBEGIN(*-explicit-constructor)
  operator Value() const { return {}; }
  operator std::optional<std::uint32_t>() const { return std::nullopt; }
  operator std::optional<std::int64_t>() const { return std::nullopt; }
  // NOLINTEND(*-explicit-constructor)
};

class ValueWriter {
 public:
  ValueWriter(Builder& to, const ExpressionRules& rules) : out_(to.expressions()), rules_(rules) {}

  const ExpressionRules& rules() const { return rules_; }
  /// What was refused, where something was.
  const Fault& fault() const { return *fault_; }  // NOLINT(bugprone-unchecked-optional-access)
  /// The first fault counts.
  Refused refuse(Cause cause, std::uint32_t at, std::string detail = {});

  /// Another expression begins. `address`: of the word whose value it is, 0 in a statement: ROUND
  /// rounds otherwise.
  void begin(char address) {
    fault_.reset();
    out_.begin();
    address_ = static_cast<std::uint8_t>(address);
  }
  bool in_word() const { return address_ != 0; }
  /// An instruction that holds nothing, or a value.
  void emit(Ins op, std::uint32_t at) { out_.emit(op, address_, at); }
  void emit(Ins op, std::uint32_t at, double value) { out_.emit(op, address_, at, value); }
  /// The sign at `at` of the operand that began with instruction `first`.
  void negate(std::uint32_t first, std::uint32_t at);
  /// An operator of arithmetic or logic; `with_constant` is the same with a constant on its right,
  /// Ins::End where there is none.
  void emit_operator(Ins op, Ins with_constant, std::uint32_t at) {
    const std::uint32_t last = out_.last_place();
    const bool constant = with_constant != Ins::End && out_.last() == Ins::Constant;
    if (!constant || (op == Ins::Divide && out_.value(last) == 0)) return emit(op, at);
    out_.set_op(last, with_constant);
    out_.set_at(last, at);
  }
  /// Pushes the value of a variable, which may be vacant.
  Value load(std::int64_t number, std::uint32_t at);
  Value load(const ExpressionRules::Near& of, std::uint32_t number) {
    return load(of.raw, of.base + number - of.first, number);
  }
  /// The value of the last instruction, which may be vacant.
  Value last() const { return Value::variable(out_.last_place()); }

  /// A comparison leaves 1 or 0, which is a number where the control says so.
  bool is_number(Value& value) const {
    if (value.is_condition() && rules_.values) value = Value::number();
    return value.is_number();
  }
  /// From here on the value is a number: a vacant variable counts as 0. What is none is refused.
  bool arithmetic(Value& value, std::uint32_t at) {
    if (value.is_variable())
      count_vacant(value.place());
    else if (!is_number(value))
      return no_number(at);
    value = Value::number();
    return true;
  }

  /// The place of the next instruction.
  std::uint32_t next() const { return out_.next(); }
  /// Ends the expression: its number.
  std::uint32_t finish(std::uint32_t at, std::uint32_t width) { return out_.end(at, width); }

 private:
  bool no_number(std::uint32_t at);
  /// The load of a variable at a place gives 0 where it is vacant.
  void count_vacant(std::uint32_t place) {
    const Ins op = out_.op(place);
    if (op == Ins::CommonRaw)
      out_.set_op(place, Ins::Common);
    else if (op == Ins::LocalRaw)
      out_.set_op(place, Ins::Local);
    else
      count_other_vacant(place);
  }
  void count_other_vacant(std::uint32_t place);
  Value load(Ins op, std::uint32_t index, std::uint32_t number) {
    out_.emit_variable(op, index, number);
    return last();
  }

  ExpressionWriter& out_;
  const ExpressionRules& rules_;
  std::optional<Fault> fault_;
  std::uint8_t address_ = 0;
};

}  // namespace cncsub
