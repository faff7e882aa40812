#include <algorithm>
#include <array>
#include <string>

#include "cncsub/rule_lists.hpp"
#include "cncsub/statement.hpp"

namespace cncsub {

namespace {

// Whatever the control allows: values on the stack of an expression, and brackets or NOT inside
// each other. What is inside is read by functions inside each other.
constexpr int kDeepest = 200, kMostInside = 64;
constexpr int kTightest = 3;  // of the levels at which operators bind, where logic binds last

struct FunctionName {
  std::string_view name;
  Ins op;
};
constexpr FunctionName kFunctions[] = {{"SIN", Ins::Sin},
                                       {"COS", Ins::Cos},
                                       {"TAN", Ins::Tan},
                                       {"ASIN", Ins::Asin},
                                       {"ACOS", Ins::Acos},
                                       {"ATAN", Ins::Atan},
                                       {"ATAN2", Ins::Atan2},
                                       {"SQRT", Ins::Sqrt},
                                       {"SQR", Ins::Sqrt},
                                       {"ABS", Ins::Abs},
                                       {"ROUND", Ins::Round},
                                       {"RND", Ins::Round},
                                       {"FIX", Ins::Fix},
                                       {"INT", Ins::Fix},
                                       {"FUP", Ins::Fup},
                                       {"LN", Ins::Ln},
                                       {"EXP", Ins::Exp},
                                       {"POW", Ins::Pow},
                                       {"BIN", Ins::Bin},
                                       {"BCD", Ins::Bcd},
                                       {"ADP", Ins::Adp},
                                       {"PRM", Ins::Parameter},
                                       {"SIGN", Ins::Sign},
                                       {"RAND", Ins::Random},
                                       {"SRAND", Ins::RandomBetween},
                                       {"AR", Ins::Programmed}};

bool listed(const Codes& list, std::string_view name) {
  std::size_t at = 0;
  while ((at = list.find(name, at)) != std::string::npos) {
    const bool starts = at == 0 || list[at - 1] == ' ';
    const bool ends = at + name.size() == list.size() || list[at + name.size()] == ' ';
    if (starts && ends) return true;
    ++at;
  }
  return false;
}

/// The function of this name, or of the name that it abbreviates.
const FunctionName* find_function(const Control& control, std::string_view word) {
  for (const FunctionName& f : kFunctions)
    if (f.name == word && listed(control.functions.value, f.name)) return &f;
  if (!control.short_functions.value || word.size() < 2) return nullptr;
  for (const FunctionName& f : kFunctions)
    if (f.name.substr(0, word.size()) == word && listed(control.functions.value, f.name)) return &f;
  return nullptr;
}

Ins computed(Ins raw) {
  switch (raw) {
    case Ins::LocalRaw:
      return Ins::Local;
    case Ins::CommonRaw:
      return Ins::Common;
    case Ins::VariableRaw:
      return Ins::Variable;
    case Ins::IndirectRaw:
      return Ins::Indirect;
    default:
      return raw;
  }
}

}  // namespace

std::vector<std::string_view> function_names() {
  std::vector<std::string_view> names = {"PI", "TRUE", "FALSE"};
  for (const FunctionName& f : kFunctions) names.push_back(f.name);
  return names;
}

std::nullopt_t ExpressionReader::refuse(Cause cause, std::uint32_t at, std::string detail) {
  if (!failed_) fault_ = {cause, at, 1, std::move(detail)};
  failed_ = true;
  return std::nullopt;
}

void ExpressionReader::emit(Ins op, std::uint32_t at, double value) {
  code_.instructions.push_back({op, static_cast<std::uint8_t>(address_), at, value});
}

std::uint32_t ExpressionReader::finish(std::uint32_t first, std::uint32_t at) {
  emit(Ins::End, at);
  Expression expression;
  expression.first = first;
  expression.at = at;
  expression.width = std::max<std::uint32_t>(1, s_.offset() - at);
  shorten(expression);
  code_.expressions.push_back(expression);
  return static_cast<std::uint32_t>(code_.expressions.size() - 1);
}

/// Tells expressions of one value, and of one operation on two, from longer ones.
void ExpressionReader::shorten(Expression& expression) const {
  const Instruction* at = code_.instructions.data() + expression.first;
  const std::size_t count = code_.instructions.size() - expression.first;
  const auto load = [](const Instruction& from, Expression::Load& to) {
    using From = Expression::Load::From;
    switch (from.op) {
      case Ins::Constant:
        to = {From::Constant, true, 0, from.value};
        return true;
      case Ins::Local:
      case Ins::LocalRaw:
        to = {From::Local, from.op == Ins::LocalRaw, from.at, 0};
        return true;
      case Ins::Common:
      case Ins::CommonRaw:
        to = {From::Common, from.op == Ins::CommonRaw, from.at, 0};
        return true;
      default:
        return false;
    }
  };
  if (count == 2 && load(at[0], expression.loads[0])) expression.form = Expression::Form::One;
  if (count == 3 && at[1].op >= Ins::AddConstant && at[1].op <= Ins::MultiplyConstant &&
      load(at[0], expression.loads[0])) {
    expression.form = Expression::Form::Two;
    expression.op = at[1].op == Ins::AddConstant        ? Ins::Add
                    : at[1].op == Ins::SubtractConstant ? Ins::Subtract
                                                        : Ins::Multiply;
    expression.loads[1].value = at[1].value;
  }
  if (count != 4 || !load(at[0], expression.loads[0]) || !load(at[1], expression.loads[1])) return;
  const bool plain = (at[2].op >= Ins::Add && at[2].op <= Ins::Multiply) ||
                     (at[2].op >= Ins::Equal && at[2].op <= Ins::LessEqual);
  if (!plain) return;
  expression.form = Expression::Form::Two;
  expression.op = at[2].op;
}

bool ExpressionReader::grow() {
  if (++depth_ <= kDeepest) return true;
  refuse(Cause::BracketsTooDeep, s_.offset());
  return false;
}

/// From here on the value is a number: a vacant variable counts as 0.
/// A comparison leaves 1 or 0, which is a number where the control says so.
bool ExpressionReader::is_number(Value& value) const {
  if (value.type == Type::Condition && code_.control->conditions_are_values.value)
    value.type = Type::Number;
  return value.type == Type::Number;
}

bool ExpressionReader::arithmetic(Value& value) {
  if (!is_number(value)) {
    refuse(Cause::ExpressionFormat, s_.offset(), "the result of a comparison is not a number");
    return false;
  }
  if (value.raw >= 0) {
    Instruction& load = code_.instructions[static_cast<std::size_t>(value.raw)];
    if (load.op == Ins::Constant) load.value = 0;
    load.op = computed(load.op);
    value.raw = -1;
  }
  return true;
}

std::optional<std::uint32_t> ExpressionReader::number() {
  const auto first = static_cast<std::uint32_t>(code_.instructions.size());
  s_.blanks();
  const std::uint32_t at = s_.offset();
  auto value = expression();
  if (!value) return std::nullopt;
  if (!is_number(*value))
    return refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  return finish(first, at);
}

std::optional<std::uint32_t> ExpressionReader::word_value(char address) {
  address_ = address;
  const auto first = static_cast<std::uint32_t>(code_.instructions.size());
  s_.blanks();
  const std::uint32_t at = s_.offset();
  const bool negative = s_.take('-');
  if (!negative) s_.take('+');
  const bool variable = s_.peek() == '#';
  if (const auto wrong =
          code_.lacks(variable ? StatementKind::Variables : StatementKind::Brackets, at))
    return refuse(wrong->cause, at, wrong->detail);
  auto value = variable ? variable_value() : bracket();
  if (!value) return std::nullopt;
  if (!is_number(*value))
    return refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative)
    emit(Ins::Negate, at);  // of a vacant variable it stays vacant: X-#1 is no word then
  return finish(first, at);
}

