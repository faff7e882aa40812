// Variables of expressions: #1, #[#2+1], #NAME.
#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kComputed = -1;
constexpr const char* kNoVariable = "behind # stands a number, or an expression in brackets";

bool starts_name(Scanner& s) { return is_letter(s.peek()) || s.peek() == '_'; }

}  // namespace

/// The assigned variable, or that of AR, where more than digits stand behind its #.
std::optional<ExpressionReader::Variable> ExpressionReader::other_target(std::uint32_t hash) {
  const auto first = out_.first();
  const bool inside = s_->peek() == '[';
  const std::uint32_t at = inside ? s_->offset() : hash;
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, out_.finish(first, at, inside ? s_->offset() - at : 1)};
}

/// The value of a variable that is not written as digits alone, or does not lie near.
Value ExpressionReader::other_variable() {
  const std::uint32_t at = s_->offset();
  ++s_->at;
  if (!out_.has_room(s_->offset())) return {};
  if (const auto number = plain_number(s_->at)) return out_.load(*number, at);
  const char first = s_->peek();
  if (first == '[') return open(Waiting::Kind::Indirect, at);
  if (!is_digit(first) && starts_name(*s_) && !rules_.names)
    return out_.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const auto number = variable_number(at);
  if (!number) return {};
  if (*number != kComputed) return out_.load(*number, at);
  out_.emit(Ins::IndirectRaw, at);
  return out_.last();
}

/// The number of a variable, where it is written behind the #; else kComputed, and instructions
/// give it.
std::optional<std::int64_t> ExpressionReader::variable_number(std::uint32_t at) {
  const char first = s_->peek();
  if (first == '[') {
    Value inner = bracket();
    if (!inner || !out_.arithmetic(inner, s_->offset())) return std::nullopt;
    return kComputed;
  }
  if (!is_digit(first) && starts_name(*s_) && rules_.names) {
    out_.emit(Ins::Named, at, static_cast<double>(names_.text(s_->take_name())));
    return kComputed;
  }
  const auto number = written_number();
  if (!number || !rules_.indirect || *number < 9000 || *number > 9999) return number;
  Value inner = out_.load(*number - 9000, at);
  out_.arithmetic(inner, s_->offset());
  return kComputed;
}

std::optional<std::int64_t> ExpressionReader::written_number() {
  const char c = s_->peek();
  const std::uint32_t at = s_->offset();
  if (!is_digit(c)) return out_.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const Number number = scan_number(*s_);
  const bool behind = number.points == 1 && number.decimals == 0 && number.any;
  const bool whole = number.points == 0 || (behind && rules_.points);
  if (!whole || number.digits > kMostVariableDigits)
    return out_.refuse(Cause::IllegalVariable, at, "a variable number is a whole number");
  return to_whole<std::int64_t>(number.value);
}

}  // namespace cncsub
