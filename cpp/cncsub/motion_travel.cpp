// Where the tool may not go: the travel of the axes, and the area of G22.
#include <algorithm>

#include "cncsub/motion_facts.hpp"

namespace cncsub {

Motion::Result Motion::check_travel(const Piece& piece, const Axes& machine) const {
  for (const auto& limit : facts_->limits) {
    const double value = machine[static_cast<std::size_t>(limit.axis)];
    double low = value, high = value;
    if (piece.turn != 0) arc_reach(piece, machine, limit.axis, low, high);
    if (low >= limit.low - 1e-9 && high <= limit.high + 1e-9) continue;
    const double outside = low < limit.low - 1e-9 ? low : high;
    std::string number = std::to_string(std::round(outside * 1e6) / 1e6 + 0.0);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    const char axis = kAxisNames[static_cast<std::size_t>(limit.axis)];
    return Fault{.cause = Cause::OverTravel,
                 .at = piece.at,
                 .detail = std::string(1, axis) + " would go to " + number,
                 .direction = {axis, outside < limit.low ? '-' : '+'},
                 .address = axis};
  }
  return std::nullopt;
}

/// How far an arc reaches on an axis of its plane.
void Motion::arc_reach(const Piece& piece, const Axes& machine, int axis, double& low,
                       double& high) const {
  const PlaneAxes plane = plane_axes(piece.plane);
  if (axis != plane.a && axis != plane.b) return;
  const auto part = [&](const Axes& at, int i) {
    return (at[i] - piece.length[i] - piece.tip[i] - piece.centre[i]) * facts_->share(i);
  };
  const auto radius_at = [&](const Axes& at) {
    return std::hypot(part(at, plane.a), part(at, plane.b));
  };
  const double start = radius_at(s_.tool_at), end = radius_at(machine);
  const double first = std::atan2(part(s_.tool_at, plane.b), part(s_.tool_at, plane.a));
  const double from = std::min(first, first + piece.turn), to = std::max(first, first + piece.turn);
  for (int quarter = -6; quarter <= 6; ++quarter) {
    const double t = quarter * kPi / 2;
    if (t < from || t > to) continue;
    const double reach = (start + (end - start) * (t - first) / piece.turn) *
                             (axis == plane.a ? std::cos(t) : std::sin(t)) / facts_->share(axis) +
                         piece.centre[axis] + piece.length[axis] + piece.tip[axis];
    low = std::min(low, reach);
    high = std::max(high, reach);
  }
}

/// G22 X Y Z I J K: the upper and the lower corner of the area, in machine coordinates; what is not
/// written stays. [TDi 31]
void Motion::set_area(const BlockWords& block) {
  for (std::size_t i = 0; i < 3; ++i) {
    const char high = "XYZ"[i], low = "IJK"[i];
    if (block.words.has(high)) s_.area.high[i] = number(block, high), s_.area.known = true;
    if (block.words.has(low)) s_.area.low[i] = number(block, low), s_.area.known = true;
  }
}

/// Whether a corner of the area is not above the other by 2000 least increments. [Talm 068]
bool Motion::area_is_empty() const {
  for (const std::size_t i : {0u, 1u, 2u})
    if ((i != 1 || !facts_->lathe()) &&
        s_.area.high[i] - s_.area.low[i] <= 2000 * facts_->increment)
      return s_.area.known;
  return false;
}

bool Motion::checks_area() const {
  return s_.area.known && s_.modal[at(Group::Stroke)].meaning == Meaning::StrokeOn;
}

namespace {

/// The way of the tool between two points, in machine coordinates, over a parameter 0 to 1.
struct Way {
  Axes from{}, to{};
  std::array<double, 3> done{1, 1, 1};  // where an axis that moves at its own rate arrives
  // Of an arc: in the plane, true lengths.
  double turn = 0, first = 0, radius = 0;
  int a = 0, b = 1;
  std::array<double, 3> centre{}, share{1, 1, 1};

