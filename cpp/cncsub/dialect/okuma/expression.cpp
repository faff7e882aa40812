#include "cncsub/dialect/okuma/expression.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub::okuma {

namespace {

constexpr int kDeepest = 100;             // nested values, more than a program has use for
constexpr std::size_t kMostDigits = 9;    // [OKA 2205]
constexpr std::size_t kLongestLocal = 4;  // [OKA 2227]

// [OKA 2327; the order of operators is general knowledge]
constexpr OperatorRow kRows[] = {
    {"*", 4, Ins::Multiply},      {"/", 4, Ins::Divide},     {"+", 3, Ins::Add},
    {"-", 3, Ins::Subtract},      {"EQ", 2, Ins::Equal},     {"NE", 2, Ins::NotEqual},
    {"LT", 2, Ins::Less},         {"LE", 2, Ins::LessEqual}, {"GT", 2, Ins::Greater},
    {"GE", 2, Ins::GreaterEqual}, {"AND", 1, Ins::And},      {"OR", 0, Ins::Or},
    {"EOR", 0, Ins::Xor}};

constexpr bool is_comparison(const OperatorRow& of) { return of.level == 2; }

// [OKA 2327; what they give is general knowledge]
constexpr Function kFunctions[] = {{"SIN", Ins::Sin},
                                   {"COS", Ins::Cos},
                                   {"TAN", Ins::Tan},
                                   {"ATAN", Ins::ArcTangentOf},
                                   {"ATAN2", Ins::ArcTangentOf, 2},
                                   {"SQRT", Ins::Sqrt},
                                   {"ABS", Ins::Abs},
                                   {"BIN", Ins::Bin},
                                   {"BCD", Ins::Bcd},
                                   {"ROUND", Ins::Round},
                                   {"FIX", Ins::Fix},
                                   {"FUP", Ins::Fup},
                                   {"DROUND", Ins::Round, 1, true},
                                   {"DFIX", Ins::Fix, 1, true},
                                   {"DFUP", Ins::Fup, 1, true},
                                   {"MOD", Ins::Modulo, 2}};

}  // namespace

const std::span<const OperatorRow> kOperators = kRows;

const Function* find_function(std::string_view name) {
  for (const Function& of : kFunctions)
    if (of.name == name) return &of;
  return nullptr;
}

std::string_view digits_of_common(std::string_view name) {
  const std::size_t letters = name.starts_with("VC") ? 2 : 1;
  if (!name.starts_with('V') || name.size() == letters) return {};
  const std::string_view digits = name.substr(letters);
  return std::all_of(digits.begin(), digits.end(), is_digit) ? digits : std::string_view();
}

std::string_view variable_in(std::string_view text) {
  const std::string_view name = name_in(text);
  const bool c = same_letters(name.substr(0, 2), "VC");
  if (name.empty() || upper(name[0]) != 'V') return name;
  std::size_t end = c ? 2 : 1;
  while (end < name.size() && is_digit(name[end])) ++end;
  return end > (c ? 2U : 1U) ? name.substr(0, end) : name;
}

bool ExpressionReader::wrong(Cause cause, std::string detail, std::uint32_t at, Kind kind) {
  fault = Fault{.cause = cause,
                .at = at,
                .width = line_.fault_width(at),
                .detail = std::move(detail),
                .kind = kind};
  return false;
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
  const char sign = line_.peek();
  if (sign == '-' || sign == '+') line_.pass(1);
  if (!is_digit(line_.peek()) && line_.peek() != '.')
    return wrong(Cause::AddressWithoutValue, "a number must stand here, or = and an expression",
                 at);
  if (!read_number()) return false;
  if (sign == '-' && constant_) constant_ = -*constant_;
  return finish(value, at);
}

bool ExpressionReader::value(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  in_condition_ = false;
  return read_operators_in(0) && finish(value, at);
}

bool ExpressionReader::condition(std::uint32_t& expression) {
  const std::uint32_t at = line_.offset();
  if (line_.peek() != '[')
    return wrong(Cause::IfFormat, "a condition in brackets must follow: IF [V1 EQ 2] N10", at,
                 kNoBracket);
  to_.expressions().begin();
  in_condition_ = true;
  compared_ = false;
  const bool read = read_bracket(0);
  in_condition_ = false;
  if (!read) return false;
  if (!compared_)
    return wrong(Cause::IfFormat, "a condition compares two values: IF [V1 EQ 2] N10", at,
                 kNoComparison);
  expression = to_.expressions().end(at, line_.width_from(at));
  return true;
}

