// What a call hands over besides values: variables and arrays of the caller; and the program that a
// text names.
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/target.hpp"
#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

void copy_arrays(Run& run, const CallRecord& record) {
  State& s = run.state;
  for (const PassedReference& of : record.references()) {
    if (!of.copied) continue;
    double* const local = s.locals.data() + run.local_at(s.level, of.local);
    const Reference from = Reference::of(local[0]);
    const auto count = to_whole<std::size_t>(local[1]);
    local[0] = Reference{Reference::In::Copies, s.copies.size()}.packed();
    for (std::size_t i = 0; i < count; ++i) {
      const double* const value = s.cell(from.behind(i));
      s.copies.push_back(value == nullptr ? 0 : *value);
    }
  }
}

namespace {

/// Return the variable of the present level that a call names, or the array; nothing where the run
/// stopped.
std::optional<Reference> passed(Run& run, const Statement& of) {
  double number = 0;
  if (of.is_computed() && !evaluate(run, of.variable, number)) return std::nullopt;
  if (of.is_element()) {
    const ArrayElements all = elements_of(run, of, number);
    if (all.left > 0) return all.first;
    alarm(run, {Cause::ParameterMissing, of.variable_at, of.variable_width,
                "nothing was given for this parameter"});
    return std::nullopt;
  }
  if (const auto variable = variable_of(run, of)) return variable;
  const VariablePlace place = run.code->place(number_of_variable(number));
  if (place.is_common())
    return Reference{Reference::In::Commons, static_cast<std::size_t>(place.index)};
  alarm(run, {Cause::IllegalVariable, of.variable_at, of.variable_width,
              "there is no variable of this number"});
  return std::nullopt;
}

}  // namespace

bool evaluate_references(Run& run, const CallRecord& record) {
  std::vector<double>& arguments = run.block.arguments;
  for (const PassedReference& of : record.references()) {
    const std::optional<Reference> at = passed(run, of.variable);
    if (!at) return false;
    const auto local = static_cast<std::size_t>(of.local);
    arguments[local] = at->packed();
    if (of.extents.empty()) continue;
    double elements = 1;
    for (std::size_t i = 0; i < of.extents.size(); ++i) {
      // That of an array that is a parameter itself is known now.
      const double extent =
          of.extents[i] > 0
              ? of.extents[i]
              : run.state.locals[run.local_at(
                    run.state.level, of.variable.index + 2 + static_cast<std::int32_t>(i))];
      arguments[local + 2 + i] = extent;
      elements *= extent;
    }
    arguments[local + 1] = elements;
  }
  return true;
}

SearchFrom search_of(const Run& run) {
  SearchFrom from{run.state.frames.front().program};
  const std::int32_t added = run.code->call_path;
  if (added >= 0) from.added = text_of(run, run.state.commons[static_cast<std::size_t>(added)]);
  return from;
}

std::optional<std::uint32_t> record_of(Run& run, const Block& block) {
  const CallRecord& record = run.code->calls[block.aux];
  if (record.constant) return block.aux;
  const CallChoice* const choice = chosen(*run.code, record, search_of(run));
  if (choice == nullptr) return block.aux;
  if (choice->fault == CallChoice::kNone) return choice->record;
  alarm(run, run.code->faults[choice->fault]);
  return std::nullopt;
}

bool find_by_text(Run& run, const CallRecord& record, Target& target) {
  double value = 0;
  const Operand& text = record.name_text();
  if (!value_of(run, text, value)) return false;
  const std::string_view path = text_of(run, value);
  const std::string_view last = last_of_path(path, kPathSigns);
  const std::string name(run.code->spelling->bare_name(trimmed(last)));
  target.program =
      find_called(*run.code, name, path.substr(0, path.size() - last.size()), search_of(run));
  return target.program != kNoProgram ||
         alarm(run, {Cause::NamedProgramNotFound, text.at, text.width,
                     named_program(*run.code, name) + " is not in the memory" +
                         told_elsewhere(*run.code, name)});
}

bool take_own_values(Run& run, const CallRecord& record, const Target& target) {
  const Program& program = run.code->programs[static_cast<std::size_t>(target.program)];
  for (std::uint32_t i = 0; i < program.parameters; ++i) {
    const FormalParameter& of = run.code->formal_parameters[program.first_parameter + i];
    if (of.reference >= 0)
      return alarm(run, {Cause::ParameterMissing, record.at, record.width,
                         "the call gives no variable for a parameter by reference"});
    run.block.arguments[static_cast<std::size_t>(of.variable)] = of.otherwise;
  }
  return true;
}

}  // namespace cncsub
