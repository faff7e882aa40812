#include "cncsub/dialect/sinumerik/expression.hpp"

#include <array>
#include <charconv>

#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr int kDeepest = 100;                // nested values
constexpr double kAlike = 1e-12;             // the share by which equal values may differ
constexpr std::int32_t kLastNumber = 99999;  // of a parameter, more than any control has

struct Function {
  std::string_view name;
  Ins op;
  int values;
};
constexpr std::array<Function, 12> kFunctions = {{{"SIN", Ins::SineOf, 1},
                                                  {"COS", Ins::CosineOf, 1},
                                                  {"TAN", Ins::TangentOf, 1},
                                                  {"ASIN", Ins::ArcSineOf, 1},
                                                  {"ACOS", Ins::ArcCosineOf, 1},
                                                  {"ATAN2", Ins::ArcTangentOf, 2},
                                                  {"SQRT", Ins::Sqrt, 1},
                                                  {"ABS", Ins::Abs, 1},
                                                  {"TRUNC", Ins::Fix, 1},
                                                  {"ROUND", Ins::Round, 1},
                                                  {"LN", Ins::Ln, 1},
                                                  {"POT", Ins::Raise, 1}}};

// The precedence falls from products to comparisons; NOT and signs belong to the operand. Levels 4
// to 6 are those of B_OR, B_XOR and B_AND, which are not computed. [NCI precedence: manual 4.1.3.3]
constexpr OperatorRow kRows[] = {{"*", 8, Ins::Multiply},
                                 {"/", 8, Ins::Divide},
                                 {"DIV", 8, Ins::Divide, Ins::Fix},
                                 {"MOD", 8, Ins::Modulo},
                                 {"+", 7, Ins::Add},
                                 {"-", 7, Ins::Subtract},
                                 {"AND", 3, Ins::BothTrue},
                                 {"XOR", 2, Ins::OneTrue},
                                 {"OR", 1, Ins::EitherTrue},
                                 {"==", 0, Ins::Compare, Ins::Equal},
                                 {"<>", 0, Ins::Compare, Ins::NotEqual},
                                 {"<=", 0, Ins::Compare, Ins::LessEqual},
                                 {">=", 0, Ins::Compare, Ins::GreaterEqual},
                                 {"<", 0, Ins::Compare, Ins::Less},
                                 {">", 0, Ins::Compare, Ins::Greater}};

}  // namespace

const std::span<const OperatorRow> kOperators = kRows;

void ExpressionReader::begin_block() {
  assigned_.clear();
  assigned_any_ = false;
  fault.reset();
}

bool ExpressionReader::wrong(Cause cause, std::string detail, std::uint32_t at) {
  fault =
      Fault{.cause = cause, .at = at, .width = line_.width_from(at), .detail = std::move(detail)};
  return false;
}

bool ExpressionReader::not_computed(std::string_view what, std::uint32_t at) {
  return wrong(Cause::CodeNotComputed, "cncsub does not compute " + std::string(what), at);
}

void ExpressionReader::emit(Ins op, double value) {
  to_.expressions().emit({op, 0, line_.offset(), value});
}

bool ExpressionReader::finish(Value& value, std::uint32_t at) {
  value = to_.expressions().end_value(constant_, at, line_.width_from(at));
  return true;
}

bool ExpressionReader::number(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  const bool minus = line_.take('-');
  if (!minus) line_.take('+');
  if (!read_number()) return false;
  if (minus) constant_ = -constant_.value_or(0);
  return finish(value, at);
}

bool ExpressionReader::value(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  return read(0) && finish(value, at);
}

bool ExpressionReader::condition(std::uint32_t& expression, bool otherwise) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  if (!read(0)) return false;
  if (otherwise) emit(Ins::Not);
  expression = to_.expressions().end(at, line_.width_from(at));
  return true;
}

/// The reader of the values of one expression.
class OperatorReader {
 public:
  using Value = bool;  // whether one was read
  using Operator = OperatorRow;

  OperatorReader(ExpressionReader& to, int depth) : to_(to), depth_(depth) {}

