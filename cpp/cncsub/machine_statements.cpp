// Macro statements: assignments, branches, loops.
#include <algorithm>
#include <cmath>

#include "cncsub/machine.hpp"
#include "cncsub/variable_table.hpp"

namespace cncsub {

/// Macro statements one after the other, which fill most loops, from the one at pc_ on: until
/// another kind of block comes, or one that a switch skips, or the run is to look around; or `one`.
bool Machine::statements(bool one) {
  const Code& code = *code_;
  const Block* const blocks = code.blocks.data();
  const Statement* const list = code.statements.data();
  const Expression* const expressions = code.expressions.data();
  const Places places = this->places();  // no statement opens or closes a level
  for (;;) {
    const Block& block = blocks[pc_];
    const Statement& statement = list[block.aux];
    next_ = pc_ + 1;
    switch (block.op) {
      case Op::Assign: {
        double value = 0;
        if (!evaluate(expressions[statement.expression], places, value)) return false;
        if (!assign(statement, places, value)) return false;
        break;
      }
      case Op::IfGoto: {
        double value = 0;
        last_condition_ = statement.expression;
        if (!evaluate(expressions[statement.expression], places, value)) return false;
        if (value != 0 && !go_to(statement)) return false;
        break;
      }
      case Op::While: {
        if (!may_jump(statement)) return false;
        double value = 0;
        last_condition_ = statement.expression;
        if (!evaluate(expressions[statement.expression], places, value)) return false;
        if (!loop(statement, value != 0)) return false;
        break;
      }
      case Op::Do:
        if (!may_jump(statement) || !loop(statement, true)) return false;
        break;
      case Op::EndDo:
        if (!end_loop(statement)) return false;
        break;
      default:
        return branch(block);
    }
    record_step();
    pc_ = next_;
    if (one || executed_ >= look_at_ || (blocks[pc_].skip & options_.skips) != 0) return true;
  }
}

bool Machine::evaluate_long(const Expression& e, const Places& places, double& value) {
  if (e.width > kLongText) look_soon();
  Trap trap;  // NOLINT: set where it is read
  if (compute(code_->instructions.data() + e.first, places, value, trap)) [[likely]]
    return true;
  const bool inside = trap.at >= e.at && trap.at <= e.at + e.width;
  std::string detail = trap.detail;
  if (trap.variable != Trap::kNoVariable) {
    const std::string name = "#" + std::to_string(trap.variable);
    detail = trap.cause == Cause::IllegalVariable ? no_variable(*code_->control, trap.variable)
                                                  : name + " cannot be read";
  }
  return alarm({trap.cause, inside ? trap.at : e.at, 0, std::move(detail)});
}

bool Machine::condition(std::uint32_t expression, bool& holds) {
  double value = 0;
  last_condition_ = expression;
  if (!evaluate(expression, value)) return false;
  holds = value != 0;
  return true;
}

inline bool Machine::assign(const Statement& statement, const Places& places, double value) {
  const bool plain = (statement.target == Statement::Target::Local ||
                      statement.target == Statement::Target::Common) &&
                     programmed_.empty();
  if (!plain || std::fabs(value) > kLargest) return store(statement, value);
  double& place = places.of[static_cast<std::size_t>(statement.target)][statement.index];
  changes_ += place == value ? 0 : 1;
  place = value;
  return true;
}

bool Machine::assign(const Statement& statement) {
  double value = 0;
  return evaluate(statement.expression, value) && store(statement, value);
}

bool Machine::store(const Statement& statement, double value) {
  if (std::fabs(value) > kLargest)  // a vacant value compares false
    return alarm({Cause::Overflow, statement.at, statement.width, "the result is too large"});
  const auto put = [&](double& place) {
    if (!(place == value)) ++changes_;
    place = value;
  };
  switch (statement.target) {
    case Statement::Target::Local:
      put(locals_[local_at(level_, statement.index)]);
      if (!programmed_.empty()) programmed_[local_at(level_, statement.index)] = 0;
      return true;
    case Statement::Target::Common:
      put(commons_[static_cast<std::size_t>(statement.index)]);
      return true;
    case Statement::Target::Variable:
      return store_number(statement.index, value, statement);
    case Statement::Target::Indirect: {
      double number = 0;
      if (!evaluate(statement.variable, number)) return false;
      if (is_vacant(number)) number = 0;
      return store_number(to_whole<std::int64_t>(std::clamp(std::round(number), -1e9, 2e9)), value,
                          statement);
    }
    case Statement::Target::None:
      break;
  }
  return true;
}

bool Machine::store_number(std::int64_t number, double value, const Statement& statement) {
  const VariablePlace place = code_->place(number);
  if (place.range != nullptr && place.kind == VariableKind::UserAlarm)
    return user_alarm(is_vacant(value) ? 0 : value, statement);
  if (place.range != nullptr && place.kind == VariableKind::Message) {
    const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
    say(code_->files[program.file].text.substr(statement.text, statement.text_length));
    return wait_for_operator("#" + std::to_string(number));
  }
  if (auto fault = write(number, value)) {
    fault->at = statement.variable_at;
    fault->width = statement.variable_width;
    return alarm(*fault);
  }
  ++changes_;
  return true;
}

/// #3000 = n (TEXT). The block is a step: the alarm is what it does.
bool Machine::user_alarm(double n, const Statement& statement) {
  const Control& control = *code_->control;
  const double number = std::round(n);
  if (number < 0 || number > control.user_alarm_last.value)
    return alarm(
        {Cause::IllegalUserAlarm, statement.at, statement.width,
         "a program may raise alarms 0 to " + std::to_string(control.user_alarm_last.value)});
  const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
  const std::string text =
      code_->files[program.file].text.substr(statement.text, statement.text_length);
  std::string shown =
      std::to_string(control.user_alarm_offset.value + to_whole<std::int64_t>(number));
  while (static_cast<int>(shown.size()) < control.user_alarm_digits) shown.insert(0, "0");
  words_done_ = true;
  alarm({Cause::UserAlarm, statement.at, statement.width,
         text.empty() ? "raised by the program" : text});
  if (!alarm_) return false;
  alarm_->number = control.user_alarm_number.empty() ? control.user_alarm_prefix + shown
                                                     : control.user_alarm_number;
  alarm_->text = text;
  return false;
}

bool Machine::go_to(const Statement& statement) {
  if (!may_jump(statement)) return false;
  if (motion_.compensating() && !code_->control->jumps_in_compensation.value)
    return alarm({Cause::JumpInCompensation, statement.at, statement.width,
                  "a jump while the radius offset is on"});
  Address to = statement.to;
  std::int64_t n = statement.number;
  if (n < 0) {
    double value = 0;
    if (!evaluate(statement.variable, value)) return false;
    const double rounded = is_vacant(value) ? 0 : std::round(value);
    if (rounded < 1 || rounded > code_->control->max_jump_number.value)
      return alarm({Cause::IllegalJumpNumber, statement.variable_at, statement.variable_width,
                    "GOTO takes 1 to " + std::to_string(code_->control->max_jump_number.value)});
    n = to_whole<std::int64_t>(rounded);
    to = code_->jump_target(code_->programs[static_cast<std::size_t>(frame().program)], n, pc_);
  }
  if (to == kNowhere)
    return alarm({Cause::JumpTargetNotFound, statement.variable_at, statement.variable_width,
                  "there is no N" + std::to_string(n) + " in " +
                      code_->name_of(code_->programs[static_cast<std::size_t>(frame().program)])});
  return jump_to(to);
}

/// Loops that do not hold the block are left.
void Machine::leave_loops(Address to) {
  while (loops_.size() > frame().loops) {
    const Address start = loops_.back();
    if (to >= start && to <= code_->statements[code_->blocks[start].aux].end) break;
    loops_.pop_back();
  }
}

/// Goes on at a block of the running program.
bool Machine::jump_to(Address to) {
  leave_loops(to);
  if (to <= pc_ && waits()) return false;
  next_ = to;
  return true;
}

/// A jump back that is reached twice with nothing changed in between can only wait for the world
/// outside.
inline bool Machine::waits() {
  const bool idle =
      jumped_from_ == pc_ && changes_at_jump_ == changes_ && last_condition_ != kNowhere;
  const std::uint32_t condition = last_condition_;
  jumped_from_ = pc_;
  changes_at_jump_ = changes_;
  last_condition_ = kNowhere;  // the next pass must ask again
  return idle && waits_for(condition);
}

bool Machine::waits_for(std::uint32_t condition) {
  const Instruction* at = code_->instructions.data() + code_->expressions[condition].first;
  while (at->op != Ins::End && at->op != Ins::Common && at->op != Ins::CommonRaw &&
         at->op != Ins::Variable && at->op != Ins::VariableRaw)
    ++at;
  if (at->op == Ins::End) return false;
  if (next_write_ < options_.inputs.writes.size()) {
    for (const auto& [number, value] : options_.inputs.writes[next_write_++])
      set_from_outside(number, value);
    ++changes_;
    return false;
  }
  waiting_for_ = "#" + std::to_string(to_whole<std::int64_t>(at->value));
  record_step();
  end(Stop::Waiting);
  return true;
}

/// A WHILE whose condition is known, or a DO, whose condition always holds.
inline bool Machine::loop(const Statement& statement, bool holds) {
  const bool inside = loops_.size() > frame().loops && loops_.back() == pc_;
  if (!holds) {
    if (inside) loops_.pop_back();
    next_ = statement.to;
    return true;
  }
  return inside || open_loop(statement);
}

bool Machine::open_loop(const Statement& statement) {
  if (code_->control->loops_count_across_calls.value &&
      loops_.size() >= static_cast<std::size_t>(code_->control->max_loops.value))
    return alarm({Cause::LoopsTooDeep, statement.at, statement.width,
                  "more loops inside each other than the control takes"});
  loops_.push_back(pc_);
  return true;
}

bool Machine::end_loop(const Statement& statement) {
  while (loops_.size() > frame().loops && loops_.back() != statement.to) loops_.pop_back();
  if (loops_.size() == frame().loops)
    return alarm({Cause::MissingDo, statement.at, statement.width, "a jump led into this loop"});
  if (waits()) return false;
  next_ = statement.to;
  return true;
}

bool Machine::name_variables(const Statement& statement) {
  for (std::uint32_t i = 0; i < statement.variable_width; ++i) {
    if (i % kLongText == kLongText - 1 && breaks_off()) return false;
    names_[code_->names[static_cast<std::size_t>(statement.index) + i]] = statement.number + i;
  }
  return true;
}

}  // namespace cncsub
