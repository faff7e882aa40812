// The loop that reads expressions: operands and operators, and what waits for them.
#include <array>
#include <span>

#include "cncsub/dialect/iso/expression.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

namespace {

/// The level at which an operator binds, but for logic of numbers where that binds first.
int level_of(const ExpressionRules& rules, const OperatorName& of) {
  return rules.alike ? of.alike : of.last;
}

/// The signs of arithmetic by their character.
constexpr auto kSigns = [] {
  std::array<const OperatorName*, 256> signs{};
  for (const OperatorName& of : kArithmetic) signs[static_cast<unsigned char>(of.text[0])] = &of;
  return signs;
}();

/// The loop. What it changes with every character it has in hand, in registers; what is not written
/// in the plainest way is left to others, who find it where the expression keeps it.
class ValueLoop {
 public:
  explicit ValueLoop(OpenExpression& e) : e_(e), end_(e.s->end) { take(); }

  /// Reads until what waits above `base` has its value; `alone`: no operator behind that is read.
  CNCSUB_ALWAYS_INLINE Value values(const Waiting* base, bool alone) {
    for (;;) {
      Value value = operand();
      if (value) value = behind(value, base, alone);
      if (value.is_awaited()) continue;
      keep();
      return value;
    }
  }

 private:
  void take() {
    at_ = e_.s->at;
    last_ = e_.last;
    top_ = e_.out.instructions().top();
  }
  void keep() {
    e_.s->at = at_;
    e_.last = last_;
    e_.out.instructions().set_top(top_);
  }
  template <class Other>
  CNCSUB_ALWAYS_INLINE Value left_to(const Other& other) {
    keep();
    const Value value = other();
    take();
    return value;
  }

  /// As much as an operand and what is joined behind it may take has room.
  CNCSUB_ALWAYS_INLINE void make_room() {
    if (top_ <= e_.out.instructions().limit()) return;
    keep();
    e_.out.instructions().make_room();
    take();
  }
  std::uint32_t place() const { return e_.out.instructions().place_of(top_); }
  void put(Ins op, std::uint32_t at) { *top_++ = ExpressionCell::of(op, e_.out.address(), at); }

  // ---- operands ----

  /// A number that is digits and a point; else nothing.
  CNCSUB_ALWAYS_INLINE Value constant() {
    const char* end = at_;
    const Mantissa m = scan_mantissa(end);
    const std::ptrdiff_t digits = m.whole + m.decimals;
    if (digits == 0 || digits > e_.rules.most_digits || !e_.ends_at(end)) return {};
    const Value value = Value::constant(place());
    put(Ins::Constant, e_.offset(at_));
    const auto whole = static_cast<double>(static_cast<std::int64_t>(m.value));
    *top_++ = ExpressionCell::of(whole / kPowersOfTen[m.decimals]);
    at_ = end;
    return value;
  }

  /// A variable whose number is digits and nothing else, and which lies near; else nothing.
  CNCSUB_ALWAYS_INLINE Value near_variable() {
    std::uint32_t number = 0;
    const char* const end = e_.plain_number(at_ + 1, number);
    if (end == nullptr) [[unlikely]]
      return {};
    const NearRange* const near = e_.rules.code.near.find(number);
    if (near == nullptr) [[unlikely]]
      return {};
    const Value value = Value::variable(place());
    *top_++ = ExpressionCell::of(near->raw, near->base + number - near->first, number);
    at_ = end;
    return value;
  }

  /// A variable or a number that is written in the plainest way; else nothing.
  CNCSUB_ALWAYS_INLINE Value plain_operand() {
    if (*at_ == '#') return near_variable();
    return is_digit(*at_) || *at_ == '.' ? constant() : Value{};
  }

