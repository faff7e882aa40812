#include "cncsub/machine/state/context.hpp"

#include <utility>

#include "cncsub/machine/state/layout.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// Return what the codes mean on the machine that the setup names.
std::shared_ptr<const CodeMeanings> meanings_on(const Code& code, const std::string& machine) {
  const MachineType type = machine_of(*code.control, machine);
  if (type == code.meanings->machine) return code.meanings;
  return std::make_shared<const CodeMeanings>(*code.control, type, code.code_lists, code.word_uses);
}

}  // namespace

Run::Run(std::shared_ptr<const Code> of, Options how)
    : code(std::move(of)),
      options(std::move(how)),
      meanings(meanings_on(*code, options.setup.machine)),
      motion(code->control, options.setup, meanings, code->general_only) {
  std::shared_ptr<const Workpiece>& workpiece = options.inputs.workpiece;
  if (workpiece)  // it stays where it is, whatever the program does to zero points
    workpiece = std::make_shared<const Workpiece>(placed(motion.view(), *workpiece));
  options.skips |= Block::kPartEnd;
  trace.depth = options.trace;
  state.locals.assign(static_cast<std::size_t>(code->locals), kVacant);
  if (control().macros.call_passes_words.value) state.programmed.assign(state.locals.size(), 0);
  state.commons.assign(static_cast<std::size_t>(code->commons), kVacant);
  for (const auto& [common, value] : code->first_values)
    state.commons[static_cast<std::size_t>(common)] = value;
  state.elements.assign(static_cast<std::size_t>(code->elements), 0);
  state.signals = options.inputs.signals;
  state.external_reads.clock_ms = options.inputs.clock_ms;
  largest_word = kPowersOfTen[most_digits(control())];
  for (const char address : control().reading.computed_whole.value) computed_whole |= bit(address);
  for (const char address : code->spelling->unsigned_words)
    if (!code->spelling->signs_by_rule || !control().reading.minus_addresses.value.has(address))
      unsigned_words |= bit(address);
}

void Run::extend(std::shared_ptr<const Code> with) {
  const VariableLayout before = variable_layout(*code);
  code = std::move(with);
  meanings = meanings_on(*code, options.setup.machine);
  fit(state, before, *code);
}

}  // namespace cncsub
