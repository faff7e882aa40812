// Writes expressions: their instructions one by one, which become a part of the code when the
// expression ends.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cncsub/code/code.hpp"

namespace cncsub {

class ExpressionWriter {
 public:
  explicit ExpressionWriter(Code& code) : code_(code) {}
  ExpressionWriter(const ExpressionWriter&) = delete;
  ExpressionWriter& operator=(const ExpressionWriter&) = delete;

  /// Another expression begins. One that was begun and did not end is forgotten.
  void begin() {
    first_ = code_.expressions.room(kRoom) + 1;
    limit_ = first_ + kRoom - kSpare;
    top_ = last_ = first_;
  }
  /// The place of the next instruction.
  std::uint32_t next() const { return place_of(top_); }
  void emit(const Instruction& instruction) {
    put(ExpressionCell::of(instruction));
    if (held_by(instruction.op) == Holds::Value) *top_++ = ExpressionCell::of(instruction.value);
  }
  /// The same for an instruction of which it is known what it holds: nothing, a value, a variable.
  void emit(Ins op, std::uint8_t address, std::uint32_t at) {
    put(ExpressionCell::of(op, address, at));
  }
  void emit(Ins op, std::uint8_t address, std::uint32_t at, double value) {
    put(ExpressionCell::of(op, address, at));
    *top_++ = ExpressionCell::of(value);
  }
  void emit_variable(Ins op, std::uint32_t index, std::uint32_t number) {
    put(ExpressionCell::of(op, index, number));
  }

  /// The operation of the instruction at a place, and of the last one.
  Ins op(std::uint32_t place) const { return first_[place].op(); }
  Ins last() const { return last_->op(); }
  std::uint32_t last_place() const { return place_of(last_); }
  /// The value of one that holds it.
  double value(std::uint32_t place) const { return first_[place + 1].value(); }
  void set_value(std::uint32_t place, double value) {
    first_[place + 1] = ExpressionCell::of(value);
  }
  /// Another operation that holds the same.
  void set_op(std::uint32_t place, Ins op) {
    first_[place].low = (first_[place].low & ~0xFFU) | static_cast<std::uint32_t>(op);
  }
  void set_at(std::uint32_t place, std::uint32_t at) { first_[place].high = at; }

  /// Takes away the instructions from this place on.
  void take_back(std::uint32_t from) { top_ = first_ + from; }
  /// Ends the expression, which stands there in the text: its number.
  std::uint32_t end(std::uint32_t at, std::uint32_t width);
  /// An expression of one instruction: its number.
  std::uint32_t one(const Instruction& only, std::uint32_t at, std::uint32_t width);

  /// How much is written: what is written from there on can be taken back.
  struct Place {
    std::size_t cells;
  };
  Place place() const { return {code_.expressions.size()}; }
  void take_back(const Place& from) { code_.expressions.keep(from.cells); }

 private:
  static constexpr std::size_t kRoom = 64;
  static constexpr std::size_t kSpare = 4;  // the head, an instruction and the End

  std::uint32_t place_of(const ExpressionCell* at) const {
    return static_cast<std::uint32_t>(at - first_);
  }
  void put(ExpressionCell cell) {
    if (top_ > limit_) make_room();
    last_ = top_;
    *top_++ = cell;
  }
  void make_room();

  Code& code_;
  // Behind the expressions of the code, where the head's cell is free: the instructions.
  ExpressionCell *first_ = nullptr, *top_ = nullptr, *last_ = nullptr, *limit_ = nullptr;
};

}  // namespace cncsub