  bool operand() { return to_.read_operand(depth_); }
  const OperatorRow* next_operator() const {
    const std::string name = capitals(to_.line_.name());
    const std::string_view rest = to_.line_.peek() == '\0' ? std::string_view() : to_.line_.rest();
    for (const OperatorRow& of : kOperators)
      if (is_letter(of.spelling[0]) ? name == of.spelling : rest.starts_with(of.spelling))
        return &of;
    return nullptr;
  }
  template <class Left>
  int level_of(const OperatorRow& of, bool /*value*/, const Left& /*left*/) const {
    return of.level;
  }
  std::uint32_t offset() const { return 0; }  // an instruction tells where its last value ends
  void pass(const OperatorRow& of) { to_.line_.pass(of.spelling.size()); }
  /// Write an operator. A comparison is of the values' difference, measured by their size, with 0.
  /// [NCI comparisons]
  bool apply(const OperatorRow& of, std::uint32_t /*at*/, bool /*left*/, bool /*right*/) {
    to_.emit(of.op, of.op == Ins::Compare ? kAlike : 0);
    if (of.op == Ins::Compare) to_.emit(Ins::Constant, 0);
    if (of.other != Ins::End) to_.emit(of.other);
    to_.constant_.reset();
    return true;
  }

 private:
  ExpressionReader& to_;
  int depth_;
};

bool ExpressionReader::read(int depth) {
  OperatorReader values(*this, depth);
  return read_operators(values) && !is_uncomputed_operator();
}

/// Return whether an operator on bits follows; refuse it. [NCI precedence: manual 4.1.3.3]
bool ExpressionReader::is_uncomputed_operator() {
  const std::uint32_t at = line_.offset();
  const std::string name = capitals(line_.name());
  if (name != "B_AND" && name != "B_OR" && name != "B_XOR") return false;
  line_.pass(name.size());
  return !not_computed(name, at);
}

/// Read the sign that stands here, or NOT, and its operand.
bool ExpressionReader::read_signed(char sign, std::string_view name, int depth) {
  line_.pass(name.empty() ? 1 : name.size());
  if (!read_operand(depth + 1)) return false;
  if (sign == '+') return true;
  if (constant_ && sign == '-') constant_ = -*constant_;
  if (sign != '-') constant_.reset();
  emit(sign == '-' ? Ins::Negate : Ins::Not);
  return true;
}

/// Read a value with its signs, which bind closest.
bool ExpressionReader::read_operand(int depth) {
  const std::uint32_t at = line_.offset();
  if (depth > kDeepest)
    return wrong(Cause::BracketsTooDeep, "more brackets inside each other than cncsub reads", at);
  const char c = line_.peek();
  const std::string name = capitals(line_.name());
  if (c == '-' || c == '+' || name == "NOT") return read_signed(c, name, depth);
  if (c == '(') return read_bracket('(', ')', depth + 1);
  if (is_digit(c) || c == '.') return read_number();
  if (c == '\0') return wrong(Cause::ExpressionFormat, "a value is missing", at);
  if (c == '$') return read_system_variable();
  if (c == '"') {
    line_.pass_quoted();
    return not_computed("a text", at);
  }
  if (name.empty()) return wrong(Cause::ExpressionFormat, "a value cannot begin like this", at);
  if (name[0] == 'R' && (name.size() == 1 ? line_.ahead(1) == '[' : is_digit(name[1])))
    return read_parameter(depth);
  if (const Definition* const of = definitions_.find(name)) return read_variable(*of, name);
  return read_function(name, depth);
}

bool ExpressionReader::read_bracket(char open, char close, int depth) {
  const std::uint32_t at = line_.offset();
  if (!line_.take(open))
    return wrong(Cause::BracketNotOpened, std::string(1, open) + " is missing", at);
  if (!read(depth)) return false;
  if (line_.take(close)) return true;
  return wrong(Cause::BracketNotClosed, std::string(1, close) + " is missing", at);
}

