#include "cncsub/machine/statements/statements.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/output.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

namespace {

// ---- assignments ----

/// Give a value to a variable that is neither written as a local nor as a common.
bool set_other(Run& run, const Block& block, const Assigned& assigned, const Places& places,
               double value) {
  if (assigned.target != Statement::Target::Indirect || std::fabs(value) > kLargest)
    return store(run, assignment_of(*run.code, block), value);
  double number = 0;
  if (!evaluate(run, run.code->expression(block.aux - assigned.index), places, number))
    return false;
  const std::int64_t variable = number_of_variable(number);
  double* const place = places.near(*run.code, variable, true);
  if (place == nullptr || !run.state.programmed.empty())
    return store_number(run, variable, value, assignment_of(*run.code, block));
  *place = value;
  ++run.state.changes;
  return true;
}

inline bool set(Run& run, const Block& block, const Places& places) {
  double value = 0;
  if (!evaluate(run, run.code->expression(block.aux), places, value)) return false;
  const std::uint32_t kind = Assigned::kind_of(block);
  if (kind > 1) return set_other(run, block, Assigned::of(block), places, value);
  if (!run.state.programmed.empty() || std::fabs(value) > kLargest)
    return store(run, assignment_of(*run.code, block), value);
  double& place = places.of[kind][Assigned::index_of(block)];
  run.state.changes += place == value ? 0 : 1;
  place = value;
  return true;
}

bool assign(Run& run, const Statement& statement) {
  double value = 0;
  return evaluate(run, statement.expression, value) && store(run, statement, value);
}

// ---- jumps and loops ----

/// Return whether a loop only waits for something outside: for what its condition reads, if another
/// program does not write it now.
bool waits_for(Run& run, std::uint32_t condition) {
  State& s = run.state;
  const Expression of = run.code->expression(condition);
  auto at = of.begin();
  const auto reads = [](Ins op) {
    return op == Ins::Common || op == Ins::CommonRaw || op == Ins::Variable ||
           op == Ins::VariableRaw;
  };
  while (at != Expression::end() && !reads((*at).op)) ++at;
  if (at == Expression::end()) return false;
  if (s.next_write < run.options.inputs.writes.size()) {
    for (const auto& [number, value] : run.options.inputs.writes[s.next_write++])
      set_from_outside(run, number, value);
    ++s.changes;
    return false;
  }
  s.waiting_for =
      run.code->spelling->name_of_variable(*run.code->control, to_whole<std::int64_t>((*at).value));
  record_step(run);
  end_run(run, Stop::Waiting);
  return true;
}

/// Return whether a jump back waits for the world outside: it is reached twice with nothing changed
/// in between. It is inlined, as every pass of a loop asks it.
CNCSUB_ALWAYS_INLINE inline bool waits_here(Run& run) {
  State& s = run.state;
  const bool idle =
      s.jumped_from == s.pc && s.changes_at_jump == s.changes && s.last_condition != kNowhere;
  const std::uint32_t condition = s.last_condition;
  s.jumped_from = s.pc;
  s.changes_at_jump = s.changes;
  s.last_condition = kNowhere;  // the next pass must ask again
  return idle && waits_for(run, condition);
}

/// Execute GOTO 10 or GOTO #1.
bool jump_by_goto(Run& run, const Statement& statement) {
  if (!may_jump(run, statement)) return false;
  if (compensating(run.motion.state()) && run.refuses(Cause::JumpInCompensation))
    return alarm(run, {Cause::JumpInCompensation, statement.at, statement.width,
                       "a jump while the radius offset is on"});
  if (statement.search != Statement::Search::None) return jump_by_text(run, statement);
  Address to = statement.to;
  std::int64_t n = statement.number;
  if (n < 0) {
    double value = 0;
    if (!evaluate(run, statement.variable, value)) return false;
    const double rounded = is_vacant(value) ? 0 : std::round(value);
    const int most = run.control().calls.max_jump_number.value;
    if (rounded < 1 || rounded > most)
      return alarm(run, {Cause::IllegalJumpNumber, statement.variable_at, statement.variable_width,
                         "the number of GOTO must be 1 to " + std::to_string(most)});
    n = to_whole<std::int64_t>(rounded);
    to = run.code->jump_target(run.program(), n, run.state.pc);
  }
  if (to == kNowhere)
    return alarm(run, {Cause::JumpTargetNotFound, statement.variable_at, statement.variable_width,
                       run.code->no_block(n, run.program())});
  return jump_to(run, to);
}

bool open_loop(Run& run, const Statement& statement) {
  const MacroRules& rules = run.control().macros;
  if (rules.loops_count_across_calls.value &&
      run.state.loops.size() >= static_cast<std::size_t>(rules.max_loops.value))
    return alarm(run, {Cause::LoopsTooDeep, statement.at, statement.width,
                       "more loops inside each other than the control allows"});
  run.state.loops.push_back({run.state.pc});
  return true;
}

/// Execute a WHILE whose condition is known, or a DO, whose condition always holds.
inline bool loop(Run& run, const Statement& statement, bool holds) {
  std::vector<OpenLoop>& loops = run.state.loops;
  const bool inside = loops.size() > run.frame().loops && loops.back().start == run.state.pc;
  if (!holds) {
    if (inside) loops.pop_back();
    run.block.next = statement.to;
    return true;
  }
  return inside || open_loop(run, statement);
}

/// Leave the loops inside the one whose end this is; alarm where that one is not open.
bool leave_inner_loops(Run& run, const Statement& statement) {
  std::vector<OpenLoop>& loops = run.state.loops;
  while (loops.size() > run.frame().loops && loops.back().start != statement.to) loops.pop_back();
  return loops.size() > run.frame().loops ||
         alarm(run,
               {Cause::MissingDo, statement.at, statement.width, "a jump leads into this loop"});
}

bool end_loop(Run& run, const Statement& statement) {
  if (!leave_inner_loops(run, statement) || waits_here(run)) return false;
  run.block.next = statement.to;
  return true;
}

/// Execute a FOR: what counts takes its first value. The last value is evaluated once, here.
bool begin_count(Run& run, const Statement& statement, const Places& places, bool& holds) {
  const Statement& first = run.code->statements[statement.then];
  double last = 0, value = 0;
  if (!may_jump(run, statement) ||
      !evaluate(run, run.code->expression(statement.expression), places, last) ||
      !evaluate(run, run.code->expression(first.expression), places, value))
    return false;
  holds = value <= last;
  if (!holds && statement.to == kNowhere)
    return alarm(run,
                 {Cause::MissingEnd, statement.at, statement.width, "no end of the loop follows"});
  if (!store(run, first, value) || !loop(run, statement, holds)) return false;
  if (holds) run.state.loops.back().last = last;
  return true;
}

/// Count, and go back to the block after the FOR while the last value is not passed.
bool end_count(Run& run, const Statement& statement, const Places& places, bool& holds) {
  const Statement& next = run.code->statements[statement.then];
  double value = 0;
  if (!leave_inner_loops(run, statement) ||
      !evaluate(run, run.code->expression(next.expression), places, value) ||
      !store(run, next, value))
    return false;
  std::vector<OpenLoop>& loops = run.state.loops;
  holds = value <= loops.back().last;
  if (holds)
    run.block.next = statement.to + 1;
  else
    loops.pop_back();
  return true;
}

/// Execute SETVN.
bool name_variables(Run& run, const Statement& statement) {
  for (std::uint32_t i = 0; i < statement.variable_width; ++i) {
    if (i % kLongText == kLongText - 1 && breaks_off(run)) return false;
    const std::string& name = run.code->names[static_cast<std::size_t>(statement.index) + i];
    run.state.names[name] = statement.number + i;
  }
  return true;
}

/// Evaluate the condition of IF or WHILE. It is inlined, as every pass of a loop asks it.
CNCSUB_ALWAYS_INLINE inline bool condition(Run& run, std::uint32_t expression, const Places& places,
                                           bool& holds) {
  double value = 0;
  run.state.last_condition = expression;
  if (!evaluate_condition(run, run.code->expression(expression), places, value)) return false;
  holds = value != 0;
  return true;
}

/// Execute one of the statements that fill most loops; `holds`: its condition. Others are left.
enum class Ran : std::uint8_t { Yes, Stopped, Other };
CNCSUB_ALWAYS_INLINE inline Ran run_one(Run& run, const Block& block, const Places& places,
                                        bool& holds) {
  const auto ran = [](bool runs) { return runs ? Ran::Yes : Ran::Stopped; };
  if (block.op == Op::Set) return ran(set(run, block, places));
  if (block.op < Op::Assign || block.op > Op::EndDo) return Ran::Other;  // it has no statement
  const Statement& statement = run.code->statements[block.aux];
  switch (block.op) {
    case Op::Assign:
      return ran(assign(run, statement));
    case Op::IfGoto:
      return ran(condition(run, statement.expression, places, holds) &&
                 (!holds || jump_by_goto(run, statement)));
    case Op::While:
      return ran(may_jump(run, statement) && condition(run, statement.expression, places, holds) &&
                 loop(run, statement, holds));
    case Op::Do:
      return ran(may_jump(run, statement) && loop(run, statement, true));
    case Op::For:
      return ran(begin_count(run, statement, places, holds));
    case Op::EndFor:
      return ran(end_count(run, statement, places, holds));
    case Op::EndDo:
      return ran(end_loop(run, statement));
    default:
      return Ran::Other;
  }
}

}  // namespace

