// Polar coordinates, and what turns written points: rotation, scaling, mirror.
#include "cncsub/motion_facts.hpp"

namespace cncsub {

/// The first axis of the plane is the radius, the second the angle.
void Motion::polar_target(BlockWords& block, Axes& end, std::uint32_t& named) {
  const PlaneAxes plane = plane_axes(s_.plane);
  const char radius_name = kAxisNames[static_cast<std::size_t>(plane.a)];
  const char angle_name = kAxisNames[static_cast<std::size_t>(plane.b)];
  const bool has_radius = block.words.has(radius_name), has_angle = block.words.has(angle_name);
  if (!has_radius && !has_angle) return;
  const double a = s_.work[plane.a], b = s_.work[plane.b];
  // A radius written under G91 counts from where the tool is. [16MC p.147]
  const bool from_tool = has_radius && s_.incremental;
  const double radius = has_radius ? number(block, radius_name) : std::hypot(a, b);
  const double present = s_.polar_known ? s_.polar_angle : std::atan2(b, a) * 180 / kPi;
  double angle = present;
  if (has_angle) angle = raw(block, angle_name) + (s_.incremental ? present : 0);
  s_.polar_angle = angle;
  s_.polar_known = true;
  const double t = angle * kPi / 180;
  end[plane.a] = (from_tool ? a : 0) + radius * std::cos(t);
  end[plane.b] = (from_tool ? b : 0) + radius * std::sin(t);
  named |= axis_bit(plane.a) | axis_bit(plane.b);
}

Motion::Result Motion::set_turned(BlockWords& block) {
  if (block.has(Group::Mirror)) set_mirror(block);
  if (block.has(Group::Scaling))
    if (auto wrong = set_scaling(block)) return wrong;
  return block.has(Group::Rotation) ? set_rotation(block) : std::nullopt;
}

Motion::Result Motion::set_rotation(BlockWords& block) {
  const Control& c = *facts_->control;
  Turned turned = s_.turned;
  turned.rotation = block.meaning(Group::Rotation) == Meaning::RotationOn;
  if (turned.rotation) {
    turned.angle = 0;
    for (const char name : c.rotation_words.value)
      if (block.words.has(name)) turned.angle = raw(block, name);
    if (c.max_rotation.value > 0 && std::fabs(turned.angle) > c.max_rotation.value)
      return fault(Cause::RotationAngle, block);
    turned.plane = s_.plane;
    turned.frame = facts_->lathe();
    for (int i = 0; i < 3; ++i) {
      const char name = kAxisNames[static_cast<std::size_t>(i)];
      // The centre is absolute under G91 as well. [B-64113EN p.789]
      turned.centre[i] = block.words.has(name) ? number(block, name) : s_.work[i];
    }
    block.consumed = true;
  }
  s_.turned = turned;
  s_.modal[at(Group::Rotation)] = block.codes[at(Group::Rotation)];
  return std::nullopt;
}

Motion::Result Motion::set_scaling(BlockWords& block) {
  const NcWords& w = block.words;
  s_.modal[at(Group::Scaling)] = block.codes[at(Group::Scaling)];
  s_.turned.scaling = block.meaning(Group::Scaling) == Meaning::ScalingOn;
  if (!s_.turned.scaling) return std::nullopt;
  block.consumed = true;
  for (int i = 0; i < 3; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)], own = "IJK"[i];
    // As the centre of rotation. [B-63682EN p.117]
    s_.turned.scale_centre[i] = w.has(name) ? number(block, name) : s_.work[i];
    double scale = w.has('P') ? scale_of(block, 'P') : w.has(own) ? scale_of(block, own) : 1;
    if (scale == 0) return fault(Cause::ScaleZero, block);
    if (scale < 0 && facts_->refuses(Cause::ScaleNegative))
      return fault(Cause::ScaleNegative, block);
    s_.turned.scale[i] = scale;
  }
  return std::nullopt;
}