std::optional<std::uint32_t> ExpressionReader::condition() {
  const auto first = static_cast<std::uint32_t>(code_.instructions.size());
  s_.blanks();
  const std::uint32_t at = s_.offset();
  const bool bare = code_.control->conditions_without_brackets.value;
  if (!bare && s_.peek() != '[')
    return refuse(Cause::ExpressionFormat, at, "a condition stands in brackets");
  auto value = bare ? expression() : bracket();
  if (!value) return std::nullopt;
  const int most = code_.control->max_condition_length.value;
  if (most > 0 && s_.offset() - at > static_cast<std::uint32_t>(most))
    return refuse(Cause::ExpressionFormat, at,
                  "a condition has at most " + std::to_string(most) + " characters");
  const bool any = bare || code_.control->conditions_are_values.value;
  if (any && value->type == Type::Number) {  // WHILE TRUE
    arithmetic(*value);
    value->type = Type::Condition;
  }
  if (value->type != Type::Condition)
    return refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return finish(first, at);
}

std::optional<ExpressionReader::Variable> ExpressionReader::variable() {
  const std::uint32_t at = s_.offset();
  const char c = s_.peek();
  if (c == '[') {
    const auto first = static_cast<std::uint32_t>(code_.instructions.size());
    auto inner = bracket();
    if (!inner || !arithmetic(*inner)) return std::nullopt;
    return Variable{-1, finish(first, at)};
  }
  if (!is_digit(c))
    return refuse(Cause::ExpressionFormat, at,
                  "behind # stands a number, or an expression in brackets");
  const Number number = scan_number(s_);
  const bool behind = number.points == 1 && number.decimals == 0 && number.any;
  const bool whole = number.points == 0 || (behind && code_.control->variable_point.value);
  if (!whole || number.digits > 9)
    return refuse(Cause::IllegalVariable, at, "a variable number is a whole number");
  return Variable{to_whole<std::int64_t>(number.value), 0};
}

