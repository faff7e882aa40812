// Writes expressions: their instructions one by one, which become a part of the code when the
// expression ends.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "cncsub/code/code.hpp"
#include "cncsub/code/expression_form.hpp"

namespace cncsub {

/// A value as it is written: a number, or an expression that computes it.
struct ValueRead {
  bool computed = false;
  double number = 0;
  std::uint32_t expression = 0;
  std::uint32_t at = 0, width = 1;
};

/// The instructions of the expression that is being written. They stand where they stay, after the
/// expressions of the code. The cell before the first is free for the head.
class OpenInstructions {
 public:
  /// `short_forms`: one value, or one operation on two, is kept in its own form.
  OpenInstructions(OpenTable<ExpressionCell>& table, bool short_forms)
      : table_(table), widest_(short_forms ? Expression::kWidest : 0) {}

  /// Begin another expression. One that was begun and did not end is forgotten.
  void begin() {
    first_ = top_ = table_.room(kRoom) + 1;
    limit_ = first_ + kRoom - kSpare;
  }
  /// Return where the next instruction goes. Up to the limit there is room for a few after it.
  ExpressionCell* top() const { return top_; }
  const ExpressionCell* limit() const { return limit_; }
  /// Write a cell where there is room.
  void put(ExpressionCell cell) { *top_++ = cell; }
  void make_room();

  std::uint32_t place_of(const ExpressionCell* at) const {
    return static_cast<std::uint32_t>(at - first_);
  }
  /// Return the place of the next cell.
  std::uint32_t next() const { return place_of(top_); }
  /// Return the operation of the instruction at a place.
  Ins op(std::uint32_t place) const { return first_[place].op(); }
  /// Return the value of an instruction that holds one.
  double value(std::uint32_t place) const { return first_[place + 1].value(); }
  void set_value(std::uint32_t place, double value) {
    first_[place + 1] = ExpressionCell::of(value);
  }
  /// Replace an operation by another one that holds the same.
  void set_op(std::uint32_t place, Ins op) {
    first_[place].low = (first_[place].low & ~0xFFU) | static_cast<std::uint32_t>(op);
  }
  void set_at(std::uint32_t place, std::uint32_t at) { first_[place].high = at; }
  /// Take away the instructions from this place on.
  void rollback(std::uint32_t from) { top_ = first_ + from; }
  /// Make them an expression, which stands there in the text; return its number.
  std::uint32_t end(std::uint32_t at, std::uint32_t width);

 private:
  static constexpr std::size_t kRoom = 64;
  static constexpr std::size_t kSpare = 20;  // the head, a few instructions and the End

  OpenTable<ExpressionCell>& table_;
  std::uint32_t widest_;  // the widest text of an expression in a form of its own
  ExpressionCell *first_ = nullptr, *top_ = nullptr, *limit_ = nullptr;
};

inline std::uint32_t OpenInstructions::end(std::uint32_t at, std::uint32_t width) {
  const auto number = static_cast<std::uint32_t>(table_.size());
  using Form = Expression::Form;
  const auto [form, op] =
      width <= widest_ ? ExpressionForm::of(first_, top_) : ExpressionForm{Form::Long};
  first_[-1] = Expression::head(form, op, at, std::max(1U, width));
  if (form == Form::Constant) {
    first_[0] = first_[1];
    --top_;
  } else if (form == Form::Long) {
    *top_++ = ExpressionCell::of(Ins::End, 0, at);
  }
  table_.add(1 + place_of(top_));
  return number;
}

class ExpressionWriter {
 public:
  explicit ExpressionWriter(Code& code)
      : code_(code), open_(code.expressions, !code.general_only) {}
  ExpressionWriter(const ExpressionWriter&) = delete;
  ExpressionWriter& operator=(const ExpressionWriter&) = delete;

  OpenInstructions& open() { return open_; }
  void begin() { open_.begin(); }
  /// Return the place of the next instruction.
  std::uint32_t next() const { return open_.next(); }
  void emit(const Instruction& instruction) {
    put(ExpressionCell::of(instruction));
    if (held_by(instruction.op) == Holds::Value) put(ExpressionCell::of(instruction.value));
  }
  void rollback(std::uint32_t from) { open_.rollback(from); }
  std::uint32_t end(std::uint32_t at, std::uint32_t width) { return open_.end(at, width); }
  /// Write an expression of one instruction; return its number.
  std::uint32_t one(const Instruction& only, std::uint32_t at, std::uint32_t width);
  /// Write an expression with one more operation, on its value; return its number.
  std::uint32_t changed(std::uint32_t expression, Ins by);
  /// End an expression as a value: a number where it is this constant and nothing else.
  ValueRead end_value(std::optional<double> constant, std::uint32_t at, std::uint32_t width) {
    ValueRead value{!constant, constant.value_or(0), 0, at, width};
    if (value.computed) value.expression = end(at, width);
    return value;
  }
  /// Return the expression of a value, which is made where the value is a number.
  std::uint32_t expression_of(const ValueRead& value) {
    if (value.computed) return value.expression;
    return one({Ins::Constant, 0, value.at, value.number}, value.at, value.width);
  }

  /// The number of cells written. What is written from there on can be rolled back.
  struct Place {
    std::size_t cells;
  };
  Place place() const { return {code_.expressions.size()}; }
  void rollback(const Place& from) { code_.expressions.keep(from.cells); }

 private:
  void put(ExpressionCell cell) {
    if (open_.top() > open_.limit()) open_.make_room();
    open_.put(cell);
  }

  Code& code_;
  OpenInstructions open_;
};

}  // namespace cncsub
