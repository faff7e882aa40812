// A block from its words to its effect.
#include "cncsub/motion/block/block.hpp"

#include <algorithm>

#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {
namespace {

/// Return whether a code stands for a cycle of moves.
bool makes_cycle(Meaning meaning) { return is_simple_cycle(meaning) || is_multiple_cycle(meaning); }

/// Execute G70 to G76 of a lathe.
Result multiple_cycle(MotionContext& m, BlockWords& block) {
  switch (block.meaning(Group::OneShot)) {
    case Meaning::Finish:
    case Meaning::RoughTurn:
    case Meaning::RoughFace:
    case Meaning::RoughPattern:
      return contour(m, block, block.meaning(Group::OneShot));
    case Meaning::PeckFace:
    case Meaning::PeckTurn:
      return grooving(m, block, block.meaning(Group::OneShot));
    case Meaning::MultipleThread:
      return multiple_thread(m, block);
    default:
      return std::nullopt;
  }
}

Result straight(MotionContext& m, BlockWords& block, Meaning meaning) {
  if (double angle = 0; angle_word(m, block, angle)) return pending_angle(m, block, meaning, angle);
  const auto [end, named] = end_point(m, block);
  const bool bare = named == 0;
  if (bare && !(block.has(Group::Motion) && m.facts.refuses(Cause::NoFeed))) return std::nullopt;
  if (auto wrong = need_feed(m, block, meaning)) return wrong;
  if (bare) return std::nullopt;
  const MoveKind kind = meaning == Meaning::Rapid ? MoveKind::Rapid : MoveKind::Feed;
  if (!may_have_corner(m, block)) return move(m, block, kind, end, named);
  Piece piece = make_piece(m, block, kind, end, named);
  if (auto wrong = corner_words(m, block, piece)) return wrong;
  return move(m, block, piece);
}

// A line for each case: shorter would be harder to read.
// NOLINTNEXTLINE(readability-function-size,readability-function-cognitive-complexity)
Result one_shot(MotionContext& m, BlockWords& block) {
  switch (block.meaning(Group::OneShot)) {
    case Meaning::Dwell:
      return dwell(m, block);
    case Meaning::SetData:
      return set_data(m, block);
    case Meaning::CheckReference:
      return check_reference(m, block);
    case Meaning::Reference:
    case Meaning::SecondReference:
      return reference(m, block, block.meaning(Group::OneShot) == Meaning::Reference ? 1 : 2);
    case Meaning::FromReference:
      return from_reference(m, block);
    case Meaning::Skip:
      return skip(m, block);
    case Meaning::MeasureTool:
      return measure_tool(m, block);
    case Meaning::OneWay:
      return one_way(m, block);
    case Meaning::Tapping:  // a line at the feed; the code of motion stays in force
      return straight(m, block, Meaning::Line);
    case Meaning::PositionAxes:
      return position_axes(m, block);
    case Meaning::Local:
      return set_local(m, block);
    case Meaning::FrameShift:
    case Meaning::FrameShiftByAxis:
    case Meaning::FrameRotation:
    case Meaning::FrameScale:
    case Meaning::FrameMirror:
      return set_frame(m, block, block.meaning(Group::OneShot));
    case Meaning::Pole:
      return set_pole(m, block);
    case Meaning::Machine:
      return machine_move(m, block);
    case Meaning::SetCoordinate:
      return set_coordinate(m, block);
    case Meaning::ClearCoordinate:
      return clear_coordinate(m, block);
    case Meaning::SetShift:
    case Meaning::ClearShift:
    case Meaning::SuspendShift:
    case Meaning::RestoreShift:
      return change_shift(m, block, block.meaning(Group::OneShot));
    case Meaning::StoreReference:
      return store_reference(m, block);
    default:
      return multiple_cycle(m, block);
  }
}

void take_motion_code(MotionContext& m, const BlockWords& block) {
  if (!block.has(Group::Motion)) return;
  // The taper of a turning cycle ends with it. [TA 6 note 2]
  if (block.meaning(Group::Motion) != m.state.modal[at(Group::Motion)].meaning) m.state.turn = {};
  m.state.modal[at(Group::Motion)] = block.code(Group::Motion);
  m.state.no_motion = false;
  end_cycles(m.facts, m.state);
}

/// Return whether a block has words that a motion is made of, or the code of one.
bool has_motion(const BlockWords& block) {
  return block.has(Group::Motion) || block.has(Group::Cycle) ||
         (block.words.mask & (kAxisWords | kCentreWords)) != 0;
}

/// Return whether a block would move while no motion code is in force.
bool lacks_motion(MotionView m, const BlockWords& block) {
  return m.state.no_motion && (block.words.mask & kAxisWords) != 0 && !block.consumed;
}

/// Refuse what is not computed where the frame tilts the plane or scales its axes differently.
Result check_frame(MotionView m, const BlockWords& block, Meaning meaning) {
  if (keeps_arcs(m.state.frame, plane_axes(m.state.plane))) return std::nullopt;
  const bool line = meaning == Meaning::Rapid || meaning == Meaning::Line;
  if (line && side_of(m.state) == 0 && !in_cycle(m.state) && !may_have_corner(m, block))
    return std::nullopt;
  return fault(Cause::CodeNotComputed, block,
               "cncsub computes only lines in a frame that tilts the plane or scales its axes "
               "differently");
}

Result make_motion(MotionContext& m, BlockWords& block) {
  // A spline holds for its block; the mode before it stays in force. [rs274 2.9: convert_spline]
  if (block.meaning(Group::Motion) == Meaning::Spline) return spline(m, block);
  take_motion_code(m, block);
  if (block.has(Group::Cycle)) {
    if (auto wrong = enter_cycle(m, block)) return wrong;
  }
  if (lacks_motion(m, block)) return fault(Cause::NoMotionCode, block);
  const Meaning meaning = m.state.modal[at(Group::Motion)].meaning;
  if (m.state.frame.turned)
    if (auto wrong = check_frame(m, block, meaning)) return wrong;
  block.cycle = block.cycle || in_cycle(m.state) || makes_cycle(meaning);
  if (in_cycle(m.state)) return canned_cycle(m, block);
  if (is_simple_cycle(meaning)) return turning_cycle(m, block, meaning);
  switch (meaning) {
    case Meaning::Cw:
    case Meaning::Ccw:
      return arc(m, block, meaning);
    case Meaning::TangentArc:
      return tangent_arc(m, block);
    case Meaning::ThreePoints:
    case Meaning::ThreePointsAbsolute:
      return arc_by_points(m, block, meaning);
    case Meaning::Thread:
      if (m.state.modal[at(Group::Motion)].variant != 0) return thread_by_k(m, block);
      [[fallthrough]];
    case Meaning::VariableThread:
      return thread(m, block, meaning);
    case Meaning::Skip:
      return skip(m, block);
    case Meaning::DriveLineThread:
      return drive_line_thread(m, block);
    default:
      return straight(m, block, meaning);
  }
}

/// Execute G92.1 to G92.3 beside another code that holds for one block.
Result change_shift_beside(MotionContext& m, BlockWords& block) {
  for (const Meaning meaning : {Meaning::ClearShift, Meaning::SuspendShift, Meaning::RestoreShift})
    if (block.words.codes->all.test(at(meaning)) && block.meaning(Group::OneShot) != meaning)
      return change_shift(m, block, meaning);
  return std::nullopt;
}

/// Execute the one-shot code, then the motion by the axis words that it leaves.
Result leave_axes(MotionContext& m, BlockWords& block) {
  if (auto wrong = one_shot(m, block)) return wrong;
  if (auto wrong = change_shift_beside(m, block)) return wrong;
  return has_motion(block) && !block.consumed ? make_motion(m, block) : std::nullopt;
}

/// Return the words of chamfers and corner rounds in a block that another one of it comes before.
std::uint32_t other_corners(const MotionFacts& facts, const BlockWords& block) {
  const std::uint32_t all = (facts.chamfers.mask | facts.rounds.mask) & block.words.mask;
  const int round = facts.rounds.find(all);
  const int first = round >= 0 ? round : facts.chamfers.find(all);
  return first < 0 ? 0 : all & ~(1u << first);
}

/// Drop the words of arcs and frames that no code of the block takes.
void drop_unused_words(MotionContext& m, const BlockWords& block) {
  const MotionRules& rules = m.facts.control->motion;
  if (!rules.unused_words_told.value) return;
  std::uint32_t turns = 0, angles = 0, frames = 0, corners = 0, taken = 0;
  for (const char name : rules.added_turns.value) turns |= bit(name);
  for (const char name : rules.arc_angle_words.value) angles |= bit(name);
  for (const char name : rules.rotation_words.value) frames |= bit(name);
  for (const char name : rules.corner_feed_words.value) corners |= bit(name);
  const bool has_corner =
      !m.state.lookahead.corner.empty() && m.state.lookahead.corner.back().at == block.words.at;
  if (has_corner) corners = other_corners(m.facts, block);
  const Meaning once = block.meaning(Group::OneShot);
  const Meaning motion = m.state.modal[at(Group::Motion)].meaning;
  if (once == Meaning::FrameRotation) taken = frames;
  if (once == Meaning::PositionAxes) taken = kCentreWords;
  if (goes_with_motion(m.state, block) && block.submitted) {
    if (motion == Meaning::Cw || motion == Meaning::Ccw)
      taken = bit('R') | kCentreWords | turns | angles;
    if (motion == Meaning::TangentArc) taken = turns;
    if (motion == Meaning::ThreePoints || motion == Meaning::ThreePointsAbsolute ||
        motion == Meaning::Thread)
      taken = kCentreWords;
  }
  m.outcome.drop((((bit('R') | kCentreWords | turns | angles | frames) & ~taken) | corners) &
                 block.words.mask);
}

/// Do what the block does with its axis words.
Result act(MotionContext& m, BlockWords& block) {
  const Meaning once = block.meaning(Group::OneShot);
  if (once == Meaning::Ignored) return std::nullopt;
  if (leaves_axes(m.facts, block)) return leave_axes(m, block);
  if (goes_with_motion(m.state, block))
    return block.consumed ? std::nullopt : make_motion(m, block);
  take_motion_code(m, block);  // it holds for the blocks after this one, as the end of a cycle does
  if (block.meaning(Group::Cycle) == Meaning::CycleOff)
    if (auto wrong = enter_cycle(m, block)) return wrong;
  block.cycle = block.cycle || makes_cycle(once);
  if (once == Meaning::Machine)  // G53 moves after the shift is changed
    if (auto wrong = change_shift_beside(m, block)) return wrong;
  if (auto wrong = one_shot(m, block)) return wrong;
  return once == Meaning::Machine ? std::nullopt : change_shift_beside(m, block);
}

/// Return whether a block may change where things lie: it has T or H, or a code of a group other
/// than these.
bool sets_frame(const NcWords& words) {
  constexpr std::uint32_t kOthers = bit(Group::Motion) | bit(Group::Plane) | bit(Group::Distance) |
                                    bit(Group::Return) | bit(Group::Feed) | bit(Group::Radius) |
                                    bit(Group::Cycle);
  return (words.codes->groups & ~kOthers) != 0 || (words.mask & (bit('T') | bit('H'))) != 0;
}

/// Return whether everything that moves may let grow from block to block is still in range.
bool moved_in_range(const MotionState& s) {
  return in_range(s.work) && in_range(s.feed, s.polar_angle);
}

/// Return whether what other blocks change is in range too.
bool all_in_range(const MotionState& s, bool with_frame) {
  return moved_in_range(s) && in_range(s.speed, s.surface_speed, s.max_speed) &&
         (!with_frame || (in_range(s.offset) && in_range(s.length) && in_range(s.skip)));
}

/// Check a block and set its modes.
Result begin_block(MotionContext& m, BlockWords& block) {
  if (auto wrong = read_codes(m, block)) return wrong;
  if (auto wrong = check_block(m, block)) return wrong;
  if (const int code = block.words.codes->uncomputed; code >= 0)
    return fault_of(code, Cause::CodeNotComputed, block);
  if (block.has(Group::Diameter))  // it counts for the words of its own block too [rs274 2.9]
    m.state.diameter = block.meaning(Group::Diameter) == Meaning::DiameterOn;
  return set_modes(m, block);
}

/// Take over H, D and G45 to G48, and do what the block does. A length moves its axis at once.
Result set_offsets_and_act(MotionContext& m, BlockWords& block) {
  const bool length = block.has(Group::Length) || block.words.has('H');
  const Axes before = length ? m.state.length : Axes{};
  if (length)
    if (auto wrong = set_length(m, block)) return wrong;
  const bool edges = m.facts.control->motion.tool_edges.value;
  if (block.has(Group::Radius) || (!edges && block.words.has('D') && !takes_word(m, block, 'D')))
    if (auto wrong = set_radius(m, block)) return wrong;
  if ((block.words.mask & m.facts.contour_modes) != 0) {
    set_contour_offset(m, block);
    if (auto wrong = set_corner_modes(m, block)) return wrong;
  }
  if (block.has(Group::OneShot))
    if (auto wrong = set_longer(m, block)) return wrong;
  if (auto wrong = act(m, block)) return wrong;
  drop_unused_words(m, block);
  return length ? move_by_length(m, block, before) : std::nullopt;
}

/// Count a block without a move between the two sides of a corner; refuse what may not stand there.
Result stand_in_corner(MotionContext& m, const BlockWords& block) {
  const NcWords& w = block.words;
  const bool plain = w.codes->groups == 0 && (w.mask & (bit('T') | bit('D'))) == 0 && !w.ends &&
                     !w.stops && !w.has(Role::ToolChange);
  LookaheadQueue& lookahead = m.state.lookahead;
  const bool modal = lookahead.corner.back().modal_corner;
  if (modal && w.ends) return leave_corner(m);
  if (modal && m.state.modal_round == 0) lookahead.round_ended = true;
  if (plain && ++lookahead.idle <= m.facts.control->motion.corner_idle_blocks.value)
    return std::nullopt;
  if (modal)
    return fault(Cause::CodeNotComputed, block,
                 "cncsub does not compute this block between two sides whose corner is rounded as "
                 "all are: end the rounding in the block of the last side");
  return fault(Cause::CornerNoMove, block);
}

/// Check what is left to check when a block has done what it does.
Result end_block(MotionContext& m, const BlockWords& block, bool corner_waited, bool in_range) {
  if (corner_waited && !block.submitted) {
    if (auto wrong = stand_in_corner(m, block)) return wrong;
    return in_range ? std::nullopt : Result(out_of_range(block.words.at));
  }
  // A coordinate system that has been set counts as a move. [source 003, G20 G21 G22]
  const Meaning once = block.meaning(Group::OneShot);
  if (block.submitted || block.has(Group::Work) || once == Meaning::SetCoordinate ||
      once == Meaning::Local)
    m.state.moved_before = true;
  if (!in_range) return out_of_range(block.words.at);
  return count_idle(m, block.words.at);
}

}  // namespace

Result run_block(MotionContext& m, const NcWords& words, std::uint32_t step, bool of_cycle) {
  m.state.row_moves = nullptr;  // the modes change
  BlockWords block{.words = words, .step = step, .was_cycle = in_cycle(m.state), .cycle = of_cycle};
  const bool frame = sets_frame(words);
  const bool corner_waits = !m.state.lookahead.corner.empty(),
             angle_waits = m.state.pending_angle.waiting();
  const bool keeps = m.facts.control->motion.shifts_move_increments.value;
  const Axes from = keeps ? increments_from(m.state) : Axes{};
  if (auto wrong = begin_block(m, block)) return wrong;
  if (keeps) keep_increments(m.facts, m.state, from);
  if (auto wrong = set_offsets_and_act(m, block)) return wrong;
  if (auto wrong = check_angle(m, block, angle_waits)) return wrong;
  return end_block(m, block, corner_waits, all_in_range(m.state, frame));
}

}  // namespace cncsub
