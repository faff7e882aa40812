// Values that are computed when a block runs.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cncsub {

/// The value of #0 and of a variable never set. Arithmetic never produces a NaN, so every NaN is
/// vacant.
constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();
inline bool is_vacant(double value) { return std::isnan(value); }

enum class Ins : std::uint8_t {
#define INS(name, effect, function) name,
#include "cncsub/code/ins.def"
#undef INS
};

/// How many values more an instruction leaves on the stack.
constexpr int stack_effect(Ins op) {
  enum { Join = -1, Take = -1, Change = 0, Push = 1 };
  constexpr std::int8_t kEffects[] = {
#define INS(name, effect, function) effect,
#include "cncsub/code/ins.def"
#undef INS
  };
  return kEffects[static_cast<std::size_t>(op)];
}

struct Instruction {
  Ins op = Ins::End;
  std::uint8_t address = 0;  // RoundWord: the word's address
  std::uint32_t at = 0;      // where in the text, for a fault; of a variable: its index
  double value = 0;          // a constant; of a variable: its number
};

/// An expression. Most are one value, or one operation on two, and need no instructions: `form`
/// says so.
struct Expression {
  std::uint32_t first = 0;  // into Code::instructions
  std::uint32_t at = 0;
  std::uint32_t width = 1;
  enum class Form : std::uint8_t { Long, One, Two } form = Form::Long;
  Ins op = Ins::End;  // of Two
  struct Load {
    enum class From : std::uint8_t { Constant, Local, Common } from = From::Constant;
    bool raw = false;  // a vacant variable stays vacant
    std::uint32_t index = 0;
    double value = 0;
  };
  std::array<Load, 2> loads{};
};

/// A value in a block: absent, written as a number, or an expression.
struct Operand {
  enum class Kind : std::uint8_t { Absent, Constant, Expression } kind = Kind::Absent;
  bool bracketed = false;    // P[#100]
  bool whole = false;        // a number without a decimal point
  bool fine = false;         // a number with more than three decimals
  std::uint8_t digits = 0;   // without leading zeros
  std::uint8_t written = 0;  // with them
  std::uint32_t expression = 0;
  double value = 0;
  std::uint32_t at = 0;
  std::uint32_t width = 1;

  bool present() const { return kind != Kind::Absent; }
};

}  // namespace cncsub
