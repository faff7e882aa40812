// Reference points and machine coordinates: G53, G27 to G30, G60.
#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Return the tool length that is left on an axis that goes to a machine coordinate. The length is
/// taken away, except where it shifts the work coordinates.
double length_left(MotionContext& m, int axis) {
  double& length = m.state.length[static_cast<std::size_t>(axis)];
  if (m.facts.control->motion.length_type.value == LengthType::Shift ||
      m.facts.control->motion.machine_move.value == MachineMove::ModalWithTool)
    return length;
  return length = 0;
}

/// Execute G53 in a rotated work system: an axis without a word stays where it is in the machine.
Result turned_machine_move(MotionContext& m, BlockWords& block, MoveKind kind) {
  Axes machine = in_machine(m.state, machine_point(m.state));
  std::uint32_t named = 0;
  for (int i = 0; i < kAxes; ++i)
    if (const char name = kAxisNames[static_cast<std::size_t>(i)]; block.words.has(name)) {
      named |= i < 2 ? 3u : axis_bit(i);
      machine[static_cast<std::size_t>(i)] = number(m, block, name);
    }
  if (named == 0) return std::nullopt;
  if (kind == MoveKind::Feed)
    if (auto wrong = need_feed(m, block, Meaning::Line)) return wrong;
  const Axes end = in_frame(m.state, machine) - m.state.offset - m.state.length;
  return move(m, block, make_piece(m, block, kind, end, named));
}

/// Return where G53 leads without a rotated frame, along the axes that it names.
NamedPoint machine_target(MotionContext& m, const BlockWords& block) {
  std::uint32_t named = 0;
  Axes end = m.state.work;
  // G53 leaves the zero point of all systems in force; the codes that suppress it are variant 1.
  const Axes basic = block.code(Group::OneShot).variant == 1 ? Axes{} : m.state.tables.zero(0);
  for (int i = 0; i < kAxes; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (!block.words.has(name) || (m.facts.machine == MachineType::LatheA && i > 5)) continue;
    named |= axis_bit(i);
    const double value = number(m, block, name);
    m.state.unmoved[i] = 0;
    if (block.words.forms.is_incremental(bit(name), m.state.incremental))
      end[i] += value;
    else if (m.facts.control->motion.machine_move.value == MachineMove::ModalWithTool)
      end[i] = value - m.state.offset[i] + basic[i];
    else
      end[i] = value - m.state.offset[i] - length_left(m, i);
  }
  return {end, named};
}

/// Return whether a block has words of a path that is no line between points of axes.
bool has_other_path(const BlockWords& block, Meaning meaning) {
  const bool line = meaning == Meaning::Rapid || meaning == Meaning::Line;
  return (block.words.mask & kPolarWords) != 0 ||
         (!line && (block.words.mask & (kAxisWords | kCentreWords)) != 0);
}

}  // namespace

Result machine_move(MotionContext& m, BlockWords& block) {
  const Control& c = *m.facts.control;
  const bool modal = c.motion.machine_move.value != MachineMove::Rapid;
  if (!m.facts.homed && m.facts.refuses(Cause::NotHomed)) return fault(Cause::NotHomed, block);
  if (m.state.incremental && !modal) return std::nullopt;
  if (m.state.incremental && c.motion.machine_move.value == MachineMove::ModalAbsolute)
    return fault(Cause::MachineMoveIncremental, block);
  const Meaning meaning = m.state.modal[at(Group::Motion)].meaning;
  if (const int code = block.code(Group::OneShot).code; modal && has_other_path(block, meaning))
    return fault_at(
        WordName{.code = code}, Cause::CodeNotComputed, block,
        "cncsub computes " + code_name(code) + " only on lines between points that axes name");
  const MoveKind kind = modal && meaning != Meaning::Rapid ? MoveKind::Feed : MoveKind::Rapid;
  if (modal && m.state.frame_angle != 0) return turned_machine_move(m, block, kind);
  const auto [end, named] = machine_target(m, block);
  if (named == 0) return std::nullopt;
  if (kind == MoveKind::Feed)
    if (auto wrong = need_feed(m, block, Meaning::Line)) return wrong;
  return move(
      m, block,
      modal ? make_piece(m, block, kind, end, named) : uncompensated(m, block, kind, end, named));
}

