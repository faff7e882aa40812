// Values that are computed when a block runs.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "cncsub/text/number.hpp"

namespace cncsub {

/// The value of #0 and of a variable never set. Arithmetic never produces a NaN, so every NaN is
/// vacant.
constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();
inline bool is_vacant(double value) { return std::isnan(value); }

enum class Ins : std::uint8_t {
#define INS(name, effect, holds, function) name,
#include "cncsub/code/ins.def"
#undef INS
};

/// Return the comparison that an instruction makes, without how near values have to be.
constexpr Ins exact(Ins op) {
  constexpr int kApart = static_cast<int>(Ins::AlikeEqual) - static_cast<int>(Ins::Equal);
  const bool alike = op >= Ins::AlikeEqual && op <= Ins::AlikeLessEqual;
  return alike ? static_cast<Ins>(static_cast<int>(op) - kApart) : op;
}
static_assert(exact(Ins::AlikeLessEqual) == Ins::LessEqual);

/// Return whether values count as equal that differ by no more than a share of the larger one.
/// [NCI comparisons]
inline bool is_alike(double a, double b) {
  constexpr double kShare = 1e-12;
  return std::fabs(a - b) <= kShare * std::fmax(std::fabs(a), std::fabs(b));
}

/// The kinds of what an instruction holds besides its place.
enum class Holds : std::uint8_t { None, Variable, Value };

namespace instructions {

inline constexpr Holds kHolds[] = {
#define INS(name, effect, holds, function) Holds::holds,
#include "cncsub/code/ins.def"
#undef INS
};

}  // namespace instructions

constexpr Holds held_by(Ins op) { return instructions::kHolds[static_cast<std::size_t>(op)]; }

struct Instruction {
  Ins op = Ins::End;
  std::uint8_t address = 0;  // RoundWord: the word's address
  std::uint32_t at = 0;      // where in the text, for a fault; of a variable: its index
  double value = 0;          // a constant; of a variable: its number
};

/// An instruction as it is kept: one cell, with its place or the number of its variable in the
/// upper half. A value that it holds is a cell of its own after it.
struct ExpressionCell {
  std::uint32_t low = 0, high = 0;

  static constexpr std::uint32_t kLargestIndex = (1U << 24) - 1;

  Ins op() const { return static_cast<Ins>(low & 0xFFU); }
  std::uint32_t index() const { return low >> 8; }
  double value() const { return std::bit_cast<double>(*this); }

  static ExpressionCell of(Ins op, std::uint32_t upper, std::uint32_t high) {
    return {static_cast<std::uint32_t>(op) | upper << 8, high};
  }
  static ExpressionCell of(double value) { return std::bit_cast<ExpressionCell>(value); }
  static ExpressionCell of(const Instruction& of) {
    if (held_by(of.op) != Holds::Variable) return ExpressionCell::of(of.op, of.address, of.at);
    return ExpressionCell::of(of.op, of.at & kLargestIndex, to_whole<std::uint32_t>(of.value));
  }
};

/// Return how many cells an instruction takes.
constexpr int cells_of(Ins op) { return held_by(op) == Holds::Value ? 2 : 1; }
/// Return the instruction that is kept from `at` on, which is known to be `op`.
inline Instruction instruction_at(const ExpressionCell* at, Ins op) {
  const auto address = static_cast<std::uint8_t>(at->low >> 8);
  switch (held_by(op)) {
    case Holds::Variable:
      return {op, 0, at->index(), static_cast<double>(at->high)};
    case Holds::Value:
      return {op, address, at->high, at[1].value()};
    case Holds::None:
      break;
  }
  return {op, address, at->high, 0};
}
inline Instruction instruction_at(const ExpressionCell* at) { return instruction_at(at, at->op()); }

/// An expression: a cell that says where it stands in the text, how wide it is and how it is
/// computed, then its instructions. Most are one value, or one operation on two: `form` says so,
/// and how many cells these take. Others go as far as their End.
class Expression {
 public:
  enum class Form : std::uint8_t {
    Long,
    Constant,             // 5: nothing but the value
    Variable,             // #2: a local or a common
    TwoVariables,         // #1+#2, #1LT#2
    VariableAndConstant,  // #1+5: an instruction that holds the constant
    VariableToConstant,   // #1LT5
    ConstantAndVariable,  // 5-#1
  };
  /// The largest width of an expression that is not Long.
  static constexpr std::uint32_t kWidest = (1U << 16) - 1;

  explicit Expression(const ExpressionCell* head) : head_(head) {}

  Form form() const { return static_cast<Form>(head_->low & 0xFFU); }
  /// Return what joins two values.
  Ins op() const { return static_cast<Ins>(head_->low >> 8 & 0xFFU); }
  std::uint32_t at() const { return head_->high; }
  std::uint32_t width() const { return form() == Form::Long ? head_->low >> 8 : head_->low >> 16; }
  const ExpressionCell* cells() const { return head_ + 1; }
  /// Return how many cells there are, where the form says it.
  std::ptrdiff_t size() const { return kSizes[static_cast<std::size_t>(form())]; }

  /// The instructions of an expression without an End, one after the other.
  class Iterator {
   public:
    explicit Iterator(const Expression& of)
        : at_(of.form() == Form::Constant ? of.head_ : of.cells()),
          end_(of.form() == Form::Long ? nullptr : of.cells() + of.size()),
          constant_(of.form() == Form::Constant) {}
    Instruction operator*() const { return instruction_at(at_, op()); }
    Iterator& operator++() {
      at_ += cells_of(op());
      return *this;
    }
    struct End {};
    bool operator==(End /*end*/) const {
      return end_ == nullptr ? at_->op() == Ins::End : at_ == end_;
    }

   private:
    Ins op() const { return constant_ ? Ins::Constant : at_->op(); }

    const ExpressionCell *at_, *end_;
    bool constant_;  // the head stands for the instruction
  };
  Iterator begin() const { return Iterator(*this); }
  static Iterator::End end() { return {}; }

  static ExpressionCell head(Form form, Ins op, std::uint32_t at, std::uint32_t width) {
    const auto low = static_cast<std::uint32_t>(form);
    if (form == Form::Long) return {low | std::min(width, kWidestLong) << 8, at};
    return {low | static_cast<std::uint32_t>(op) << 8 | width << 16, at};
  }

 private:
  static constexpr std::uint32_t kWidestLong = (1U << 24) - 1;
  static constexpr std::int8_t kSizes[] = {0, 1, 1, 3, 3, 4, 4};

  const ExpressionCell* head_;
};
static_assert(static_cast<int>(Ins::Constant) == 0, "so that the head of one has no address");

/// A value in a block: absent, written as a number, or an expression.
struct Operand {
  enum class Kind : std::uint8_t { Absent, Constant, Expression };
  double value = 0;
  std::uint32_t expression = 0;
  std::uint32_t at = 0;
  std::uint32_t width = 1;
  Kind kind : 2 = Kind::Absent;
  bool bracketed : 1 = false;  // P[#100]
  bool whole : 1 = false;      // a number without a decimal point
  bool fine : 1 = false;       // a number with more than three decimals
  std::uint8_t digits = 0;     // without leading zeros
  std::uint8_t written = 0;    // with them

  bool present() const { return kind != Kind::Absent; }
};
static_assert(sizeof(Operand) == 24);  // each call and argument has some

}  // namespace cncsub
