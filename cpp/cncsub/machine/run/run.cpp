#include "cncsub/machine/run/run.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/calls/modal.hpp"
#include "cncsub/machine/calls/parts.hpp"
#include "cncsub/machine/calls/returns.hpp"
#include "cncsub/machine/calls/words.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/watch.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kLookSkipped = 1 << 20;  // blocks skipped between two looks
constexpr std::size_t kPartRows = 1 << 20;      // of moves or changes: a part with more ends early
constexpr std::size_t kManySkipped = 1'000'000;
constexpr Op kFirstStatement = Op::Set, kLastStatement = Op::EndDo;

void after_plain_move(Run& run, const Block& block) {
  run.state.last_n = block.n >= 0 ? block.n : run.state.last_n;
  record_step(run);
  run.state.pc = run.block.next;
}

/// Return the G code of a plain move: the first of its two, the second, or -1 where none is
/// written.
int written_g(const Block& block, int first) {
  if ((block.flags & Block::kNoG) != 0) return -1;
  return (block.flags & Block::kSecondG) != 0 ? first + 1 : first;
}

CNCSUB_ALWAYS_INLINE inline bool linear(Run& run, const Block& block) {
  bool moved = false;
  const Cell* values = run.code->cells.data() + block.data;
  if (!run.motion.linear(block.mask, values, written_g(block, 0), run.step(), run.moves(), moved))
    return execute_words(run, block);
  run.state.changes += moved ? 1 : 0;
  if (run.state.modals.empty()) {
    after_plain_move(run, block);
    return true;
  }
  run.state.last_n = block.n >= 0 ? block.n : run.state.last_n;
  run.block.outcome = {};
  run.block.outcome.moved = moved;
  run.block.outcome.axis_word = (block.mask & kEndWords) != 0;
  return after_words(run);
}

bool arc(Run& run, const Block& block) {
  const Cell* values = run.code->cells.data() + block.data;
  if (!run.motion.arc(block.mask, values, written_g(block, 2), run.step(), run.moves()))
    return execute_words(run, block);
  ++run.state.changes;
  after_plain_move(run, block);
  return true;
}

/// Execute macro statements from the present block on, and a block of another kind that stands
/// after them or after THEN.
inline bool statements(Run& run, bool one) {
  const Block* instead = nullptr;
  return run_statements(run, one, instead) && (instead == nullptr || dispatch(run, *instead));
}

/// Execute the block at State::pc and record it. It decides where the run goes on. The macro
/// statements after a macro statement are executed too, unless `one` block is asked for.
inline bool execute(Run& run, const Block& block, bool one) {
  run.block.next = run.state.pc + 1;
  run.block.words_done = false;
  if (run.state.modals.empty()) {
    if (block.op == Op::Linear) return linear(run, block);
    if (block.op == Op::Arc) return arc(run, block);
    if (block.op >= kFirstStatement && block.op <= kLastStatement) return statements(run, one);
  }
  run.block.follows_moves = false;
  return dispatch(run, block);
}

/// Execute one block by the general path.
bool execute_generally(Run& run, const Block& block) {
  run.block.next = run.state.pc + 1;
  run.block.words_done = false;
  run.block.follows_moves = false;
  return dispatch(run, block);
}

/// Skip the block at State::pc and return true if a block-skip switch says so, or if a pass of
/// RepeatPart ends before it. A program of nothing but such blocks that starts over and over is
/// stopped: no limit counts it.
bool passes_over(Run& run, const Block& block) {
  State& s = run.state;
  if ((block.skip & run.options.skips) == 0) return false;
  const bool passed = (block.skip & Block::kPartEnd) != 0 && end_pass(run);
  if (!passed && (block.skip & run.options.skips & ~Block::kPartEnd) == 0) return false;
  if (s.skipped_behind != s.executed) s.skipped = 0;
  s.skipped_behind = s.executed;
  if (static_cast<std::size_t>(++s.skipped) > run.code->blocks.size() + kManySkipped)
    end_run(run, Stop::Limit);
  if (!passed) ++s.pc;
  return true;
}