std::optional<ExpressionReader::Value> ExpressionReader::variable_value() {
  s_.blanks();
  const std::uint32_t at = s_.offset();
  s_.take('#');
  const char c = s_.peek();
  if (!grow()) return std::nullopt;
  if (c == '[') {
    auto inner = bracket();
    if (!inner) return std::nullopt;
    if (!arithmetic(*inner)) return std::nullopt;
    --depth_;
    emit(Ins::IndirectRaw, at);
  } else if (is_letter(c) || c == '_') {
    if (!code_.control->variable_names.value)
      return refuse(Cause::ExpressionFormat, at,
                    "behind # stands a number, or an expression in brackets");
    code_.names.push_back(s_.take_name());
    emit(Ins::Named, at, static_cast<double>(code_.names.size() - 1));
    emit(Ins::IndirectRaw, at);
  } else {
    const auto written = variable();
    if (!written) return std::nullopt;
    std::int64_t number = written->number;
    const bool indirect = code_.control->indirect_9nnn.value && number >= 9000 && number <= 9999;
    if (indirect) number -= 9000;
    const VariablePlace place = code_.place(number);
    const bool known = place.range != nullptr;
    Ins op = Ins::VariableRaw;
    std::uint32_t where = at;
    if (known && place.kind == VariableKind::Vacant) {
      op = Ins::Constant;
    } else if (known && place.kind == VariableKind::Local) {
      op = Ins::LocalRaw;
      where = static_cast<std::uint32_t>(place.index);
    } else if (known && (place.kind == VariableKind::Common || place.kind == VariableKind::Kept)) {
      op = Ins::CommonRaw;
      where = static_cast<std::uint32_t>(place.index);
    }
    emit(op, where, op == Ins::Constant ? kVacant : static_cast<double>(number));
    if (indirect) {
      Value inner{Type::Number, static_cast<std::int64_t>(code_.instructions.size()) - 1};
      arithmetic(inner);
      emit(Ins::IndirectRaw, at);
    }
  }
  return Value{Type::Number, static_cast<std::int64_t>(code_.instructions.size()) - 1};
}

bool ExpressionReader::open() {
  s_.blanks();
  const std::uint32_t at = s_.offset();
  if (!s_.take('[')) {
    refuse(Cause::BracketNotOpened, at, "an opening bracket is missing here");
    return false;
  }
  ++brackets_;
  const int most = std::min(code_.control->max_brackets.value, kMostInside);
  if (brackets_ > most) {
    refuse(Cause::BracketsTooDeep, at,
           "more than " + std::to_string(most) + " brackets inside each other");
    return false;
  }
  return true;
}

bool ExpressionReader::close() {
  const char c = s_.peek();
  if (c != ']') {
    if (c == '\0')
      refuse(Cause::BracketNotClosed, s_.offset(), "a closing bracket is missing");
    else
      refuse(Cause::ExpressionFormat, s_.offset(),
             "an operator or a closing bracket is missing here");
    return false;
  }
  ++s_.at;
  --brackets_;
  return true;
}