/// The reader of the values of one pair of brackets, for `read_operators`.
class Operators {
 public:
  using Value = bool;
  using Operator = OperatorRow;

  Operators(ExpressionReader& to, int depth) : to_(to), depth_(depth) {}

  bool operand() { return to_.read_value(depth_); }
  const OperatorRow* next_operator() const {
    const char c = to_.line_.peek();
    for (const OperatorRow& of : kOperators) {
      const bool sign = !is_letter(of.spelling[0]);
      const bool here = sign ? of.spelling[0] == c : same_letters(to_.line_.name(), of.spelling);
      if (here && (to_.in_condition_ || !is_comparison(of))) return &of;
    }
    return nullptr;
  }
  template <class Left>
  int level_of(const OperatorRow& of, bool /*value*/, const Left& /*left*/) const {
    return of.level;
  }
  std::uint32_t offset() const { return to_.line_.offset(); }
  void pass(const OperatorRow& of) {
    to_.line_.pass(of.spelling.size());
    to_.compared_ = to_.compared_ || is_comparison(of);
  }
  bool apply(const OperatorRow& of, std::uint32_t at, bool /*left*/, bool /*right*/) {
    to_.to_.expressions().emit({of.op, 0, at, 0});
    to_.constant_.reset();
    return true;
  }

 private:
  ExpressionReader& to_;
  int depth_;
};

bool ExpressionReader::read_operators_in(int depth) {
  Operators values(*this, depth);
  return read_operators(values);
}

bool ExpressionReader::read_bracket(int depth) {
  line_.take('[');
  if (!read_operators_in(depth)) return false;
  const std::uint32_t at = line_.offset();
  return line_.take(']') || wrong(Cause::BracketNotClosed, "] is missing", at);
}

bool ExpressionReader::read_value(int depth) {
  const std::uint32_t at = line_.offset();
  if (depth > kDeepest) return wrong(Cause::BracketsTooDeep, "too many brackets", at);
  const char c = line_.peek();
  if (c == '\0') return wrong(Cause::ExpressionFormat, "the block ends within the expression", at);
  if (c == '[') return read_bracket(depth + 1);
  if (c == '-' || c == '+') return read_signed(depth, c);
  if (is_digit(c) || c == '.') return read_number();
  if (is_letter(c)) return read_name(depth + 1);
  line_.pass(first_character(line_.rest()).size());
  if (c == '$' || c == '#')
    return wrong(Cause::CodeNotComputed, "cncsub does not compute hexadecimal numbers", at);
  return wrong(Cause::ExpressionFormat, "a value must stand here", at);
}

bool ExpressionReader::read_signed(int depth, char sign) {
  line_.pass(1);
  if (!read_value(depth + 1)) return false;
  if (sign == '+') return true;
  if (constant_) constant_ = -*constant_;
  emit(Ins::Negate);
  return true;
}

bool ExpressionReader::read_number() {
  const std::uint32_t at = line_.offset();
  const std::string_view text = line_.take_number();
  const auto digits = static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_digit));
  if (std::count(text.begin(), text.end(), '.') > 1)
    return wrong(Cause::IllegalDecimalPoint, "a number with more than one decimal point", at);
  if (digits > kMostDigits) return wrong(Cause::TooManyDigits, "a number has at most 9 digits", at);
  if (digits == 0) return wrong(Cause::AddressWithoutValue, "a number without digits", at);
  const std::string plain = (text.front() == '.' ? "0" : "") + std::string(text);
  double number = 0;
  system::parse(plain, number, system::Decimal::Fixed);
  constant_ = number;
  emit(Ins::Constant, number);
  return true;
}