bool run_statements(Run& run, bool one, const Block*& instead) {
  State& s = run.state;
  const Block* const blocks = run.code->blocks.data();
  const Places places = cncsub::places(run);  // no statement opens or closes a level
  for (;;) {
    const Block& block = blocks[s.pc];
    run.block.next = s.pc + 1;
    bool holds = true;
    const Ran ran = run_one(run, block, places, holds);
    if (ran == Ran::Other) {
      instead = &block;
      return true;
    }
    if (ran == Ran::Stopped) return false;
    record_step(run, !holds);
    s.pc = run.block.next;
    if (one || s.executed >= run.watch.look_at || (blocks[s.pc].skip & run.options.skips) != 0)
      return true;
    if (run.watch.marked != nullptr && run.watch.marked[s.pc] != 0) return true;
  }
}

namespace {

/// Execute a CASE, or several IF GOTO: choose the first alternative that has the value, or whose
/// condition holds.
bool choose_alternative(Run& run, const Statement& choice, bool& holds, const Block*& instead) {
  const Places places = cncsub::places(run);
  const bool by_value = choice.index == Statement::kHasValue;
  double sought = 0;
  if (by_value) {
    run.state.last_condition = choice.expression;
    if (!evaluate(run, choice.expression, sought)) return false;
  }
  for (const Statement& of : alternatives_of(choice)) {
    bool chosen = of.index == Statement::kAlways;
    double value = 0;
    if (!chosen && by_value) {
      if (!evaluate(run, of.expression, value)) return false;
      chosen = value == sought;
    } else if (!chosen && !condition(run, of.expression, places, chosen)) {
      return false;
    }
    if (!chosen) continue;
    instead = &run.code->variants[of.then];
    return true;
  }
  holds = false;
  return true;
}

/// Record a statement that has done what it says as a step.
bool end_statement(Run& run, const Block& block, bool holds) {
  const bool device = block.op == Op::OpenOutput || block.op == Op::CloseOutput;
  if (device && run.observer != nullptr) run.observer->device = block.op;
  record_step(run, !holds);
  run.state.pc = run.block.next;
  return true;
}

}  // namespace