/// Execute a block that assigns and says something, besides its words if it has any.
bool run_together(Run& run, const Block& block) {
  const ParallelAssign& all = run.code->parallel_assigns[block.aux];
  run.block.parallel_assign = &all;
  bool done = false;
  if (all.words != OWord::kNone) {
    const Block& words = run.code->variants[all.words];
    const bool together = words.op == Op::Words || words.op == Op::EndProgram;
    done = (together || assign_in_parallel(run)) && dispatch(run, words);
  } else if (assign_in_parallel(run)) {
    if (block.n >= 0) run.state.last_n = block.n;
    record_step(run);
    run.state.pc = run.block.next;
    done = true;
  }
  run.block.parallel_assign = nullptr;
  run.block.before_together.forget();
  return done;
}

bool statement(Run& run, const Block& block) {
  const Block* instead = nullptr;
  return run_statement(run, block, instead) && (instead == nullptr || dispatch(run, *instead));
}

/// Execute a macro statement, and enter the macro of a modal call that follows every block.
bool statement_before_macro(Run& run, const Block& block) {
  const std::int64_t before = run.state.executed;
  const Address at = run.state.pc;
  const Block* instead = nullptr;
  const bool loops = block.op == Op::IfGoto || block.op >= Op::While;
  bool runs = loops ? run_statements(run, true, instead) : run_statement(run, block, instead);
  if (runs && instead != nullptr)
    runs = run_statement(run, *std::exchange(instead, nullptr), instead);
  if (!runs || run.state.executed == before || run.state.stop != Stop::Running) return runs;
  run.state.moved_at = at;
  return call_after_move(run);
}

/// Execute one of two blocks, chosen by the skip switches or by who called.
bool choose(Run& run, const Block& block) {
  const Select& variant = run.code->selects[block.aux];
  bool second = (variant.skip & run.options.skips) != 0;
  const char letter = run.frame().code_letter;
  if (variant.address != 0 && letter != 0) {
    switch (run.control().macros.code_cascade.value) {
      case CodeCascade::None:
        second = true;
        break;
      case CodeCascade::OtherKind:
        second = (variant.address == 'G') == (letter == 'G');
        break;
      case CodeCascade::All:
        break;
    }
  }
  if (variant.of_called) second = !ends_the_run(run);
  return dispatch(run, run.code->variants[second ? variant.second : variant.first]);
}

/// Execute one block by the path of its library, and note the changes of watched variables.
void execute_alone(Run& run, const Block& block) {
  const std::int64_t before = run.state.executed;
  const Address at = run.state.pc;
  const Reach reach = reach_of(run, block);
  if (run.code->general_only)
    execute_generally(run, block);
  else
    execute(run, block, true);
  if (run.state.executed != before) note_changes(run, run.state.executed - 1, at, reach);
}

/// Execute blocks and nothing else until the run is to look for a reason to stop. Return false
/// where it is to `pause`. The caller asks whether variables are watched, not every pass.
template <bool watched>
inline bool run_blocks(Run& run, const Pauses& pauses, std::int64_t& passed) {
  State& s = run.state;
  const Block* blocks = run.code->blocks.data();
  const std::uint8_t* const marked = pauses.marked;
  const bool asks = static_cast<bool>(pauses.ask), each = asks && marked == nullptr;
  while (s.executed < run.watch.look_at && s.stop == Stop::Running) {
    const Block& block = blocks[s.pc];
    if ((block.skip & run.options.skips) != 0) [[unlikely]] {
      const bool passes = passes_over(run, block);
      if (++passed % kLookSkipped == 0) look_soon(run);
      if (passes) continue;
    }
    if (asks && (each || marked[s.pc] != 0) && pauses.ask()) return false;
    if constexpr (watched)
      execute_alone(run, block);
    else
      execute(run, block, each);
  }
  return true;
}

/// Return whether a part of a stream has rows enough.
bool is_full(const Trace& trace) {
  return trace.moves.size() > kPartRows || trace.changes.size() > kPartRows;
}

/// Let a run that was interrupted go on; return whether it runs.
bool goes_on(State& s) {
  if (s.stop == Stop::Interrupted) s.stop = Stop::Running;
  return s.stop == Stop::Running;
}

}  // namespace

