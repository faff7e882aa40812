// G31: where its skip signal comes, and what of that is kept.
#include "cncsub/motion_facts.hpp"

namespace cncsub {

/// G31: a feed that ends where the skip signal comes. The rest of the way is dropped: the blocks
/// behind go on from there, increments too. [15iM p.564; M7 p.547]
Motion::Result Motion::skip(BlockWords& block) {
  if (compensating()) return fault(Cause::CompensationSkip, block);
  if (s_.modal[at(Group::Feed)].meaning == Meaning::PerRevolution &&
      facts_->refuses(Cause::SkipPerRevolution))
    return fault(Cause::SkipPerRevolution, block);
  std::uint32_t named = 0;
  Axes end = linear_target(block, named);
  if (named == 0) return std::nullopt;
  const double feed = s_.feed;
  if (auto wrong = skip_feed(block)) return wrong;
  hold_skip_feed();
  const bool touched = signal_on_way(block, signals_of(block), end).has_value();
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

/// A control that stops at once is not let go fast. [TDi 16, TDi 17]
void Motion::hold_skip_feed() {
  const double most = facts_->control->max_skip_feed.value;
  const bool turns = s_.modal[at(Group::Feed)].meaning == Meaning::PerRevolution;
  if (most > 0 && !turns) s_.feed = std::min(s_.feed, most);
  if (most > 0 && turns && s_.speed > 0) s_.feed = std::min(s_.feed, most / s_.speed);
}

/// The signals that G31 or G04 watches; none is no signal at all.
SignalMask Motion::signals_of(const BlockWords& block) const {
  const Control& c = *facts_->control;
  const bool dwells = block.meaning(Group::OneShot) == Meaning::Dwell;
  const char word = dwells ? 'Q' : 'P';
  const double named = block.words.has(word) ? raw(block, word) : 0;
  const auto bits = [&c](int number) {
    return static_cast<SignalMask>(to_whole<int>(c.parameter(std::to_string(number)), 0, 255)) << 1;
  };
  switch (c.skip_signals.value) {
    case SkipSignals::Any:
      return dwells ? 0 : kAnySignal;
    case SkipSignals::Numbered:
      if (named >= 1 && named < kArrivalSignal) return signal_bit(whole(named));
      return dwells || named != 0 ? 0 : signal_bit(1);
    case SkipSignals::Parameters:
      if (named >= 1 && named < 5) return bits(6201 + whole(named));
      return bits(dwells ? 6206 : 6202);
    case SkipSignals::Bits: {
      if (dwells) return bits(1173);
      if (named >= 1) return static_cast<SignalMask>(to_whole<int>(named, 1, 255)) << 1;
      const int form = block.codes[at(Group::OneShot)].code - 310;
      return form == 0 ? signal_bit(1) : bits(1173 + 2 * form);
    }
  }
  return kAnySignal;
}

/// Where on the way the first of these signals comes, 0 to 1; the way then ends there.
std::optional<double> Motion::signal_on_way(const BlockWords& block, SignalMask signals,
                                            Axes& end) const {
  constexpr double kTouchPlaces = 1e6;  // to the millionth of a mm: 37, not 36.99999999999999
  const Outside& outside = block.outside;
  const SkipsTold told = outside.skips ? outside.skips(signals) : SkipsTold{{}, signals};
  std::optional<double> part;
  const SkipSignal* first = nullptr;
  for (const SkipSignal& signal : told.told)
    if (const auto there = part_of(signal, end); there && (!part || *there < *part)) {
      part = there;
      first = &signal;
    }
  if (told.open != 0 && outside.workpiece != nullptr)
    if (const auto there = touch(*outside.workpiece, told.open, end);
        there && (!part || *there < *part)) {
      part = there;
      first = nullptr;
    }
  if (!part) return std::nullopt;
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end[i] == s_.work[i]) continue;
    end[i] = s_.work[i] + (end[i] - s_.work[i]) * *part;
    if (first == nullptr) end[i] = std::round(end[i] * kTouchPlaces) / kTouchPlaces;
  }
  if (first != nullptr && first->comes == SkipSignal::Comes::AtCoordinate)
    end[static_cast<std::size_t>(first->axis)] = first->value;
  return part;
}

/// Where on the way to `end` a signal comes that was told.
std::optional<double> Motion::part_of(const SkipSignal& told, const Axes& end) const {
  constexpr double kOnTheWay = 1e-9;
  if (told.comes == SkipSignal::Comes::Never) return std::nullopt;
  if (told.comes == SkipSignal::Comes::AtFraction) return told.value;
  const auto axis = static_cast<std::size_t>(told.axis);
  const double from = s_.work[axis], way = end[axis] - from, to = told.value - from;
  if (way != 0 && to / way > 0 && to / way <= 1 + kOnTheWay / std::fabs(way)) return to / way;
  if (std::fabs(to) <= kOnTheWay) return 0;
  return std::nullopt;
}

/// Where the ball of the stylus touches on its way from here to a point in work coordinates.
std::optional<double> Motion::touch(const Workpiece& workpiece, SignalMask signals,
                                    const Axes& end) const {
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
  std::vector<Solid> touching;
  bool bodies = false, body = false;
  for (const Solid& solid : workpiece.solids) {
    bodies = bodies || !solid.hole;
    if (solid.signal != 0 && (signals & signal_bit(solid.signal)) == 0) continue;
    body = body || !solid.hole;
    touching.push_back(solid);
  }
  if (bodies && !body) return std::nullopt;  // holes in what gives another signal
  return first_contact(touching, ball(s_.work), ball(end), workpiece.stylus);
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
