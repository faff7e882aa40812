// G71 and G72 of type II: a profile that goes in and out is cut pocket by pocket. [TDi 23.1 figure
// 3-69; TA 8]
#include <algorithm>

#include "cncsub/motion/cycle/contour.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"

namespace cncsub {
namespace {

/// A piece of the profile that does not turn back across the levels.
struct Bit {
  Curve curve;
  MoveKind kind = MoveKind::Feed;
};
using Chain = std::vector<Bit>;

/// The profile, and the levels in which it is cut.
struct Pockets {
  Contour& contour;
  PlaneView view;
  double out, along;  // the signs of outward and of the direction of the cuts
  double top = 0;     // the level where the cycle starts

  double height(Point p) const { return out * (contour.level_axis == 0 ? p.b : p.a); }
  double place(Point p) const { return along * (contour.level_axis == 0 ? p.a : p.b); }
  Point point(double place, double height) const {
    const double u = along * place, h = out * height;
    return contour.level_axis == 0 ? Point{u, h} : Point{h, u};
  }
  Point here() const { return view.point(contour.m.state.work); }

  Chain profile() const;
  void add(Chain& chain, const Bit& bit) const;
  Point crossing(const Curve& curve, double level) const;
  std::vector<Chain> split(const Chain& chain, double level) const;
  Result go(MoveKind kind, Point to);
  Result follow(const Chain& chain, std::size_t first, std::size_t last);
  Result retract(double level);
  struct Level;
  std::size_t highest(const Chain& part) const;
  Result cut(Level& at);
  Result pass_island(Level& at);
  Result rough(Chain chain);
};

/// Add a bit to a chain, divided where an arc is highest or lowest.
void Pockets::add(Chain& chain, const Bit& bit) const {
  const Curve& c = bit.curve;
  if (c.straight()) {
    if (size(c.to - c.from) > 1e-9) chain.push_back(bit);
    return;
  }
  const Point r = c.from - c.centre;
  const double first = std::atan2(r.b, r.a), quarter = contour.level_axis == 0 ? kPi / 2 : 0;
  std::vector<double> turns{0, c.turn};
  for (int k = -4; k <= 4; ++k)
    if (const double turn = quarter + k * kPi - first;
        turn * c.turn > 0 && std::fabs(turn) < std::fabs(c.turn) - 1e-9 && std::fabs(turn) > 1e-9)
      turns.push_back(turn);
  std::sort(turns.begin(), turns.end(),
            [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  Point from = c.from;
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double t = first + turns[i];
    const Point to =
        i + 1 == turns.size() ? c.to : c.centre + c.radius() * Point{std::cos(t), std::sin(t)};
    chain.push_back({{from, to, c.centre, turns[i] - turns[i - 1]}, bit.kind});
    from = to;
  }
}

Chain Pockets::profile() const {
  Chain chain;
  Axes from = contour.start + contour.shift;
  for (const Piece& piece : contour.pieces) {
    Piece moved = piece;
    for (std::size_t i = 0; i < 3; ++i) {
      moved.end[i] += contour.shift[i] - piece.offset[i];
      moved.centre[i] += contour.shift[i] - piece.offset[i];
    }
    add(chain, {curve_of(view, from, moved), piece.kind});
    from = moved.end;
  }
  return chain;
}

Point Pockets::crossing(const Curve& curve, double level) const {
  if (curve.straight()) {
    const double a = height(curve.from), b = height(curve.to);
    return curve.from + (level - a) / (b - a) * (curve.to - curve.from);
  }
  const double up = level - height(curve.centre), r = curve.radius();
  const double across = std::sqrt(std::max(0.0, r * r - up * up));
  const double middle = place(curve.centre);
  const Point one = point(middle - across, level), other = point(middle + across, level);
  const auto miss = [&](Point p) {
    return size(p - curve.from) + size(p - curve.to);  // the shorter of the two directions
  };
  return miss(one) <= miss(other) ? one : other;
}

/// Return the parts of a chain at or above a level and those below it, alternating; the first is
/// above.
std::vector<Chain> Pockets::split(const Chain& chain, double level) const {
  std::vector<Chain> parts(1);
  const auto below = [&](Point p) { return height(p) < level - 1e-7; };
  const auto turn = [](const Curve& c, Point from, Point to) {
    const Point p = from - c.centre, q = to - c.centre;
    return c.straight() ? 0 : std::atan2(cross(p, q), dot(p, q));
  };
  bool low = false;
  for (const Bit& bit : chain) {
    const bool from = below(bit.curve.from), to = below(bit.curve.to);
    if (from == to) {
      if (from != low) parts.emplace_back(), low = from;
      parts.back().push_back(bit);
      continue;
    }
    const Point cut = crossing(bit.curve, level);
    Bit first = bit, second = bit;
    first.curve.to = second.curve.from = cut;
    first.curve.turn = turn(bit.curve, bit.curve.from, cut);
    second.curve.turn = turn(bit.curve, cut, bit.curve.to);
    if (from != low) parts.emplace_back(), low = from;
    if (size(cut - bit.curve.from) > 1e-9) parts.back().push_back(first);
    parts.emplace_back(), low = to;
    if (size(bit.curve.to - cut) > 1e-9) parts.back().push_back(second);
  }
  return parts;
}

Result Pockets::go(MoveKind kind, Point to) {
  const Point now = here();
  std::uint32_t named = 0;
  if (std::fabs(to.a - now.a) > 1e-9) named |= axis_bit(2);
  if (std::fabs(to.b - now.b) > 1e-9) named |= axis_bit(0);
  if (named == 0) return std::nullopt;
  Axes end = contour.m.state.work;
  view.set(end, to);
  return move(contour.m, contour.block, kind, end, named);
}

/// Move along the bits of a chain from `first` to before `last`.
Result Pockets::follow(const Chain& chain, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const Curve& curve = chain[i].curve;
    if (curve.straight()) {
      if (auto wrong = go(chain[i].kind, curve.to)) return wrong;
      continue;
    }
    Axes end = contour.m.state.work;
    view.set(end, curve.to);
    Piece piece = make_piece(contour.m, contour.block,
                             curve.turn > 0 ? MoveKind::Ccw : MoveKind::Cw, end, kXz);
    view.set(piece.centre, curve.centre);
    for (std::size_t k = 0; k < 3; ++k) piece.centre[k] += piece.offset[k];
    piece.turn = curve.turn;
    if (auto wrong = move(contour.m, contour.block, piece)) return wrong;
  }
  return std::nullopt;
}

/// Retract from the part by the escape, but not beyond the level where the cycle starts.
Result Pockets::retract(double level) {
  const bool feeds = contour.m.facts.control->turning.escape.value == ReturnedEscape::Feed;
  const double up = std::max(level, std::min(level + contour.escape, top));
  return go(feeds ? MoveKind::Feed : MoveKind::Rapid, point(place(here()), up));
}

/// A level that is being cut: the parts of the profile above and below it, alternating, and the
/// next pocket.
struct Pockets::Level {
  double level;
  std::vector<Chain> parts;
  std::size_t next = 1;
  std::size_t crest = 0;  // the bits of the part after the last pocket that are cut already
  Point summit{};         // where that cut ended

