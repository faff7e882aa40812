// Operators of expressions: each language has a table of them, and one loop reads them all.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "cncsub/code/expression.hpp"
#include "cncsub/system/compiler.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// An operator of a language: how it is written, how tightly it binds, and the instruction that
/// computes it. Operators of one level are done from left to right.
struct OperatorRow {
  std::string_view spelling;
  int level = 0;  // 0 binds weakest
  Ins op = Ins::End;
  Ins other = Ins::End;  // a second instruction, where the language needs one

  constexpr bool is_logic() const {
    return op == Ins::And || op == Ins::Or || op == Ins::Xor || op == Ins::BothTrue ||
           op == Ins::EitherTrue || op == Ins::OneTrue;
  }
  constexpr bool is_conjunction() const { return op == Ins::And || op == Ins::BothTrue; }
};

/// Return the operator whose letters are these, capitals or not; null where none is.
inline const OperatorRow* operator_of_letters(std::span<const OperatorRow> rows,
                                              std::string_view letters) {
  for (const OperatorRow& of : rows)
    if (same_letters(letters, of.spelling)) return &of;
  return nullptr;
}

/// More levels than any language has.
inline constexpr std::size_t kMostLevels = 10;

/// The operators of one pair of brackets that wait for the value on their right. Each binds more
/// tightly than the one before it, so there are at most as many as levels.
template <class Reader>
class WaitingOperators {
 public:
  using Value = typename Reader::Value;
  using Operator = typename Reader::Operator;

  explicit WaitingOperators(Reader& reader) : reader_(reader), last_(all_) {}
  WaitingOperators(const WaitingOperators&) = delete;
  WaitingOperators& operator=(const WaitingOperators&) = delete;

  void push(Value left, std::uint32_t at, const Operator& of, int level) {
    *last_++ = {std::move(left), &of, at, level};
  }
  /// Join a value with those on its left that bind at least as tightly as a level.
  CNCSUB_ALWAYS_INLINE Value join(Value value, int level) {
    while (last_ != all_ && last_[-1].level >= level && value) {
      --last_;
      value = reader_.apply(*last_->of, last_->at, std::move(last_->left), std::move(value));
    }
    return value;
  }
  template <class Asked>
  bool any(const Asked& asked) const {
    return std::any_of(static_cast<const Waiting*>(all_), static_cast<const Waiting*>(last_),
                       [&](const Waiting& waiting) { return asked(*waiting.of); });
  }

 private:
  struct Waiting {  // NOLINT(*-member-init): as far as `last_`
    Value left;
    const Operator* of;
    std::uint32_t at;
    int level;
  };

  Reader& reader_;
  Waiting all_[kMostLevels];  // NOLINT(*-member-init,*-avoid-c-arrays): as far as `last_`
  Waiting* last_;
};

/// Read operands and the operators between them, as far as operators follow. The reader of the
/// language says what they are:
///   operand()                 reads a value with its signs; what is false ends all
///   next_operator()           the operator that stands here, which stays; null where none does
///   level_of(of, value, left) how tightly it binds; it may join the value with what waits
///   offset(), pass(of)        where it stands; goes past it
///   apply(of, at, left, right) what the operator makes of two values
template <class Reader>
CNCSUB_ALWAYS_INLINE inline typename Reader::Value read_operators(Reader& reader) {
  WaitingOperators<Reader> waiting(reader);
  for (;;) {
    auto value = reader.operand();
    if (!value) return value;
    const typename Reader::Operator* const next = reader.next_operator();
    if (next == nullptr) return waiting.join(std::move(value), 0);
    const int level = reader.level_of(*next, value, waiting);
    value = waiting.join(std::move(value), level);
    if (!value) return value;
    waiting.push(std::move(value), reader.offset(), *next, level);
    reader.pass(*next);
  }
}

}  // namespace cncsub
