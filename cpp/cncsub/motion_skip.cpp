// G31: where its skip signal comes, and what of that is kept.
#include "cncsub/motion_facts.hpp"

namespace cncsub {

/// G31: a feed that ends where the skip signal comes. The rest of the way is dropped: the blocks
/// behind go on from there, increments too. [15iM p.564; M7 p.547]
Motion::Result Motion::skip(BlockWords& block) {
  if (compensating()) return fault(Cause::CompensationSkip, block);
  std::uint32_t named = 0;
  Axes end = linear_target(block, named);
  if (named == 0) return std::nullopt;
  const double feed = s_.feed;
  if (auto wrong = skip_feed(block)) return wrong;
  const bool touched = signal_on_way(block, end).has_value();
  Piece piece = make_piece(block, MoveKind::Feed, end, named);
  piece.skip = touched ? SkipMove::Touched : SkipMove::Missed;
  if (auto wrong = move(block, piece)) return wrong;
  block.outcome.skip = piece.skip;
  s_.feed = feed;
  s_.skip = s_.work + s_.length;  // with the tool, like #5041 [NCT 99M p.183]
  return std::nullopt;
}

/// The feed of G31, and the numbers of its signals: P.
Motion::Result Motion::skip_feed(const BlockWords& block) {
  const Control& c = *facts_->control;
  if (const int most = c.max_skip_signals.value; most > 0 && block.words.has('P'))
    if (const double p = raw(block, 'P'); p < 1 || p > most)
      return fault(Cause::ValueOutOfRange, block, "P of G31 is 1 to " + std::to_string(most));
  if (!c.skip_own_feed.value) return need_feed(block, Meaning::Line);
  // Parameters of G31, G31.1, G31.2 and G31.3. [M7 p.547, p.552]
  const int form = block.codes[at(Group::OneShot)].code - 310;
  s_.feed = c.parameter(std::to_string(1174 + 2 * form));
  if (block.words.has('F'))
    if (auto wrong = feed_of(block, s_.feed)) return wrong;
  if (s_.feed <= 0) return fault(Cause::NoSkipFeed, block);
  return need_feed(block, Meaning::Line);
}

/// Where on the way the signal comes, 0 to 1; the way then ends there.
std::optional<double> Motion::signal_on_way(const BlockWords& block, Axes& end) const {
  constexpr double kOnTheWay = 1e-9;
  constexpr double kTouchPlaces = 1e6;  // to the millionth of a mm: 37, not 36.99999999999999
  const Outside& outside = block.outside;
  const auto told = outside.skip ? outside.skip() : std::nullopt;
  std::optional<double> part;
  if (!told) {
    if (outside.workpiece != nullptr) part = touch(*outside.workpiece, end);
  } else if (told->comes == SkipSignal::Comes::AtFraction) {
    part = told->value;
  } else if (told->comes == SkipSignal::Comes::AtCoordinate) {
    const auto axis = static_cast<std::size_t>(told->axis);
    const double from = s_.work[axis], way = end[axis] - from, to = told->value - from;
    if (std::fabs(to) <= kOnTheWay) part = 0;
    if (way != 0 && to / way > 0 && to / way <= 1 + kOnTheWay / std::fabs(way)) part = to / way;
  }
  if (!part) return std::nullopt;
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end[i] == s_.work[i]) continue;
    end[i] = s_.work[i] + (end[i] - s_.work[i]) * *part;
    if (!told) end[i] = std::round(end[i] * kTouchPlaces) / kTouchPlaces;
  }
  if (told && told->comes == SkipSignal::Comes::AtCoordinate)
    end[static_cast<std::size_t>(told->axis)] = told->value;
  return part;
}

/// Where the ball of the stylus touches on its way from here to a point in work coordinates.
std::optional<double> Motion::touch(const Workpiece& workpiece, const Axes& end) const {
  Axes tool = s_.length + s_.tool_shift;  // from the tool's point to the machine position
  if (workpiece.length) {
    tool = {};
    tool[static_cast<std::size_t>(s_.length_axis)] = *workpiece.length;
  }
  const auto ball = [&](const Axes& work) {
    const Axes machine = work + s_.offset + s_.length - tool;
    Point3 centre{};
    for (std::size_t i = 0; i < centre.size(); ++i)
      centre[i] = machine[i] * facts_->share(static_cast<int>(i));
    if (workpiece.by_end && s_.length_axis < 3)
      centre[static_cast<std::size_t>(s_.length_axis)] += workpiece.stylus;
    return centre;
  };
  return first_contact(workpiece.solids, ball(s_.work), ball(end), workpiece.stylus);
}

Workpiece Motion::placed(Workpiece workpiece) const {
  Axes zero{};
  if (const int system = system_of(workpiece.system); system > 100)
    zero = tables_->work[0] + tables_->extra[static_cast<std::size_t>(system - 101)];
  else if (system > 0)
    zero = tables_->work[0] + tables_->work[static_cast<std::size_t>(system)];
  for (Solid& solid : workpiece.solids)
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = facts_->share(static_cast<int>(i));
      for (Point3* point : {&solid.at, &solid.low, &solid.high})
        (*point)[i] = ((*point)[i] + zero[i]) * share;
    }
  open_holes(workpiece.solids);
  return workpiece;
}

}  // namespace cncsub
