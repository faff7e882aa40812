// Variables by their number: locals, commons, and what the control answers itself.
#include <algorithm>
#include <cmath>

#include "cncsub/machine.hpp"
#include "cncsub/variable_table.hpp"

namespace cncsub {

namespace {

constexpr int kSystems = 20;  // numbers from one work coordinate system to the next

Fault missing(const Code& code, std::int64_t number) {
  return {.cause = Cause::IllegalVariable, .detail = no_variable(*code.control, number)};
}

std::optional<Fault> refused_write(const Code& code, const VariablePlace& place,
                                   std::int64_t number) {
  if (place.range == nullptr) return missing(code, number);
  if (place.kind == VariableKind::Vacant)
    return Fault{.cause = Cause::VacantAssigned, .detail = "#0 is always vacant"};
  switch (place.range->access) {
    case Access::ReadWrite:
      break;
    case Access::ReadOnly:
      return Fault{.cause = Cause::VariableWriteProtected,
                   .detail = "#" + std::to_string(number) + " cannot be written"};
    case Access::WriteOnly:  // it is a statement: the block that writes it has done it already
      return Fault{.cause = Cause::VariableWriteProtected,
                   .detail = "#" + std::to_string(number) + " takes a value from a program only"};
  }
  return std::nullopt;
}

/// The axis of #2500 to #2506, #2600 to #2606 and so on, from 0.
int axis_of(const VariableRange& range) { return range.first / 100 % 10 - 5; }

}  // namespace

/// A program's look at a variable. With every look at the clock it goes on a little, besides going
/// on with the motion: a program that waits for it comes on.
std::optional<Fault> Machine::read(std::int64_t number, double& value) {
  const VariablePlace place = code_->place(number);
  if (place.range != nullptr && place.kind == VariableKind::Milliseconds) {
    take_from_outside();
    clock_ms_ += 1;
    ++changes_;
  }
  return read_at(place, number, level_, value);
}
std::optional<Fault> Machine::read_at(std::int64_t number, int level, double& value) const {
  return read_at(code_->place(number), number, level, value);
}
std::optional<Fault> Machine::write(std::int64_t number, double value) {
  return write_at(number, level_, value);
}

std::optional<Fault> Machine::read_at(const VariablePlace& place, std::int64_t number, int level,
                                      double& value) const {
  if (place.range == nullptr) return missing(*code_, number);
  if (place.range->access == Access::WriteOnly)
    return Fault{.cause = Cause::VariableReadProtected,
                 .detail = "#" + std::to_string(number) + " cannot be read"};
  switch (place.kind) {
    case VariableKind::Vacant:
      value = kVacant;
      return std::nullopt;
    case VariableKind::Local:
      value = locals_[local_at(level, place.index)];
      return std::nullopt;
    case VariableKind::Common:
    case VariableKind::Kept:
      value = commons_[static_cast<std::size_t>(place.index)];
      return std::nullopt;
    case VariableKind::LevelImage: {
      const int of = place.index / code_->locals_per_level;
      value = of > level_ ? kVacant : locals_[local_at(of, place.index % code_->locals_per_level)];
      return std::nullopt;
    }
    default:
      return system_read(place, number, value);
  }
}

std::optional<Fault> Machine::unwritable(std::int64_t number) const {
  return refused_write(*code_, code_->place(number), number);
}

bool Machine::can_be_vacant(std::int64_t number) const {
  const VariableKind kind = code_->place(number).kind;
  return kind == VariableKind::Local || kind == VariableKind::Common ||
         kind == VariableKind::Kept || kind == VariableKind::LevelImage;
}

/// What the machine or another program writes: a signal, or a variable.
void Machine::set_from_outside(std::int32_t number, double value) {
  if (is_signal(number))
    options_.inputs.signals[number] = value;
  else
    write(number, value);
}

bool Machine::is_signal(std::int64_t number) const {
  const VariablePlace place = code_->place(number);
  return place.range != nullptr &&
         (place.kind == VariableKind::Input || place.kind == VariableKind::InputWord);
}

std::optional<Fault> Machine::write_at(std::int64_t number, int level, double value) {
  const VariablePlace place = code_->place(number);
  if (auto fault = refused_write(*code_, place, number)) return fault;
  switch (place.kind) {
    case VariableKind::Local:
      locals_[local_at(level, place.index)] = value;
      if (!programmed_.empty()) programmed_[local_at(level, place.index)] = 0;
      return std::nullopt;
    case VariableKind::Common:
    case VariableKind::Kept:
      commons_[static_cast<std::size_t>(place.index)] = value;
      return std::nullopt;
    case VariableKind::LevelImage: {
      const int of = place.index / code_->locals_per_level;
      if (of <= level_) locals_[local_at(of, place.index % code_->locals_per_level)] = value;
      return std::nullopt;
    }
    default:
      return system_write(place, number, value);
  }
}

/// The parameter whose number was written to the first variable that chooses one; 0 where the
/// control has none of this number, as of PRM.
double Machine::chosen_parameter() const {
  for (const auto& [range, base] : code_->variables)
    if (range.kind == VariableKind::ParameterChoice) {
      const auto chosen = system_.find(range.first);
      const double number = chosen == system_.end() ? 0 : std::round(chosen->second);
      if (!(std::fabs(number) < 1e9)) return 0;
      return code_->control->parameter(std::to_string(to_whole<std::int64_t>(number)));
    }
  return 0;
}

std::optional<Fault> Machine::system_read(const VariablePlace& place, std::int64_t number,
                                          double& value) const {
  const int index = place.index;
  const auto written = [&](double otherwise) {
    const auto found = system_.find(number);
    return found == system_.end() ? otherwise : found->second;
  };
  const auto signal = [&](std::int32_t of) {
    const auto found = options_.inputs.signals.find(of);
    return found == options_.inputs.signals.end() ? 0.0 : found->second;
  };
  switch (place.kind) {
    case VariableKind::Input:
      value = signal(static_cast<std::int32_t>(number)) != 0 ? 1 : 0;
      break;
    case VariableKind::InputWord:
      value = signal(static_cast<std::int32_t>(number));
      break;
    case VariableKind::Milliseconds:
      value = clock_ms_ + motion_.time() * 1000.0;
      break;
    case VariableKind::Hours:
      value = written(0) + motion_.time() / 3600.0;
      break;
    case VariableKind::Date:
      value = written(options_.inputs.date);
      break;
    case VariableKind::Time:
      value = written(options_.inputs.time);
      break;
    case VariableKind::ModalCode:
    case VariableKind::ActiveCode:
      value = motion_.modal_code(static_cast<int>(number % 100));
      break;
    case VariableKind::ModalWord:
    case VariableKind::ActiveWord: {
      const char address = place.range->address;
      const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
      if (address == 'M')
        value = last_m_ < 0 ? 0 : static_cast<double>(last_m_);
      else if (address == 'N')
        value = last_n_ < 0 ? 0 : static_cast<double>(last_n_);
      else if (address == 'O')
        value = program.number < 0 ? 0 : static_cast<double>(program.number);
      else
        value = motion_.modal_word(address);
      if (is_vacant(value)) value = 0;
      break;
    }
    case VariableKind::BlockEnd:
      value = motion_.block_end(index);
      break;
    case VariableKind::MachinePosition:
      value = motion_.machine_position(index);
      break;
    case VariableKind::WorkPosition:
      value = motion_.work_position(index);
      break;
    case VariableKind::SkipPosition:
      value = motion_.skip_position(index);
      break;
    case VariableKind::ActiveLength:
      value = motion_.active_length(index);
      break;
    case VariableKind::ServoError:
      value = 0;
      break;
    case VariableKind::WorkOffset:
      value = motion_.work_offset(index / kSystems, index % kSystems);
      break;
    case VariableKind::AxisWorkOffset:
      value = motion_.work_offset(index, axis_of(*place.range));
      break;
    case VariableKind::ExtraWorkOffset:
      value = motion_.extra_offset(index / kSystems + 1, index % kSystems);
      break;
    case VariableKind::ParameterValue:
      value = chosen_parameter();
      break;
    case VariableKind::LengthWear:
    case VariableKind::LengthGeometry:
    case VariableKind::RadiusWear:
    case VariableKind::RadiusGeometry:
      value = motion_.offset(place.kind, index + (place.range->first % 100 == 0 ? 0 : 1));
      break;
    default:
      value = written(0);
      break;
  }
  return std::nullopt;
}

std::optional<Fault> Machine::system_write(const VariablePlace& place, std::int64_t number,
                                           double value) {
  const int index = place.index;
  if (is_vacant(value) && !code_->control->vacant_system_writes.value)
    return Fault{.cause = Cause::IllegalVariableValue,
                 .detail = "a vacant value for #" + std::to_string(number)};
  if (is_vacant(value)) value = 0;
  switch (place.kind) {
    case VariableKind::Milliseconds:
      clock_ms_ = value - motion_.time() * 1000.0;
      break;
    case VariableKind::Hours:
      system_[number] = value - motion_.time() / 3600.0;
      break;
    case VariableKind::WorkOffset:
      motion_.set_work_offset(index / kSystems, index % kSystems, value);
      break;
    case VariableKind::AxisWorkOffset:
      motion_.set_work_offset(index, axis_of(*place.range), value);
      break;
    case VariableKind::ExtraWorkOffset:
      motion_.set_extra_offset(index / kSystems + 1, index % kSystems, value);
      break;
    case VariableKind::LengthWear:
    case VariableKind::LengthGeometry:
    case VariableKind::RadiusWear:
    case VariableKind::RadiusGeometry:
      motion_.set_offset(place.kind, index + (place.range->first % 100 == 0 ? 0 : 1), value);
      break;
    default:
      system_[number] = value;
      break;
  }
  return std::nullopt;
}

bool Machine::cleared_by_reset(std::int64_t number) const {
  const VariablePlace place = code_->place(number);
  if (place.range == nullptr) return false;
  const Control& control = *code_->control;
  return (place.kind == VariableKind::Local && control.reset_clears_locals.value) ||
         (place.kind == VariableKind::Common && control.reset_clears_commons.value);
}

void Machine::reset() {
  finish();
  motion_.reset();
  modals_.clear();
  loops_.clear();
  waiting_.clear();
  stack_.resize(1);
  frame().repeat = 1;
  level_ = 0;
  subprograms_ = macros_ = 0;
  cycles_ = 0;
  for (std::int64_t number = 0; number < code_->locals; ++number)
    if (cleared_by_reset(number)) locals_[static_cast<std::size_t>(number)] = kVacant;
  for (const auto& [range, base] : code_->variables)
    if (range.kind == VariableKind::Common && cleared_by_reset(range.first))
      std::fill_n(commons_.begin() + base, range.last - range.first + 1, kVacant);
  stop_ = Stop::Running;
  alarm_.reset();
  waiting_for_.clear();
  pc_ = frame().restart;
}

std::map<std::int32_t, double> Machine::variables(int level) const {
  std::map<std::int32_t, double> values;
  for (const auto& [range, base] : code_->variables) {
    const double* value = nullptr;
    if (is_alias(range)) continue;
    if (range.kind == VariableKind::Local) {
      value = locals_.data() + local_at(level, range.first);
    } else if (range.kind == VariableKind::Common || range.kind == VariableKind::Kept) {
      value = commons_.data() + base;
    } else {
      continue;
    }
    for (std::int32_t number = range.first; number <= range.last; ++number, ++value)
      if (!is_vacant(*value)) values[number] = *value;
  }
  for (const auto& [number, value] : system_) values[static_cast<std::int32_t>(number)] = value;
  return values;
}

}  // namespace cncsub
