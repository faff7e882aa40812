// Lines by their angle: one coordinate and an angle, or two angles and the end of the second line.
#include "cncsub/motion_geometry.hpp"

namespace cncsub {
namespace {

constexpr double kLeastAngle = 1;  // degrees; nearer to a line no end is sought on it [TDi 13]

double sine(double degrees) { return std::sin(degrees * kPi / 180); }
double cosine(double degrees) { return std::cos(degrees * kPi / 180); }

}  // namespace

/// The angle of a line with the first axis of the plane, counter-clockwise, in degrees.
bool Motion::angle_word(const BlockWords& block, double& angle) const {
  const NcWords& w = block.words;
  const Control& c = *facts_->control;
  if (!facts_->lathe() && !c.angles_on_mills.value) return false;
  const bool rapid = s_.modal[at(Group::Motion)].meaning == Meaning::Rapid;
  const int place = facts_->angles.find(rapid ? w.mask & ~bit('A') : w.mask);
  if (place < 0) return false;
  angle = w.value[static_cast<std::size_t>(place)];
  const bool thousandths =
      place == 'Q' - 'A'
          ? c.cycle_increments.value && angle == std::floor(angle)
          : c.whole_numbers.value == WholeNumbers::Increments && (w.whole >> place & 1) != 0;
  if (thousandths) angle *= 1e-3;
  return true;
}

Motion::Result Motion::angled(BlockWords& block, Meaning meaning, double angle) {
  const PlaneAxes plane = plane_axes(s_.plane);
  std::uint32_t named = 0;
  Axes end = target(block, named);
  const bool has_a = (named & axis_bit(plane.a)) != 0, has_b = (named & axis_bit(plane.b)) != 0;
  if (auto wrong = need_feed(block, meaning)) return wrong;
  const MoveKind kind = meaning == Meaning::Rapid ? MoveKind::Rapid : MoveKind::Feed;
  const double a_share = facts_->share(plane.a), b_share = facts_->share(plane.b);
  if (!s_.angled.waiting && has_a != has_b) {
    if (std::fabs(has_a ? cosine(angle) : sine(angle)) < sine(kLeastAngle))
      return fault(Cause::AngleParallel, block);
    const double slope = sine(angle) / cosine(angle);
    if (has_a)
      end[plane.b] += (end[plane.a] - s_.work[plane.a]) * a_share * slope / b_share;
    else
      end[plane.a] += (end[plane.b] - s_.work[plane.b]) * b_share / slope / a_share;
    named |= axis_bit(plane.a) | axis_bit(plane.b);
  }
  Piece piece = make_piece(block, kind, end, named);
  if (auto wrong = corner_words(block, piece)) return wrong;
  if (s_.angled.waiting) {
    const auto absolute = [&](int axis) {
      return block.words.has(kAxisNames[static_cast<std::size_t>(axis)]) && !s_.incremental;
    };
    if (!absolute(plane.a) || !absolute(plane.b)) return fault(Cause::AngleEnd, block);
    return meet_angles(block, piece, angle);
  }
  // With both coordinates the angle does not count. [TDi 13]
  if (has_a || has_b) return move(block, piece);
  piece.named |= axis_bit(plane.a) | axis_bit(plane.b);
  s_.angled = {true, angle, piece, 0};
  block.submitted = true;
  return std::nullopt;
}

/// The line that waits ends where the one that ends here, at its angle, begins.
Motion::Result Motion::meet_angles(BlockWords& block, Piece second, double angle) {
  const PlaneView view{plane_axes(second.plane), facts_->share(0)};
  Piece first = s_.angled.piece;
  const Point u{cosine(s_.angled.angle), sine(s_.angled.angle)}, v{cosine(angle), sine(angle)};
  const Axes start = s_.work + first.offset;
  const Point p = view.point(start), q = view.point(second.end);
  if (std::fabs(cross(u, v)) < sine(kLeastAngle)) return fault(Cause::AngleParallel, block);
  first.end = start;
  view.set(first.end, p + cross(q - p, v) / cross(u, v) * u);
  s_.angled = {};
  if (auto wrong = move(block, first)) return wrong;
  return move(block, second);
}

/// Behind a line of which only the angle is known comes the one that tells its end; one block
/// without a move may stand between. [TDi 13 notes 6, 7]
Motion::Result Motion::check_angle(const BlockWords& block, bool waited) {
  if ((block.words.mask >> kCommaA & 1) != 0) {
    const bool taken = (facts_->angles.mask >> kCommaA & 1) != 0 &&
                       (facts_->lathe() || facts_->control->angles_on_mills.value);
    if (!taken) return fault(Cause::AddressNotUsable, block, ",A");
  }
  if (!waited || !s_.angled.waiting) return std::nullopt;
  if (block.submitted) return fault(Cause::AngleEnd, block);
  if (++s_.angled.idle > 1) return fault(Cause::AngleNoEnd, block);
  return std::nullopt;
}

}  // namespace cncsub