Result reference(MotionContext& m, BlockWords& block, int number_of_point) {
  if (number_of_point == 2) {
    const double p = block.words.has('P') ? counted(m, block.words, 'P') : 2;
    if (p < 2 || p > 4) return fault_at('P', Cause::ReferenceNumber, block);
    if (!m.facts.homed && m.facts.refuses(Cause::ReferenceNotHomed))
      return fault(Cause::ReferenceNotHomed, block);
    number_of_point = to_whole<int>(p);
  }
  auto [middle, named] = linear_target(m, block);
  const bool direct = block.code(Group::OneShot).variant == 2;  // the words only name the axes
  if (direct && named == 0) return std::nullopt;
  if (direct) {
    middle = m.state.work;
  } else if (named == 0) {
    if (block.code(Group::OneShot).variant == 0) return std::nullopt;
    named = m.state.named | 7u;  // all axes go, and no point lies between [rs274 2.9]
  } else if (auto wrong = move(m, block, uncompensated(m, block, MoveKind::Rapid, middle, named))) {
    return wrong;
  }
  m.state.middle_known |= named;
  const Axes point = in_frame(m.state, m.state.tables.point(number_of_point));
  Axes end = m.state.work;
  for (int i = 0; i < kAxes; ++i) {
    if ((named >> i & 1) == 0) continue;
    m.state.middle[i] = middle[i] + m.state.offset[i];
    end[i] = point[static_cast<std::size_t>(i)] - m.state.offset[i] - length_left(m, i);
  }
  return move(m, block, uncompensated(m, block, MoveKind::Rapid, end, named));
}

Result store_reference(MotionContext& m, BlockWords& block) {
  if (compensating(m.state)) return fault(Cause::CompensationShift, block);
  m.state.tables.reference.change()[block.code(Group::OneShot).variant] =
      in_machine(m.state, machine_point(m.state));
  return std::nullopt;
}

Result from_reference(MotionContext& m, BlockWords& block) {
  const std::uint32_t named = linear_target(m, block).named;
  if (m.state.middle_known == 0) return fault(Cause::NoIntermediate, block);
  if (named == 0) return std::nullopt;
  Axes middle = m.state.work;
  for (int i = 0; i < kAxes; ++i)
    if ((named >> i & 1) != 0 && (m.state.middle_known >> i & 1) != 0)
      middle[i] = m.state.middle[i] - m.state.offset[i];
  if (auto wrong = move(m, block, MoveKind::Rapid, middle, named)) return wrong;
  const Axes end = linear_target(m, block).point;
  return move(m, block, MoveKind::Rapid, end, named);
}

Result check_reference(MotionContext& m, BlockWords& block) {
  const auto [end, named] = linear_target(m, block);
  if (named == 0) return std::nullopt;
  if (auto wrong = move(m, block, MoveKind::Rapid, end, named)) return wrong;
  const Axes away = machine_point(m.state) - m.state.tables.point(1);
  for (int i = 0; i < kAxes; ++i)
    if ((named >> i & 1) != 0 && std::fabs(away[i]) > m.facts.increment / 2)
      m.outcome.missed_reference = true;
  return std::nullopt;
}

Result one_way(MotionContext& m, BlockWords& block) {
  if (block.has(Group::Motion)) m.state.modal[at(Group::Motion)] = block.code(Group::Motion);
  end_cycles(m.facts, m.state);
  const auto [end, named] = target(m, block);
  if (named == 0) return std::nullopt;
  const double overrun = m.facts.control->motion.one_way_overrun.value * 1e-3;
  Axes past = end;
  for (int i = 0; i < kAxes; ++i)
    if ((named >> i & 1) != 0) past[i] -= overrun;
  if (overrun != 0)
    if (auto wrong = move(m, block, MoveKind::Rapid, past, named)) return wrong;
  return move(m, block, MoveKind::Rapid, end, named);
}

}  // namespace cncsub