bool ExpressionReader::read_name(int depth) {
  const std::uint32_t at = line_.offset();
  line_.peek();
  const std::string name = capitals(variable_in(line_.rest()));
  line_.pass(name.size());
  constant_.reset();
  if (const Function* const function = find_function(name)) return read_function(*function, depth);
  if (name == "NOT") {
    if (!read_value(depth)) return false;
    constant_.reset();
    emit(in_condition_ && compared_ ? Ins::Not : Ins::BitNot);
    return true;
  }
  if (name == "EMPTY")
    return wrong(Cause::CodeNotComputed,
                 "EMPTY stands on the right of EQ or NE: cncsub computes it nowhere else", at);
  if (name.starts_with('V')) return read_variable(name, depth);
  return is_local(name, at) && read_local(name, at);
}

bool ExpressionReader::read_function(const Function& function, int depth) {
  const std::uint32_t at = line_.offset();
  if (!line_.take('['))
    return wrong(Cause::ExpressionFormat,
                 "[ must follow " + std::string(function.name) + ": " + std::string(function.name) +
                     (function.values == 2 ? "[1,2]" : "[1]"),
                 at);
  if (!read_operators_in(depth)) return false;
  if (function.values == 2) {
    if (!line_.take(','))
      return wrong(Cause::MissingComma, "a second value must follow after a comma", line_.offset());
    if (!read_operators_in(depth)) return false;
  }
  const std::uint32_t end = line_.offset();
  if (!line_.take(']')) return wrong(Cause::BracketNotClosed, "] is missing", end);
  constant_.reset();
  constexpr double kThousand = 1000;
  if (function.op == Ins::ArcTangentOf && function.values == 1) emit(Ins::Constant, 1);
  if (function.thousandths) emit(Ins::MultiplyConstant, kThousand);
  to_.expressions().emit({function.op, 0, at, 0});
  if (function.thousandths) emit(Ins::DivideConstant, kThousand);
  return true;
}

/// Take EQ EMPTY or NE EMPTY where it stands here; `is`: it asks whether the value is vacant.
bool ExpressionReader::asks_existence(bool& is) {
  if (!in_condition_) return false;
  const std::string_view asked = line_.name();
  is = same_letters(asked, "EQ");
  if (!is && !same_letters(asked, "NE")) return false;
  const Line before = line_;
  line_.pass(2);
  if (same_letters(line_.name(), "EMPTY")) {
    line_.pass(5);
    compared_ = true;
    return true;
  }
  line_ = before;
  return false;
}

/// Return whether a name is one that a local may have.
bool ExpressionReader::is_local(const std::string& name, std::uint32_t at) {
  if (name.size() > kLongestLocal)
    return wrong(Cause::VariableNameTooLong,
                 name + " is no word of the control, and a local has at most 4 characters", at);
  if (name.size() > 1 && is_letter(name[1])) return true;
  return wrong(Cause::IllegalVariableName,
               "a value must stand here: the name of a local begins with two letters", at);
}

/// Refuse a variable that the block has assigned; return whether it has.
bool ExpressionReader::is_assigned_here(const std::string& name, std::uint32_t at) {
  if (!assigned_.contains(name)) return false;
  wrong(Cause::CodeNotComputed,
        "no source says which value " + name + " has in the block that assigns it", at);
  return true;
}

bool ExpressionReader::read_local(const std::string& name, std::uint32_t at) {
  if (is_assigned_here(name, at)) return false;
  const std::uint32_t place = to_.names().variable(name, false);
  const auto index = static_cast<std::uint32_t>(to_.code().named_variables[place].index);
  bool vacant = false;
  if (asks_existence(vacant)) {
    to_.expressions().emit({Ins::LocalRaw, 0, index, 0});
    emit(Ins::IsSet);
    if (vacant) emit(Ins::Not);
    return true;
  }
  to_.expressions().emit({Ins::NamedLocal, 0, index, static_cast<double>(place)});
  return true;
}

/// Return the number of V5 or VC5.
bool ExpressionReader::common_number(const std::string& name, std::uint32_t at,
                                     std::int32_t& number) {
  const std::string_view digits = digits_of_common(name);
  constexpr std::size_t kMost = 6;
  double value = 0;
  system::parse(digits.substr(0, kMost), value, system::Decimal::Fixed);
  const bool c = name.starts_with("VC");
  number = (c ? kCommonsC : kCommons) + to_whole<std::int32_t>(value);
  const bool inside = value > 0 && number <= (c ? 2 * kCommonsC : kCommonsC);
  if (inside && to_.code().place(number).is_common()) return true;
  return wrong(Cause::IllegalVariable, "there is no common variable " + name, at);
}