  /// What opens in the plainest way: a bracket, or a function of three letters with its bracket.
  CNCSUB_ALWAYS_INLINE bool opens() {
    if (end_ - at_ <= 3 || e_.brackets >= e_.rules.most_brackets) return false;
    const FunctionName* function = nullptr;
    int width = 1;
    if (*at_ != '[') {
      if (at_[3] != '[' || !is_letter(*at_)) return false;
      function = e_.rules.short_function(at_[0], at_[1], at_[2]);
      if (function == nullptr) return false;
      width = 4;
    }
    Waiting& of = *last_++;
    of.function = function;
    of.at = e_.offset(at_);
    of.level = Waiting::kOpening;
    of.kind = function == nullptr ? Waiting::Kind::Bracket : Waiting::Kind::Function;
    of.second = false;
    ++e_.brackets;
    at_ += width;
    return true;
  }

  /// An operand; what is opened before it, and signs, wait.
  CNCSUB_ALWAYS_INLINE Value operand() {
    for (;;) {
      make_room();
      Value value = plain_operand();
      if (value) return value;
      if (opens()) continue;
      value = left_to([this] { return other_operand(e_); });
      if (!value.is_awaited()) return value;
    }
  }

  // ---- what was opened ----

  /// What a function makes of its arguments.
  CNCSUB_ALWAYS_INLINE Value function(const Waiting& of) {
    Ins op = of.second ? of.function->two : of.function->one;
    if (op == Ins::Round && e_.out.in_word()) op = Ins::RoundWord;
    put(op, of.at);
    return Value::number();
  }

  /// What ends here gives its value to what was opened last: the value of that, or another argument
  /// is awaited.
  CNCSUB_ALWAYS_INLINE Value closed(Value value) {
    Waiting& of = last_[-1];
    const bool argument =
        of.kind == Waiting::Kind::Function || of.kind == Waiting::Kind::ArcTangent;
    if (argument && !e_.out.arithmetic(value, e_.offset(at_))) return {};
    const bool one_more = argument && of.function->one == Ins::End && !of.second;
    if (at_ == end_ || *at_ != ']' || one_more)
      return left_to([&] { return not_closed(e_, of, argument); });
    ++at_;
    --e_.brackets;
    --last_;
    if (of.kind == Waiting::Kind::Bracket) return value;
    if (of.kind == Waiting::Kind::Function) return function(of);
    return left_to([&] { return other_closed(e_, of, value); });
  }

  // ---- operators ----

  /// Joins two values by the operator at `at`.
  CNCSUB_ALWAYS_INLINE Value apply(const OperatorName& of, std::uint32_t at, Value left,
                                   Value right) {
    const std::uint32_t end = e_.offset(at_);
    if (!of.is_arithmetic())
      return left_to([&] { return apply_other(e_.out, of, at, left, right, end); });
    const bool constant = right.is_constant() && of.other != Ins::End;
    const std::uint32_t last = constant ? right.place() : 0;
    if (!e_.out.arithmetic(left, end) || !e_.out.arithmetic(right, end)) return {};
    OpenInstructions& written = e_.out.instructions();
    if (!constant || (of.op == Ins::Divide && written.value(last) == 0)) {
      put(of.op, at);
    } else {
      written.set_op(last, of.other);
      written.set_at(last, at);
    }
    return Value::number();
  }

  /// The operator that stands here, null where none does.
  CNCSUB_ALWAYS_INLINE const OperatorName* next_operator() {
    if (at_ == end_) return nullptr;
    if (const OperatorName* const sign = kSigns[static_cast<unsigned char>(*at_)]) return sign;
    if (*at_ == ']') return nullptr;
    if (end_ - at_ > 2)
      if (const OperatorName* const of = short_operator(at_[0], at_[1])) return of;
    return other_operator();
  }
  /// One with a gap before it or in it, or with another name.
  const OperatorName* other_operator() {
    Scanner s{at_, end_, e_.s->file};
    s.blanks();
    at_ = s.at;
    if (at_ == end_) return nullptr;
    const OperatorName* const sign = kSigns[static_cast<unsigned char>(*at_)];
    return sign != nullptr ? sign : find_other_operator(e_.rules, s);
  }
  CNCSUB_ALWAYS_INLINE void pass(const OperatorName& of) {
    const auto width = static_cast<std::ptrdiff_t>(of.text.size());
    if (width == 1 || (width == 2 && at_[1] == of.text[1])) {
      at_ += width;
      return;
    }
    Scanner s{at_, end_, e_.s->file};
    s.take_word(of.text);
    at_ = s.at;
  }