// A line for each case: shorter would be harder to read.
// NOLINTNEXTLINE(readability-function-size,readability-function-cognitive-complexity)
bool run_statement(Run& run, const Block& block, const Block*& instead) {
  const bool other = block.op == Op::Print || block.op == Op::HCode || block.op == Op::Set;
  const Statement* const statement = other ? nullptr : run.code->statements.data() + block.aux;
  bool runs = true, holds = true;
  switch (block.op) {
    case Op::Goto:
      runs = jump_by_goto(run, *statement);
      break;
    case Op::Set:
      runs = set(run, block, places(run));
      break;
    case Op::Assign:
      runs = assign(run, *statement);
      break;
    case Op::IfThen:
    case Op::If:
      runs = condition(run, statement->expression, places(run), holds);
      if (runs && holds && block.op == Op::IfThen) {
        instead = &run.code->variants[statement->then];
        return true;
      }
      if (!holds && block.op == Op::If) run.block.next = statement->to;
      break;
    case Op::Switch:
      runs = choose_alternative(run, *statement, holds, instead);
      if (runs && instead != nullptr) return true;
      break;
    case Op::Else:
      run.block.next = statement->to;
      break;
    case Op::HCode:
      runs = h_code(run, run.code->h_codes[block.aux], holds);
      break;
    case Op::Print:
      runs = print(run, run.code->prints[block.aux]);
      break;
    case Op::NameVariables:
      runs = name_variables(run, *statement);
      break;
    default:  // ENDIF, POPEN, PCLOS
      break;
  }
  return runs && end_statement(run, block, holds);
}

bool may_jump(Run& run, const Statement& statement) {
  return !run.frame().typed || !run.refuses(Cause::JumpInMdi) ||
         alarm(run, {Cause::JumpInMdi, statement.at, statement.width, "a jump or a loop in MDI"});
}

void leave_loops(Run& run, Address to) {
  std::vector<OpenLoop>& loops = run.state.loops;
  while (loops.size() > run.frame().loops) {
    const Address start = loops.back().start;
    if (to >= start && to <= run.code->statements[run.code->blocks[start].aux].end) break;
    loops.pop_back();
  }
}

bool jump_to(Run& run, Address to) {
  leave_loops(run, to);
  if (to <= run.state.pc && waits_here(run)) return false;
  run.block.next = to;
  return true;
}

bool waits(Run& run) { return waits_here(run); }

}  // namespace cncsub
