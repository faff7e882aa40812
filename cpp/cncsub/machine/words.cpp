#include "cncsub/machine/words.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "cncsub/machine/ends.hpp"
#include "cncsub/machine/expressions.hpp"
#include "cncsub/machine/limits.hpp"
#include "cncsub/machine/modal.hpp"
#include "cncsub/machine/output.hpp"
#include "cncsub/machine/outside.hpp"
#include "cncsub/machine/returns.hpp"
#include "cncsub/machine/saved.hpp"
#include "cncsub/machine/statements.hpp"
#include "cncsub/machine/together.hpp"
#include "cncsub/machine/variables.hpp"

namespace cncsub {

namespace {

constexpr std::uint32_t role_bit(Role role) { return 1u << static_cast<unsigned>(role); }
constexpr std::uint32_t kSavingRoles = role_bit(Role::SaveModes) | role_bit(Role::ForgetModes) |
                                       role_bit(Role::RestoreModes) | role_bit(Role::KeepModes);

// Moves that are kept for a block to be undone: it takes as long to keep them as to make one.
constexpr std::int64_t kHeldPieces = 8;

struct Place {
  std::uint32_t at, width;
};

/// Where a code is written that is an expression; that of other codes is their block.
Place place_of(const Run& run, const Block& block, const Cell& cell) {
  if (cell.value >= 0) return {block.text, block.length};
  const auto expression = run.code->expression(to_whole<std::uint32_t>(-1.0 - cell.value));
  return {expression.at(), expression.width()};
}

/// A G or M code in its cell: a number, or an expression, of which a vacant value (-1) is no code.
bool decode_code(Run& run, const Block& block, Address of, const Cell& cell, double factor,
                 int& code) {
  double value = cell.value;
  if (value < 0) {
    const auto expression = to_whole<std::uint32_t>(-1.0 - value);
    if (!evaluate(run, expression, value, of)) return false;
    if (is_vacant(value)) {
      code = -1;
      return true;
    }
    value = std::round(value * factor);
  }
  if (const auto [at, width] = place_of(run, block, cell); value < 0 || value > kLargestCode)
    return alarm(run, {Cause::ValueOutOfRange, at, width, "the code is out of range", of});
  code = to_whole<int>(value);
  return true;
}

/// Codes of which one is an expression, or of which a library has too many lists.
bool decode_codes(Run& run, const Block& block, Address of, const Cell*& cell, NcWords& words) {
  CodeList list;
  for (unsigned i = 0; i < block.g_count; ++i) {
    const Place place = place_of(run, block, *cell);
    int g = 0;
    if (!decode_code(run, block, of, *cell++, 10, g)) return false;
    if (g > 10000 || (g >= 0 && !run.code->g_codes.test(static_cast<std::size_t>(g))))
      return alarm(run, {.cause = Cause::GCodeNotAvailable,
                         .at = place.at,
                         .width = place.width,
                         .detail = "the control has no such G code",
                         .block = of,
                         .address = 'G',
                         .code = g});
    if (g >= 0) list.add_g(g);
  }
  for (unsigned i = 0; i < block.m_count; ++i) {
    int m = 0;
    if (!decode_code(run, block, of, *cell++, 1, m)) return false;
    if (m >= 0) list.add_m(m);
  }
  run.codes = {list, *run.meanings};
  words.codes = &run.codes;
  return true;
}

/// A word whose value is an expression.
bool decode_computed(Run& run, std::uint32_t expression, Address of, std::size_t place,
                     NcWords& words) {
  double value = 0;
  if (!evaluate(run, expression, value, of)) return false;
  if (std::fabs(value) >= run.largest_word) {  // a vacant value compares false
    const Expression e = run.code->expression(expression);
    if (std::fabs(value) > kLargest)
      return alarm(run, {Cause::Overflow, e.at(), e.width(), "the result is too large", of});
    return alarm(
        run,
        {Cause::ValueOutOfRange, e.at(), e.width(),
         "the value has more than " + std::to_string(most_digits(run.control())) + " digits", of});
  }
  if (is_vacant(value)) {
    if (run.control().macros.vacant_address.value == VacantAddress::Ignored)
      words.mask &= ~(1u << place);
    value = 0;
  }
  words.value[place] = (run.computed_whole >> place & 1) != 0 ? std::round(value) : value;
  words.computed |= 1u << place;
  return true;
}

/// What an M code of the control is.
Role role_of(const Run& run, int m) { return run.control().calls.roles.value.of_m(m); }

/// Whether the run waits for the operator at an M code.
bool waits_at(const Run& run, Role role) {
  return role == Role::Stop || (role == Role::OptionalStop && run.options.optional_stop);
}

/// What a G31 leaves: its position, in the variables of a control that keeps it among the commons
/// (X Z Y and the fourth and the fifth axis of a lathe [TDi p.94]); or that nothing was met.
void keep_skip(Run& run, SkipMove skip) {
  if (skip == SkipMove::Missed) {
    run.trace.missed_skips.push({run.state.executed, run.state.pc});
    return;
  }
  const int first = run.control().motion.skip_variables.value;
  if (first <= 0) return;
  for (int axis = 0; axis < kSkipAxes; ++axis)
    write_variable(run, first + axis, skip_position(run.motion.view(), axis));
}

/// What a G31 came to.
void take_skip(Run& run, SkipMove skip) {
  keep_skip(run, skip);
  if (run.options.inputs.workpiece == nullptr) run.state.taken.asked = Taken::kSkipSignal;
}

/// What the machine does about a code it was sent: its signals change, and variables that it
/// writes.
void answer(Run& run, char address, std::int64_t code) {
  if (run.options.inputs.answers.empty()) return;
  const auto found = run.options.inputs.answers.find({address, code});
  if (found == run.options.inputs.answers.end()) return;
  for (const auto& [number, value] : found->second) set_from_outside(run, number, value);
  ++run.state.changes;
}

/// M, T and S codes go to the machine; M00 and M01 wait for the operator.
bool send_codes(Run& run, const NcWords& words, const Block& block) {
  const auto record = [&](char kind, double value) {
    if (run.trace.depth == Trace::Depth::None) return;
    run.trace.codes.push({run.state.executed, value, run.state.pc, kind});
  };
  if (words.has('T')) {
    const auto tool = to_whole<std::int64_t>(std::round(words['T']));
    record('T', static_cast<double>(tool));
    answer(run, 'T', tool);
  }
  // With G50 or G92 it is no speed, but the highest there may be.
  if (words.has('S') && words.codes->meaning(Group::OneShot) != Meaning::SetCoordinate)
    record('S', words['S']);
  for (const int m : words.codes->m()) {
    record('M', m);
    run.state.last_m = m;
    answer(run, 'M', m);
    const Role role = role_of(run, m);
    if (waits_at(run, role) && !wait_for_operator(run, CodeName{'M', m * 10}.text())) return false;
    if (role == Role::StartOver && run.state.frames.size() == 1)
      run.block.next = RunningBlock::kRestart;
    if (role == Role::End && block.op != Op::EndProgram) run.block.next = RunningBlock::kEnd;
  }
  return true;
}

/// Tells the words to who listens.
void hear(Run& run, const Block& block, const NcWords& words) {
  const bool has_extra = (block.flags & Block::kHasExtra) != 0;
  const bool computed = words.codes == &run.codes ||
                        (has_extra && run.code->cells[block.data].extra.expressions != 0);
  if (computed)
    run.heard->keep(block, words, run.codes);
  else
    run.heard->words = &block;
}

/// Moves that were made count, and those that wait.
void count_moves(Run& run) {
  run.watch.moves += run.block.outcome.moves;
  if (const Held& held = run.motion.state().held; !held.radius.empty() || !held.corner.empty())
    run.watch.moves += held_pieces(run.motion.state()) / kHeldPieces;
  if (run.watch.moves > run.watch.look_moves) look_soon(run);
}

/// What there is to do about a motion that was made.
void follow_up(Run& run, const Outside& around) {
  const Motion::Outcome& outcome = run.block.outcome;
  if (around.skips.taken) {
    about_to_take(run);
    run.state.taken.skips = *around.skips.taken;
  }
  if (outcome.skip != SkipMove::No) take_skip(run, outcome.skip);
  count_moves(run);
}

bool execute(Run& run, const NcWords& words, Outside& around) {
  if (auto fault = run.motion.execute(words, run.step(), run.moves(), run.block.outcome, around))
    return run.watch.broken_off == Stop::Running && alarm_of_motion(run, *fault);
  run.watch.in_block = 0;
  return true;
}

/// The motion of a block that names a profile.
bool move_along(Run& run, const NcWords& words, const ProfileNumbers& wanted) {
  Outside around = outside(run);
  std::optional<Profile> profile(std::in_place);
  profile->fault = read_profile(run, wanted, *profile);
  if (run.state.stop != Stop::Running) return false;
  around.profile = &*profile;
  if (!execute(run, words, around)) return false;
  if (run.heard != nullptr) run.heard->profile = std::move(profile);
  follow_up(run, around);
  return true;
}

/// The motion of a block: moves, modes, offsets.
bool move(Run& run, const Block& block, NcWords& words) {
  words.ends = block.op == Op::EndProgram && ends_the_run(run);
  words.stops = words.ends || words.has(Role::Stop) || words.has(Role::End) ||
                (run.options.optional_stop && words.has(Role::OptionalStop));
  if (const auto wanted = run.motion.wanted_profile(words)) return move_along(run, words, *wanted);
  Outside around = outside(run);
  if (!execute(run, words, around)) return false;
  follow_up(run, around);
  return true;
}

/// The words of a block without those that hold no longer when it has taken modes back: F, S and
/// how the feed counts are read before. [rs274 2.9]
NcWords behind_modes(const NcWords& words, BlockCodes& codes) {
  NcWords left = words;
  codes = *words.codes;
  codes.groups &= ~bit(Group::Feed);
  codes.of[at(Group::Feed)] = {};
  left.codes = &codes;
  left.mask &= ~(bit('F') | bit('S'));
  return left;
}

bool move_behind_modes(Run& run, const Block& block, const NcWords& words) {
  BlockCodes codes;
  NcWords left = behind_modes(words, codes);
  return move(run, block, left);
}

}  // namespace

bool decode(Run& run, const Block& block, Address at, NcWords& words) {
  const Cell* cell = run.code->cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) {
    expressions = cell->extra.expressions;
    words.whole = cell->extra.whole;
    ++cell;
  }
  words.at = at;
  if ((block.flags & Block::kListed) != 0)
    words.codes = &run.meanings->blocks[block.list];
  else if (block.has_codes() && !decode_codes(run, block, at, cell, words))
    return false;
  words.mask = block.mask;
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const auto place = static_cast<std::size_t>(std::countr_zero(left));
    if ((expressions & (1u << place)) == 0)
      words.value[place] = cell->value;
    else if (!decode_computed(run, static_cast<std::uint32_t>(cell->expression), at, place, words))
      return false;
  }
  return true;
}

