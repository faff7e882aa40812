// Polar coordinates, and what transforms written points: rotation, scaling, mirror.
#include <algorithm>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

Result set_rotation(MotionContext& m, BlockWords& block) {
  const Control& c = *m.facts.control;
  Transform transform = m.state.transform;
  transform.rotation = block.meaning(Group::Rotation) == Meaning::RotationOn;
  if (transform.rotation) {
    transform.angle = 0;
    std::uint32_t others = bit('P') | bit('R');  // the angle of other controls
    for (const char name : c.motion.rotation_words.value) {
      if (block.words.has(name)) transform.angle = block.words[name];
      others &= ~bit(name);
    }
    m.outcome.drop(block.words.mask & others);
    if (c.motion.max_rotation.value > 0 && std::fabs(transform.angle) > c.motion.max_rotation.value)
      return fault_at('R', Cause::RotationAngle, block);
    transform.plane = m.state.plane;
    transform.frame = m.facts.lathe();
    for (int i = 0; i < 3; ++i) {
      const char name = kAxisNames[static_cast<std::size_t>(i)];
      // The centre is absolute under G91 as well. [B-64113EN]
      transform.centre[i] = block.words.has(name) ? number(m, block, name) : m.state.work[i];
    }
    block.consumed = true;
  }
  m.state.transform = transform;
  m.state.modal[at(Group::Rotation)] = block.code(Group::Rotation);
  return std::nullopt;
}

/// Return whether P of G51 counts thousandths.
bool scales_by_thousandths(MotionView m, const BlockWords& block) {
  const ScaleUnit unit = m.facts.control->motion.scale_unit.value;
  return unit == ScaleUnit::Thousandths ||
         (unit == ScaleUnit::AsWritten && (block.words.computed & bit('P')) != 0);
}

/// Return the scale at an address. I J K without a point count thousandths where lengths count
/// increments. [general knowledge]
double scale_of(MotionView m, const BlockWords& block, char address) {
  const bool thousandths =
      address == 'P' ? scales_by_thousandths(m, block)
                     : (block.words.whole & bit(address)) != 0 &&
                           m.facts.control->reading.whole_numbers.value == WholeNumbers::Increments;
  return block.words[address] * (thousandths ? 0.001 : 1);
}

Result set_scaling(MotionContext& m, BlockWords& block) {
  const NcWords& w = block.words;
  m.state.modal[at(Group::Scaling)] = block.code(Group::Scaling);
  m.state.transform.scaling = block.meaning(Group::Scaling) == Meaning::ScalingOn;
  if (!m.state.transform.scaling) return std::nullopt;
  block.consumed = true;
  if (w.has('P')) m.outcome.drop(w.mask & (bit('I') | bit('J') | bit('K')));
  for (int i = 0; i < 3; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)], own = "IJK"[i];
    // The centre is absolute under G91, as that of rotation. [B-63682EN p.117]
    m.state.transform.scale_centre[i] = w.has(name) ? number(m, block, name) : m.state.work[i];
    double scale = w.has('P') ? scale_of(m, block, 'P') : w.has(own) ? scale_of(m, block, own) : 1;
    if (scale == 0)
      return fault_at({.addresses = bit('P') | kCentreWords}, Cause::ScaleZero, block);
    if (scale < 0 && m.facts.refuses(Cause::ScaleNegative))
      return fault_at({.addresses = bit('P') | kCentreWords}, Cause::ScaleNegative, block);
    m.state.transform.scale[i] = scale;
  }
  return std::nullopt;
}

void set_mirror(MotionContext& m, BlockWords& block) {
  const bool on = block.meaning(Group::Mirror) == Meaning::MirrorOn;
  bool any = false;
  for (int i = 0; i < 3; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (!block.words.has(name)) continue;
    any = true;
    if (on) m.state.transform.mirror_at[i] = number(m, block, name);
    m.state.transform.mirrored =
        on ? m.state.transform.mirrored | axis_bit(i) : m.state.transform.mirrored & ~axis_bit(i);
  }
  if (!on && !any) m.state.transform.mirrored = 0;
  m.state.transform.mirror = m.state.transform.mirrored != 0;
  if (on || !m.state.transform.mirror) m.state.modal[at(Group::Mirror)] = block.code(Group::Mirror);
  block.consumed = true;
}