bool ExpressionReader::read_variable(const std::string& name, int depth) {
  const std::uint32_t at = line_.offset() - static_cast<std::uint32_t>(name.size());
  if (digits_of_common(name).empty()) return read_system(name, depth);
  std::int32_t number = 0;
  if (!common_number(name, at, number)) return false;
  if (is_assigned_here(name, at)) return false;
  const VariablePlace place = to_.code().place(number);
  to_.expressions().emit(
      {Ins::Common, 0, static_cast<std::uint32_t>(place.index), static_cast<double>(number)});
  return true;
}

/// Read the index of a system variable, and let the expression give the number of the variable.
bool ExpressionReader::read_index(const SystemVariable& of, int depth) {
  const std::uint32_t at = line_.offset();
  if (of.step == 0) {
    emit(Ins::Constant, of.first);
    return true;
  }
  if (!line_.take('['))
    return wrong(Cause::ExpressionFormat,
                 "[ must follow " + std::string(of.name) + " with an index", at);
  const bool condition = std::exchange(in_condition_, false);
  const bool read = read_operators_in(depth);
  in_condition_ = condition;
  if (!read) return false;
  const std::uint32_t end = line_.offset();
  if (!line_.take(']')) return wrong(Cause::BracketNotClosed, "] is missing", end);
  emit(Ins::WholeNumber);
  if (of.step != 1) emit(Ins::MultiplyConstant, of.step);
  emit(Ins::AddConstant, of.first - of.step);
  return true;
}

bool ExpressionReader::read_system(const std::string& name, int depth) {
  const std::uint32_t at = line_.offset() - static_cast<std::uint32_t>(name.size());
  const SystemVariable* const of = find_system_variable(name);
  if (of == nullptr) {
    if (name.starts_with("VZOF") && name.size() == 5)
      return wrong(Cause::IllegalVariable, "there is no system variable " + name, at, kSystem);
    return wrong(Cause::CodeNotComputed,
                 "cncsub does not know what " + name + " holds: the machine has it", at);
  }
  if (!of->readable) return wrong(Cause::VariableReadProtected, name + " cannot be read", at);
  if (!read_index(*of, depth)) return false;
  constant_.reset();
  emit(Ins::Indirect);
  return true;
}

bool ExpressionReader::left_side(Statement& statement) {
  const std::uint32_t at = statement.variable_at = line_.offset();
  const std::string name = capitals(variable_in(line_.rest()));
  line_.pass(name.size());
  using Target = Statement::Target;
  if (!name.starts_with('V')) {
    if (!is_local(name, at)) return false;
    const std::uint32_t place = to_.names().variable(name, false);
    statement.target = Target::Local;
    statement.index = to_.code().named_variables[place].index;
  } else if (!digits_of_common(name).empty()) {
    if (!common_number(name, at, statement.number)) return false;
    statement.target = Target::Common;
    statement.index = to_.code().place(statement.number).index;
  } else {
    const SystemVariable* const of = find_system_variable(name);
    if (of == nullptr) return read_system(name, 0);  // refused
    if (!of->writable) return wrong(Cause::VariableWriteProtected, name + " cannot be set", at);
    to_.expressions().begin();
    if (!read_index(*of, 0)) return false;
    statement.target = Target::Indirect;
    statement.variable = to_.expressions().end(at, line_.width_from(at));
  }
  statement.variable_width = line_.width_from(at);
  return true;
}

}  // namespace cncsub::okuma

namespace cncsub {

std::optional<Fault> okuma_expression(Builder& to, const ExpressionText& text,
                                      std::uint32_t& expression, ValueType& /*type*/) {
  const std::string bracketed = "[" + std::string(text.text) + "]";
  okuma::Line line;
  line.set(bracketed, text.at - 1);
  okuma::ExpressionReader reader(to, line);
  okuma::Value value;
  const okuma::Line begin = line;
  if (!reader.condition(expression)) {
    line = begin;
    reader.fault.reset();
    if (!reader.value(value)) return reader.fault;
    expression = to.expressions().expression_of(value);
  }
  if (line.at_end()) return std::nullopt;
  return Fault{Cause::ExpressionFormat, line.offset(), 1, "the expression ends before this"};
}

}  // namespace cncsub
