// The functions of expressions: SIN[30], ATAN[1]/[2], PRM[6001, 5], and words that are values.
#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

struct FunctionName {
  Function function;
  Ins one, two = Ins::End;  // of one argument, of two; End: it does not take so many
};

namespace {

constexpr int kMostNots = 64;  // before one condition: they are read inside each other

constexpr FunctionName kFunctions[] = {{Function::Sin, Ins::Sin},
                                       {Function::Cos, Ins::Cos},
                                       {Function::Tan, Ins::Tan},
                                       {Function::Asin, Ins::Asin},
                                       {Function::Acos, Ins::Acos},
                                       {Function::Atan, Ins::Atan},
                                       {Function::Atan2, Ins::End, Ins::Atan2},
                                       {Function::Sqrt, Ins::Sqrt},
                                       {Function::Sqr, Ins::Sqrt},
                                       {Function::Abs, Ins::Abs},
                                       {Function::Round, Ins::Round},
                                       {Function::Rnd, Ins::Round},
                                       {Function::Fix, Ins::Fix},
                                       {Function::Int, Ins::Fix},
                                       {Function::Fup, Ins::Fup},
                                       {Function::Ln, Ins::Ln},
                                       {Function::Exp, Ins::Exp},
                                       {Function::Pow, Ins::End, Ins::Pow},
                                       {Function::Bin, Ins::Bin},
                                       {Function::Bcd, Ins::Bcd},
                                       {Function::Adp, Ins::Adp},
                                       {Function::Prm, Ins::Parameter, Ins::ParameterBit},
                                       {Function::Sign, Ins::Sign},
                                       {Function::Rand, Ins::Random},
                                       {Function::Srand, Ins::End, Ins::RandomBetween},
                                       {Function::Ar, Ins::Programmed}};

struct ConstantName {
  Function word;
  double value;
};
constexpr ConstantName kConstants[] = {
    {Function::Pi, 3.14159265358979323846}, {Function::True, 1}, {Function::False, 0}};

/// The function of this name, or of the name that it abbreviates.
const FunctionName* find_function(const Code& code, std::string_view word) {
  for (const FunctionName& f : kFunctions)
    if (name_of(f.function) == word && has_function(code, f.function)) return &f;
  if (!code.control->macros.short_functions.value || word.size() < 2) return nullptr;
  for (const FunctionName& f : kFunctions)
    if (name_of(f.function).starts_with(word) && has_function(code, f.function)) return &f;
  return nullptr;
}

}  // namespace

bool has_function(const Code& code, Function function) {
  return code.control->macros.functions.value.has(function);
}

std::optional<Value> ExpressionReader::word() {
  const std::uint32_t at = s_.offset();
  std::string word;
  while (is_letter(s_.peek()) || (word == "ATAN" && s_.peek() == '2')) {
    word += s_.peek();
    ++s_.at;
    if (word.size() > 8) break;
  }
  for (const ConstantName& of : kConstants) {
    if (word != name_of(of.word) || !has_function(code_, of.word)) continue;
    if (!out_.has_room(s_.offset())) return std::nullopt;
    out_.emit(Ins::Constant, at, of.value);
    return Value{};
  }
  if (word == "NOT" && code_.control->macros.conditions.value.has(Condition::Bare))
    return negated(at);
  const FunctionName* found = find_function(code_, word);
  if (found == nullptr)
    return out_.refuse(Cause::ExpressionFormat, at, word + " is no function of this control");
  if (found->one == Ins::Atan && !has_function(code_, Function::Atan2)) return arc_tangent(at);
  if (found->one == Ins::Programmed) return programmed(at);
  return function(*found, at);
}

std::optional<Value> ExpressionReader::function(const FunctionName& of, std::uint32_t at) {
  if (!open() || !argument()) return std::nullopt;
  const bool two = of.one == Ins::End || (of.two != Ins::End && s_.peek() == ',');
  if (two && !s_.take(','))
    return out_.refuse(Cause::MissingComma, s_.offset(), "the function takes two arguments");
  if (two && !argument()) return std::nullopt;
  if (!close()) return std::nullopt;
  Ins op = two ? of.two : of.one;
  if (op == Ins::Round && out_.in_word()) op = Ins::RoundWord;
  out_.emit(op, at);
  return Value{};
}

bool ExpressionReader::argument() {
  auto value = expression();
  return value && out_.arithmetic(*value, s_.offset());
}

/// ATAN[a]/[b], ATAN[a,b] and ATAN[a].
std::optional<Value> ExpressionReader::arc_tangent(std::uint32_t at) {
  if (!open() || !argument()) return std::nullopt;
  bool two = s_.take(',');
  if (two && !argument()) return std::nullopt;
  if (!close()) return std::nullopt;
  Scanner ahead = s_;
  if (!two && ahead.take('/') && ahead.peek() == '[') {
    s_ = ahead;
    auto second = bracket();
    if (!second || !out_.arithmetic(*second, s_.offset())) return std::nullopt;
    two = true;
  }
  out_.emit(two ? Ins::Atan2 : Ins::Atan, at);
  return Value{};
}

/// AR[#23]: how the word was programmed, so the variable itself counts.
std::optional<Value> ExpressionReader::programmed(std::uint32_t at) {
  if (!open() || s_.peek() != '#')
    return out_.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  const std::uint32_t hash = s_.offset();
  s_.take('#');
  const auto target = variable(hash);
  if (!target || target->number < 0)
    return out_.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  if (!close() || !out_.has_room(s_.offset())) return std::nullopt;
  out_.emit(Ins::Programmed, at, static_cast<double>(target->number));
  return Value{};
}

/// NOT before a condition.
std::optional<Value> ExpressionReader::negated(std::uint32_t at) {
  if (++nots_ > kMostNots) return out_.refuse(Cause::ExpressionFormat, at, "too many NOT in a row");
  auto value = operand();
  if (!value) return std::nullopt;
  --nots_;
  if (value->type != Value::Type::Condition)
    return out_.refuse(Cause::ExpressionFormat, at, "NOT takes a condition");
  out_.emit(Ins::Not, at);
  return value;
}

}  // namespace cncsub