void rotate(double& a, double& b, double degrees) {
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  const double transform = a * c - b * s;
  b = a * s + b * c;
  a = transform;
}

}  // namespace

void polar_target(MotionContext& m, const BlockWords& block, bool incremental, Axes& end,
                  std::uint32_t& named) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  const char radius_name = kAxisNames[static_cast<std::size_t>(plane.a)];
  const char angle_name = kAxisNames[static_cast<std::size_t>(plane.b)];
  const bool has_radius = block.words.has(radius_name), has_angle = block.words.has(angle_name);
  if (!has_radius && !has_angle) return;
  const double a = m.state.work[plane.a], b = m.state.work[plane.b];
  // A radius written under G91 counts from where the tool is. [16MC p.147]
  const bool from_tool = has_radius && incremental;
  const double radius = has_radius ? number(m, block, radius_name) : std::hypot(a, b);
  const double direction = std::hypot(a, b) < kStanding ? 0 : std::atan2(b, a) * 180 / kPi;
  const double present = m.state.polar_known ? m.state.polar_angle : direction;
  double angle = present;
  if (has_angle) angle = block.words[angle_name] + (incremental ? present : 0);
  m.state.polar_angle = angle;
  m.state.polar_known = true;
  const double t = angle * kPi / 180;
  end[plane.a] = (from_tool ? a : 0) + radius * std::cos(t);
  end[plane.b] = (from_tool ? b : 0) + radius * std::sin(t);
  named |= axis_bit(plane.a) | axis_bit(plane.b);
}

Result set_pole(MotionContext& m, BlockWords& block) {
  const MotionState& s = m.state;
  const PlaneAxes plane = plane_axes(s.plane);
  std::array<double, 3> pole{};
  if (const int from = block.code(Group::OneShot).variant; from == 1) {
    const Axes point = as_programmed(s, s.work);
    std::copy(point.begin(), point.begin() + 3, pole.begin());
  } else if (from == 3) {
    pole = s.pole;
  }
  for (std::size_t i = 0; i < pole.size(); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name)) pole[i] += number(m, block, name);
  if (block.words.has_place(kRadius)) {
    const double radius = block.words.value[kRadius] * s.unit;
    const double angle = block.words.value[kAngle] * kPi / 180;  // 0 where it is not given
    pole[static_cast<std::size_t>(plane.a)] += radius * std::cos(angle);
    pole[static_cast<std::size_t>(plane.b)] += radius * std::sin(angle);
  }
  m.state.pole = pole;
  block.consumed = true;
  return std::nullopt;
}