/// Read 10, 10.5, .5, or 1.5EX3 for 1500.
bool ExpressionReader::read_number() {
  const std::uint32_t at = line_.offset();
  std::string text(line_.take_digits());
  if (line_.ahead(0) == '.') {
    line_.pass(1);
    text += '.';
    text += line_.take_digits();
  }
  if (text.empty() || text == ".")
    return wrong(Cause::AddressWithoutValue, "a number is missing", at);
  if (line_.ahead(0) == 'E' && line_.ahead(1) == 'X') {
    line_.pass(2);
    text += 'e';
    const char sign = line_.ahead(0);
    if (sign == '-' || sign == '+') line_.pass(1);
    if (sign == '-') text += '-';
    text += line_.take_digits();
  }
  double number = 0;
  const auto read = system::parse(text, number);
  if (!read.number || read.length != text.size() || number > kLargest)
    return wrong(Cause::ValueOutOfRange, "this is not a number", at);
  constant_ = number;
  emit(Ins::Constant, number);
  return true;
}

bool ExpressionReader::parameter_number(std::string_view digits, std::uint32_t at,
                                        VariablePlace& place, std::int32_t& number) {
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (read.ec == std::errc() && number <= kLastNumber) place = to_.code().place(number);
  if (place.is_common()) return true;
  return wrong(Cause::IllegalVariable, "this control has no parameter R" + std::string(digits), at);
}

bool ExpressionReader::read_parameter(int depth) {
  const std::uint32_t at = line_.offset();
  line_.pass(1);
  constant_.reset();
  if (line_.ahead(0) == '[') {
    if (!read_bracket('[', ']', depth + 1)) return false;
    constant_.reset();
    emit(Ins::Indirect);
    return (!assigned_any_ && assigned_.empty()) || late(at);
  }
  VariablePlace place;
  std::int32_t number = 0;
  if (!parameter_number(line_.take_digits(), at, place, number)) return false;
  to_.expressions().emit(
      {Ins::Common, 0, static_cast<std::uint32_t>(place.index), static_cast<double>(number)});
  return (!assigned_any_ && !assigned_.contains(number)) || late(at);
}

bool ExpressionReader::read_function(std::string_view name, int depth) {
  const std::uint32_t at = line_.offset();
  line_.pass(name.size());
  if (name == "TRUE" || name == "FALSE") {
    constant_ = name == "TRUE" ? 1 : 0;
    emit(Ins::Constant, *constant_);
    return true;
  }
  const auto* const of = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                      [name](const Function& known) { return known.name == name; });
  if (of == std::end(kFunctions)) {
    if (is_not_computed(name)) return not_computed(name, at);
    return wrong(Cause::CodeNotComputed,
                 std::string(name) +
                     " is not defined in this program, and global variables are not computed here",
                 at);
  }
  if (!read_values(of->values, at, depth)) return false;
  constant_.reset();
  if (of->op == Ins::Raise) emit(Ins::Constant, 2);  // POT: the square
  emit(of->op);
  return true;
}

/// Read the values of the function at `at`, in their brackets.
bool ExpressionReader::read_values(int count, std::uint32_t at, int depth) {
  if (!line_.take('(')) return wrong(Cause::BracketNotOpened, "( is missing", at);
  for (int i = 0; i < count; ++i) {
    if (i > 0 && !line_.take(','))
      return wrong(Cause::MissingComma, "a second value is missing", at);
    if (!read(depth + 1)) return false;
  }
  return line_.take(')') || wrong(Cause::BracketNotClosed, ") is missing", at);
}

/// Read the left side, then the value. Only then does the variable count as assigned: R1=R1+1.
bool ExpressionReader::assignment(Statement& statement) {
  const std::uint32_t at = line_.offset();
  std::int32_t number = -1;
  statement.variable_at = at;
  line_.pass(1);  // R
  if (line_.ahead(0) == '[') {
    to_.expressions().begin();
    if (!read_bracket('[', ']', 0)) return false;
    statement.target = Statement::Target::Indirect;
    statement.variable = to_.expressions().end(at, line_.width_from(at));
  } else {
    VariablePlace place;
    if (!parameter_number(line_.take_digits(), at, place, number)) return false;
    statement.target = Statement::Target::Common;
    statement.index = place.index;
  }
  statement.variable_width = line_.width_from(at);
  if (!line_.take('='))
    return wrong(Cause::MissingEquals, "R1 alone has no effect: write R1=5, or X=R1", at);
  if (!assigned_value(Type::Real, statement)) return false;
  if (number >= 0)
    assigned_.insert(number);
  else
    assigned_any_ = true;
  return true;
}

}  // namespace cncsub::sinumerik
