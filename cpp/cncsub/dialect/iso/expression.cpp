// The expressions of words and statements, and conditions.
#include "cncsub/dialect/iso/expression.hpp"

#include <string>

#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

namespace {

/// Return how many characters a text has from `s` on, without the gap at its end.
std::ptrdiff_t length_of(Scanner s) {
  const char* const first = s.at;
  const char* last = first;
  while (s.peek() != '\0') last = ++s.at;
  return last - first;
}

/// Return whether an operator of arithmetic or logic stands here. A slash before a word is none.
bool computes(const ExpressionRules& rules, const Scanner& s) {
  const IsoOperator* const of = find_operator(rules, s);
  if (of == nullptr || of->op != Ins::Divide) return of != nullptr && !of->compares();
  Scanner behind = s;
  behind.take('/');
  const char c = behind.peek();
  return c == '#' || c == '[' || begins_number(c);
}

}  // namespace

std::optional<std::uint32_t> ExpressionReader::finished(Value value, std::uint32_t at,
                                                        bool negative) {
  last_ = value;
  if (!value) return std::nullopt;
  if (!out_.is_number(value))
    return out_.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative) out_.emit(Ins::Negate, at);  // a vacant variable stays vacant: X-#1 is no word then
  return out_.finish(at, offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::number(Scanner& s) {
  begin(s);
  gap();
  const std::uint32_t at = offset();
  const auto read = finished(values(), at);
  s.at = s_.at;
  return read;
}

bool ExpressionReader::goes_on(const Scanner& s) const {
  return rules_.word_arithmetic && computes(rules_, s);
}

std::optional<std::uint32_t> ExpressionReader::arithmetic_of_word(Scanner& s, char address) {
  begin(s, address);
  gap();
  const std::uint32_t at = offset();
  const auto read = finished(values(), at);
  s.at = s_.at;
  return read;
}

std::optional<std::uint32_t> ExpressionReader::word_value(Scanner& s, char address) {
  begin(s, address);
  gap();
  const Scanner first = s_;
  const bool negative = take('-');
  if (!negative) take('+');
  const Value value = value_of_word(first.offset());
  s.at = s_.at;
  if (!value || !goes_on(s)) return finished(value, first.offset(), negative);
  s.at = first.at;
  return arithmetic_of_word(s, address);
}

/// Read a variable or a value in brackets, without the sign before it.
Value ExpressionReader::value_of_word(std::uint32_t at) {
  const bool is_variable = peek() == '#';
  const StatementKind kind = is_variable ? StatementKind::Variables : StatementKind::Brackets;
  if (!rules_.code.lacking.test(static_cast<std::size_t>(kind)))
    return is_variable ? one_operand() : bracket();
  Fault wrong = rules_.code.lacking_fault(kind, at);
  return out_.refuse(wrong.cause, at, std::move(wrong.detail));
}

std::optional<std::uint32_t> ExpressionReader::condition(Scanner& s) {
  begin(s);
  const auto read = read_condition();
  s.at = s_.at;
  return read;
}

std::optional<std::uint32_t> ExpressionReader::counted(const Scanner& counter,
                                                       const Scanner* step) {
  begin(counter);
  gap();
  const std::uint32_t at = offset();
  Value value = one_operand();
  if (!value || !out_.arithmetic(value, offset())) return std::nullopt;
  if (step == nullptr) {
    out_.emit(Ins::Constant, at, 1);
  } else {
    s_ = *step;
    Value added = values();
    if (!added || !out_.arithmetic(added, offset())) return std::nullopt;
  }
  out_.emit(Ins::Add, at);
  return out_.finish(at, 1);
}

std::optional<std::uint32_t> ExpressionReader::not_passed(const Scanner& counter,
                                                          const Scanner& last,
                                                          const Scanner& step) {
  begin(last);
  gap();
  const std::uint32_t at = offset();
  Value value = values();
  if (!value || !out_.arithmetic(value, offset())) return std::nullopt;
  const std::uint32_t width = offset() - at;
  s_ = counter;
  value = one_operand();
  if (!value || !out_.arithmetic(value, offset())) return std::nullopt;
  out_.emit(Ins::Subtract, at);
  s_ = step;
  value = values();
  if (!value || !out_.arithmetic(value, offset())) return std::nullopt;
  out_.emit(Ins::Sign, at);
  out_.emit(Ins::Multiply, at);
  out_.emit(Ins::Constant, at, 0);
  out_.emit(Ins::GreaterEqual, at);
  return out_.finish(at, width);
}

std::optional<std::uint32_t> ExpressionReader::contrary(Scanner& s) {
  begin(s);
  gap();
  const std::uint32_t at = offset();
  Value value = values();
  s.at = s_.at;
  if (!value || !out_.arithmetic(value, offset())) return std::nullopt;
  out_.emit(Ins::Not, at);
  return out_.finish(at, offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::condition_or_number(Scanner& s) {
  begin(s);
  gap();
  const std::uint32_t at = offset();
  const Value value = values();
  s.at = s_.at;
  return value && value.is_condition() ? out_.finish(at, offset() - at) : finished(value, at);
}

std::optional<std::uint32_t> ExpressionReader::read_condition() {
  const bool opened = peek() == '[';
  const std::uint32_t at = offset();
  if (!rules_.bare && !opened)
    return out_.refuse(Cause::ExpressionFormat, at, "a condition must be in brackets");
  Value value = rules_.bare ? values() : bracket();
  if (!value) return std::nullopt;
  const int most = rules_.control.macros.max_condition_length.value;
  if (most > 0 && length_of({s_.file + at, s_.at, s_.file}) > most)
    return out_.refuse(Cause::ExpressionFormat, at,
                       "a condition has at most " + std::to_string(most) + " characters");
  const bool any = rules_.bare || rules_.values;
  if (any && value.is_number()) {  // WHILE TRUE
    out_.arithmetic(value, offset());
    value = Value::condition();
  }
  if (!value.is_condition())
    return out_.refuse(Cause::ExpressionFormat, at, "a condition must compare two values");
  return out_.finish(at, offset() - at);
}

/// Read the variable of an assignment if more than digits follow its #.
std::optional<ExpressionReader::Variable> ExpressionReader::read_target(const Scanner& s,
                                                                        std::uint32_t hash) {
  begin(s);
  const bool inside = peek() == '[';
  const std::uint32_t at = inside ? offset() : hash;
  if (inside) {
    Value inner = bracket();
    if (!inner || !out_.arithmetic(inner, offset())) return std::nullopt;
    add_base(hash);
    return Variable{kComputed, out_.finish(at, offset() - at)};
  }
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, out_.finish(at, 1)};
}

std::optional<Fault> iso_expression(Builder& to, const ExpressionText& text,
                                    std::uint32_t& expression, ValueType& /*type*/) {
  const ExpressionRules rules(to.code());
  ExpressionReader reader(to, rules);
  const char* const file = to.code().files[text.file].text.view().data();
  Scanner s{text.text.data(), text.text.data() + text.text.size(), file};
  const auto read = reader.condition_or_number(s);
  if (!read) return reader.fault();
  if (s.peek() != '\0')
    return Fault{Cause::ExpressionFormat, s.offset(), 1, "the expression ends before this"};
  expression = *read;
  return std::nullopt;
}

}  // namespace cncsub
