#include "cncsub/code/parameters.hpp"

#include <span>
#include <string>
#include <utility>

namespace cncsub {

namespace {

bool is_given(const ActualParameter& of) { return of.is_text || of.operand.present(); }

Fault fault(const ActualParameter& at, Cause cause, std::string detail) {
  return {cause, at.operand.at, at.operand.width, std::move(detail)};
}

/// Give a parameter that takes a character the code of the one in its text.
void as_character(const Texts& texts, const FormalParameter& formal, ActualParameter& actual) {
  if (!formal.is_character || !actual.is_text || actual.operand.kind != Operand::Kind::Constant)
    return;
  const std::string& text = texts.at(to_whole<std::size_t>(actual.operand.value));
  if (text.size() != 1) return;
  actual.is_text = false;
  actual.operand.value = static_cast<unsigned char>(text[0]);
}

/// Return why a parameter does not take a value.
std::optional<Fault> refused(const FormalParameter& formal, const ActualParameter& actual) {
  if (actual.is_text != formal.is_text)
    return fault(actual, Cause::StatementFormat,
                 formal.is_text ? "the parameter takes a text" : "the parameter takes no text");
  if (formal.by_reference && actual.variable.target == Statement::Target::None)
    return fault(actual, Cause::StatementFormat,
                 "the parameter takes a variable, whose value the return changes");
  return std::nullopt;
}

void add_argument(Code& code, CallRecord& call, std::int32_t variable, const Operand& value) {
  Argument argument;
  argument.variable = variable;
  argument.operand = value;
  code.arguments.push_back(argument);
  ++call.arguments;
}

}  // namespace

std::optional<Fault> pass_parameters(Code& code, CallRecord& call) {
  CallExtras* const extras = call.extras.find();
  if (call.kind != CallKind::Named || extras == nullptr) return std::nullopt;
  if (!code.named_variables.empty()) call.locals = CallRecord::Locals::Own;
  std::vector<ActualParameter> given = std::exchange(extras->given, {});
  call.first_argument = static_cast<std::uint32_t>(code.arguments.size());
  const std::int32_t found = code.find(extras->name);
  std::span<const FormalParameter> formals;
  if (found != kNoProgram) {
    const Program& program = code.programs[static_cast<std::size_t>(found)];
    formals =
        std::span(code.formal_parameters).subspan(program.first_parameter, program.parameters);
  }
  for (std::size_t i = formals.size(); i < given.size(); ++i) {
    if (!is_given(given[i])) continue;
    if (found != kNoProgram)
      return fault(
          given[i], Cause::TooManyArguments,
          code.name_of(found) + " declares " + std::to_string(formals.size()) + " parameters");
    add_argument(code, call, 0, given[i].operand);  // what it reads is known, if nothing else
  }
  for (std::size_t i = 0; i < formals.size(); ++i) {
    const FormalParameter& formal = formals[i];
    Operand value;
    value.kind = Operand::Kind::Constant;
    value.value = formal.otherwise;
    if (i < given.size() && is_given(given[i])) {
      as_character(code.texts, formal, given[i]);
      if (auto wrong = refused(formal, given[i])) return wrong;
      value = given[i].operand;
      if (formal.by_reference) extras->back.push_back({formal.variable, given[i].variable});
    }
    add_argument(code, call, formal.variable, value);
  }
  return std::nullopt;
}

}  // namespace cncsub