bool ExpressionReader::comma() {
  if (s_.take(',')) return true;
  refuse(Cause::MissingComma, s_.offset(), "the function takes two arguments");
  return false;
}

std::optional<ExpressionReader::Value> ExpressionReader::bracket() {
  if (!open()) return std::nullopt;
  const auto inner = expression();
  if (!inner || !close()) return std::nullopt;
  return inner;
}

std::optional<ExpressionReader::Value> ExpressionReader::operand() {
  const char c = s_.peek();
  const std::uint32_t at = s_.offset();
  if (c == '#') return variable_value();
  if (c == '[') return bracket();
  if (c == '-' || c == '+') {
    ++s_.at;
    const char next = s_.peek();
    if (next == '-' || next == '+')
      return refuse(Cause::ExpressionFormat, s_.offset(), "two signs in a row");
    auto value = operand();
    if (!value || !arithmetic(*value)) return std::nullopt;
    if (c == '-') emit(Ins::Negate, at);
    return value;
  }
  if (is_digit(c) || c == '.') {
    const Number number = scan_number(s_);
    if (number.points > 1)
      return refuse(Cause::IllegalDecimalPoint, at, "two points in one number");
    if (!number.any) return refuse(Cause::ExpressionFormat, at, "a point is no number");
    const int most = code_.control->max_constant_digits.value;
    if (number.digits > static_cast<std::uint32_t>(most))
      return refuse(Cause::TooManyDigits, at,
                    "a number has at most " + std::to_string(most) + " digits");
    if (!grow()) return std::nullopt;
    emit(Ins::Constant, at, number.value);
    return Value{};
  }
  if (is_letter(c)) return function();
  if (c == ']')
    return refuse(brackets_ > 0 ? Cause::ExpressionFormat : Cause::BracketNotOpened, at,
                  "a value is missing before the bracket");
  if (c == '\0')
    return refuse(brackets_ > 0 ? Cause::BracketNotClosed : Cause::ExpressionFormat, at,
                  "a value is missing at the end");
  return refuse(Cause::ExpressionFormat, at, "a value is missing here");
}

std::optional<ExpressionReader::Value> ExpressionReader::function() {
  const std::uint32_t at = s_.offset();
  std::string word;
  while (is_letter(s_.peek()) || (word == "ATAN" && s_.peek() == '2')) {
    word += s_.peek();
    ++s_.at;
    if (word.size() > 8) break;
  }
  const Codes& known = code_.control->functions.value;
  if ((word == "PI" || word == "TRUE" || word == "FALSE") && listed(known, word)) {
    if (!grow()) return std::nullopt;
    emit(Ins::Constant, at, word == "PI" ? 3.14159265358979323846 : word == "TRUE" ? 1.0 : 0.0);
    return Value{};
  }
  if (word == "NOT" && code_.control->conditions_without_brackets.value) {
    if (++nots_ > kMostInside) return refuse(Cause::ExpressionFormat, at, "too many NOT in a row");
    auto value = operand();
    if (!value) return std::nullopt;
    --nots_;
    if (value->type != Type::Condition)
      return refuse(Cause::ExpressionFormat, at, "NOT takes a condition");
    emit(Ins::Not, at);
    return value;
  }
  const FunctionName* found = find_function(*code_.control, word);
  if (found == nullptr)
    return refuse(Cause::ExpressionFormat, at, word + " is no function of this control");
  if (found->op == Ins::Atan && !listed(known, "ATAN2")) return arc_tangent(at);
  if (found->op ==
      Ins::Programmed) {  // AR[#23]: how the word was programmed, so the variable itself counts
    if (!open() || s_.peek() != '#')
      return refuse(Cause::ExpressionFormat, at, "AR takes a variable");
    s_.take('#');
    const auto target = variable();
    if (!target || target->number < 0)
      return refuse(Cause::ExpressionFormat, at, "AR takes a variable");
    if (!close() || !grow()) return std::nullopt;
    emit(Ins::Programmed, at, static_cast<double>(target->number));
    return Value{};
  }
  if (!open()) return std::nullopt;
  auto value = expression();
  if (!value || !arithmetic(*value)) return std::nullopt;
  Ins op = found->op;
  if (op == Ins::Pow || op == Ins::Atan2 || op == Ins::RandomBetween ||
      (op == Ins::Parameter && s_.peek() == ',')) {
    if (!comma()) return std::nullopt;
    auto second = expression();
    if (!second || !arithmetic(*second)) return std::nullopt;
    --depth_;
    if (op == Ins::Parameter) emit(Ins::Modulo, at, -1);  // marks the bit form
  }
  if (!close()) return std::nullopt;
  if (op == Ins::Round && address_ != 0) op = Ins::RoundWord;
  emit(op, at);
  return Value{};
}

