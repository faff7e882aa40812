// The operators of expressions: how tightly each binds, and what it makes of two values.
#include <algorithm>
#include <span>

#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

struct OperatorName {
  std::string_view text;
  Ins op;
  int alike, last;  // the level at which it binds where logic binds like arithmetic; where it binds
                    // last. Level 0 binds weakest
  Ins other = Ins::End;  // of logic: on two conditions; else with a constant on the right

  bool compares() const { return op >= Ins::Equal && op <= Ins::LessEqual; }
  bool is_logic() const { return last == 0; }
  bool is_arithmetic() const { return last >= 2; }
};

namespace {

constexpr int kTightest = 3;  // of the levels where logic binds last

constexpr OperatorName kArithmetic[] = {{"+", Ins::Add, 1, 2, Ins::AddConstant},
                                        {"-", Ins::Subtract, 1, 2, Ins::SubtractConstant},
                                        {"*", Ins::Multiply, 2, 3, Ins::MultiplyConstant},
                                        {"/", Ins::Divide, 2, 3, Ins::DivideConstant}};
constexpr OperatorName kOperators[] = {{"AND", Ins::And, 2, 0, Ins::BothTrue},
                                       {"XOR", Ins::Xor, 1, 0, Ins::OneTrue},
                                       {"OR", Ins::Or, 1, 0, Ins::EitherTrue},
                                       {"MOD", Ins::Modulo, 2, 3},
                                       {"EQ", Ins::Equal, 0, 1},
                                       {"NE", Ins::NotEqual, 0, 1},
                                       {"GT", Ins::Greater, 0, 1},
                                       {"LT", Ins::Less, 0, 1},
                                       {"GE", Ins::GreaterEqual, 0, 1},
                                       {"LE", Ins::LessEqual, 0, 1}};
constexpr OperatorName kSymbols[] = {{"==", Ins::Equal, 0, 1},        {"<>", Ins::NotEqual, 0, 1},
                                     {">=", Ins::GreaterEqual, 0, 1}, {"<=", Ins::LessEqual, 0, 1},
                                     {">", Ins::Greater, 0, 1},       {"<", Ins::Less, 0, 1}};

template <std::size_t N>
const OperatorName* find_operator(const OperatorName (&names)[N], Scanner s) {
  const char c = s.peek();
  for (const OperatorName& of : names)
    if (of.text[0] == c && s.take_word(of.text)) return &of;
  return nullptr;
}

/// Goes through what stands behind a logic operator, as far as the next one.
class Lookahead {
 public:
  explicit Lookahead(const Scanner& behind) : s_(behind), bracket_(s_.peek() == '[') {}

  /// Whether it is a condition: `AND #2 EQ 4` or `AND [#2 EQ 4]`, not `AND 3`.
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
    const OperatorName* found = find_operator(kOperators, s_);
    const bool own = depth_ == 0 || (bracket_ && depth_ == 1 && deepest_ == 1);
    return own && found != nullptr && found->compares();
  }