  bool last() const { return next + 2 >= parts.size(); }
  const Chain& behind() const {
    static const Chain kNothing;
    return next + 1 < parts.size() ? parts[next + 1] : kNothing;
  }
};

/// Rough what the levels leave of the profile: down along it, across, up along it, and back; then
/// deeper, pocket by pocket. `waiting` holds the levels with pockets to come, no more than there
/// are islands.
Result Pockets::rough(Chain chain) {
  std::vector<Level> waiting;
  double level = top;
  for (;;) {
    if (contour.m.inputs.over(chain.size() / 64)) return broken_off(contour.block.words.at);
    level -= contour.depth;
    std::vector<Chain> parts = split(chain, level);
    const bool deeper = parts.size() > 1;
    const Chain& way = deeper ? parts[0] : chain;
    if (auto wrong = follow(way, 0, way.size())) return wrong;
    if (!deeper && waiting.empty()) return std::nullopt;
    if (deeper)
      waiting.push_back({level, std::move(parts)});
    else if (auto wrong = pass_island(waiting.back()))
      return wrong;
    Level& at = waiting.back();
    if (auto wrong = cut(at)) return wrong;
    level = at.level;
    chain = std::move(at.parts[at.next]);
    if (at.last()) waiting.pop_back();
  }
}

/// Cut the next pocket of a level: across, up along the profile after it, back, and in again.
Result Pockets::cut(Level& at) {
  const MoveKind in =
      contour.pieces.front().kind == MoveKind::Rapid ? MoveKind::Rapid : MoveKind::Feed;
  const Point from = at.parts[at.next].front().curve.from;
  const Point to = at.parts[at.next].back().curve.to;
  if (auto wrong = go(MoveKind::Feed, point(place(to), at.level))) return wrong;
  const Chain& behind = at.behind();
  at.crest = at.last() ? behind.size() : highest(behind);
  if (auto wrong = follow(behind, 0, at.crest)) return wrong;
  at.summit = here();
  if (auto wrong = retract(height(at.summit))) return wrong;
  if (auto wrong = go(MoveKind::Rapid, point(place(from), height(here())))) return wrong;
  return go(in, from);
}

/// Pass the island after a finished pocket: rapid over it, feed onto it. [TDi 23.1 note 3]
Result Pockets::pass_island(Level& at) {
  const double up = std::max(height(at.summit), std::min(height(at.summit) + contour.escape, top));
  if (auto wrong = go(MoveKind::Rapid, point(place(here()), up))) return wrong;
  if (auto wrong = go(MoveKind::Rapid, point(place(at.summit), up))) return wrong;
  if (auto wrong = go(MoveKind::Feed, at.summit)) return wrong;
  const Chain& behind = at.behind();
  if (auto wrong = follow(behind, at.crest, behind.size())) return wrong;
  at.next += 2;
  return std::nullopt;
}

/// Return how many bits of a part lead to its last highest point.
std::size_t Pockets::highest(const Chain& part) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (height(part[i].curve.to) >= height(part[at].curve.to) - 1e-9) at = i;
  return part.empty() ? 0 : at + 1;
}

/// Find on which side of the profile the cycle starts, in which direction and from which level it
/// cuts.
Pockets pockets_of(Contour& contour) {
  Pockets pockets{contour, {plane_axes(Plane::ZX), contour.m.facts.share(0)}, 1, 1};
  double lowest = contour.level_of(contour.start), highest = lowest;
  const double level = lowest;
  for (const Piece& piece : contour.pieces) {
    Axes end = contour.end_of(piece);
    lowest = std::min(lowest, contour.level_of(end));
    highest = std::max(highest, contour.level_of(end));
  }
  Axes last = contour.end_of(contour.pieces.back());
  pockets.out = level - lowest >= highest - level ? 1 : -1;
  pockets.along = contour.cut_of(last) >= contour.cut_of(contour.start) ? 1 : -1;
  pockets.top = pockets.height(pockets.view.point(contour.start + contour.shift));
  return pockets;
}

/// Rise to the level where the cycle starts.
Result rise(Pockets& pockets) {
  const Point now = pockets.here();
  return pockets.height(now) < pockets.top
             ? pockets.go(MoveKind::Rapid, pockets.point(pockets.place(now), pockets.top))
             : std::nullopt;
}

/// Return whether the profile is cut once more along its allowance.
bool cuts_again(const Contour& contour) {
  const PocketPass pass = contour.m.facts.control->turning.pocket_pass.value;
  const NcWords& w = contour.block.words;
  return pass == PocketPass::Always || (pass == PocketPass::WithJ && w.has('J') && w['J'] == 1);
}

}  // namespace

