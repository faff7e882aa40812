// Operators, and the values of whole expressions.
#include "cncsub/dialect/sinumerik/expression.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"

namespace cncsub::sinumerik {

namespace {

// The precedence falls from products to comparisons; NOT, B_NOT and signs belong to the operand.
// [SONE p.444, priority of the operations]
constexpr OperatorRow kRows[] = {{"*", 9, Ins::Multiply},        {"/", 9, Ins::Divide},
                                 {":", 9, Ins::ChainFrames},     {"DIV", 9, Ins::Divide, Ins::Fix},
                                 {"MOD", 9, Ins::Modulo},        {"+", 8, Ins::Add},
                                 {"-", 8, Ins::Subtract},        {"B_AND", 7, Ins::And},
                                 {"B_XOR", 6, Ins::Xor},         {"B_OR", 5, Ins::Or},
                                 {"AND", 4, Ins::BothTrue},      {"XOR", 3, Ins::OneTrue},
                                 {"OR", 2, Ins::EitherTrue},     {"<<", 1, Ins::JoinTexts},
                                 {"==", 0, Ins::AlikeEqual},     {"<>", 0, Ins::AlikeNotEqual},
                                 {"<=", 0, Ins::AlikeLessEqual}, {">=", 0, Ins::AlikeGreaterEqual},
                                 {"<", 0, Ins::AlikeLess},       {">", 0, Ins::AlikeGreater}};

bool compares(const OperatorRow& of) {
  return of.op >= Ins::AlikeEqual && of.op <= Ins::AlikeLessEqual;
}
bool is_whole(Type type) { return type == Type::Int || type == Type::Char || type == Type::Bool; }

/// Return the type of what an operator makes of two numbers.
Type type_of(const OperatorRow& of, Type left, Type right) {
  if (compares(of)) return Type::Bool;
  switch (of.op) {
    case Ins::BothTrue:
    case Ins::OneTrue:
    case Ins::EitherTrue:
      return Type::Bool;
    case Ins::And:
    case Ins::Or:
    case Ins::Xor:
      return Type::Int;
    case Ins::Divide:
      return Type::Real;
    default:
      return is_whole(left) && is_whole(right) ? Type::Int : Type::Real;
  }
}

/// The reader of the values of one expression.
class OperatorReader {
 public:
  using Value = Read;
  using Operator = OperatorRow;

  OperatorReader(OpenExpression& open, int depth) : open_(open), depth_(depth) {}

  Read operand() { return read_operand(open_, depth_); }
  const OperatorRow* next_operator() const {
    const std::string name = capitals(open_.line.name());
    const std::string_view rest =
        open_.line.peek() == '\0' ? std::string_view() : open_.line.rest();
    for (const OperatorRow& of : kOperators)
      if (is_letter(of.spelling[0]) ? name == of.spelling : rest.starts_with(of.spelling))
        return &of;
    return nullptr;
  }
  template <class Left>
  int level_of(const OperatorRow& of, Read /*value*/, const Left& /*left*/) const {
    return of.level;
  }
  std::uint32_t offset() const { return open_.line.offset(); }
  void pass(const OperatorRow& of) { open_.line.pass(of.spelling.size()); }

  Read apply(const OperatorRow& of, std::uint32_t at, Read left, Read right) {
    open_.constant.reset();
    if (!left || !right) return std::nullopt;
    if (of.op == Ins::JoinTexts) return join(*left, *right, at);
    if (of.op == Ins::ChainFrames || *left == Type::Frame || *right == Type::Frame)
      return chain(of, *left, *right, at);
    const bool texts = *left == Type::String || *right == Type::String;
    const bool axes = *left == Type::Axis || *right == Type::Axis;
    if (texts || (axes && *left != *right)) return compare_texts(of, *left, *right, at);
    if (axes && !compares(of)) return refuse("an axis is no number", at);
    open_.emit_at(at, of.op);
    if (of.other != Ins::End) open_.emit_at(at, of.other);
    return type_of(of, *left, *right);
  }