namespace {

/// Set the end by polar words about the pole. A word that is missing keeps its value.
void words_about_pole(MotionView m, const BlockWords& block, bool incremental, Axes& end,
                      std::uint32_t& named) {
  const NcWords& w = block.words;
  const PlaneAxes plane = plane_axes(m.state.plane);
  const double pole_a = m.state.pole[static_cast<std::size_t>(plane.a)],
               pole_b = m.state.pole[static_cast<std::size_t>(plane.b)];
  double radius = std::hypot(end[plane.a] - pole_a, end[plane.b] - pole_b);
  double angle = radius < kStanding ? 0 : std::atan2(end[plane.b] - pole_b, end[plane.a] - pole_a);
  // A radius is absolute under G91 too. [840Df p.118]
  const bool adds = w.forms.is_incremental(1u << kRadius, false);
  if (w.has_place(kRadius)) radius = w.value[kRadius] * m.state.unit + (adds ? radius : 0);
  if (w.has_place(kAngle))
    angle = w.value[kAngle] * kPi / 180 +
            (w.forms.is_incremental(1u << kAngle, incremental) ? angle : 0);
  end[plane.a] = pole_a + radius * std::cos(angle);
  end[plane.b] = pole_b + radius * std::sin(angle);
  named |= axis_bit(plane.a) | axis_bit(plane.b);
}

/// Refuse a radius below zero and an angle of more than a full turn. [840De p.4-4: RP is positive,
/// AP within 360 degrees]
Result check_polar_values(MotionView m, const BlockWords& block) {
  const NcWords& w = block.words;
  const bool pole = block.meaning(Group::OneShot) == Meaning::Pole;
  const PlaneAxes plane =
      plane_axes(block.has(Group::Plane) ? plane_of(block.meaning(Group::Plane)) : m.state.plane);
  const auto named = [](int place) { return WordName{.addresses = 1u << place}; };
  double radius = w.value[kRadius];
  if (w.forms.is_incremental(1u << kRadius, false)) {
    const Axes from = as_programmed(m.state, m.state.work);
    const auto a = static_cast<std::size_t>(plane.a), b = static_cast<std::size_t>(plane.b);
    radius += std::hypot(from[a] - m.state.pole[a], from[b] - m.state.pole[b]) / m.state.unit;
  }
  if (w.has_place(kRadius) && radius < -kStanding)
    return fault_at(named(kRadius), pole ? Cause::PoleRadius : Cause::PolarRadius, block);
  if (w.has_place(kAngle) && std::fabs(w.value[kAngle]) > 360)
    return fault_at(named(kAngle), pole ? Cause::PoleAngle : Cause::PolarAngle, block);
  return std::nullopt;
}

/// Refuse coordinates of the plane beside polar words.
Result check_about_pole(MotionView m, const BlockWords& block) {
  if (auto wrong = check_polar_values(m, block)) return wrong;
  const PlaneAxes plane = plane_axes(m.state.plane);
  for (const int axis : {plane.a, plane.b})
    if (const char name = kAxisNames[static_cast<std::size_t>(axis)]; block.words.has(name))
      return fault_at(name, Cause::PolarWord, block);
  return std::nullopt;
}

}  // namespace

Result check_polar_words(MotionView m, const BlockWords& block) {
  if (m.facts.control->motion.poles.value) return check_about_pole(m, block);
  const NcWords& w = block.words;
  const bool moves = block.meaning(Group::OneShot) == Meaning::None || leaves_axes(m.facts, block);
  const bool incremental = block.has(Group::Distance)
                               ? block.meaning(Group::Distance) == Meaning::Incremental
                               : m.state.incremental;
  const bool counts = incremental || !w.has_place(kRadius) || !w.has_place(kAngle);
  const bool at_zero = std::hypot(m.state.work[0], m.state.work[1]) < kStanding;
  // A hole by a radius alone lies along the first axis there. [rs274 2.9]
  const bool drills = block.has(Group::Cycle) || (block.was_cycle && !block.has(Group::Motion));
  const bool lacks_angle = counts && at_zero && (incremental || (!w.has_place(kAngle) && !drills));
  if (w.has('X') || w.has('Y') || m.state.plane != Plane::XY || !moves || lacks_angle)
    return fault(Cause::PolarWord, block);
  return std::nullopt;
}

void polar_words(MotionView m, const BlockWords& block, bool incremental, Axes& end,
                 std::uint32_t& named) {
  if (m.facts.control->motion.poles.value)
    return words_about_pole(m, block, incremental, end, named);
  const NcWords& w = block.words;
  double radius = std::hypot(end[0], end[1]);
  double angle = radius < kStanding ? 0 : std::atan2(end[1], end[0]);
  if (w.has_place(kRadius)) radius = w.value[kRadius] * m.state.unit + (incremental ? radius : 0);
  if (w.has_place(kAngle)) angle = w.value[kAngle] * kPi / 180 + (incremental ? angle : 0);
  end[0] = radius * std::cos(angle);
  end[1] = radius * std::sin(angle);
  named |= 3u;
}