Result Contour::rough_pockets() {
  Pockets pockets = pockets_of(*this);
  Chain profile = pockets.profile();
  double deepest = pockets.top;
  for (const Bit& bit : profile) {
    const double back = std::min(pockets.place(bit.curve.start_direction()),
                                 pockets.place(bit.curve.end_direction()));
    if (back < -1e-6) return turns_back(cut_axis());
    deepest = std::min(deepest, pockets.height(bit.curve.to));
  }
  if ((pockets.top - deepest) / depth * static_cast<double>(pieces.size()) > kMostCrossings)
    return fault(Cause::ValueOutOfRange, block, "the block would cut too many levels");
  const Axes begin = start + shift;
  if (auto wrong = go(MoveKind::Rapid, begin)) return wrong;
  if (auto wrong = pockets.rough(std::move(profile))) return wrong;
  if (auto wrong = rise(pockets)) return wrong;
  if (cuts_again(*this)) {
    if (auto wrong = pass(shift)) return wrong;
    if (auto wrong = rise(pockets)) return wrong;
  }
  return go(MoveKind::Rapid, start);
}

/// Return how often the profile goes back in after a shoulder.
int Contour::pocket_count() const {
  const auto level = static_cast<std::size_t>(level_axis);
  const double away = end_of(pieces.front())[level] <= start[level] ? 1 : -1;
  int count = 0;
  bool outward = false;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double step = (pieces[i].end[level] - pieces[i - 1].end[level]) * away;
    if (step < -1e-9 && outward) ++count;
    if (std::fabs(step) > 1e-9) outward = step > 0;
  }
  return count;
}

}  // namespace cncsub
