// G31: where its skip signal comes, and what is kept of that.
#include <algorithm>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Read the feed of G31, and check P, the numbers of its signals.
Result skip_feed(MotionView m, const BlockWords& block, double& feed) {
  const Control& c = *m.facts.control;
  if (const int most = c.motion.max_skip_signals.value; most > 0 && block.words.has('P'))
    if (const double p = block.words['P']; p < 1 || p > most)
      return fault_at('P', Cause::ValueOutOfRange, block,
                      "P of G31 must be 1 to " + std::to_string(most));
  if (!c.motion.skip_own_feed.value) return need_feed(m, block, Meaning::Line);
  // Parameters of G31, G31.1, G31.2 and G31.3. [M7 p.547, p.552]
  const int form = block.code(Group::OneShot).variant;
  feed = c.parameter(std::to_string(1174 + 2 * form));
  if (block.words.has('F'))
    if (auto wrong = feed_of(m, block, feed)) return wrong;
  if (feed <= 0) return fault_at('F', Cause::NoSkipFeed, block);
  return lacks_speed(m) ? Result(fault_at('S', Cause::NoSpeed, block)) : std::nullopt;
}

/// Return where on the path to `end` a reported signal comes.
std::optional<double> part_of(const MotionState& state, const SkipSignal& reported,
                              const Axes& end) {
  constexpr double kOnTheWay = 1e-9;
  if (reported.comes == SkipSignal::Comes::Never) return std::nullopt;
  if (reported.comes == SkipSignal::Comes::AtFraction) return reported.value;
  const auto axis = static_cast<std::size_t>(reported.axis);
  const double from = state.work[axis], way = end[axis] - from, to = reported.value - from;
  if (way != 0 && to / way > 0 && to / way <= 1 + kOnTheWay / std::fabs(way)) return to / way;
  if (std::fabs(to) <= kOnTheWay) return 0;
  return std::nullopt;
}

/// Return where the ball of the stylus touches on its path from here to a point in work
/// coordinates.
std::optional<double> touch(MotionView m, const Workpiece& workpiece, SignalMask signals,
                            const Axes& end) {
  Axes tool = m.state.length + m.state.tool_shift;  // from the tool's point to the machine position
  if (workpiece.length) {
    tool = {};
    tool[static_cast<std::size_t>(m.state.length_axis)] = *workpiece.length;
  }
  const auto ball = [&](const Axes& work) {
    const Axes machine = in_machine(m.state, machine_point(m.state, work) - tool);
    Point3 centre{};
    for (std::size_t i = 0; i < centre.size(); ++i)
      centre[i] = machine[i] * m.facts.share(static_cast<int>(i));
    if (workpiece.by_end && m.state.length_axis < 3)
      centre[static_cast<std::size_t>(m.state.length_axis)] += workpiece.stylus;
    return centre;
  };
  return first_contact(workpiece, signals, ball(m.state.work), ball(end));
}

/// Return signals 1 to 8 out of the bits of a parameter.
SignalMask signals_of_parameter(const Control& c, int number) {
  return static_cast<SignalMask>(to_whole<int>(c.parameter(std::to_string(number)), 0, 255)) << 1;
}

/// Return the signals of G31 and its forms G31.1 to G31.3; P names them.
SignalMask signals_of_skip(const Control& c, const BlockWords& block, double p) {
  const int form = block.code(Group::OneShot).variant;
  switch (c.motion.skip_signals.value) {
    case SkipSignals::Any:
      return kAnySignal;
    case SkipSignals::Numbered:
      if (p >= 1 && p < kArrivalSignal) return signal_bit(whole(p));
      return p != 0 ? 0 : signal_bit(1);
    case SkipSignals::Parameters:
      return signals_of_parameter(c, p >= 1 && p < 5 ? 6201 + whole(p) : 6202);
    case SkipSignals::Bits:
      if (p >= 1) return static_cast<SignalMask>(to_whole<int>(p, 1, 255)) << 1;
      return form == 0 ? signal_bit(1) : signals_of_parameter(c, 1173 + 2 * form);
  }
  return kAnySignal;
}

/// Return the signals that end a dwell; Q names them.
SignalMask signals_of_dwell(const Control& c, double q) {
  switch (c.motion.skip_signals.value) {
    case SkipSignals::Any:
      return 0;
    case SkipSignals::Numbered:
      return q >= 1 && q < kArrivalSignal ? signal_bit(whole(q)) : 0;
    case SkipSignals::Parameters:
      return signals_of_parameter(c, q >= 1 && q < 5 ? 6201 + whole(q) : 6206);
    case SkipSignals::Bits:
      return signals_of_parameter(c, 1173);
  }
  return 0;
}

}  // namespace