Result set_turned(MotionContext& m, BlockWords& block) {
  if (block.has(Group::Mirror)) set_mirror(m, block);
  if (block.has(Group::Scaling))
    if (auto wrong = set_scaling(m, block)) return wrong;
  return block.has(Group::Rotation) ? set_rotation(m, block) : std::nullopt;
}

/// Return whether G51.1 mirrors one axis of a plane and not the other.
static bool mirrored_once(const Transform& t, const PlaneAxes& plane) {
  return t.mirror && (((t.mirrored >> plane.a) ^ (t.mirrored >> plane.b)) & 1) != 0;
}

/// Return the angle by which points turn. A mirror in one axis of the plane interchanges the two
/// directions of rotation, as it does those of arcs and the sides of radius compensation.
static double rotation_angle(const Transform& t) {
  return mirrored_once(t, plane_axes(t.plane)) ? -t.angle : t.angle;
}

void turn_point(const MotionState& state, Axes& point, std::uint32_t& named) {
  const Transform& t = state.transform;
  for (int i = 0; i < 3; ++i) {
    if (t.mirror && (t.mirrored >> i & 1) != 0) point[i] = 2 * t.mirror_at[i] - point[i];
    if (t.scaling) point[i] = t.scale_centre[i] + (point[i] - t.scale_centre[i]) * t.scale[i];
  }
  if (state.frame.turned) turn_in_frame(state.frame, point, named);
  if (!t.rotation) return;
  const PlaneAxes plane = plane_axes(t.plane);
  double a = point[plane.a], b = point[plane.b];
  if (!t.frame) a -= t.centre[plane.a], b -= t.centre[plane.b];
  rotate(a, b, rotation_angle(t));
  point[plane.a] = a + t.centre[plane.a];
  point[plane.b] = b + t.centre[plane.b];
  if ((named & (axis_bit(plane.a) | axis_bit(plane.b))) != 0)
    named |= axis_bit(plane.a) | axis_bit(plane.b);
}

Axes turned_back(const MotionState& state, Axes point) {
  const Transform& t = state.transform;
  if (t.rotation) {
    const PlaneAxes plane = plane_axes(t.plane);
    double a = point[plane.a] - t.centre[plane.a], b = point[plane.b] - t.centre[plane.b];
    rotate(a, b, -rotation_angle(t));
    point[plane.a] = a + (t.frame ? 0 : t.centre[plane.a]);
    point[plane.b] = b + (t.frame ? 0 : t.centre[plane.b]);
  }
  if (state.frame.turned) point = turned_back(state.frame, point);
  for (int i = 0; i < 3; ++i) {
    if (t.scaling) point[i] = t.scale_centre[i] + (point[i] - t.scale_centre[i]) / t.scale[i];
    if (t.mirror && (t.mirrored >> i & 1) != 0) point[i] = 2 * t.mirror_at[i] - point[i];
  }
  return point;
}

void turn_vector(const MotionState& state, double& a, double& b, const PlaneAxes& plane) {
  const Transform& t = state.transform;
  if (t.mirror && (t.mirrored >> plane.a & 1) != 0) a = -a;
  if (t.mirror && (t.mirrored >> plane.b & 1) != 0) b = -b;
  if (t.scaling) a *= t.scale[plane.a], b *= t.scale[plane.b];
  if (state.frame.turned) {
    const GeneralFrame& f = state.frame;
    const double from = a;
    a = f(plane.a, plane.a) * from + f(plane.a, plane.b) * b;
    b = f(plane.b, plane.a) * from + f(plane.b, plane.b) * b;
  }
  if (t.rotation && t.plane == state.plane) rotate(a, b, rotation_angle(t));
}

bool mirrored_plane(const MotionState& state) {
  const PlaneAxes plane = plane_axes(state.plane);
  bool odd = mirrored_once(state.transform, plane);
  for (const int i : {plane.a, plane.b}) {
    if (state.transform.scaling && state.transform.scale[static_cast<std::size_t>(i)] < 0)
      odd = !odd;
  }
  return odd != (state.frame.turned && factor_in_plane(state.frame, plane) < 0);
}

}  // namespace cncsub
