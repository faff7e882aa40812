// Where the tool may not go: the travel of the axes, and the area of G22.
#include <algorithm>

#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Widen `low` and `high` by how far an arc reaches on an axis of its plane.
void arc_reach(MotionView m, const Piece& piece, const Axes& machine, int axis, double& low,
               double& high) {
  const PlaneAxes plane = arc_axes(piece.plane, piece.state.parallel);
  if (axis != plane.a && axis != plane.b) return;
  const auto part = [&](const Axes& at, int i) {
    const std::size_t place = centre_place(i);
    return (at[i] - piece.length[i] - piece.tip[place] - piece.centre[place]) * m.facts.share(i);
  };
  const auto radius_at = [&](const Axes& at) {
    return std::hypot(part(at, plane.a), part(at, plane.b));
  };
  const double start = radius_at(m.state.tool_at), end = radius_at(machine);
  const double first = std::atan2(part(m.state.tool_at, plane.b), part(m.state.tool_at, plane.a));
  const double from = std::min(first, first + piece.turn), to = std::max(first, first + piece.turn);
  for (int quarter = -6; quarter <= 6; ++quarter) {
    const double t = quarter * kPi / 2;
    if (t < from || t > to) continue;
    const double reach = (start + (end - start) * (t - first) / piece.turn) *
                             (axis == plane.a ? std::cos(t) : std::sin(t)) / m.facts.share(axis) +
                         piece.centre[centre_place(axis)] + piece.length[axis] +
                         piece.tip[centre_place(axis)];
    low = std::min(low, reach);
    high = std::max(high, reach);
  }
}

/// The path of the tool between two points, in machine coordinates, over a parameter 0 to 1.
struct TravelPath {
  Axes from{}, to{};
  std::array<double, 3> done{1, 1, 1};  // where an axis that moves at its own rate arrives
  // The fields of an arc, in the plane, true lengths.
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

  /// List the places where an axis has a value.
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

namespace {

/// Return whether a corner of the area is not above the other by 2000 least increments. [Talm 068]
bool area_is_empty(MotionView m) {
  for (const std::size_t i : {0u, 1u, 2u})
    if ((i != 1 || !m.facts.lathe()) &&
        m.state.area.high[i] - m.state.area.low[i] <= 2000 * m.facts.increment)
      return m.state.area.known;
  return false;
}

/// Find where axes at rapid arrive that do not wait for each other.
void arrive_apart(MotionView m, TravelPath& path, std::vector<double>& places) {
  const double whole = rapid_time(path.from, path.to, m.facts.rapid, m.facts.diameters);
  for (std::size_t i = 0; i < 3 && whole > 0; ++i) {
    const double own = std::fabs(path.to[i] - path.from[i]) * m.facts.share(static_cast<int>(i)) *
                       60 / m.facts.rapid[i];
    if (own > 0) path.done[i] = std::min(1.0, own / whole), places.push_back(path.done[i]);
  }
}

void follow_arc(MotionView m, const Piece& piece, TravelPath& path) {
  if (piece.state.parallel != 0) return;  // X, Y and Z do not make it alone
  const PlaneAxes plane = plane_axes(piece.plane);
  path.turn = piece.turn;
  path.a = plane.a, path.b = plane.b;
  for (int i = 0; i < 3; ++i) {
    path.share[i] = m.facts.share(i);
    path.centre[i] = piece.centre[i] + piece.length[i] + piece.tip[i];
  }
  const double a = (path.from[plane.a] - path.centre[plane.a]) * path.share[plane.a];
  const double b = (path.from[plane.b] - path.centre[plane.b]) * path.share[plane.b];
  path.radius = std::hypot(a, b);
  path.first = std::atan2(b, a);
}

/// Return the axes of the area; a lathe's Y counts where the area has it.
std::vector<int> area_axes(MotionView m) {
  const StrokeArea& area = m.state.area;
  if (m.facts.lathe() && area.low[1] == area.high[1]) return {0, 2};
  return {0, 1, 2};
}

}  // namespace

Result check_travel(MotionView m, const Piece& piece, const Axes& machine) {
  for (const auto& limit : m.facts.limits) {
    const double value = machine[static_cast<std::size_t>(limit.axis)];
    double low = value, high = value;
    if (piece.turn != 0) arc_reach(m, piece, machine, limit.axis, low, high);
    if (low >= limit.low - 1e-9 && high <= limit.high + 1e-9) continue;
    const double exceeded = low < limit.low - 1e-9 ? low : high;
    std::string number = std::to_string(std::round(exceeded * 1e6) / 1e6 + 0.0);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    const char axis = kAxisNames[static_cast<std::size_t>(limit.axis)];
    return Fault{.cause = Cause::OverTravel,
                 .at = piece.at,
                 .detail = std::string(1, axis) + " would go to " + number,
                 .kind = {axis, exceeded < limit.low ? '-' : '+'},
                 .word = {.addresses = bit(axis)}};
  }
  return std::nullopt;
}

Result set_area(MotionContext& m, BlockWords& block) {
  for (std::size_t i = 0; i < 3; ++i) {
    const char high = "XYZ"[i], low = "IJK"[i];
    if (block.words.has(high))
      m.state.area.high[i] = number(m, block, high), m.state.area.known = true;
    if (block.words.has(low))
      m.state.area.low[i] = number(m, block, low), m.state.area.known = true;
  }
  block.consumed = true;
  if (area_is_empty(m) && m.facts.refuses(Cause::StrokeArea))
    return fault_at({.addresses = kEndWords | kCentreWords}, Cause::StrokeArea, block);
  return std::nullopt;
}

bool checks_area(const MotionState& state) {
  return state.area.known && state.modal[at(Group::Stroke)].meaning == Meaning::StrokeOn;
}

Result check_area(MotionView m, const Piece& piece, const Axes& machine) {
  if (piece.kind == MoveKind::Dwell) return std::nullopt;
  const StrokeArea& area = m.state.area;
  TravelPath path;
  path.from = m.state.tool_at;
  path.to = machine;
  std::vector<double> places{0, 1};
  if (piece.kind == MoveKind::Rapid &&
      m.facts.control->motion.rapid_way.value != RapidWay::Straight)
    arrive_apart(m, path, places);
  if (piece.turn != 0) follow_arc(m, piece, path);
  const std::vector<int> axes = area_axes(m);
  for (const int i : axes)
    for (const double value : {area.low[i], area.high[i]}) path.meetings(i, value, places);
  std::erase_if(places, [](double t) { return std::isnan(t) || t < 0 || t > 1; });
  std::sort(places.begin(), places.end());
  // Between two such places the path lies inside all along, or outside.
  const bool must_stay_inside =
      m.facts.control->motion.stroke_area.value == StrokeCheck::OutsideForbidden;
  const double margin = must_stay_inside ? -1e-6 : 1e-6;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double middle = (places[k - 1] + places[k]) / 2;
    const bool inside = std::all_of(axes.begin(), axes.end(), [&](int i) {
      const double value = path.at(i, middle);
      return value > area.low[i] + margin && value < area.high[i] - margin;
    });
    if (inside != must_stay_inside)
      return fault_at(
          {.addresses = kAxisWords}, Cause::OverTravel, piece.at,
          must_stay_inside ? "the move leaves the area of G22" : "the move enters the area of G22");
  }
  return std::nullopt;
}

}  // namespace cncsub
