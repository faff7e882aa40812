#include "cncsub/code/parameters.hpp"

#include <span>
#include <string>
#include <utility>

namespace cncsub {

namespace {

using Type = DefinedVariable::Type;

bool is_given(const ActualParameter& of) { return of.operand.present(); }

Fault fault(const ActualParameter& at, Cause cause, std::string detail) {
  return {cause, at.operand.at, at.operand.width, std::move(detail)};
}

/// Return how a type is written.
std::string name_of(Type type) {
  switch (type) {
    case Type::Real:
      return "a REAL";
    case Type::Int:
      return "an INT";
    case Type::Bool:
      return "a BOOL";
    case Type::Char:
      return "a CHAR";
    case Type::Text:
      return "a STRING";
    case Type::Axis:
      return "an AXIS";
    case Type::Frame:
      break;
  }
  return "a FRAME";
}

/// Give a parameter that takes a character the code of the one in its text.
void as_character(const Texts& texts, const FormalParameter& formal, ActualParameter& actual) {
  if (formal.type != Type::Char || actual.type != Type::Text || formal.by_reference ||
      actual.operand.kind != Operand::Kind::Constant)
    return;
  const std::string& text = texts.at(to_whole<std::size_t>(actual.operand.value));
  if (text.size() != 1) return;
  actual.type = Type::Char;
  actual.operand.value = static_cast<unsigned char>(text[0]);
}

/// Return whether an array is one of the extents that a parameter declares.
bool fits(const FormalParameter& formal, const ActualParameter& actual) {
  if (formal.extents.size() != actual.extents.size()) return false;
  for (std::size_t i = 0; i < formal.extents.size(); ++i)
    if (formal.extents[i] > 0 && actual.extents[i] > 0 && formal.extents[i] != actual.extents[i])
      return false;
  return true;
}

/// Return whether a value can become one of the parameter's type: numbers change into each other.
/// What a parameter by reference stands for has the same type. [general knowledge]
bool can_become(const FormalParameter& formal, Type type) {
  if (formal.type == type) return true;
  const auto number = [](Type of) { return of <= Type::Char; };
  return !formal.by_reference && !formal.is_array() && number(formal.type) && number(type);
}

/// Return why a parameter does not take a value.
std::optional<Fault> refused(const FormalParameter& formal, const ActualParameter& actual) {
  const bool variable = actual.variable.target != Statement::Target::None;
  if (!fits(formal, actual))
    return fault(actual, Cause::ParameterDimension,
                 formal.is_array() ? "the parameter takes an array of its own dimensions"
                                   : "the parameter takes no array");
  if (formal.by_reference && !variable)
    return fault(actual, Cause::ParameterNoVariable,
                 "the parameter takes a variable, and stands for it");
  if (!can_become(formal, actual.type))
    return fault(actual, Cause::ParameterType,
                 "this is " + name_of(actual.type) + ", and the parameter " + name_of(formal.type));
  return std::nullopt;
}

void add_argument(Code& code, CallRecord& call, std::int32_t variable, const Operand& value) {
  Argument argument;
  argument.variable = variable;
  argument.operand = value;
  code.arguments.push_back(argument);
  ++call.arguments;
}

/// Pass one value, or the variable that a parameter stands for.
std::optional<Fault> pass(Code& code, CallRecord& call, const FormalParameter& formal,
                          ActualParameter& actual) {
  if (!is_given(actual)) {
    if (formal.by_reference || formal.is_array())
      return Fault{Cause::ParameterMissing, call.at, call.width,
                   "the call gives no variable for parameter " +
                       code.named_variables[code.named_at[0].at(formal.variable)].name};
    Operand value;
    value.kind = Operand::Kind::Constant;
    value.value = formal.otherwise;
    add_argument(code, call, formal.variable, value);
    return std::nullopt;
  }
  as_character(code.texts, formal, actual);
  if (auto wrong = refused(formal, actual)) return wrong;
  if (!formal.is_array()) add_argument(code, call, formal.variable, actual.operand);
  if (formal.reference >= 0)
    call.extras.make().references.push_back(
        {formal.reference, actual.variable, actual.extents, !formal.by_reference});
  return std::nullopt;
}

/// Pass whether the call gives a parameter, if some program asks.
void pass_given(Code& code, CallRecord& call, std::size_t parameter, bool given) {
  const auto found = code.hidden_locals.find(std::string(kGivenParameters));
  if (found == code.hidden_locals.end() || parameter >= kMostGivenParameters) return;
  Operand value;
  value.kind = Operand::Kind::Constant;
  value.value = given ? 1 : 0;
  add_argument(code, call, found->second + static_cast<std::int32_t>(parameter), value);
}

/// Return whether the first block of a program is refused: the call enters it, and it alarms there.
bool has_faulty_head(const Code& code, const Program& program) {
  return program.first < program.last && code.blocks[program.first].op == Op::Fault;
}

}  // namespace

std::optional<Fault> pass_parameters(Code& code, CallRecord& call, std::int32_t called) {
  CallExtras* const extras = call.extras.find();
  if (call.kind != CallKind::Named || extras == nullptr) return std::nullopt;
  if (call.arguments > 0) return std::nullopt;  // the reader has given each value its local
  if (!code.named_variables.empty()) call.locals = CallRecord::Locals::Own;
  std::vector<ActualParameter> given = std::exchange(extras->given, {});
  call.first_argument = static_cast<std::uint32_t>(code.arguments.size());
  std::span<const FormalParameter> formals;
  bool is_declared = called != kNoProgram;
  if (is_declared) {
    const Program& program = code.programs[static_cast<std::size_t>(called)];
    is_declared = !has_faulty_head(code, program);
    formals =
        std::span(code.formal_parameters).subspan(program.first_parameter, program.parameters);
  }
  for (std::size_t i = formals.size(); i < given.size(); ++i) {
    if (!is_given(given[i])) continue;
    if (is_declared)
      return fault(
          given[i], Cause::TooManyArguments,
          code.name_of(called) + " declares " + std::to_string(formals.size()) + " parameters");
    add_argument(code, call, 0, given[i].operand);  // what it reads is known, if nothing else
  }
  for (std::size_t i = 0; i < formals.size(); ++i) {
    ActualParameter none;
    none.operand.at = call.at;
    none.operand.width = call.width;
    ActualParameter& actual = i < given.size() ? given[i] : none;
    if (auto wrong = pass(code, call, formals[i], actual)) return wrong;
    pass_given(code, call, i, is_given(actual));
  }
  return std::nullopt;
}

}  // namespace cncsub