  /// Joins a value with what waits on its left and binds as closely.
  CNCSUB_ALWAYS_INLINE Value join(Value value, int level) {
    while (last_[-1].level >= level) {
      const Waiting& left = *--last_;
      value = apply(*left.of, left.at, left.left, value);
      if (!value) break;
    }
    return value;
  }

  /// An operator stands behind the value: both wait for what comes, but where that is written in
  /// the plainest way and nothing behind it can bind it.
  CNCSUB_ALWAYS_INLINE Value operates(const OperatorName& of, Value value) {
    int level = level_of(e_.rules, of);
    if (e_.rules.numbers_first && of.is_logic()) {
      value = join(value, of.alike + 1);
      if (!value) return value;
      if (is_of_numbers(of, value)) level = of.alike + 1;
    }
    value = join(value, level);
    if (!value) return value;
    const std::uint32_t at = e_.offset(at_);
    pass(of);
    Value right = plain_operand();
    if (right && (at_ == end_ || *at_ == ']')) return apply(of, at, value, right);
    if (!right) right = Value::awaited();
    Waiting& waiting = *last_++;
    waiting.left = value;
    waiting.of = &of;
    waiting.at = at;
    waiting.level = level;
    waiting.kind = Waiting::Kind::Operator;
    return right;
  }

  bool is_of_numbers(const OperatorName& of, const Value& value) {
    keep();
    const Waiting* first = last_;
    while (first[-1].level > Waiting::kOpening) --first;
    return cncsub::is_of_numbers(*e_.s, of, value, {first, last_});
  }

  /// What stands behind an operand: the whole value, or an operand is awaited.
  CNCSUB_ALWAYS_INLINE Value behind(Value value, const Waiting* base, bool alone) {
    for (;;) {
      make_room();
      if (last_[-1].level == Waiting::kPrefix) {
        value = left_to([&] { return prefixed(e_, value); });
        if (!value) return value;
      }
      if (alone && last_ == base) return value;
      if (const OperatorName* const next = next_operator()) {
        value = operates(*next, value);
        if (!value) return value;
        continue;
      }
      value = join(value, 0);
      if (!value || last_ == base) return value;
      value = closed(value);
      if (!value) return value;
    }
  }

  OpenExpression& e_;
  const char* const end_;
  const char* at_ = nullptr;       // in the text
  Waiting* last_ = nullptr;        // behind what waits
  ExpressionCell* top_ = nullptr;  // where the next instruction goes
};

}  // namespace

Value ExpressionReader::values(const Waiting* base, bool alone) {
  return ValueLoop(e_).values(base, alone);
}

/// What stands in brackets.
Value ExpressionReader::bracket() {
  if (!e_.opens()) return {};
  const Value value = expression();
  return value && e_.closes() ? value : Value{};
}

/// The variable of an assignment, where more than digits stand behind its #.
std::optional<ExpressionReader::Variable> ExpressionReader::other_target(Scanner& s,
                                                                         std::uint32_t hash) {
  e_.begin(s);
  const bool inside = e_.s->peek() == '[';
  const std::uint32_t at = inside ? e_.s->offset() : hash;
  if (inside) {
    Value inner = bracket();
    if (!inner || !e_.out.arithmetic(inner, e_.s->offset())) return std::nullopt;
    return Variable{kComputed, e_.out.finish(at, e_.s->offset() - at)};
  }
  const auto number = variable_number(e_, at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, e_.out.finish(at, 1)};
}

}  // namespace cncsub
