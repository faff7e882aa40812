#include "cncsub/dialect/iso/operators.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace cncsub {

namespace {

constexpr IsoOperator kSymbols[] = {
    {{"==", 1, Ins::Equal}, 0},        {{"<>", 1, Ins::NotEqual}, 0},
    {{">=", 1, Ins::GreaterEqual}, 0}, {{"<=", 1, Ins::LessEqual}, 0},
    {{">", 1, Ins::Greater}, 0},       {{"<", 1, Ins::Less}, 0}};

template <std::size_t N>
const IsoOperator* find_in(const IsoOperator (&names)[N], Scanner s) {
  const char c = s.peek();
  for (const IsoOperator& of : names)
    if (of.spelling[0] == c && s.take_word(of.spelling)) return &of;
  return nullptr;
}

/// A scan of the text after a logic operator, as far as the next one.
class Lookahead {
 public:
  explicit Lookahead(const Scanner& behind) : s_(behind), bracket_(s_.peek() == '[') {}

  /// Return whether the text is a condition: `AND #2 EQ 4` or `AND [#2 EQ 4]`, not `AND 3`.
  bool finds_condition() {
    for (char c = s_.peek(); c != '\0'; c = s_.peek()) {
      if (is_letter(c)) {
        if (value_ && compares()) return true;
        if (value_ && joins()) return false;
        pass_word();
      } else {
        if (compares(c)) return true;
        if (c == ']' && depth_ == 0) return false;
        pass(c);
      }
    }
    return false;
  }

 private:
  bool compares(char symbol) const {
    const bool own = depth_ == 0 || (bracket_ && depth_ == 1);
    return own && (symbol == '<' || symbol == '>' || symbol == '=');
  }

  bool compares() const {
    const IsoOperator* found = find_in(kNamedOperators, s_);
    const bool own = depth_ == 0 || (bracket_ && depth_ == 1 && deepest_ == 1);
    return own && found != nullptr && found->compares();
  }

  /// Return whether a logic operator stands here, or a word that is no operator: the text after the
  /// first operator ends there.
  bool joins() const {
    const IsoOperator* found = find_in(kNamedOperators, s_);
    return depth_ == 0 && (found == nullptr || found->op != Ins::Modulo);
  }

  void pass_word() {
    while (is_letter(s_.peek())) ++s_.at;
    value_ = false;
  }

  void pass(char c) {
    if (c == '[') deepest_ = std::max(deepest_, ++depth_);
    if (c == ']') --depth_;
    value_ = c == ']' || is_digit(c) || c == '.';
    ++s_.at;
  }

  Scanner s_;
  bool bracket_;  // the text begins with a bracket
  int depth_ = 0, deepest_ = 0;
  bool value_ = false;  // the value of an operand has ended: an operator follows
};

}  // namespace

Value compare(ValueWriter& out, Ins op, std::uint32_t at, Value left, Value right,
              std::uint32_t end) {
  const bool tells_vacant =
      out.rules().distinguishes_vacant && (op == Ins::Equal || op == Ins::NotEqual);
  if (!out.is_number(left) || !out.is_number(right))
    return out.refuse(Cause::ExpressionFormat, at, "a comparison must have two values");
  if (!tells_vacant && (!out.arithmetic(left, end) || !out.arithmetic(right, end))) return {};
  out.emit(op, at);
  return Value::condition();
}

namespace {

template <bool kAlike>
constexpr auto kRows = [] {
  constexpr std::size_t kSigns = std::size(kArithmetic), kNames = std::size(kNamedOperators);
  std::array<OperatorRow, kSigns + kNames> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const IsoOperator& of = i < kSigns ? kArithmetic[i] : kNamedOperators[i - kSigns];
    rows[i] = of;
    if (kAlike) rows[i].level = of.alike;
  }
  return rows;
}();

}  // namespace

std::span<const OperatorRow> iso_operators(LogicOrder order) {
  if (order == LogicOrder::LikeArithmetic) return kRows<true>;
  return kRows<false>;
}

const IsoOperator* find_operator(const ExpressionRules& rules, const Scanner& s) {
  if (const IsoOperator* const sign = find_in(kArithmetic, s)) return sign;
  if (const IsoOperator* const found = find_in(kNamedOperators, s))
    return found->op == Ins::Modulo && !rules.modulo ? nullptr : found;
  return rules.symbols ? find_in(kSymbols, s) : nullptr;
}

bool is_before_condition(const Scanner& at, const IsoOperator& of) {
  Scanner behind = at;
  behind.take_word(of.spelling);
  return Lookahead(behind).finds_condition();
}

Value join_by_logic(ValueWriter& out, const IsoOperator& of, std::uint32_t at, Value left,
                    Value right, std::uint32_t end) {
  if (left.is_condition() && right.is_condition()) {
    if (!out.rules().joined)
      return out.refuse(Cause::IfFormat, at, "conditions cannot be joined on this control");
    out.emit(of.other, at);
    return Value::condition();
  }
  if (!out.arithmetic(left, end) || !out.arithmetic(right, end)) return {};
  out.emit(of.op, at);
  return Value::number();
}

}  // namespace cncsub