 private:
  Read refuse(const char* why, std::uint32_t at) {
    open_.wrong(Cause::TypeMismatch, why, at);
    return std::nullopt;
  }
  Read join(Type left, Type right, std::uint32_t at) {
    if (left == Type::Frame || right == Type::Frame) return refuse("a frame is no text", at);
    open_.emit_at(at, Ins::JoinTexts,
                  static_cast<int>(written_as(left)) * 16 + static_cast<int>(written_as(right)));
    return Type::String;
  }
  Read chain(const OperatorRow& of, Type left, Type right, std::uint32_t at) {
    if (of.op != Ins::ChainFrames || left != Type::Frame || right != Type::Frame)
      return refuse(of.op == Ins::ChainFrames ? ": chains two frames" : "a frame is no number", at);
    open_.to.expressions().emit({of.op, 0, at, 0});
    return Type::Frame;
  }
  /// Compare two texts, or a text with a character.
  Read compare_texts(const OperatorRow& of, Type left, Type right, std::uint32_t at) {
    if (!compares(of)) return refuse("a text is no number: NUMBER makes one of it", at);
    if (of.op != Ins::AlikeEqual && of.op != Ins::AlikeNotEqual) {
      open_.not_computed("which of two texts comes first", at);
      return std::nullopt;
    }
    if (left == Type::Char) open_.emit_at(at, Ins::OnlyCharacter);
    if (right == Type::Char) convert_to_text(open_, Type::Char);
    const auto fits = [](Type type) { return type == Type::String || type == Type::Char; };
    if (!fits(left) || !fits(right)) return refuse("a text is compared with a text", at);
    open_.emit_at(at, exact(of.op));
    return Type::Bool;
  }

