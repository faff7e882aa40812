// The values of structured programs. Their expressions have round brackets and operators of their
// own, and a number is whole or real: 1/2 is 0, 1./2 is 0.5. What type a variable has is not known.
#include <string>

#include "cncsub/dialect/iso/structured_words.hpp"
#include "cncsub/dialect/iso/values.hpp"

namespace cncsub {

namespace {

// From the weakest to the tightest. [SYM, operators]
constexpr IsoOperator kOperators[] = {
    {{"<>", 3, Ins::NotEqual}, 0},     {{"<=", 5, Ins::LessEqual}, 0}, {{"<", 5, Ins::Less}, 0},
    {{">=", 5, Ins::GreaterEqual}, 0}, {{">", 5, Ins::Greater}, 0},    {{"=", 4, Ins::Equal}, 0},
    {{"&", 2, Ins::And}, 0},           {{"+", 6, Ins::Add}, 0},        {{"-", 6, Ins::Subtract}, 0},
    {{"*", 7, Ins::Multiply}, 0},      {{"/", 7, Ins::Divide}, 0},     {{"MOD", 7, Ins::Modulo}, 0},
    {{"AND", 2, Ins::And}, 0},         {{"XOR", 1, Ins::Xor}, 0},      {{"OR", 0, Ins::Or}, 0}};

/// The type of what a function gives.
enum class Gives : std::uint8_t { Whole, Real, AsArguments };

struct TypedFunction {
  std::string_view name;
  Ins op;
  int arguments;
  Gives gives;
};
constexpr TypedFunction kFunctions[] = {
    {"SIN", Ins::Sin, 1, Gives::Real},           {"COS", Ins::Cos, 1, Gives::Real},
    {"TAN", Ins::Tan, 1, Gives::Real},           {"ASIN", Ins::Asin, 1, Gives::Real},
    {"ACOS", Ins::Acos, 1, Gives::Real},         {"ATAN", Ins::Atan, 1, Gives::Real},
    {"ATAN2", Ins::Atan2, 2, Gives::Real},       {"SQRT", Ins::Sqrt, 1, Gives::Real},
    {"ABS", Ins::Abs, 1, Gives::Real},           {"LN", Ins::Ln, 1, Gives::Real},
    {"EXP", Ins::Exp, 1, Gives::Real},           {"POW", Ins::Raise, 2, Gives::Real},
    {"ROUND", Ins::Round, 1, Gives::Whole},      {"CEIL", Ins::Ceil, 1, Gives::Whole},
    {"FLOOR", Ins::Floor, 1, Gives::Whole},      {"SIGN", Ins::Sign, 1, Gives::Whole},
    {"MAX", Ins::Larger, 2, Gives::AsArguments}, {"MIN", Ins::Smaller, 2, Gives::AsArguments},
    {"RANDOM", Ins::Random, 0, Gives::Whole}};

constexpr double kLargestRandom = 32767;

Value typed(bool whole, bool real) {
  return real ? Value::real() : whole ? Value::whole() : Value::number();
}

}  // namespace

Value ValueReader::structured_operand(char first) {
  const std::uint32_t at = offset();
  if (first == '#') {
    ++s_.at;
    return with_type(other_variable(at), at);
  }
  if (is_digit(first) || first == '.') return typed_constant();
  if (first == '[') return bracket();
  if (is_letter(first)) return typed_function();
  if (first != '-' && first != '+') return no_operand();
  ++s_.at;
  const Value value = behind_sign(at);
  return !value || first == '+' ? value : typed_negation_of(value, at);
}

/// Read the value after a sign or NOT at `at`.
Value ValueReader::behind_sign(std::uint32_t at) {
  if (++nots_ > kMostNots)
    return out_.refuse(Cause::ExpressionFormat, at, "too many signs or NOT in a row");
  const Value value = one_operand();
  if (value) --nots_;
  return value;
}

/// Give a variable the type of the value that it has been assigned, where that is known. It is not
/// vacant then.
Value ValueReader::with_type(Value value, std::uint32_t at) {
  if (!value || rules_.types == nullptr) return value;
  std::int64_t number = 0;
  const char* c = s_.file + at + 1;
  for (; c < s_.at && is_digit(*c); ++c) number = number * 10 + (*c - '0');
  const auto found =
      c == s_.at ? rules_.types->find(number + rules_.base_of(at)) : rules_.types->end();
  if (found == rules_.types->end() || !out_.arithmetic(value, offset())) return value;
  return found->second ? Value::whole() : Value::real();
}

/// Write the minus sign at `at` before a value. A vacant variable stays vacant.
Value ValueReader::typed_negation_of(Value value, std::uint32_t at) {
  out_.emit(Ins::Negate, at);
  return value.is_variable() ? Value::number() : value;
}

Value ValueReader::typed_constant() {
  const char* const from = s_.at;
  if (!other_constant()) return {};
  const bool point = std::string_view(from, static_cast<std::size_t>(s_.at - from)).find('.') !=
                     std::string_view::npos;
  return point ? Value::real() : Value::whole();
}

/// Read the arguments of a function in their brackets; tell whether all are whole, or any is real.
bool ValueReader::typed_arguments(int count, bool& whole, bool& real) {
  if (!opens()) return false;
  for (int i = 0; i < count; ++i) {
    if (i > 0 && !take(',')) {
      out_.refuse(Cause::MissingComma, offset(), "the function must have two arguments");
      return false;
    }
    Value value = values();
    if (!value) return false;
    whole = whole && value.is_whole();
    real = real || value.is_real();
    if (!out_.arithmetic(value, offset())) return false;
  }
  gap();
  return closes();
}

/// Read a function, or NOT and the value whose bits it turns.
Value ValueReader::typed_function() {
  const std::uint32_t at = offset();
  const std::string word = name_of_word(s_);
  if (word == "NOT") {
    Value value = behind_sign(at);
    if (!value || !out_.arithmetic(value, offset())) return {};
    out_.emit(Ins::BitNot, at);
    return Value::whole();
  }
  if (is_not_computed(word))
    return out_.refuse(Cause::CodeNotComputed, at, "cncsub does not compute " + word);
  const auto listed = FunctionEntry::read(word);
  const bool lacking = listed && !rules_.has(*listed);
  for (const TypedFunction& of : kFunctions) {
    if (word != of.name || lacking) continue;
    const bool random = of.arguments == 0;
    bool whole = of.gives != Gives::Real, real = of.gives == Gives::Real;
    bool arguments_whole = true, argument_real = false;
    if (random) out_.emit(Ins::Constant, at, kLargestRandom);
    if (!typed_arguments(of.arguments, arguments_whole, argument_real)) return {};
    out_.emit(of.op, at);
    if (random) out_.emit(Ins::Round, at);
    if (of.gives == Gives::AsArguments) whole = arguments_whole, real = argument_real;
    return typed(whole, real);
  }
  return out_.refuse(Cause::ExpressionFormat, at, word + " is not a function of this control");
}

const IsoOperator* ValueReader::structured_operator() {
  for (const IsoOperator& of : kOperators) {
    const std::size_t width = of.spelling.size();
    if (static_cast<std::size_t>(s_.end - s_.at) < width ||
        !same_letters({s_.at, width}, of.spelling))
      continue;
    const char* const behind = s_.at + width;
    if (is_letter(of.spelling[0]) && behind != s_.end && (is_letter(*behind) || *behind == '_'))
      continue;
    behind_operator_ = behind;
    return &of;
  }
  return nullptr;
}

/// Join two values. A quotient of two whole numbers is whole, and MOD takes no others.
Value ValueReader::apply_typed(const IsoOperator& of, std::uint32_t at, Value left, Value right) {
  const bool whole = left.is_whole() && right.is_whole();
  const bool real = left.is_real() || right.is_real();
  if (of.compares())
    return compare(out_, of.op, at, left, right, offset()) ? Value::whole() : Value{};
  if (!out_.arithmetic(left, offset()) || !out_.arithmetic(right, offset())) return {};
  if (of.op == Ins::Modulo) {
    if (real) return out_.refuse(Cause::TypeMismatch, at, "MOD takes whole numbers only");
    // Where the types are not known the values decide: the rest of a division by a whole number is
    // whole where the other one is.
    if (!whole) out_.emit(Ins::WholeNumber, at);
    out_.emit(Ins::Modulo, at);
    if (!whole) out_.emit(Ins::WholeNumber, at);
    return Value::whole();
  }
  if (of.is_logic()) {
    out_.emit(of.op, at);
    return Value::whole();
  }
  if (of.op == Ins::Divide && !whole && !real)
    return out_.refuse(Cause::CodeNotComputed, at,
                       "whether both values are whole numbers, whose quotient is cut, is not "
                       "known: write a number with its point");
  out_.emit(of.op, at);
  if (of.op == Ins::Divide && whole) out_.emit(Ins::Fix, at);
  return typed(whole, real);
}

}  // namespace cncsub
