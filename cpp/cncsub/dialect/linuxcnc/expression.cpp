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

struct Function {
  std::string_view name;
  Ins op;
};
constexpr std::array<Function, 12> kFunctions = {{{"abs", Ins::Abs},
                                                  {"acos", Ins::ArcCosineOf},
                                                  {"asin", Ins::ArcSineOf},
                                                  {"cos", Ins::CosineOf},
                                                  {"fix", Ins::Floor},
                                                  {"fup", Ins::Ceil},
                                                  {"ln", Ins::Ln},
                                                  {"round", Ins::Round},
                                                  {"sin", Ins::SineOf},
                                                  {"sqrt", Ins::Sqrt},
                                                  {"tan", Ins::TangentOf},
                                                  {"exp", Ins::Raise}}};

// All operators are left-associative, powers too. [rs274 2.9]
constexpr OperatorRow kRows[] = {{"**", 4, Ins::Raise},        {"*", 3, Ins::Multiply},
                                 {"/", 3, Ins::Divide},        {"mod", 3, Ins::PositiveModulo},
                                 {"+", 2, Ins::Add},           {"-", 2, Ins::Subtract},
                                 {"eq", 1, Ins::NearlyEqual},  {"ne", 1, Ins::NearlyNotEqual},
                                 {"ge", 1, Ins::GreaterEqual}, {"gt", 1, Ins::Greater},
                                 {"le", 1, Ins::LessEqual},    {"lt", 1, Ins::Less},
                                 {"and", 0, Ins::BothTrue},    {"or", 0, Ins::EitherTrue},
                                 {"xor", 0, Ins::OneTrue}};

}  // namespace

const std::span<const OperatorRow> kOperators = kRows;

void push(Builder& to, const Line& line, Ins op, double value, std::uint32_t index) {
  const bool indexed = op == Ins::Local || op == Ins::LocalRaw || op == Ins::Common ||
                       op == Ins::CommonRaw || op == Ins::NamedLocal || op == Ins::NamedCommon;
  to.expressions().emit({op, 0, indexed ? index : line.offset(), value});
}

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
  push(to_, line_, op, value, index);
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

/// The reader of the values of one pair of brackets.
class OperatorReader {
 public:
  using Value = bool;  // whether one was read
  using Operator = OperatorRow;

  OperatorReader(ExpressionReader& to, int depth) : to_(to), depth_(depth) {}

  bool operand() { return to_.read_value(depth_); }
  const OperatorRow* next_operator() const {
    const std::string_view rest = to_.line_.rest();
    for (const OperatorRow& of : kOperators)
      if (rest.starts_with(of.spelling)) return &of;
    return nullptr;
  }
  template <class Left>
  int level_of(const OperatorRow& of, bool /*value*/, const Left& /*left*/) const {
    return of.level;
  }
  std::uint32_t offset() const { return to_.line_.offset(); }
  void pass(const OperatorRow& of) { to_.line_.take(of.spelling); }
  bool apply(const OperatorRow& of, std::uint32_t at, bool /*left*/, bool /*right*/) {
    to_.emit_at(at, of.op);
    to_.constant_.reset();
    return true;
  }

 private:
  ExpressionReader& to_;
  int depth_;
};

bool ExpressionReader::read_bracket(int depth) {
  line_.take('[');
  OperatorReader values(*this, depth);
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
  for (const Function& function : kFunctions) {
    if (!line_.take(function.name)) continue;
    if (line_.peek() != '[')
      return wrong(Cause::ExpressionFormat, "Left bracket missing after unary operation name",
                   place);
    const bool power = function.op == Ins::Raise;  // of e
    if (power) emit(Ins::Constant, 2.71828182845904523536);
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
  linuxcnc::Line line;
  line.set("[" + std::string(text.text) + "]", text.at - 1);
  linuxcnc::ExpressionReader reader(to, line);
  linuxcnc::Value value;
  if (!reader.bracketed(value)) return reader.fault;
  if (!line.at_end())
    return Fault{Cause::ExpressionFormat, line.offset(), 1, "the expression ends before this"};
  expression = to.expressions().expression_of(value);
  return std::nullopt;
}

}  // namespace cncsub