  double at(int axis, double t) const {
    const auto i = static_cast<std::size_t>(axis);
    if (turn == 0 || (axis != a && axis != b)) {
      const double part = t >= done[i] ? 1 : t / done[i];
      return from[i] + (to[i] - from[i]) * part;
    }
    const double angle = first + turn * t;
    return centre[i] + radius * (axis == a ? std::cos(angle) : std::sin(angle)) / share[i];
  }

  /// The places where an axis has a value.
  void meetings(int axis, double value, std::vector<double>& list) const {
    const auto i = static_cast<std::size_t>(axis);
    if (turn == 0 || (axis != a && axis != b)) {
      if (to[i] != from[i]) list.push_back((value - from[i]) / (to[i] - from[i]) * done[i]);
      return;
    }
    const double ratio = (value - centre[i]) * share[i] / radius;
    if (std::fabs(ratio) > 1) return;
    const double angle = axis == a ? std::acos(ratio) : std::asin(ratio);
    for (const double one : {angle, axis == a ? -angle : kPi - angle})
      for (int round = -2; round <= 2; ++round)
        list.push_back((one + round * 2 * kPi - first) / turn);
  }
};

}  // namespace

/// The stored stroke check 2: no move leads through the area, or out of it.
Motion::Result Motion::check_area(const Piece& piece, const Axes& machine) const {
  if (!checks_area() || piece.kind == MoveKind::Dwell) return std::nullopt;
  const StrokeArea& area = s_.area;
  Way way;
  way.from = s_.tool_at;
  way.to = machine;
  std::vector<double> places{0, 1};
  if (piece.kind == MoveKind::Rapid && !facts_->control->straight_rapid.value) {
    const double whole = rapid_time(way.from, way.to, facts_->rapid, facts_->diameters);
    for (std::size_t i = 0; i < 3 && whole > 0; ++i) {
      const double own = std::fabs(way.to[i] - way.from[i]) * facts_->share(static_cast<int>(i)) *
                         60 / facts_->rapid[i];
      if (own > 0) way.done[i] = std::min(1.0, own / whole), places.push_back(way.done[i]);
    }
  }
  if (piece.turn != 0) {
    const PlaneAxes plane = plane_axes(piece.plane);
    way.turn = piece.turn;
    way.a = plane.a, way.b = plane.b;
    for (int i = 0; i < 3; ++i) {
      way.share[i] = facts_->share(i);
      way.centre[i] = piece.centre[i] + piece.length[i] + piece.tip[i];
    }
    const double a = (way.from[plane.a] - way.centre[plane.a]) * way.share[plane.a];
    const double b = (way.from[plane.b] - way.centre[plane.b]) * way.share[plane.b];
    way.radius = std::hypot(a, b);
    way.first = std::atan2(b, a);
  }
  std::vector<int> axes;  // a lathe's Y counts where the area has it
  for (int i = 0; i < 3; ++i)
    if (i != 1 || !facts_->lathe() || area.low[1] != area.high[1]) axes.push_back(i);
  for (const int i : axes)
    for (const double value : {area.low[i], area.high[i]}) way.meetings(i, value, places);
  std::erase_if(places, [](double t) { return std::isnan(t) || t < 0 || t > 1; });
  std::sort(places.begin(), places.end());
  // Between two such places the way lies inside all along, or outside.
  const bool outside = facts_->control->stroke_outside.value;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double middle = (places[k - 1] + places[k]) / 2, margin = outside ? -1e-6 : 1e-6;
    const bool inside = std::all_of(axes.begin(), axes.end(), [&](int i) {
      const double value = way.at(i, middle);
      return value > area.low[i] + margin && value < area.high[i] - margin;
    });
    if (inside != outside)
      return Fault{Cause::OverTravel, piece.at, 1,
                   outside ? "the move leaves the area of G22" : "the move enters the area of G22"};
  }
  return std::nullopt;
}

}  // namespace cncsub
