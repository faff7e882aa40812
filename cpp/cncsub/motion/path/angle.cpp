// Lines by their angle: one coordinate and an angle, or two angles and the end of the second line.
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {
namespace {

constexpr double kLeastAngle = 1;  // degrees; nearer to a line no end is sought on it [TDi 13]

double sine(double degrees) { return std::sin(degrees * kPi / 180); }

double cosine(double degrees) { return std::cos(degrees * kPi / 180); }

/// End the waiting line where the second line begins, whose end and angle are given.
Result meet_angles(MotionContext& m, BlockWords& block, Piece second, double angle) {
  const PlaneView view{plane_axes(second.plane), m.facts.share(0)};
  Piece first = m.state.pending_angle.line.front();
  const Point u{cosine(m.state.pending_angle.angle), sine(m.state.pending_angle.angle)},
      v{cosine(angle), sine(angle)};
  const Axes start = m.state.work + second.offset;
  const Point p = view.point(start), q = view.point(second.end);
  if (std::fabs(cross(u, v)) < sine(kLeastAngle))
    return fault_at({.addresses = m.facts.angles.mask}, Cause::AngleParallel, block);
  first.end = start;
  view.set(first.end, p + cross(q - p, v) / cross(u, v) * u);
  m.state.pending_angle = {};
  if (auto wrong = move(m, block, first)) return wrong;
  return move(m, block, second);
}

}  // namespace

bool angle_word(MotionView m, const BlockWords& block, double& angle) {
  const NcWords& w = block.words;
  if ((w.mask & m.facts.angles.mask) == 0) return false;
  const Control& c = *m.facts.control;
  if (!m.facts.lathe() && !c.motion.angles_on_mills.value) return false;
  const bool rapid = m.state.modal[at(Group::Motion)].meaning == Meaning::Rapid;
  const int place = m.facts.angles.find(rapid ? w.mask & ~bit('A') : w.mask);
  if (place < 0) return false;
  angle = w.value[static_cast<std::size_t>(place)];
  const bool thousandths =
      place == 'Q' - 'A'
          ? c.turning.cycle_unit.value == CycleUnit::Increments && angle == std::floor(angle)
          : c.reading.whole_numbers.value == WholeNumbers::Increments &&
                (w.whole >> place & 1) != 0;
  if (thousandths) angle *= 1e-3;
  return true;
}

Result pending_angle(MotionContext& m, BlockWords& block, Meaning meaning, double angle) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  auto [end, named] = target(m, block);
  const bool has_a = (named & axis_bit(plane.a)) != 0, has_b = (named & axis_bit(plane.b)) != 0;
  if (auto wrong = need_feed(m, block, meaning)) return wrong;
  const MoveKind kind = meaning == Meaning::Rapid ? MoveKind::Rapid : MoveKind::Feed;
  const double a_share = m.facts.share(plane.a), b_share = m.facts.share(plane.b);
  if (!m.state.pending_angle.waiting() && has_a != has_b) {
    if (std::fabs(has_a ? cosine(angle) : sine(angle)) < sine(kLeastAngle))
      return fault_at({.addresses = m.facts.angles.mask}, Cause::AngleParallel, block);
    const double slope = sine(angle) / cosine(angle);
    if (has_a)
      end[plane.b] += (end[plane.a] - m.state.work[plane.a]) * a_share * slope / b_share;
    else
      end[plane.a] += (end[plane.b] - m.state.work[plane.b]) * b_share / slope / a_share;
    named |= axis_bit(plane.a) | axis_bit(plane.b);
  }
  Piece piece = make_piece(m, block, kind, end, named);
  if (auto wrong = corner_words(m, block, piece)) return wrong;
  if (m.state.pending_angle.waiting()) {
    const auto absolute = [&](int axis) {
      return block.words.has(kAxisNames[static_cast<std::size_t>(axis)]) && !m.state.incremental;
    };
    if (!absolute(plane.a) || !absolute(plane.b))
      return fault_at({.addresses = kAxisWords}, Cause::AngleEnd, block);
    return meet_angles(m, block, piece, angle);
  }
  // With both coordinates the angle does not count. [TDi 13]
  if (has_a || has_b) return move(m, block, piece);
  piece.named |= axis_bit(plane.a) | axis_bit(plane.b);
  m.state.pending_angle = {angle, {piece}, 0};
  block.submitted = true;
  return std::nullopt;
}

Result check_angle(MotionContext& m, const BlockWords& block, bool waited) {
  if ((block.words.mask >> kCommaA & 1) != 0) {
    const bool taken = (m.facts.angles.mask >> kCommaA & 1) != 0 &&
                       (m.facts.lathe() || m.facts.control->motion.angles_on_mills.value);
    if (!taken) return fault_at('A', Cause::AddressNotUsable, block, ",A");
  }
  if (!waited || !m.state.pending_angle.waiting()) return std::nullopt;
  if (block.submitted) return fault_at({.addresses = kAxisWords}, Cause::AngleEnd, block);
  if (++m.state.pending_angle.idle > 1)
    return fault_at({.addresses = m.facts.angles.mask}, Cause::AngleNoEnd, block);
  return std::nullopt;
}

}  // namespace cncsub
