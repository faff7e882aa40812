// Writes expressions: their instructions one by one, which become a part of the code when the
// expression ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cncsub/code/code.hpp"

namespace cncsub {

class ExpressionWriter {
 public:
  explicit ExpressionWriter(Code& code) : code_(code), open_(kRoom) { clear(); }
  ExpressionWriter(const ExpressionWriter&) = delete;
  ExpressionWriter& operator=(const ExpressionWriter&) = delete;

  /// The place of the next instruction; those of one expression follow each other.
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
  Ins op(std::uint32_t place) const { return open_[place].op(); }
  Ins last() const { return last_->op(); }
  std::uint32_t last_place() const { return place_of(last_); }
  /// The value of one that holds it.
  double value(std::uint32_t place) const { return open_[place + 1].value(); }
  void set_value(std::uint32_t place, double value) {
    open_[place + 1] = ExpressionCell::of(value);
  }
  /// Another operation that holds the same.
  void set_op(std::uint32_t place, Ins op) {
    open_[place].low = (open_[place].low & ~0xFFU) | static_cast<std::uint32_t>(op);
  }
  void set_at(std::uint32_t place, std::uint32_t at) { open_[place].high = at; }

  /// Takes away the instructions from this place on.
  void take_back(std::uint32_t from) { top_ = open_.data() + from; }
  /// Takes away those of expressions that did not end.
  void clear() {
    top_ = last_ = open_.data() + 1;
    limit_ = open_.data() + open_.size() - kSpare;
  }
  /// How much is written: what is written from there on can be taken back, open instructions too.
  struct Place {
    std::size_t cells;
  };
  Place place() const { return {code_.expressions.size()}; }
  void take_back(const Place& from) {
    code_.expressions.resize(from.cells);
    clear();
  }
  /// Ends the expression that began with instruction `first`: its number.
  std::uint32_t end(std::uint32_t first, std::uint32_t at, std::uint32_t width);
  /// An expression of one instruction: its number.
  std::uint32_t one(const Instruction& only, std::uint32_t at, std::uint32_t width);
  /// Where an expression stands in the text.
  std::uint32_t at(std::uint32_t number) const {
    return number == ended_ ? code_.expressions.back().high : code_.expression(number).at();
  }

 private:
  static constexpr std::size_t kRoom = 64;
  static constexpr std::size_t kSpare = 3;  // an instruction and the End

  std::uint32_t place_of(const ExpressionCell* at) const {
    return static_cast<std::uint32_t>(at - open_.data());
  }
  void put(ExpressionCell cell) {
    if (top_ > limit_) grow();
    last_ = top_;
    *top_++ = cell;
  }
  void grow();

  Code& code_;
  std::vector<ExpressionCell> open_;  // up to `top_`; one before the first instruction is free
  ExpressionCell *top_ = nullptr, *last_ = nullptr, *limit_ = nullptr;
  std::uint32_t ended_ = 0xffffffff;  // the expression that was ended last
};

}  // namespace cncsub