  OpenExpression& open_;
  int depth_;
};

}  // namespace

const std::span<const OperatorRow> kOperators = kRows;

bool OpenExpression::wrong(Cause cause, std::string detail, std::uint32_t at) {
  fault =
      Fault{.cause = cause, .at = at, .width = line.width_from(at), .detail = std::move(detail)};
  return false;
}

bool OpenExpression::not_computed(std::string_view what, std::uint32_t at) {
  return wrong(Cause::CodeNotComputed, "cncsub does not compute " + std::string(what), at);
}

Read read_value(OpenExpression& open, int depth) {
  OperatorReader values(open, depth);
  return read_operators(values);
}

void ExpressionReader::begin_block() {
  open_.assigned.clear();
  open_.assigned_any = false;
  fault.reset();
}

bool ExpressionReader::finish(Value& value, std::uint32_t at) {
  value = open_.to.expressions().end_value(open_.constant, at, open_.line.width_from(at));
  return true;
}

bool ExpressionReader::number(Value& value) {
  const std::uint32_t at = open_.line.offset();
  const bool minus = open_.line.take('-');
  if (!minus) open_.line.take('+');
  double number = 0;
  if (!take_number(open_, number)) return false;
  value = {false, minus ? -number : number, 0, at, open_.line.width_from(at)};
  return true;
}

bool ExpressionReader::value_of_any(Value& value, Type& type) {
  const std::uint32_t at = open_.line.offset();
  open_.to.expressions().begin();
  const Read read = read_value(open_, 0);
  if (read) type = *read;
  return read && finish(value, at);
}

bool ExpressionReader::value(Value& value) {
  const std::uint32_t at = open_.line.offset();
  open_.to.expressions().begin();
  const Read read = read_value(open_, 0);
  if (!read) return false;
  if (!is_number(*read)) return open_.wrong(Cause::TypeMismatch, no_number(*read), at);
  return finish(value, at);
}

bool ExpressionReader::indexing_axis(bool opens) {
  const std::uint32_t at = open_.line.offset();
  if (opens) open_.to.expressions().begin();
  const Read read = read_value(open_, 0);
  return read && (read == Type::Axis ||
                  open_.wrong(Cause::TypeMismatch, "AX has the name of an axis in brackets", at));
}

bool ExpressionReader::value_of_axis(int axis, bool opens) {
  const std::uint32_t at = open_.line.offset();
  const Read read = read_value(open_, 0);
  if (!read) return false;
  if (read == Type::String || read == Type::Axis)
    return open_.wrong(Cause::TypeMismatch, "the value of an axis is a number", at);
  open_.emit(Ins::OnlyOfAxis, axis);
  if (!opens) open_.emit(Ins::FirstSet);
  open_.constant.reset();
  return true;
}

Value ExpressionReader::indexed_value(std::uint32_t at) {
  Value value;
  finish(value, at);
  return value;
}

bool ExpressionReader::text(Value& value) {
  const std::uint32_t at = open_.line.offset();
  open_.to.expressions().begin();
  const Read read = read_value(open_, 0);
  if (!read) return false;
  if (*read == Type::Frame) return open_.wrong(Cause::TypeMismatch, "a frame is no text", at);
  convert_to_text(open_, *read);
  return finish(value, at);
}

bool ExpressionReader::value_of(const Definition& of, Value& value) {
  const std::uint32_t at = open_.line.offset();
  open_.to.expressions().begin();
  const Read read = read_value(open_, 0);
  return read && convert(open_, *read, of, at) && finish(value, at);
}

bool ExpressionReader::condition(std::uint32_t& expression, bool otherwise) {
  const std::uint32_t at = open_.line.offset();
  open_.to.expressions().begin();
  const Read read = read_value(open_, 0);
  if (!read) return false;
  if (*read == Type::Frame) return open_.wrong(Cause::TypeMismatch, no_number(*read), at);
  if (otherwise) open_.emit(Ins::Not);
  expression = open_.to.expressions().end(at, open_.line.width_from(at));
  return true;
}

namespace {

/// Return how the text of a program defined a variable.
Definition definition_of(const DefinedVariable& of) {
  static constexpr std::pair<DefinedVariable::Type, Type> kTypes[] = {
      {DefinedVariable::Type::Real, Type::Real},   {DefinedVariable::Type::Int, Type::Int},
      {DefinedVariable::Type::Bool, Type::Bool},   {DefinedVariable::Type::Char, Type::Char},
      {DefinedVariable::Type::Text, Type::String}, {DefinedVariable::Type::Axis, Type::Axis},
      {DefinedVariable::Type::Frame, Type::Frame}};
  Definition definition;
  for (const auto& [shown, type] : kTypes)
    if (shown == of.type) definition.type = type;
  definition.global = of.common;
  definition.local = of.index;
  definition.reference = of.reference;
  definition.dimensions = std::min(of.extents.size(), Definition::kMostDimensions);
  std::copy_n(of.extents.begin(), definition.dimensions, definition.extents.begin());
  return definition;
}

/// Return the variables that a program may name.
Definitions definitions_of(const Code& code, std::int32_t program) {
  Definitions all;
  const Program& of = code.programs[static_cast<std::size_t>(program)];
  for (std::uint32_t i = 0; i < of.defined; ++i) {
    const DefinedVariable& variable = code.defined_variables[of.first_defined + i];
    all.add(variable.name, definition_of(variable));
  }
  for (const DefinedVariable& variable : code.shared_variables)
    all.add(variable.name, definition_of(variable));
  return all;
}

}  // namespace

}  // namespace cncsub::sinumerik

namespace cncsub {

std::optional<Fault> sinumerik_expression(Builder& to, const ExpressionText& text,
                                          std::uint32_t& expression, ValueType& value_type) {
  const sinumerik::Definitions definitions = sinumerik::definitions_of(to.code(), text.program);
  sinumerik::Line line;
  line.set(text.text, text.at);
  sinumerik::ExpressionReader reader(to, line, definitions);
  reader.stand_alone();
  sinumerik::Value value;
  auto type = sinumerik::Type::Real;
  if (!reader.value_of_any(value, type)) return reader.fault;
  if (!line.at_end())
    return Fault{Cause::ExpressionFormat, line.offset(), 1, "the expression ends before this"};
  value_type = type == sinumerik::Type::String  ? ValueType::Text
               : type == sinumerik::Type::Axis  ? ValueType::Axis
               : type == sinumerik::Type::Frame ? ValueType::Frame
                                                : ValueType::Number;
  expression = to.expressions().expression_of(value);
  return std::nullopt;
}

}  // namespace cncsub
