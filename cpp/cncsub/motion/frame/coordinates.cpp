// Work coordinates: zero points and shifts.
#include <utility>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/frame/frame_values.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
void hold_zero(MotionState& state) {
  if (std::exchange(state.zero_is_held, true)) return;
  state.zero = state.tables.zero(system_in_force(state));
  state.zero_turn = turn_of_system(state, system_in_force(state));
}

Axes zero_offset(const MotionState& state) {
  const Axes& system = state.zero_is_held ? state.zero : state.tables.zero(system_in_force(state));
  return in_frame(state, state.tables.zero(0) + system) + state.shift + state.local +
         state.tool_shift + state.frame.shift;
}

double turn_of_system(const MotionState& state, int system) {
  const auto found = state.tables.angles->find(system);
  return found == state.tables.angles->end() ? 0 : found->second;
}

namespace {

/// Rotate the frame with the work system in force: what is in its coordinates is computed anew.
void turn_frame(MotionState& state) {
  const double angle =
      (state.zero_is_held ? state.zero_turn : turn_of_system(state, system_in_force(state))) * kPi /
      180;
  if (angle == state.frame_angle) return;
  const double by = state.frame_angle - angle;
  const Axes base = turned_by(by, state.work + state.offset);
  state.length = turned_by(by, state.length);
  state.tool_at = turned_by(by, state.tool_at);
  state.frame_angle = angle;
  state.offset = zero_offset(state);
  state.work = base - state.offset;
  settle_origin(state);
}

}  // namespace

void refresh_offset(MotionState& state) {
  if (!state.tables.angles->empty()) turn_frame(state);
  const Axes now = zero_offset(state);
  if (now == state.offset) return;
  state.work = state.work + (state.offset - now);
  state.offset = now;
  settle_origin(state);
  state.row_moves = nullptr;
}

Axes reported_shift(const MotionState& state) { return state.shifted ? state.kept_shift : Axes{}; }

void lose_written_shift(MotionState& state) {
  const Axes reported = reported_shift(state);
  if (reported == state.shift) return;
  state.work = state.work + (state.shift - reported);
  settle_origin(state);
  state.row_moves = nullptr;
}

namespace {

/// Put the extra work system in force that a block names, by its code or by a word.
Result select_extra(MotionContext& m, const BlockWords& block) {
  const int own = block.code(Group::Work).variant;
  const char word = own == kNamedByH ? 'H' : 'P';
  const double p = own > 0 ? own : block.words.has(word) ? counted(m, block.words, word) : 1;
  if (p < 1 || p > static_cast<double>(m.state.tables.extra->size()))
    return fault_at(word, Cause::WorkSystem, block);
  m.state.extra_system = to_whole<int>(p);
  return std::nullopt;
}

}  // namespace

Result select_work(MotionContext& m, BlockWords& block) {
  if (!block.has(Group::Work)) return std::nullopt;
  const Meaning meaning = block.meaning(Group::Work);
  // [TDi 21 note 6: G54 in a block of G50 is ignored]
  if (m.facts.lathe() && block.meaning(Group::OneShot) == Meaning::SetCoordinate)
    return std::nullopt;
  const int before = system_in_force(m.state);
  int system = static_cast<int>(meaning) - static_cast<int>(Meaning::Work1) + 1;
  if (meaning == Meaning::WorkExtra) {
    if (auto wrong = select_extra(m, block)) return wrong;
    system = 0;
  }
  m.state.work_system = system;
  m.state.modal[at(Group::Work)] = block.code(Group::Work);
  const WrittenOffset written = m.facts.control->motion.written_offset.value;
  if (written == WrittenOffset::WhenProgrammed) {
    m.state.zero_is_held = false;
    const Matrix matrix = m.state.frame.matrix;
    take_stored_frame(m.state);
    if (moves_wait(m.state) && matrix != m.state.frame.matrix)
      return fault_at({.groups = bit(Group::Work)}, Cause::CodeNotComputed, block,
                      "cncsub does not compute another rotation, scale or mirror while a radius is "
                      "compensated or a corner waits");
  } else if (system_in_force(m.state) != before) {
    if (written == WrittenOffset::WhenSelected) lose_written_shift(m.state);
    m.state.zero_is_held = false;
    m.state.set_anew[1] = true;
  }
  refresh_offset(m.state);
  return std::nullopt;
}

Result set_coordinate(MotionContext& m, BlockWords& block) {
  // Also under G91 it is a setting.
  const auto [given, named] = target(m, block, {.incremental = false, .polar = polar(m.state)});
  if (named == 0) return std::nullopt;
  if (m.facts.lathe() && m.facts.refuses(Cause::CoordinateSettingRefused))
    return fault(Cause::CoordinateSettingRefused, block);
  for (int i = 0; i < kAxes; ++i) {
    if ((named >> i & 1) == 0) continue;
    // What was G52's becomes part of the shift. [TDi 19 note 5]
    m.state.shift[i] += m.state.work[i] - given[i] + m.state.local[i];
    m.state.local[i] = 0;
    // The given point is the one without the tool offset. [TDi 18 table]
    if (m.facts.control->turning.set_coordinate_without_tool.value)
      m.state.shift[i] += m.state.tool_shift[i];
  }
  m.state.kept_shift = m.state.shift;
  m.state.shifted = true;
  m.state.set_anew[2] = true;
  refresh_offset(m.state);
  return std::nullopt;
}

Result change_shift(MotionContext& m, BlockWords& block, Meaning meaning) {
  MotionState& s = m.state;
  if (compensating(s))  // G92.1 to G92.3 do nothing then, and say nothing [rs274 2.9]
    return meaning == Meaning::SetShift ? Result(fault(Cause::CompensationShift, block))
                                        : std::nullopt;
  if (meaning == Meaning::SetShift) {
    for (int i = 0; i < kAxes; ++i)
      if (const char name = kAxisNames[static_cast<std::size_t>(i)]; block.words.has(name))
        s.shift[i] = number(m, block, name);
    s.kept_shift = s.shift;
  } else {
    s.shift = meaning == Meaning::RestoreShift ? s.kept_shift : Axes{};
    if (meaning == Meaning::ClearShift) s.kept_shift = {};
  }
  s.shifted = meaning == Meaning::SetShift || meaning == Meaning::RestoreShift;
  s.set_anew[2] = true;
  refresh_offset(s);
  return std::nullopt;
}

Result clear_coordinate(MotionContext& m, BlockWords& block) {
  for (int i = 0; i < kAxes; ++i)
    if (block.words.has(kAxisNames[static_cast<std::size_t>(i)]))
      m.state.shift[i] = m.state.local[i] = 0;
  refresh_offset(m.state);
  return std::nullopt;
}

Result set_local(MotionContext& m, BlockWords& block) {
  const bool lathe_a = m.facts.machine == MachineType::LatheA;
  for (int i = 0; i < (lathe_a ? 6 : kAxes); ++i)
    if (const char name = kAxisNames[static_cast<std::size_t>(i)]; block.words.has(name))
      m.state.local[i] = number(m, block, name);
  if (lathe_a)
    for (const auto& [letter, axis] : {std::pair{'U', 0}, {'V', 1}, {'W', 2}})
      if (block.words.has(letter)) m.state.local[axis] = number(m, block, letter);
  refresh_offset(m.state);
  return std::nullopt;
}

}  // namespace cncsub