/// P counts thousandths, and so do I J K without a point where lengths count increments. [K]
double Motion::scale_of(const BlockWords& block, char address) const {
  const bool thousandths =
      address == 'P' ? facts_->control->scale_thousandths.value
                     : (block.words.whole & bit(address)) != 0 &&
                           facts_->control->whole_numbers.value == WholeNumbers::Increments;
  return raw(block, address) * (thousandths ? 0.001 : 1);
}

void Motion::set_mirror(BlockWords& block) {
  const bool on = block.meaning(Group::Mirror) == Meaning::MirrorOn;
  bool any = false;
  for (int i = 0; i < 3; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (!block.words.has(name)) continue;
    any = true;
    if (on) s_.turned.mirror_at[i] = number(block, name);
    s_.turned.mirrored = on ? s_.turned.mirrored | axis_bit(i) : s_.turned.mirrored & ~axis_bit(i);
  }
  if (!on && !any) s_.turned.mirrored = 0;
  s_.turned.mirror = s_.turned.mirrored != 0;
  if (on || !s_.turned.mirror) s_.modal[at(Group::Mirror)] = block.codes[at(Group::Mirror)];
  block.consumed = true;
}

namespace {

void rotate(double& a, double& b, double degrees) {
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  const double turned = a * c - b * s;
  b = a * s + b * c;
  a = turned;
}

}  // namespace

/// From the written point to the one the tool goes to: mirror, scaling, rotation.
void Motion::turn_point(Axes& point, std::uint32_t& named) const {
  const Turned& t = s_.turned;
  for (int i = 0; i < 3; ++i) {
    if (t.mirror && (t.mirrored >> i & 1) != 0) point[i] = 2 * t.mirror_at[i] - point[i];
    if (t.scaling) point[i] = t.scale_centre[i] + (point[i] - t.scale_centre[i]) * t.scale[i];
  }
  if (!t.rotation) return;
  const PlaneAxes plane = plane_axes(t.plane);
  double a = point[plane.a], b = point[plane.b];
  if (!t.frame) a -= t.centre[plane.a], b -= t.centre[plane.b];
  rotate(a, b, t.angle);
  point[plane.a] = a + t.centre[plane.a];
  point[plane.b] = b + t.centre[plane.b];
  if ((named & (axis_bit(plane.a) | axis_bit(plane.b))) != 0)
    named |= axis_bit(plane.a) | axis_bit(plane.b);
}

Axes Motion::turned_back(Axes point) const {
  const Turned& t = s_.turned;
  if (t.rotation) {
    const PlaneAxes plane = plane_axes(t.plane);
    double a = point[plane.a] - t.centre[plane.a], b = point[plane.b] - t.centre[plane.b];
    rotate(a, b, -t.angle);
    point[plane.a] = a + (t.frame ? 0 : t.centre[plane.a]);
    point[plane.b] = b + (t.frame ? 0 : t.centre[plane.b]);
  }
  for (int i = 0; i < 3; ++i) {
    if (t.scaling) point[i] = t.scale_centre[i] + (point[i] - t.scale_centre[i]) / t.scale[i];
    if (t.mirror && (t.mirrored >> i & 1) != 0) point[i] = 2 * t.mirror_at[i] - point[i];
  }
  return point;
}

/// The same for a distance in the plane, as I and J are.
void Motion::turn_vector(double& a, double& b, const PlaneAxes& plane) const {
  const Turned& t = s_.turned;
  if (t.mirror && (t.mirrored >> plane.a & 1) != 0) a = -a;
  if (t.mirror && (t.mirrored >> plane.b & 1) != 0) b = -b;
  if (t.scaling) a *= t.scale[plane.a], b *= t.scale[plane.b];
  if (t.rotation && t.plane == s_.plane) rotate(a, b, t.angle);
}

bool Motion::mirrored_plane() const {
  const PlaneAxes plane = plane_axes(s_.plane);
  bool odd = false;
  for (const int i : {plane.a, plane.b}) {
    if (s_.turned.mirror && (s_.turned.mirrored >> i & 1) != 0) odd = !odd;
    if (s_.turned.scaling && s_.turned.scale[static_cast<std::size_t>(i)] < 0) odd = !odd;
  }
  return odd;
}

}  // namespace cncsub
