// The writer of an expression's instructions, and the kind of value that the last of them left.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/expression_rules.hpp"

namespace cncsub {

/// The value of a part of an expression: a number or a condition. It is neither if it was refused.
class Value {
 public:
  Value() = default;
  static Value number() { return Value(kNumber); }
  static Value condition() { return Value(kCondition); }
  /// Return a number of which the language knows that it is whole, or that it is not.
  static Value whole() { return Value(kWhole); }
  static Value real() { return Value(kReal); }
  /// Return the value of the instruction at `place`: one variable, which may still be vacant.
  static Value variable(std::uint32_t place) { return Value(static_cast<std::int32_t>(2 * place)); }
  /// Return the value of the instruction at `place`: a number as it is written.
  static Value constant(std::uint32_t place) {
    return Value(static_cast<std::int32_t>(2 * place + 1));
  }

  explicit operator bool() const { return of_ >= kCondition; }
  bool is_number() const { return of_ >= kWhole; }
  bool is_whole() const { return of_ == kWhole; }
  bool is_real() const { return of_ == kReal; }
  bool is_condition() const { return of_ == kCondition; }
  bool is_variable() const { return of_ >= 0 && (of_ & 1) == 0; }
  bool is_constant() const { return of_ >= 0 && (of_ & 1) != 0; }
  /// Return the place of a variable or a constant.
  std::uint32_t place() const { return static_cast<std::uint32_t>(of_) / 2; }

 private:
  static constexpr std::int32_t kNone = -5, kCondition = -4, kWhole = -3, kReal = -2, kNumber = -1;

  explicit Value(std::int32_t of) : of_(of) {}

  std::int32_t of_ = kNone;
};

/// The result of a refusal: an empty value of whatever type is asked for.
struct Refused {
  // NOLINTBEGIN(*-explicit-constructor)
  operator Value() const { return {}; }
  operator std::optional<std::uint32_t>() const { return std::nullopt; }
  operator std::optional<std::int64_t>() const { return std::nullopt; }
  // NOLINTEND(*-explicit-constructor)
};

class ValueWriter {
 public:
  ValueWriter(Builder& to, const ExpressionRules& rules)
      : out_(to.expressions()), open_(out_.open()), rules_(rules) {}

  const ExpressionRules& rules() const { return rules_; }
  /// Return what was refused; something must have been.
  const Fault& fault() const { return *fault_; }  // NOLINT(bugprone-unchecked-optional-access)
  /// Refuse the expression. The first fault counts.
  Refused refuse(Cause cause, std::uint32_t at, std::string detail = {});

  /// Begin another expression. `address`: that of the word whose value it is, 0 in a statement.
  /// ROUND rounds differently in a word.
  void begin(char address) {
    fault_.reset();
    open_.begin();
    address_ = static_cast<std::uint8_t>(address);
  }
  std::uint8_t address() const { return address_; }
  bool in_word() const { return address_ != 0; }
  OpenInstructions& instructions() { return open_; }
  /// Write an instruction, with a value if it takes one; return its place.
  std::uint32_t emit(Ins op, std::uint32_t at, double value = 0) {
    const std::uint32_t place = out_.next();
    out_.emit({op, address_, at, value});
    return place;
  }
  /// Push a number.
  Value constant(double value, std::uint32_t at) {
    return Value::constant(emit(Ins::Constant, at, value));
  }
  /// Push the value of a variable, which may be vacant.
  Value load(std::int64_t number, std::uint32_t at);
  /// Return the value with the minus sign at `at` before it.
  Value negated(Value value, std::uint32_t at);

  /// Return whether the value is a number. A comparison leaves 1 or 0, which is one where the
  /// control says so.
  bool is_number(Value& value) const {
    if (value.is_condition() && rules_.values) value = Value::number();
    return value.is_number();
  }
  /// Make the value a number: a vacant variable counts as 0. Refuse a value that cannot be one.
  bool arithmetic(Value& value, std::uint32_t at) {
    if (value.is_variable())
      count_vacant(value.place());
    else if (!is_number(value))
      return no_number(at);
    value = Value::number();
    return true;
  }

  /// End the expression; return its number.
  std::uint32_t finish(std::uint32_t at, std::uint32_t width) { return open_.end(at, width); }

 private:
  bool no_number(std::uint32_t at);
  /// Make the load of a variable at `place` give 0 if the variable is vacant.
  void count_vacant(std::uint32_t place) {
    const Ins op = open_.op(place);
    if (op == Ins::CommonRaw)
      open_.set_op(place, Ins::Common);
    else if (op == Ins::LocalRaw)
      open_.set_op(place, Ins::Local);
    else
      count_other_vacant(place);
  }
  void count_other_vacant(std::uint32_t place);

  ExpressionWriter& out_;
  OpenInstructions& open_;
  const ExpressionRules& rules_;
  std::optional<Fault> fault_;
  std::uint8_t address_ = 0;
};

}  // namespace cncsub
