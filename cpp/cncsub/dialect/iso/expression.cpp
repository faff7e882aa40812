// Expressions of the ISO family: what a word, a statement and a bracket hold, variables and
// numbers.
//
// They are read in one loop: what is opened, a sign or an operator waits on a stack for its value.
#include "cncsub/dialect/iso/expression.hpp"

#include <array>

namespace cncsub {

namespace {

/// How many characters a text has that begins where `s` stands, without the gap at its end.
std::ptrdiff_t length_of(Scanner s) {
  const char* const first = s.at;
  const char* last = first;
  while (s.peek() != '\0') last = ++s.at;
  return last - first;
}

/// Whether an operator of arithmetic or of logic stands here, and no slash before a word.
bool computes(const ExpressionRules& rules, const Scanner& s) {
  const OperatorName* const of = find_operator(rules, s);
  if (of == nullptr || of->op != Ins::Divide) return of != nullptr && !of->compares();
  Scanner behind = s;
  behind.take('/');
  const char c = behind.peek();
  return c == '#' || c == '[' || begins_number(c);
}

}  // namespace

bool ExpressionReader::goes_on(const Scanner& s) const {
  return e_.rules.word_arithmetic && computes(e_.rules, s);
}

std::optional<std::uint32_t> ExpressionReader::word_value(Scanner& s, char address) {
  e_.out.begin(address);
  s.blanks();
  const Scanner first = s;
  const std::uint32_t at = s.offset();
  const bool negative = s.take('-');
  if (!negative) s.take('+');
  const bool variable = s.peek() == '#';
  const StatementKind kind = variable ? StatementKind::Variables : StatementKind::Brackets;
  if (e_.rules.code.lacking.test(static_cast<std::size_t>(kind))) {
    Fault wrong = e_.rules.code.lacking_fault(kind, at);
    return e_.out.refuse(wrong.cause, at, std::move(wrong.detail));
  }
  Value value = taken(s, variable ? plain_.variable(s) : plain_.bracket(s));
  if (!value) {
    e_.begin(s, address);
    value = variable ? operand_alone() : bracket();
  }
  if (!value) return std::nullopt;
  if (goes_on(s)) {
    s = first;
    return arithmetic_of_word(s, address);
  }
  if (!e_.out.is_number(value))
    return e_.out.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative)
    e_.out.emit(Ins::Negate, at);  // of a vacant variable it stays vacant: X-#1 is no word then
  return e_.out.finish(at, s.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::arithmetic_of_word(Scanner& s, char address) {
  s.blanks();
  const std::uint32_t at = s.offset();
  e_.begin(s, address);
  Value value = expression();
  if (!value) return std::nullopt;
  if (!e_.out.is_number(value))
    return e_.out.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  return e_.out.finish(at, s.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::condition(Scanner& s) {
  e_.out.begin(0);
  s.blanks();
  const std::uint32_t at = s.offset();
  if (!e_.rules.bare && s.peek() != '[')
    return e_.out.refuse(Cause::ExpressionFormat, at, "a condition stands in brackets");
  Value value = taken(s, e_.rules.bare ? plain_.read(s) : plain_.bracket(s));
  if (!value) {
    e_.begin(s);
    value = e_.rules.bare ? expression() : bracket();
  }
  if (!value) return std::nullopt;
  const int most = e_.rules.control.macros.max_condition_length.value;
  if (most > 0 && length_of({s.file + at, s.at, s.file}) > most)
    return e_.out.refuse(Cause::ExpressionFormat, at,
                         "a condition has at most " + std::to_string(most) + " characters");
  const bool any = e_.rules.bare || e_.rules.values;
  if (any && value.is_number()) {  // WHILE TRUE
    e_.out.arithmetic(value, s.offset());
    value = Value::condition();
  }
  if (!value.is_condition())
    return e_.out.refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return e_.out.finish(at, s.offset() - at);
}

}  // namespace cncsub