/// ATAN[a]/[b], ATAN[a,b] and ATAN[a].
std::optional<ExpressionReader::Value> ExpressionReader::arc_tangent(std::uint32_t at) {
  if (!open()) return std::nullopt;
  auto first = expression();
  if (!first || !arithmetic(*first)) return std::nullopt;
  bool two = false;
  if (s_.take(',')) {
    auto second = expression();
    if (!second || !arithmetic(*second) || !close()) return std::nullopt;
    two = true;
  } else {
    if (!close()) return std::nullopt;
    Scanner ahead = s_;
    if (ahead.take('/') && ahead.peek() == '[') {
      s_ = ahead;
      auto second = bracket();
      if (!second || !arithmetic(*second)) return std::nullopt;
      two = true;
    }
  }
  if (two) --depth_;
  emit(two ? Ins::Atan2 : Ins::Atan, at);
  return Value{};
}

/// Whether a condition stands behind this logic operator: `AND #2 EQ 4` or `AND [#2 EQ 4]`, not
/// `AND 3`. Looks as far as the next one.
bool ExpressionReader::condition_behind(std::string_view logic) const {
  static constexpr std::string_view kComparisons[] = {"EQ", "NE", "GT", "LT", "GE", "LE"};
  Scanner s = s_;
  if (!s.take_word(logic)) return false;
  const char first = s.peek();
  int depth = 0, deepest = 0;
  bool value = false;  // the value of an operand has ended: an operator follows
  for (char c = first; c != '\0'; c = s.peek()) {
    if (c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']') {
      if (depth-- == 0) return false;
    } else if (is_letter(c) && value) {
      for (const std::string_view comparison : kComparisons) {
        Scanner t = s;
        const bool own = depth == 0 || (first == '[' && depth == 1 && deepest == 1);
        if (t.take_word(comparison) && own) return true;
      }
      Scanner t = s;
      if (depth == 0 && !t.take_word("MOD")) return false;
      while (is_letter(s.peek())) ++s.at;
      value = false;
      continue;
    } else if ((c == '<' || c == '>' || c == '=') && (depth == 0 || (first == '[' && depth == 1))) {
      return true;
    }
    value = c == ']' || is_digit(c) || c == '.';
    if (is_letter(c)) {  // a function's name
      while (is_letter(s.peek())) ++s.at;
      continue;
    }
    ++s.at;
  }
  return false;
}

/// Takes the operator that stands here if it binds at this level. Level 0 binds weakest. Where
/// logic of numbers binds first, it counts whether the value before is a number, and whether it is
/// the right side of a comparison: `#1EQ3AND#2EQ4` joins two, `3EQ#1AND3` is one.
std::optional<Ins> ExpressionReader::take_operator(int level, bool of_number, bool compared) {
  struct Word {
    std::string_view text;
    Ins op;
    int high, low;  // the level where logic binds like arithmetic, and where it binds last
  };
  static constexpr Word kWords[] = {{"AND", Ins::And, 2, 0},         {"XOR", Ins::Xor, 1, 0},
                                    {"MOD", Ins::Modulo, 2, 3},      {"OR", Ins::Or, 1, 0},
                                    {"EQ", Ins::Equal, 0, 1},        {"NE", Ins::NotEqual, 0, 1},
                                    {"GT", Ins::Greater, 0, 1},      {"LT", Ins::Less, 0, 1},
                                    {"GE", Ins::GreaterEqual, 0, 1}, {"LE", Ins::LessEqual, 0, 1}};
  static constexpr Word kSymbols[] = {{"==", Ins::Equal, 0, 1},        {"<>", Ins::NotEqual, 0, 1},
                                      {">=", Ins::GreaterEqual, 0, 1}, {"<=", Ins::LessEqual, 0, 1},
                                      {">", Ins::Greater, 0, 1},       {"<", Ins::Less, 0, 1}};
  const bool last = code_.control->logic_binds_last.value;
  const char c = s_.peek();
  const auto binds = [&](int high, int low) { return (last ? low : high) == level; };
  if (c == '+' || c == '-') {
    if (!binds(1, 2)) return std::nullopt;
    ++s_.at;
    return c == '+' ? Ins::Add : Ins::Subtract;
  }
  if (c == '*' || c == '/') {
    if (!binds(2, 3)) return std::nullopt;
    ++s_.at;
    return c == '*' ? Ins::Multiply : Ins::Divide;
  }
  if (is_letter(c)) {
    for (const Word& word : kWords) {
      if (word.text[0] != c) continue;
      const bool logic = last && word.low == 0;
      const bool of_numbers =
          logic && of_number && level == word.high + 1 && code_.control->logic_of_numbers.value;
      if (!binds(word.high, word.low) && !of_numbers) continue;
      if (of_numbers && compared && condition_behind(word.text)) continue;
      if (word.op == Ins::Modulo && !code_.control->modulo.value) continue;
      if (s_.take_word(word.text)) return word.op;
    }
  } else if (code_.control->comparison_symbols.value) {
    for (const Word& word : kSymbols)
      if (binds(word.high, word.low) && s_.take_word(word.text)) return word.op;
  }
  return std::nullopt;
}