bool run_one(Run& run, const std::function<bool()>& interrupted) {
  State& s = run.state;
  if (!goes_on(s)) return false;
  const AtWork at_work(run, interrupted);
  const std::int64_t before = s.executed;
  const Stop& broken_off = run.watch.broken_off;
  while (s.stop == Stop::Running && s.executed == before && broken_off == Stop::Running) {
    if (s.executed >= run.options.max_blocks) return end_run(run, Stop::Limit);
    const Block& block = run.code->blocks[s.pc];
    if (!passes_over(run, block)) execute_alone(run, block);
  }
  const bool limited = broken_off == Stop::Limit || stops(run) == Stop::Limit;
  if (s.stop == Stop::Running && limited) end_run(run, Stop::Limit);
  return s.executed != before;
}

bool passes_over(Run& run) { return passes_over(run, run.code->blocks[run.state.pc]); }

void run_on(Run& run, const std::function<bool()>& interrupted, const Pauses& pauses,
            std::int64_t until) {
  State& s = run.state;
  std::int64_t passed = 0;
  const std::int64_t last = std::min(until, run.options.max_blocks);
  goes_on(s);
  const AtWork at_work(run, interrupted);
  run.watch.marked = pauses.ask ? pauses.marked : nullptr;
  if (s.stop == Stop::Running && stops(run) == Stop::Limit) end_run(run, Stop::Limit);
  while (s.stop == Stop::Running) {
    // Between two looks at the clock, the memory and Ctrl-C, only blocks are executed.
    look_later(run, last);
    const bool quickly = run.watched.empty() && !run.code->general_only;
    const bool on =
        quickly ? run_blocks<false>(run, pauses, passed) : run_blocks<true>(run, pauses, passed);
    if (!on || s.stop != Stop::Running) return;
    const Stop broken_off = run.watch.broken_off;
    const Stop why = broken_off != Stop::Running ? broken_off : stops(run);
    if (why != Stop::Running)
      end_run(run, why);
    else if (s.executed >= run.options.max_blocks)
      end_run(run, Stop::Limit);
    else if (s.executed >= until || (until != kAllBlocks && is_full(run.trace)))
      return;
  }
}

// A line for each operation: shorter would be harder to read.
// NOLINTNEXTLINE(readability-function-size)
bool dispatch(Run& run, const Block& block) {
  if (block.length > kLongText) look_soon(run);
  if (takes_words(run)) {
    if (is_words(block.op) && has_words(block)) return every_block(run, block);
    run.block.follows_moves = true;
  }
  if (run.observer != nullptr && is_words(block.op)) run.observer->words = &block;
  if (block.op >= kFirstStatement && block.op <= kLastStatement && follows_statements(run))
      [[unlikely]]
    return statement_before_macro(run, block);
  switch (block.op) {
    case Op::Linear:
      return linear(run, block);
    case Op::Arc:
      return run.state.modals.empty() ? arc(run, block) : execute_words(run, block);
    case Op::Words:
      return execute_words(run, block);
    case Op::Call:
      return call(run, block);
    case Op::MacroCall:
      return macro_call(run, block);
    case Op::ModalCall:
      return modal_call(run, block);
    case Op::CancelModal:
      return cancel_modal(run, block);
    case Op::RepeatPart:
      return repeat_part(run, block);
    case Op::Return:
      return return_from_call(run, block);
    case Op::Jump:
      return jump(run, block);
    case Op::EndProgram:
      return end_program(run, block);
    case Op::OWord:
      return run_labelled(run, block);
    case Op::ParallelAssign:
      return run_together(run, block);
    case Op::Select:
      return choose(run, block);
    case Op::Fault:
      return alarm(run, run.code->faults[block.aux]);
    case Op::EndOfRecord:
      return end_of_record(run);
    case Op::IfGoto:
    case Op::While:
    case Op::Do:
    case Op::For:
    case Op::EndFor:
    case Op::EndDo:
      return statements(run, true);
    case Op::Set:
    case Op::Assign:
    case Op::Goto:
    case Op::IfThen:
    case Op::Switch:
    case Op::If:
    case Op::Else:
    case Op::EndIf:
    case Op::HCode:
    case Op::Print:
    case Op::OpenOutput:
    case Op::CloseOutput:
    case Op::NameVariables:
      return statement(run, block);
  }
  return true;
}

}  // namespace cncsub
