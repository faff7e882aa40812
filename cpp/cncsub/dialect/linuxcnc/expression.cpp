#include "cncsub/dialect/linuxcnc/expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/system/decimal.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::linuxcnc {

namespace {

constexpr int kDeepest = 200;  // nested values, more than a line has room for

}  // namespace

bool ExpressionReader::wrong(Cause cause, std::string text, std::size_t place) {
  const std::uint32_t at = line_.offset(place);
  Fault found{.cause = cause, .at = at, .width = line_.width_from(at), .detail = text};
  found.text = std::move(text);
  fault = std::move(found);
  return false;
}

void ExpressionReader::emit_at(std::uint32_t at, Ins op, double value) {
  to_.expressions().emit({op, 0, at, value});
}

void ExpressionReader::emit(Ins op, double value, std::uint32_t index) {
  ngc_push(to_, line_, op, value, index);
}

std::optional<double> ExpressionReader::whole_number(double value, std::size_t place) {
  const auto whole = nearly_whole(value);
  if (!whole) wrong(Cause::WholeNumberExpected, "Non integer value for integer", place);
  return whole;
}

bool ExpressionReader::finish(Value& value, std::uint32_t at) {
  value = to_.expressions().end_value(constant_, at, line_.width_from(at));
  return true;
}

bool ExpressionReader::value(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  return read_value(0) && finish(value, at);
}

bool ExpressionReader::bracketed(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  return read_bracket(0) && finish(value, at);
}

bool ExpressionReader::whole(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  const std::size_t place = line_.place();
  if (!read_value(0)) return false;
  if (constant_) {
    constant_ = whole_number(*constant_, place);
    if (!constant_) return false;
  } else {
    emit(Ins::WholeNumber);
  }
  return finish(value, at);
}

bool ExpressionReader::read_value(int depth) {
  const std::size_t place = line_.place();
  if (depth > kDeepest) return wrong(Cause::BracketsTooDeep, "Command too long", place);
  const char c = line_.peek(), next = line_.peek(1);
  if (c == '\0')
    return wrong(Cause::AddressWithoutValue, "No characters found in reading real value", place);
  if (c == '[') return read_bracket(depth + 1);
  if (c == '#') {
    line_.take();
    return read_variable(depth + 1);
  }
  if ((c == '+' || c == '-') && next != '\0' && !is_digit(next) && next != '.') {
    line_.take();
    if (!read_value(depth + 1)) return false;
    if (c == '+') return true;
    if (constant_) constant_ = -*constant_;
    emit(Ins::Negate);
    return true;
  }
  if (c >= 'a' && c <= 'z') return read_function(depth + 1);
  return read_number();
}

bool ExpressionReader::read_number() {
  const std::size_t place = line_.place();
  const std::string_view signs = line_.take_all("+-");
  const std::string_view digits = line_.take_all("0123456789.");
  double number = 0;
  const auto read = system::parse(digits, number, system::Decimal::Fixed);
  const std::string text = std::string(signs) + std::string(digits);
  if (signs.size() > 1 || !read.number)
    return wrong(Cause::ExpressionFormat,
                 "bad number format (conversion failed) parsing '" + text + "'", place);
  if (read.length != digits.size())
    return wrong(Cause::IllegalDecimalPoint,
                 "bad number format (trailing characters) parsing '" + text + "'", place);
  constant_ = signs == "-" ? -number : number;
  emit(Ins::Constant, *constant_);
  return true;
}

bool ExpressionReader::read_bracket(int depth) {
  line_.take('[');
  NgcOperators values(*this, depth);
  if (!read_operators(values)) return false;
  const std::size_t place = line_.place();
  if (line_.take(']')) return true;
  const char c = line_.peek();
  if (c == '\0') return wrong(Cause::BracketNotClosed, "Unclosed expression", place);
  line_.take();
  const bool begins = std::string_view("amoxengl").find(c) != std::string_view::npos;
  return wrong(
      Cause::ExpressionFormat,
      begins ? std::string("Unknown operation name starting with ") + c : "Unknown operation",
      place);
}

bool ExpressionReader::read_function(int depth) {
  const std::size_t place = line_.place();
  const std::uint32_t at = line_.offset();
  if (line_.take("atan")) return read_arctangent(depth);
  if (line_.take("exists")) return read_exists(depth);
  for (const NgcFunction& function : ngc_functions) {
    if (!line_.take(function.name)) continue;
    if (line_.peek() != '[')
      return wrong(Cause::ExpressionFormat, "Left bracket missing after unary operation name",
                   place);
    const bool power = function.op == Ins::Raise;  // of e
    if (power) emit(Ins::Constant, kEuler);
    if (!read_bracket(depth)) return false;
    constant_.reset();
    emit_at(at, function.op);
    return true;
  }
  const char c = line_.take();
  const bool begins = std::string_view("aceflrst").find(c) != std::string_view::npos;
  return wrong(Cause::ExpressionFormat,
               begins ? std::string("Unknown word starting with ") + c
                      : "Unknown word where unary operation could be",
               place);
}

bool ExpressionReader::read_arctangent(int depth) {
  const std::size_t place = line_.place();
  const auto bracket_missing = [&](const char* text) {
    return wrong(Cause::ExpressionFormat, text, place);
  };
  if (line_.peek() != '[')
    return bracket_missing("Left bracket missing after unary operation name");
  if (!read_bracket(depth)) return false;
  if (!line_.take('/')) return bracket_missing("Slash missing after first atan argument");
  if (line_.peek() != '[')
    return bracket_missing("Left bracket missing after slash with atan operator");
  if (!read_bracket(depth)) return false;
  constant_.reset();
  emit(Ins::ArcTangentOf);
  return true;
}

}  // namespace cncsub::linuxcnc

namespace cncsub {

std::optional<Fault> linuxcnc_expression(Builder& to, const ExpressionText& text,
                                         std::uint32_t& expression, ValueType& /*type*/) {
  return ngc_expression<linuxcnc::ExpressionReader>(to, text, expression);
}

}  // namespace cncsub
