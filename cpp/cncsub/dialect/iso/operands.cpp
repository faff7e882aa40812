// The values between operators: numbers, variables, functions, what stands in brackets, signs.
#include <string>

#include "cncsub/dialect/iso/values.hpp"
#include "cncsub/text/look_alikes.hpp"

namespace cncsub {

namespace {

struct ConstantName {
  Function word;
  double value;
};
constexpr ConstantName kConstants[] = {
    {Function::Pi, 3.14159265358979323846}, {Function::True, 1}, {Function::False, 0}};

constexpr const char* kNoVariable = "a number, or an expression in brackets, must follow #";

bool starts_name(char c) { return is_letter(c) || c == '_'; }

}  // namespace

Refused ValueReader::no_operand() {
  const bool inside = brackets_ > 0;
  switch (peek()) {
    case ']':
      return out_.refuse(inside ? Cause::ExpressionFormat : Cause::BracketNotOpened, offset(),
                         "a value is missing before the bracket");
    case '\0':
      return out_.refuse(inside ? Cause::BracketNotClosed : Cause::ExpressionFormat, offset(),
                         "a value is missing at the end");
    default:
      return out_.refuse(Cause::ExpressionFormat, offset(), "a value is missing here");
  }
}

// ---- numbers and signs ----

/// Read a number with many digits or with blanks inside; refuse a text that is no number.
Value ValueReader::other_constant() {
  comments_ = true;
  const std::uint32_t at = offset();
  const Number number = scan_number(s_);
  if (number.points > 1)
    return out_.refuse(Cause::IllegalDecimalPoint, at, "two points in one number");
  if (!number.any)
    return out_.refuse(Cause::ExpressionFormat, at, "a decimal point alone is not a number");
  const int most = rules_.control.macros.max_constant_digits.value;
  if (number.digits > static_cast<std::uint32_t>(most))
    return out_.refuse(Cause::TooManyDigits, at,
                       "a number has at most " + std::to_string(most) + " digits");
  return out_.constant(number.value, at);
}

/// Read a sign and the value after it.
Value ValueReader::with_sign() {
  const std::uint32_t at = offset();
  const bool negative = *s_.at++ == '-';
  const char next = peek();
  if (next == '-' || next == '+')
    return out_.refuse(Cause::ExpressionFormat, offset(), "two signs in a row");
  Value value = one_operand();
  if (!value) return {};
  if (!value.is_constant() && !out_.arithmetic(value, offset())) return {};
  return negative ? out_.negated(value, at) : value;
}

/// Read the condition after NOT.
Value ValueReader::negation(std::uint32_t at) {
  if (++nots_ > kMostNots) return out_.refuse(Cause::ExpressionFormat, at, "too many NOT in a row");
  const Value value = one_operand();
  if (!value) return {};
  --nots_;
  if (!value.is_condition())
    return out_.refuse(Cause::ExpressionFormat, at, "NOT must have a condition after it");
  out_.emit(Ins::Not, at);
  return value;
}

// ---- variables ----

/// Read a variable that is not named by digits alone. The reading starts again after its #, at
/// `at`.
Value ValueReader::other_variable(std::uint32_t at) {
  s_.at = s_.file + at + 1;
  const char first = peek();
  if (first == '[') {
    Value inner = bracket();
    if (!inner || !out_.arithmetic(inner, offset())) return {};
    add_base(at);
    return Value::variable(out_.emit(Ins::IndirectRaw, at));
  }
  if (starts_name(first) && !rules_.names)
    return out_.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const auto number = variable_number(at);
  if (!number) return {};
  if (*number != kComputed) return out_.load(*number, at);
  return Value::variable(out_.emit(Ins::IndirectRaw, at));
}

std::optional<std::int64_t> ValueReader::variable_number(std::uint32_t at) {
  if (starts_name(peek()) && rules_.names) {
    comments_ = true;  // may stand between its letters
    out_.emit(Ins::Named, at, static_cast<double>(names_.text(s_.take_name())));
    return kComputed;
  }
  const auto number = written_number();
  if (number && rules_.structured) return *number + rules_.base_of(at);
  if (!number || !rules_.is_indirect(*number)) return number;
  Value inner = out_.load(*number - 9000, at);
  out_.arithmetic(inner, offset());
  return kComputed;
}

std::optional<std::int64_t> ValueReader::written_number() {
  const char c = peek();
  const std::uint32_t at = offset();
  if (!is_digit(c)) return out_.refuse(Cause::ExpressionFormat, at, kNoVariable);
  comments_ = true;
  const Number number = scan_number(s_);
  const bool point = number.points == 1 && number.decimals == 0 && number.any;
  const bool whole = number.points == 0 || (point && rules_.points);
  if (!whole || number.digits > ExpressionRules::kMostVariableDigits)
    return out_.refuse(Cause::IllegalVariable, at, "a variable number must be a whole number");
  return to_whole<std::int64_t>(number.value);
}

// ---- functions ----

/// Read a function, a named value or NOT; blanks may part its letters.
Value ValueReader::other_word() {
  const std::uint32_t at = offset();
  std::string word;
  for (char c = peek(); is_letter(c) || (word == "ATAN" && c == '2'); c = peek()) {
    word += c;
    ++s_.at;
    if (word.size() > 8) break;
  }
  for (const ConstantName& of : kConstants)
    if (word == name_of(of.word) && rules_.has(of.word)) return out_.constant(of.value, at);
  if (word == "NOT" && rules_.bare) return negation(at);
  const FunctionName* const found = rules_.function(word);
  if (found == nullptr)
    return out_.refuse(
        Cause::ExpressionFormat, at,
        word + " is not a function of this control" +
            letter_for_zero({s_.file, static_cast<std::size_t>(s_.end - s_.file)}, at));
  return found->one == Ins::Programmed ? programmed(at) : arguments(*found, at);
}

/// Read the rest of ATAN[a]/[b], ATAN[a,b] or ATAN[a], after the first brackets.
Value ValueReader::arc_tangent(std::uint32_t at, bool two) {
  Scanner ahead = s_;
  if (begins_gap(*ahead.at)) comments_ = true;
  if (!two && ahead.take('/') && ahead.peek() == '[') {
    s_.at = ahead.at;
    Value value = bracket();
    if (!value || !out_.arithmetic(value, offset())) return {};
    two = true;
  }
  out_.emit(two ? Ins::Atan2 : Ins::Atan, at);
  return Value::number();
}

/// Read AR[#23], which asks how a word was programmed: the number of the variable counts, not its
/// value.
Value ValueReader::programmed(std::uint32_t at) {
  if (!opens() || peek() != '#')
    return out_.refuse(Cause::ExpressionFormat, at, "AR must have a variable");
  const std::uint32_t hash = offset();
  ++s_.at;
  const bool inside = peek() == '[';
  const std::optional<std::int64_t> number = inside ? kComputed : variable_number(hash);
  if (!number || *number == kComputed)
    return out_.refuse(Cause::ExpressionFormat, at, "AR must have a variable");
  if (!closes()) return {};
  out_.emit(Ins::Programmed, at, static_cast<double>(*number));
  return Value::number();
}

}  // namespace cncsub
