// The functions of expressions: SIN[30], ATAN[1]/[2], PRM[6001, 5], and words that are values.
#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

namespace {

constexpr int kMostNots = 64;  // before one condition: they are read inside each other

struct ConstantName {
  Function word;
  double value;
};
constexpr ConstantName kConstants[] = {
    {Function::Pi, 3.14159265358979323846}, {Function::True, 1}, {Function::False, 0}};

}  // namespace

Value ExpressionReader::word() {
  const std::uint32_t at = s_.offset();
  const bool is_short = s_.end - s_.at > 3 && s_.at[3] == '[';
  if (const FunctionName* const known = is_short ? rules_.short_function(s_.at) : nullptr) {
    s_.at += 3;
    return function(*known, at);
  }
  std::string word;
  while (is_letter(s_.peek()) || (word == "ATAN" && s_.peek() == '2')) {
    word += s_.peek();
    ++s_.at;
    if (word.size() > 8) break;
  }
  for (const ConstantName& of : kConstants) {
    if (word != name_of(of.word) || !rules_.has(of.word)) continue;
    if (!out_.has_room(s_.offset())) return {};
    out_.emit(Ins::Constant, at, of.value);
    return Value::number();
  }
  if (word == "NOT" && rules_.bare) return negated(at);
  const FunctionName* found = rules_.function(word);
  if (found == nullptr)
    return out_.refuse(Cause::ExpressionFormat, at, word + " is no function of this control");
  if (found->one == Ins::Atan && !rules_.has(Function::Atan2)) return arc_tangent(at);
  if (found->one == Ins::Programmed) return programmed(at);
  return function(*found, at);
}

Value ExpressionReader::function(const FunctionName& of, std::uint32_t at) {
  if (!open() || !argument()) return {};
  const bool two = of.one == Ins::End || (of.two != Ins::End && s_.peek() == ',');
  if (two && !s_.take(','))
    return out_.refuse(Cause::MissingComma, s_.offset(), "the function takes two arguments");
  if (two && !argument()) return {};
  if (!close()) return {};
  Ins op = two ? of.two : of.one;
  if (op == Ins::Round && out_.in_word()) op = Ins::RoundWord;
  out_.emit(op, at);
  return Value::number();
}

bool ExpressionReader::argument() {
  Value value = expression();
  return value && out_.arithmetic(value, s_.offset());
}

/// ATAN[a]/[b], ATAN[a,b] and ATAN[a].
Value ExpressionReader::arc_tangent(std::uint32_t at) {
  if (!open() || !argument()) return {};
  bool two = s_.take(',');
  if (two && !argument()) return {};
  if (!close()) return {};
  Scanner ahead = s_;
  if (!two && ahead.take('/') && ahead.peek() == '[') {
    s_ = ahead;
    Value second = bracket();
    if (!second || !out_.arithmetic(second, s_.offset())) return {};
    two = true;
  }
  out_.emit(two ? Ins::Atan2 : Ins::Atan, at);
  return Value::number();
}

/// AR[#23]: how the word was programmed, so the variable itself counts.
Value ExpressionReader::programmed(std::uint32_t at) {
  if (!open() || s_.peek() != '#')
    return out_.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  const std::uint32_t hash = s_.offset();
  s_.take('#');
  const auto target = variable(hash);
  if (!target || target->number < 0)
    return out_.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  if (!close() || !out_.has_room(s_.offset())) return {};
  out_.emit(Ins::Programmed, at, static_cast<double>(target->number));
  return Value::number();
}

/// NOT before a condition.
Value ExpressionReader::negated(std::uint32_t at) {
  if (++nots_ > kMostNots) return out_.refuse(Cause::ExpressionFormat, at, "too many NOT in a row");
  Value value = operand();
  if (!value) return {};
  --nots_;
  if (value.type != Value::Type::Condition)
    return out_.refuse(Cause::ExpressionFormat, at, "NOT takes a condition");
  out_.emit(Ins::Not, at);
  return value;
}

}  // namespace cncsub