  /// A logic operator, or a word that is none: what was behind the first one ends.
  bool joins() const {
    const OperatorName* found = find_operator(kOperators, s_);
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
  bool bracket_;  // what stands behind begins with one
  int depth_ = 0, deepest_ = 0;
  bool value_ = false;  // the value of an operand has ended: an operator follows
};

struct Waiting {  // NOLINT(*-member-init): for its right value
  Value left;
  const OperatorName* of;
  std::uint32_t at;
  int level;
};

/// The level at which an operator binds, but for logic of numbers where that binds first.
int level_of(const ExpressionRules& rules, const OperatorName& of) {
  return rules.alike ? of.alike : of.last;
}

/// Whether logic behind a value binds as that of numbers, which counts where that binds first. It
/// counts whether the value is the right side of a comparison: `#1EQ3AND#2EQ4` joins two,
/// `3EQ#1AND3` is one.
bool is_of_numbers(const Scanner& s, const OperatorName& of, const Value& value,
                   std::span<const Waiting> waiting) {
  if (value.type != Value::Type::Number) return false;
  const bool compared = std::any_of(waiting.begin(), waiting.end(),
                                    [](const Waiting& left) { return left.of->compares(); });
  if (!compared) return true;
  Scanner behind = s;
  behind.take_word(of.text);
  return !Lookahead(behind).finds_condition();
}

Value compare(ValueWriter& out, const Waiting& waiting, Value right, std::uint32_t end) {
  Value left = waiting.left;
  const Ins op = waiting.of->op;
  const bool tells_vacant =
      out.rules().distinguishes_vacant && (op == Ins::Equal || op == Ins::NotEqual);
  if (!out.is_number(left) || !out.is_number(right))
    return out.refuse(Cause::ExpressionFormat, waiting.at, "a comparison compares two values");
  if (!tells_vacant && (!out.arithmetic(left, end) || !out.arithmetic(right, end)))
    return {};
  out.emit(op, waiting.at);
  return Value::condition();
}

/// Joins two values; the left one waited for the right one.
inline Value apply(ValueWriter& out, const Waiting& waiting, Value right, std::uint32_t end) {
  const OperatorName& of = *waiting.of;
  Value left = waiting.left;
  if (of.is_arithmetic()) {
    if (!out.arithmetic(left, end) || !out.arithmetic(right, end)) return {};
    out.emit_operator(of.op, of.other, waiting.at);
    return Value::number();
  }
  if (of.compares()) return compare(out, waiting, right, end);
  if (left.type == Value::Type::Condition &&
      right.type == Value::Type::Condition) {
    if (!out.rules().joined)
      return out.refuse(Cause::IfFormat, waiting.at, "conditions cannot be joined on this control");
    out.emit(of.other, waiting.at);
    return Value::condition();
  }
  if (!out.arithmetic(left, end) || !out.arithmetic(right, end)) return {};
  out.emit(of.op, waiting.at);
  return Value::number();
}

}  // namespace

/// The operator that stands here, null where none does.
inline const OperatorName* ExpressionReader::next_operator() {
  s_.blanks();
  if (s_.at == s_.end) return nullptr;
  switch (*s_.at) {
    case ']':
      return nullptr;
    case '+':
      return &kArithmetic[0];
    case '-':
      return &kArithmetic[1];
    case '*':
      return &kArithmetic[2];
    case '/':
      return &kArithmetic[3];
    default:
      return other_operator();
  }
}

const OperatorName* ExpressionReader::other_operator() {
  if (const OperatorName* found = find_operator(kOperators, s_))
    return found->op == Ins::Modulo && !rules_.modulo ? nullptr : found;
  return rules_.symbols ? find_operator(kSymbols, s_) : nullptr;
}

/// Operands and operators: a value waits with its operator until what stands on the right does not
/// bind closer.
Value ExpressionReader::expression() {
  Waiting waiting[kTightest + 1];  // NOLINT: up to `last`, looser ones first
  Waiting* last = waiting;
  const auto join = [&](Value value, int level) {  // with what waits and binds as closely
    while (value && last != waiting && last[-1].level >= level)
      value = apply(out_, *--last, value, s_.offset());
    return value;
  };
  for (;;) {
    Value value = operand();
    if (!value) return {};
    const OperatorName* const next = next_operator();
    int level = next == nullptr ? 0 : level_of(rules_, *next);
    if (next != nullptr && rules_.numbers_first && next->is_logic()) {
      value = join(value, next->alike + 1);
      if (is_of_numbers(s_, *next, value, {waiting, last})) level = next->alike + 1;
    }
    value = join(value, level);
    if (!value || next == nullptr) return value;
    *last++ = {value, next, s_.offset(), level};
    if (next->text.size() == 1)
      ++s_.at;
    else
      s_.take_word(next->text);
  }
}

}  // namespace cncsub
