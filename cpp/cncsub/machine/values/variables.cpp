#include "cncsub/machine/values/variables.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cncsub/code/variable_faults.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/machine/values/frames.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/motion/query.hpp"

namespace cncsub {

namespace {

constexpr int kSystems = 20;  // numbers from one work coordinate system to the next

/// Return the axis of #2500 to #2506, #2600 to #2606 and so on, from 0.
int axis_of(const VariableRange& range) { return range.first / 100 % 10 - 5; }

/// Return the parameter whose number was written to the first variable that chooses one; 0 where
/// the control has none of this number, as for PRM.
double chosen_parameter(const Run& run) {
  for (const auto& [range, base] : run.code->variables)
    if (range.kind == VariableKind::ParameterChoice) {
      const auto chosen = run.state.system.find(range.first);
      const double number = chosen == run.state.system.end() ? 0 : std::round(chosen->second);
      if (!(std::fabs(number) < 1e9)) return 0;
      return run.control().parameter(std::to_string(to_whole<std::int64_t>(number)));
    }
  return 0;
}

/// Return the last M code, sequence number or program number, or what the motion knows of an
/// address.
double active_word(const Run& run, char address) {
  const auto known = [](std::int64_t number) {
    return number < 0 ? 0.0 : static_cast<double>(number);
  };
  if (address == 'M') return known(run.state.last_m);
  if (address == 'N') return known(run.state.last_n);
  if (address == 'O') return known(run.program().number);
  const double value = modal_word(run.motion.view(), address);
  return is_vacant(value) ? 0 : value;
}

/// Return the number in an offset table. The tables hold numbers from 1, and begin at a variable
/// whose number ends in 01 or 00.
int offset_number(const VariablePlace& place) {
  return place.index + (place.range->first % 100 == 0 ? 0 : 1);
}

/// Return a position or an offset; nothing where the variable is something else.
// NOLINTNEXTLINE(readability-function-size): one kind after the other
std::optional<double> of_motion(const MotionView& motion, const VariablePlace& place) {
  const int index = place.index;
  switch (place.kind) {
    case VariableKind::BlockEnd:
      return block_end(motion, index);
    case VariableKind::MachinePosition:
      return machine_position(motion, index);
    case VariableKind::WorkPosition:
      return work_position(motion, index);
    case VariableKind::SkipPosition:
      return skip_position(motion, index);
    case VariableKind::MeasuredPosition:
      return measured_position(motion, index);
    case VariableKind::MeasuredMachine:
      return measured_machine(motion, index);
    case VariableKind::ActiveLength:
      return active_length(motion, index);
    case VariableKind::SkipTouched:
      return motion.state.skip_touched ? 1 : 0;
    case VariableKind::ToolLength:
      return index < 0 ? motion.state.tool : tool_length(motion, index);
    case VariableKind::ServoError:
      return 0;
    case VariableKind::Shift:
      return kept_shift(motion, index - 1);
    case VariableKind::ReferencePoint:
      return reference_point(motion, index / kSystems + 1, index % kSystems);
    case VariableKind::WorkSystem:
      return motion.state.work_system > 0 ? motion.state.work_system
                                          : 6 + motion.state.extra_system;
    case VariableKind::WorkOffset:
      return work_offset(motion, index / kSystems, index % kSystems);
    case VariableKind::AxisWorkOffset:
      return work_offset(motion, index, axis_of(*place.range));
    case VariableKind::ExtraWorkOffset:
      return work_offset(motion, kFirstExtra + index / kSystems, index % kSystems);
    case VariableKind::EdgeDatum:
      return edge_datum(motion, index);
    case VariableKind::LengthWear:
    case VariableKind::LengthGeometry:
    case VariableKind::RadiusWear:
    case VariableKind::RadiusGeometry:
      return offset(motion, place.kind, offset_number(place));
    default:
      return std::nullopt;
  }
}

/// Return what a length of the program counts in a variable that holds millimetres.
double unit_of(const Run& run, const VariablePlace& place) {
  const int axis = place.kind == VariableKind::Shift ? place.index - 1 : place.index % kSystems;
  const bool length = axis >= 0 && axis < kAxes && !is_rotary(axis);
  return place.range->metric && length && g20(run.motion.state()) ? kInch : 1;
}

/// Return the place in MotionState::set_anew of a variable that the control sets and a program may
/// write over; nothing where it is none of these.
std::optional<std::size_t> set_by_control(const VariablePlace& place) {
  switch (place.kind) {
    case VariableKind::SkipPosition:
    case VariableKind::SkipTouched:
      return 0;
    case VariableKind::WorkSystem:
      return 1;
    case VariableKind::Shift:
      return place.index == 0 ? std::optional<std::size_t>(2) : std::nullopt;
    default:
      return std::nullopt;
  }
}

/// Return what a program wrote over what the control had set; nothing where the control set it
/// anew.
std::optional<double> written_over(const Run& run, std::int64_t number) {
  const auto& written = run.state.written_over;
  const auto found = written.find(number);
  if (found == written.end() || run.motion.state().set_anew[found->second]) return std::nullopt;
  const auto value = run.state.system.find(number);
  return value == run.state.system.end() ? std::nullopt : std::optional(value->second);
}

/// Write over what the control has set. What was written before the control set it is forgotten.
void write_over(Run& run, std::size_t kind, std::int64_t number, double value) {
  auto& written = run.state.written_over;
  if (run.motion.state().set_anew[kind])
    std::erase_if(written, [kind](const auto& entry) { return entry.second == kind; });
  run.motion.write_over(kind, value);
  run.state.system[number] = value;
  written[number] = kind;
}

/// Return what the control answers itself, or what was written to its variables.
double system_read(const Run& run, const VariablePlace& place, std::int64_t number) {
  const State& s = run.state;
  const auto in = [number](const auto& values, double otherwise) {
    const auto found = values.find(static_cast<std::int32_t>(number));
    return found == values.end() ? otherwise : found->second;
  };
  switch (place.kind) {
    case VariableKind::Input:
      return in(s.signals, 0) != 0 ? 1 : 0;
    case VariableKind::InputWord:
      return in(s.signals, 0);
    case VariableKind::Milliseconds:
      return s.external_reads.clock_ms + run.motion.time() * 1000.0;
    case VariableKind::Hours:
      return in(s.system, 0) + run.motion.time() / 3600.0;
    case VariableKind::Date:
      return in(s.system, run.options.inputs.date);
    case VariableKind::Time:
      return in(s.system, run.options.inputs.time);
    case VariableKind::ModalCode:
    case VariableKind::ActiveCode:
      return modal_code(run.motion.view(), static_cast<int>(number % 100));
    case VariableKind::ModalWord:
    case VariableKind::ActiveWord:
      return active_word(run, place.range->address);
    case VariableKind::ParameterValue:
      return chosen_parameter(run);
    case VariableKind::MessageSwitch:
      return in(s.system, 1);
    default:
      if (const auto value = written_over(run, number)) return *value;
      if (const auto value = of_motion(run.motion.view(), place))
        return *value * unit_of(run, place);
      return in(s.system, 0);
  }
}

/// Write a number of the offset tables; return false where the variable is none of theirs.
bool write_offset(Motion& motion, const VariablePlace& place, double value) {
  const int index = place.index;
  switch (place.kind) {
    case VariableKind::WorkOffset:
      motion.set_work_offset(index / kSystems, index % kSystems, value);
      return true;
    case VariableKind::Shift:
    case VariableKind::EdgeDatum:
    case VariableKind::ReferencePoint:
      motion.set_offset(place.kind, index, value);
      return true;
    case VariableKind::AxisWorkOffset:
      motion.set_work_offset(index, axis_of(*place.range), value);
      return true;
    case VariableKind::ExtraWorkOffset:
      motion.set_work_offset(kFirstExtra + index / kSystems, index % kSystems, value);
      return true;
    case VariableKind::LengthWear:
    case VariableKind::LengthGeometry:
    case VariableKind::RadiusWear:
    case VariableKind::RadiusGeometry:
      motion.set_offset(place.kind, offset_number(place), value);
      return true;
    default:
      return false;
  }
}

std::optional<Fault> system_write(Run& run, const VariablePlace& place, std::int64_t number,
                                  double value) {
  if (is_vacant(value) && run.refuses(Cause::IllegalVariableValue))
    return Fault{.cause = Cause::IllegalVariableValue,
                 .detail = "a vacant value for #" + std::to_string(number)};
  if (is_vacant(value)) value = 0;
  if (const auto kind = set_by_control(place)) {
    write_over(run, *kind, number, value);
    return std::nullopt;
  }
  if (std::optional<Fault> wrong; write_frame(run, place, value, wrong)) return wrong;
  value /= unit_of(run, place);
  switch (place.kind) {
    case VariableKind::Milliseconds:
      run.state.external_reads.clock_ms = value - run.motion.time() * 1000.0;
      break;
    case VariableKind::ToolName:
      run.motion.name_tool(place.index, text_of(run, value));
      break;
    case VariableKind::Hours:
      run.state.system[number] = value - run.motion.time() / 3600.0;
      break;
    default:
      if (!write_offset(run.motion, place, value)) run.state.system[number] = value;
      break;
  }
  return std::nullopt;
}

std::optional<Fault> read_at(const Run& run, const VariablePlace& place, std::int64_t number,
                             int level, double& value) {
  if (auto fault = unreadable(*run.code, place, number)) return fault;
  switch (place.kind) {
    case VariableKind::Vacant:
      value = kVacant;
      return std::nullopt;
    case VariableKind::Local:
      value = run.state.locals[run.local_at(level, place.index)];
      return std::nullopt;
    case VariableKind::Common:
    case VariableKind::Kept:
      value = run.state.commons[static_cast<std::size_t>(place.index)];
      return std::nullopt;
    case VariableKind::LevelImage: {
      const int of = place.index / run.code->locals_per_level;
      value = of > run.state.level
                  ? kVacant
                  : run.state.locals[run.local_at(of, place.index % run.code->locals_per_level)];
      return std::nullopt;
    }
    default:
      value = system_read(run, place, number);
      return std::nullopt;
  }
}

}  // namespace

static bool is_of_outside(VariableKind kind) {
  return kind == VariableKind::Input || kind == VariableKind::InputWord ||
         kind == VariableKind::Date || kind == VariableKind::Time;
}

std::optional<Fault> read_variable(Run& run, std::int64_t number, double& value) {
  const VariablePlace place = run.code->place(number);
  if (place.range != nullptr && place.kind == VariableKind::Milliseconds) {
    log_read(run);
    run.state.external_reads.clock_ms += 1;
    ++run.state.changes;
  }
  if (place.kind == VariableKind::Hours) run.state.external_reads.time = true;
  if (place.range != nullptr && is_of_outside(place.kind)) run.state.external_reads.asked = number;
  if (const auto frame = read_frame(run, place)) return value = *frame, std::nullopt;
  if (place.range != nullptr && place.range->not_compensated && compensating(run.motion.state()))
    return Fault{.cause = Cause::CompensationPosition,
                 .detail = "#" + std::to_string(number) + " is read under radius compensation"};
  return read_at(run, place, number, run.state.level, value);
}

std::optional<Fault> read_variable(const Run& run, std::int64_t number, int level, double& value) {
  return read_at(run, run.code->place(number), number, level, value);
}

std::optional<Fault> write_variable(Run& run, std::int64_t number, int level, double value) {
  const VariablePlace place = run.code->place(number);
  if (auto fault = unwritable(*run.code, place, number)) return fault;
  switch (place.kind) {
    case VariableKind::Local:
      run.state.locals[run.local_at(level, place.index)] = value;
      if (!run.state.programmed.empty()) run.state.programmed[run.local_at(level, place.index)] = 0;
      return std::nullopt;
    case VariableKind::Common:
    case VariableKind::Kept:
      run.state.commons[static_cast<std::size_t>(place.index)] = value;
      return std::nullopt;
    case VariableKind::LevelImage: {
      const int of = place.index / run.code->locals_per_level;
      if (of <= run.state.level)
        run.state.locals[run.local_at(of, place.index % run.code->locals_per_level)] = value;
      return std::nullopt;
    }
    default:
      return system_write(run, place, number, value);
  }
}

void set_from_outside(Run& run, std::int32_t number, double value) {
  if (is_signal(*run.code, number))
    run.state.signals[number] = value;
  else
    write_variable(run, number, value);
}

bool can_be_vacant(const Code& code, std::int64_t number) {
  const VariableKind kind = code.place(number).kind;
  return kind == VariableKind::Local || kind == VariableKind::Common ||
         kind == VariableKind::Kept || kind == VariableKind::LevelImage;
}

bool is_signal(const Code& code, std::int64_t number) {
  const VariablePlace place = code.place(number);
  return place.range != nullptr &&
         (place.kind == VariableKind::Input || place.kind == VariableKind::InputWord);
}

bool cleared_by_reset(const Code& code, std::int64_t number) {
  const VariablePlace place = code.place(number);
  if (place.range == nullptr) return false;
  const Set<Cleared>& cleared = code.control->common.reset_clears.value;
  return (place.kind == VariableKind::Local && cleared.has(Cleared::Locals)) ||
         (place.kind == VariableKind::Common && cleared.has(Cleared::Commons));
}

void clear_variables(Run& run) {
  const Code& code = *run.code;
  for (std::int64_t number = 0; number < code.locals; ++number)
    if (cleared_by_reset(code, number))
      run.state.locals[static_cast<std::size_t>(number)] = kVacant;
  for (const auto& [range, base] : code.variables)
    if (range.kind == VariableKind::Common && cleared_by_reset(code, range.first))
      std::fill_n(run.state.commons.begin() + base, range.last - range.first + 1, kVacant);
}

namespace {

/// List variables that have another number as well by that, as programs call them: #100 where the
/// control counts #10100.
void call_by_aliases(const Run& run, std::map<std::int32_t, double>& values) {
  for (const auto& [range, base] : run.code->variables) {
    if (!is_alias(range)) continue;
    for (std::int32_t number = range.first; number <= range.last; ++number) {
      auto listed = values.extract(range.from + number - range.first);
      if (listed.empty()) continue;
      listed.key() = number;
      values.insert(std::move(listed));
    }
  }
}

}  // namespace

std::map<std::int32_t, double> variables(const Run& run, int level) {
  std::map<std::int32_t, double> values;
  for (const auto& [range, base] : run.code->variables) {
    const double* value = nullptr;
    if (is_alias(range)) continue;
    if (range.kind == VariableKind::Local) {
      value = run.state.locals.data() + run.local_at(level, range.first);
    } else if (range.kind == VariableKind::Common || range.kind == VariableKind::Kept) {
      value = run.state.commons.data() + base;
    } else {
      continue;
    }
    for (std::int32_t number = range.first; number <= range.last; ++number, ++value)
      if (!is_vacant(*value)) values[number] = *value;
  }
  call_by_aliases(run, values);
  for (const auto& [number, value] : run.state.system)
    values[static_cast<std::int32_t>(number)] = value;
  return values;
}

}  // namespace cncsub