namespace {

/// Return whether G38.2 or G38.4 is in force, by which a probe is to meet something.
bool must_probe(MotionView m) {
  const GCode& motion = m.state.modal[at(Group::Motion)];
  return motion.meaning == Meaning::Skip && motion.variant % 2 == 0;
}

/// Keep where the axes of the block stand as measured. [840slj p.5-24]
void keep_measured(MotionState& state, std::uint32_t named) {
  const Axes point = as_programmed(state, state.work);
  const Axes machine = in_machine(state, machine_point(state));
  for (std::size_t i = 0; i < point.size(); ++i)
    if ((named & axis_bit(static_cast<int>(i))) != 0) {
      state.measured[i] = point[i];
      state.measured_machine[i] = machine[i];
    }
}

}  // namespace

Result skip(MotionContext& m, BlockWords& block) {
  if (compensating(m.state)) return fault(Cause::CompensationSkip, block);
  if (block.code(Group::OneShot).variant == kSkipOnLine &&
      m.state.modal[at(Group::Motion)].meaning != Meaning::Line)
    return fault(Cause::CodeNotComputed, block, "measuring on another move than a line of G01");
  if (m.state.modal[at(Group::Feed)].meaning == Meaning::PerRevolution &&
      m.facts.refuses(Cause::SkipPerRevolution))
    return fault(Cause::SkipPerRevolution, block);
  auto [end, named] = linear_target(m, block);
  if (named == 0) return std::nullopt;
  if (must_probe(m) && end == m.state.work) return fault(Cause::SameProbePoint, block);
  double feed = m.state.feed;
  if (auto wrong = skip_feed(m, block, feed)) return wrong;
  const bool touched =
      m.inputs.has_signals() && signal_on_way(m, signals_of(m, block), end).has_value();
  Piece piece = make_piece(m, block, MoveKind::Feed, end, named);
  piece.state.feed = held_skip_feed(m, feed, piece.state.feed_mode);
  piece.skip = touched ? SkipMove::Touched : SkipMove::Missed;
  if (auto wrong = move(m, block, piece)) return wrong;
  m.outcome.skip = piece.skip;
  m.state.skip_touched = touched;
  m.state.set_anew[0] = true;
  m.state.skip = m.state.work;
  keep_measured(m.state, named);
  if (m.facts.control->motion.length_type.value != LengthType::Shift)
    m.state.skip = m.state.skip + m.state.length;  // with the tool, like #5041 [NCT 99M p.183]
  return std::nullopt;
}

double held_skip_feed(MotionView m, double feed, FeedMode mode) {
  const double most = m.facts.control->motion.max_skip_feed.value;
  if (most <= 0) return feed;
  if (mode != FeedMode::PerRevolution) return std::min(feed, most);
  return m.state.speed > 0 ? std::min(feed, most / m.state.speed) : feed;
}

SignalMask signals_of(MotionView m, const BlockWords& block) {
  const Control& c = *m.facts.control;
  const NcWords& w = block.words;
  return block.meaning(Group::OneShot) == Meaning::Dwell
             ? signals_of_dwell(c, w.has('Q') ? w['Q'] : 0)
             : signals_of_skip(c, block, w.has('P') ? w['P'] : 0);
}

std::optional<double> signal_on_way(MotionContext& m, SignalMask signals, Axes& end) {
  constexpr double kTouchPlaces = 1e6;  // to the millionth of a mm: 37, not 36.99999999999999
  MachineInputs& inputs = m.inputs;
  const ReportedSkips reported = inputs.skips.take(signals);
  std::optional<double> part;
  const SkipSignal* first = nullptr;
  for (const SkipSignal& signal : reported.reported)
    if (const auto there = part_of(m.state, signal, end); there && (!part || *there < *part)) {
      part = there;
      first = &signal;
    }
  if (reported.open != 0 && inputs.workpiece != nullptr)
    if (const auto there = touch(m, *inputs.workpiece, reported.open, end);
        there && (!part || *there < *part)) {
      part = there;
      first = nullptr;
    }
  if (!part) return std::nullopt;
  for (std::size_t i = 0; i < end.size(); ++i) {
    if (end[i] == m.state.work[i]) continue;
    end[i] = m.state.work[i] + (end[i] - m.state.work[i]) * *part;
    if (first == nullptr) end[i] = std::round(end[i] * kTouchPlaces) / kTouchPlaces;
  }
  if (first != nullptr && first->comes == SkipSignal::Comes::AtCoordinate)
    end[static_cast<std::size_t>(first->axis)] = first->value;
  return part;
}

}  // namespace cncsub
