#include "cncsub/machine/run/settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cncsub/machine/values/decode.hpp"
#include "cncsub/machine/values/machine_inputs.hpp"
#include "cncsub/machine/values/named_variables.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/machine/values/watch.hpp"
#include "cncsub/motion/query.hpp"
#include "cncsub/text/axis_names.hpp"

namespace cncsub {

namespace {

/// Decode the words of the block that was typed, with its codes.
bool decode_typed(Run& run, const std::shared_ptr<const Code>& typed, NcWords& words,
                  BlockCodes& codes) {
  const Address at = typed->programs.back().first;
  const auto code = std::exchange(run.code, typed);
  const auto meanings = std::exchange(
      run.meanings, std::make_shared<const CodeMeanings>(*typed->control, run.meanings->machine,
                                                         typed->code_lists, typed->word_uses));
  const bool decoded = decode(run, typed->blocks[at], at, words);
  codes = *words.codes;
  words.codes = &codes;
  run.meanings = meanings;
  run.code = code;
  return decoded;
}

/// Return whether words set this mode and nothing else; the numbers of an offset belong to it.
bool sets(const NcWords& words, const std::string& mode) {
  const BlockCodes& codes = *words.codes;
  if (codes.m_count != 0) return false;
  if (const auto group = group_named(mode))
    return codes.g_count == 1 && codes.groups == bit(*group) &&
           (words.mask & ~(bit('P') | bit('H') | bit('D'))) == 0;
  return mode.size() == 1 && codes.g_count == 0 && words.mask == bit(mode[0]);
}

/// Return a value as a variable of this type holds it; nothing where it is none of the type.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): one type after the other
std::optional<double> held_value(Run& run, DefinedVariable::Type type, const NamedValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  const double number = text == nullptr ? std::get<double>(value) : 0;
  if (!std::isfinite(number)) return std::nullopt;
  const bool whole = text == nullptr && number == std::trunc(number);
  switch (type) {
    case DefinedVariable::Type::Real:
      return text == nullptr ? std::optional(number) : std::nullopt;
    case DefinedVariable::Type::Int:
      return whole && std::fabs(number) < 0x1p31 ? std::optional(number) : std::nullopt;
    case DefinedVariable::Type::Char:
      if (text != nullptr && text->size() == 1)
        return static_cast<double>(static_cast<unsigned char>((*text)[0]));
      return whole && number >= 0 && number < 0x1p8 ? std::optional(number) : std::nullopt;
    case DefinedVariable::Type::Bool:
      return text == nullptr ? std::optional<double>(number != 0 ? 1 : 0) : std::nullopt;
    case DefinedVariable::Type::Text:
      return text != nullptr ? std::optional(keep_text(run, *text)) : std::nullopt;
    case DefinedVariable::Type::Frame:
      return std::nullopt;
    case DefinedVariable::Type::Axis:
      break;
  }
  const std::size_t axis =
      text != nullptr && text->size() == 1 ? kAxisNames.find((*text)[0]) : std::string_view::npos;
  return axis == std::string_view::npos ? std::nullopt
                                        : std::optional(static_cast<double>(axis + 1));
}

}  // namespace

std::optional<std::string> set_mode(Run& run, const std::shared_ptr<const Code>& typed,
                                    const std::string& mode) {
  const Program& program = typed->programs.back();
  const Block& block = typed->blocks[program.first];
  if (block.op == Op::Fault) return typed->faults[block.aux].detail;
  std::string none = "it does not set the mode " + mode + " alone";
  if (program.last - program.first != 1 || !is_words(block.op)) return none;
  NcWords words;
  BlockCodes codes;
  if (!decode_typed(run, typed, words, codes) || !sets(words, mode)) return none;
  words.at = run.state.pc;
  Motion trial = run.motion;
  MachineInputs inputs = machine_inputs(run);
  Motion::Outcome outcome;
  if (const auto fault = trial.execute(words, run.step(), nullptr, outcome, inputs))
    return fault->detail.empty() ? std::string(info(fault->cause).meaning) : fault->detail;
  if (outcome.moved) return "it moves";
  run.motion = std::move(trial);
  run.motion.forget_table();
  ++run.state.changes;
  note_changes_from_outside(run);
  return std::nullopt;
}

std::optional<std::string> set_position(Run& run, int axis, double value, Coordinates of) {
  if (auto refused = run.motion.stand_at(axis, value, of, run.moves())) return refused;
  run.motion.forget_table();
  ++run.state.changes;
  note_changes_from_outside(run);
  return std::nullopt;
}

std::optional<std::string> set_named(Run& run, int level, const std::string& name,
                                     const std::vector<NamedValue>& values) {
  const auto found = named_variable(run, level, name);
  if (!found) return "there is no variable " + name + " here";
  const DefinedVariable& of = *found->variable;
  std::size_t size = 1;
  for (const std::int32_t extent : found->extents) size *= static_cast<std::size_t>(extent);
  if (values.size() != size)
    return name + " holds " + std::to_string(size) + " values, not " +
           std::to_string(values.size());
  std::vector<double> held;
  for (const NamedValue& value : values) {
    const auto one = held_value(run, of.type, value);
    if (!one) return "a value is none of the type of " + name;
    held.push_back(*one);
  }
  // It lies in the state of this run, which may be written.
  std::copy(held.begin(), held.end(), const_cast<double*>(found->values));  // NOLINT
  ++run.state.changes;
  note_changes_from_outside(run);
  return std::nullopt;
}

}  // namespace cncsub