bool carry_out(Run& run, const Block& block) {
  NcWords words;
  if (!decode(run, block, run.state.pc, words)) return false;
  if (run.heard != nullptr) hear(run, block, words);
  if (run.block.together != nullptr && !set_together(run)) return false;
  if (auto fault = unused_word(run.motion.view(), words))
    return alarm_of_motion(run, std::move(*fault));
  if ((words.codes->roles & kSavingRoles) != 0 && !change_saved_modes(run, words)) return false;
  const bool moved = words.has(Role::RestoreModes) ? move_behind_modes(run, block, words)
                                                   : move(run, block, words);
  if (!moved || !send_codes(run, words, block)) return false;
  const Motion::Outcome& outcome = run.block.outcome;
  if ((block.flags & Block::kDrops) != 0 || (outcome.dropped | outcome.dropped_codes) != 0)
    tell_dropped(run, block, words);
  run.block.words_done = true;
  if (outcome.missed_reference)
    return alarm_of_motion(run, {.cause = Cause::NotAtReference, .at = run.state.pc, .detail = {}});
  if (block.n >= 0) run.state.last_n = block.n;
  if (outcome.moved || words.has('T') || !words.codes->only_of_moves()) ++run.state.changes;
  if (is_words(block.op)) return after_words(run);
  if (run.block.next != RunningBlock::kEnd) return true;
  record_step(run);  // M#1 beside a call, a return or a jump ends the program before it
  return end_run(run, Stop::End);
}

bool after_words(Run& run) {
  record_step(run);
  run.state.moved_at = run.state.pc;
  const Address next = run.block.next;
  if (next == RunningBlock::kRestart || next == RunningBlock::kEnd) return proceed(run, next);
  const Address behind = run.block.outcome.behind;
  if (behind != kNowhere) leave_loops(run, behind);
  run.state.pc = behind != kNowhere ? behind : next;
  return call_after_move(run);
}

bool wait_for_operator(Run& run, const std::string& what) {
  const Inputs& inputs = run.options.inputs;
  if (!inputs.operator_given) return true;
  const std::size_t answer = run.state.next_answer++;
  if (answer < inputs.operator_starts.size() && inputs.operator_starts[answer]) return true;
  run.state.waiting_for = "cycle start after " + what;
  record_step(run);
  return proceed(run, run.block.next) && end_run(run, Stop::Waiting);
}

}  // namespace cncsub