std::optional<ExpressionReader::Value> ExpressionReader::apply(Ins op, std::uint32_t at, Value left,
                                                               Value right) {
  --depth_;
  const bool comparison = op >= Ins::Equal && op <= Ins::LessEqual;
  if (comparison) {
    const bool tells = code_.control->vacant_comparison.value == VacantComparison::Distinguished &&
                       (op == Ins::Equal || op == Ins::NotEqual);
    if (!is_number(left) || !is_number(right))
      return refuse(Cause::ExpressionFormat, at, "a comparison compares two values");
    if (!tells && (!arithmetic(left) || !arithmetic(right))) return std::nullopt;
    emit(op, at);
    return Value{Type::Condition, -1};
  }
  const bool logic = op == Ins::And || op == Ins::Or || op == Ins::Xor;
  if (logic && left.type == Type::Condition && right.type == Type::Condition) {
    if (!code_.control->joined_conditions.value)
      return refuse(Cause::IfFormat, at, "conditions cannot be joined on this control");
    emit(op == Ins::And ? Ins::BothTrue : op == Ins::Or ? Ins::EitherTrue : Ins::OneTrue, at);
    return Value{Type::Condition, -1};
  }
  if (!arithmetic(left) || !arithmetic(right)) return std::nullopt;
  Instruction& last = code_.instructions.back();
  const bool divides = op == Ins::Divide && last.value != 0;
  if (last.op == Ins::Constant &&
      (op == Ins::Add || op == Ins::Subtract || op == Ins::Multiply || divides)) {
    last.op = op == Ins::Add        ? Ins::AddConstant
              : op == Ins::Subtract ? Ins::SubtractConstant
              : op == Ins::Multiply ? Ins::MultiplyConstant
                                    : Ins::DivideConstant;
    last.at = at;
    return Value{};
  }
  emit(op, at);
  return Value{};
}

std::optional<ExpressionReader::Value> ExpressionReader::expression() {
  struct Waiting {  // for its right value
    Value left;
    Ins op;
    std::uint32_t at;
    int level;
  };
  std::array<Waiting, kTightest + 1> waiting{};  // looser ones first
  std::size_t count = 0;
  const auto compared = [&] {
    return std::any_of(waiting.begin(), waiting.begin() + count, [](const Waiting& left) {
      return left.op >= Ins::Equal && left.op <= Ins::LessEqual;
    });
  };
  const int tightest = code_.control->logic_binds_last.value ? kTightest : kTightest - 1;
  auto value = operand();
  for (int level = tightest; value;) {
    if (count > 0 && waiting[count - 1].level == level) {
      const Waiting& left = waiting[--count];
      value = apply(left.op, left.at, left.left, *value);
      if (!value) return std::nullopt;
    }
    const std::uint32_t at = (s_.blanks(), s_.offset());
    if (const auto op = take_operator(level, value->type == Type::Number, compared())) {
      waiting[count++] = {*value, *op, at, level};
      value = operand();
      level = tightest;
    } else if (level-- == 0) {
      return value;
    }
  }
  return std::nullopt;
}

}  // namespace cncsub
