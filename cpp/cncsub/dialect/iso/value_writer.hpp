// The instructions of one expression: what kind of value the last of them left, and how many values
// wait on the stack.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cncsub/code/builder.hpp"

namespace cncsub {

struct PlainExpression;

/// Whether the control has a function, or an operator that some have not.
bool has_function(const Code& code, Function function);

/// What a part of an expression gives.
struct Value {
  enum class Type { Number, Condition };
  Type type = Type::Number;
  std::int64_t raw = -1;  // the instruction, where it is one variable and may still be vacant
};

class ValueWriter {
 public:
  explicit ValueWriter(Builder& to) : to_(to), control_(to.control()) {}

  const Control& control() const { return control_; }
  const Fault& fault() const { return fault_; }
  /// The first fault counts.
  std::nullopt_t refuse(Cause cause, std::uint32_t at, std::string detail = {});

  /// The address of the word whose value is written, 0 in a statement: ROUND rounds otherwise.
  void begin_word(char address) { address_ = address; }
  bool in_word() const { return address_ != 0; }
  void emit(Ins op, std::uint32_t at, double value = 0) {
    to_.expressions().emit({op, static_cast<std::uint8_t>(address_), at, value});
    depth_ += stack_effect(op);
  }
  /// The sign at `at` of the operand that began with instruction `first`.
  void negate(std::uint32_t first, std::uint32_t at);
  /// An operator of arithmetic or logic; `with_constant` is the same with a constant on its right,
  /// Ins::End where there is none.
  void emit_operator(Ins op, Ins with_constant, std::uint32_t at);
  /// Pushes the value of a variable, which may be vacant.
  Value load(std::int64_t number, std::uint32_t at);
  /// The value of the last instruction, which may be vacant.
  Value last() const { return {Value::Type::Number, std::int64_t{first()} - 1}; }
  /// What was read at once; nothing where it has no room.
  std::optional<Value> take(const PlainExpression& plain);

  /// Whether one more value has room on the stack; else it is refused.
  bool has_room(std::uint32_t at);
  /// A comparison leaves 1 or 0, which is a number where the control says so.
  bool is_number(Value& value) const;
  /// From here on the value is a number: a vacant variable counts as 0. What is none is refused.
  bool arithmetic(Value& value, std::uint32_t at);

  /// The place of the next instruction.
  std::uint32_t first() const { return to_.expressions().next(); }
  /// Ends the expression that began with instruction `first`: its number.
  std::uint32_t finish(std::uint32_t first, std::uint32_t at, std::uint32_t width);

 private:
  static constexpr int kDeepest = 200;  // values on the stack, whatever the control allows

  Builder& to_;
  const Control& control_;
  Fault fault_;
  bool failed_ = false;
  char address_ = 0;
  int depth_ = 0;  // values on the stack
};

}  // namespace cncsub
