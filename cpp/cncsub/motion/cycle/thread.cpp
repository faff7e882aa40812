// Threads: the lead, the run-out at the end, G32 G33 G34, and the multiple thread G76.
#include <algorithm>

#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

bool is_thread(Meaning meaning) {
  return meaning == Meaning::Thread || meaning == Meaning::VariableThread ||
         meaning == Meaning::ThreadCycle || meaning == Meaning::TapCycle;
}

double sign_of(double value) { return value < 0 ? -1 : 1; }

/// Return the run-out where K alone counts along, J alone on both sides. [TDi 24.9 notes 2 to 7]
RunOut equal_run_out(const TurnData& turn, double own) {
  const double j = std::fabs(turn.j), k = std::fabs(turn.k);
  if (!turn.has_j) return {turn.has_k && turn.k > 0 ? k : own, own};
  if (j == 0) return {};
  return {turn.has_k && k != 0 ? k : j, j};
}

/// Return the run-out where J goes across, K along; J alone leaves at once. [TA 18, ordinary mode]
RunOut run_out_across(const TurnData& turn, double own) {
  const double j = std::fabs(turn.j), k = std::fabs(turn.k);
  if (!turn.has_j) return turn.has_k ? RunOut{} : RunOut{own, own};
  if (j == 0 || (turn.has_k && k == 0)) return {};
  return {turn.has_k ? k : 0, j};
}

/// Return the run-out by J, K and the tenths of a lead, all radius values; `across` has no sign.
RunOut run_out(MotionView m, double tenths) {
  const double own = tenths * 0.1 * m.state.lead;
  switch (m.facts.control->turning.run_out_words.value) {
    case RunOutWords::None:
      break;
    case RunOutWords::Equal:
      return equal_run_out(m.state.turn, own);
    case RunOutWords::Across:
      return run_out_across(m.state.turn, own);
  }
  return {own, own};
}

/// Return the depths of the passes: sqrt(n) of the first cut, at least the least cut each, then the
/// finishing passes.
std::vector<double> thread_depths(double height, double first, const MultipleData& data) {
  std::vector<double> list;
  const double rough = height - data.allowance;
  for (int n = 1; n < 10000; ++n) {
    const double depth =
        std::max(std::sqrt(n) * first, std::sqrt(n - 1.0) * first + data.least_cut);
    if (depth >= rough - 1e-9) break;
    list.push_back(depth);
  }
  if (rough > 0) list.push_back(rough);
  const auto most = static_cast<int>(kMostMoves);  // more are refused when they move
  list.insert(list.end(), static_cast<std::size_t>(std::clamp(data.finish_passes, 1, most)),
              height);
  return list;
}

/// Take over P of the first block: passes, run-out and angle, two digits each; fewer digits name
/// the last of them. [TDi 24.12 note 4]
Result set_thread_data(MotionContext& m, BlockWords& block) {
  const NcWords& w = block.words;
  MultipleData& data = m.state.multiple;
  if (w.has('P')) {
    const int p = whole(block.words['P']);
    const bool all = !m.facts.control->turning.thread_digits_apart.value;
    if (p < 0 || p > 999999) return fault_at('P', Cause::ThreadPasses, block);
    if (all && p / 10000 == 0 && m.facts.refuses(Cause::ThreadPasses))
      return fault_at('P', Cause::ThreadPasses, block);
    if (all || p > 9999) data.finish_passes = p / 10000;
    if (all || p > 99) data.chamfer = p / 100 % 100;
    data.angle = p % 100;
  }
  if (w.has('Q')) data.least_cut = cycle_length(m, block, 'Q');
  if (w.has('R')) data.allowance = number(m, block, 'R');
  if (data.least_cut < 0) return fault_at('Q', Cause::ThreadLeastCut, block);
  if (data.allowance < 0) return fault_at('R', Cause::ThreadAllowance, block);
  return std::nullopt;
}

struct ThreadForm {  // of G76, radius values
  double height = 0, first = 0, taper = 0;
};

/// Read height, first cut and taper of the second block, or of the one block of the older form.
Result read_thread(MotionContext& m, const BlockWords& block, const Axes& end, ThreadForm& form) {
  const NcWords& w = block.words;
  MultipleData& data = m.state.multiple;
  const bool one_block = m.facts.control->turning.one_block_cycles.value && w.has('K');
  const char height = one_block ? 'K' : 'P', first = one_block ? 'D' : 'Q';
  const char taper = one_block ? 'I' : 'R';
  if (!w.has(height)) return fault(Cause::ThreadHeight, block);
  form.height = one_block ? number(m, block, 'K') : cycle_length(m, block, 'P');
  form.first = w.has(first) ? std::fabs(cycle_length(m, block, first)) : 0;
  form.taper = w.has(taper) ? number(m, block, taper) : 0;
  if (one_block && w.has('A')) data.angle = whole(block.words['A']);
  const Axes& start = m.state.work;
  const double x = (end[0] - start[0]) * m.facts.share(0), z = end[2] - start[2];
  if (form.height <= 0) return fault_at(height, Cause::ThreadHeightValue, block);
  if (form.first <= 0) return fault_at(first, Cause::ThreadCut, block);
  if (data.least_cut > form.height) return fault_at(height, Cause::ThreadLeastCut, block);
  if (data.allowance >= form.height) return fault_at(height, Cause::ThreadAllowance, block);
  if (std::fabs(x) < kStanding || std::fabs(z) < kStanding)
    return fault_at({.addresses = kEndWords | bit('U') | bit('W')}, Cause::ThreadTravel, block);
  if (std::fabs(form.taper) > std::fabs(z)) return fault_at(taper, Cause::ThreadSteep, block);
  if (form.taper * x < 0 && std::fabs(form.taper) > std::fabs(x))
    return fault_at(taper, Cause::ThreadTaper, block);
  return std::nullopt;
}

/// Cut pass after pass, each deeper along the flank.
Result cut_passes(MotionContext& m, BlockWords& block, const Axes& end, const ThreadForm& form) {
  const Axes start = m.state.work;
  const MultipleData data = m.state.multiple;
  const double outside_sign = start[0] >= end[0] + 2 * form.taper ? 1 : -1;
  const double along = end[2] < start[2] ? -1 : 1;
  const double slope = std::tan(data.angle / 2.0 * kPi / 180);
  for (const double depth : thread_depths(form.height, form.first, data)) {
    const double above = outside_sign * 2 * (form.height - depth);
    Axes in = start, out = end;
    in[0] = end[0] + 2 * form.taper + above;
    in[2] = start[2] + along * depth * slope;
    out[0] = end[0] + above;
    if (auto wrong = move(m, block, MoveKind::Rapid, in, axis_bit(0) | axis_bit(2))) return wrong;
    if (auto wrong = cut_cycle_thread(m, block, out, data.chamfer, start[0])) return wrong;
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, 0, start[0])) return wrong;
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, 2, start[2])) return wrong;
  }
  return std::nullopt;
}

}  // namespace

bool cuts_thread(const MotionState& state, const BlockWords& block) {
  if (block.meaning(Group::OneShot) == Meaning::MultipleThread) return true;
  if (block.has(Group::OneShot) && block.meaning(Group::OneShot) != Meaning::ExactStop)
    return false;
  return is_thread(
      (block.has(Group::Motion) ? block.code(Group::Motion) : state.modal[at(Group::Motion)])
          .meaning);
}

void set_lead(MotionContext& m, const BlockWords& block) {
  const Control& c = *m.facts.control;
  if (!c.turning.lead_apart.value) {
    m.state.lead = m.state.feed;
    return;
  }
  if (!cuts_thread(m.state, block)) return;
  if (block.words.has('F'))
    m.state.lead = block.words['F'] * m.state.unit;
  else if (block.words.has('I') && block.words['I'] > 0)
    m.state.lead = kInch / block.words['I'];
}

Result need_lead(MotionView m, const BlockWords& block) {
  if (m.state.lead <= 0)
    return fault_at({.addresses = bit('F') | bit('I')}, Cause::ThreadLead, block);
  if (m.facts.refuses(Cause::SpindleStands) &&
      (!m.state.turns || (m.state.surface ? m.state.surface_speed : m.state.speed) <= 0))
    return fault(Cause::SpindleStands, block);
  return std::nullopt;
}

Result cut_thread(MotionContext& m, BlockWords& block, const Axes& end, std::uint32_t named,
                  RunOut out, double way, double growth) {
  const Axes start = m.state.work;
  const auto travel = [&](int i) { return (end[i] - start[i]) * m.facts.share(i); };
  const int across = std::fabs(travel(0)) > std::fabs(travel(2)) ? 2 : 0, along = 2 - across;
  const double length = std::max(std::fabs(travel(along)), std::fabs(travel(1)));
  double lead = m.state.lead;
  const auto cut = [&](const Axes& to, std::uint32_t axes, double bit) -> Result {
    const double square = lead * lead + 2 * growth * bit;
    if (square <= 0)
      return fault_at(block.words.has('R') ? 'R' : 'K', Cause::ThreadLead, block,
                      "the lead would fall to 0");
    Piece piece = make_piece(m, block, MoveKind::Thread, to, axes);
    const double last = std::sqrt(square);
    piece.state.feed = (lead + last) / 2;  // the mean: the length by the revolutions
    piece.state.feed_mode = FeedMode::PerRevolution;
    if (auto wrong = corner_words(m, block, piece)) return wrong;
    lead = last;
    return move(m, block, piece);
  };
  if (out.across == 0) return cut(end, named, length);
  if (out.along > length + 1e-9)
    return fault_at(block.words.has('K') ? 'K' : 'J', Cause::ThreadRunOut, block,
                    "the run-out is longer than the thread");
  Axes leave = end;
  if (length > 0)
    for (const int i : {0, 2}) leave[i] -= (end[i] - start[i]) * out.along / length;
  if (auto wrong = cut(leave, named, length - out.along)) return wrong;
  Axes last = end;
  last[across] = leave[across] + way * out.across / m.facts.share(across);
  if (out.along == 0) return move(m, block, MoveKind::Rapid, last, axis_bit(across));
  return cut(last, axis_bit(0) | axis_bit(2), out.along);
}

Result thread(MotionContext& m, BlockWords& block, Meaning meaning) {
  const Control& c = *m.facts.control;
  const auto [end, named] = end_point(m, block);
  if (auto wrong = take_run_out(m, block, false)) return wrong;
  if (named == 0) return std::nullopt;
  if (auto wrong = need_lead(m, block)) return wrong;
  const Letters& growth = c.turning.lead_growth.value;
  const char letter = growth.empty() ? 'K' : growth.front();
  const bool grows = meaning == Meaning::VariableThread && block.words.has(letter);
  RunOut out;
  if (c.turning.run_out_words.value != RunOutWords::None && m.state.turn.has_j) out = run_out(m, 0);
  return cut_thread(m, block, end, named, out, sign_of(m.state.turn.j),
                    grows ? number(m, block, letter) : 0);
}

Result take_run_out(MotionContext& m, const BlockWords& block, bool of_cycle) {
  if (m.facts.control->turning.run_out_words.value == RunOutWords::None) return std::nullopt;
  const bool minus = block.words['K'] < 0 || (of_cycle && block.words['J'] < 0);
  if (minus && m.facts.refuses(Cause::ThreadRunOutSign))
    return fault_at(block.words['K'] < 0 ? 'K' : 'J', Cause::ThreadRunOutSign, block, {});
  if (block.words.has('J')) m.state.turn.j = number(m, block, 'J'), m.state.turn.has_j = true;
  if (block.words.has('K')) m.state.turn.k = number(m, block, 'K'), m.state.turn.has_k = true;
  return std::nullopt;
}

Result cut_cycle_thread(MotionContext& m, BlockWords& block, const Axes& end, double tenths,
                        double level) {
  RunOut out = run_out(m, tenths);
  const double way = level - end[0];
  if (block.words.has('J') && out.across > std::fabs(way) * m.facts.share(0) + 1e-9 &&
      m.facts.refuses(Cause::ThreadRunOutAcross))
    return fault_at('J', Cause::ThreadRunOutAcross, block);
  out.across = std::min(out.across, std::fabs(way) * m.facts.share(0));
  return cut_thread(m, block, end, axis_bit(0) | axis_bit(2), out, sign_of(way), 0);
}

/// The variant of a thread by a letter of its axis whose lead grows by F; the next one's shrinks.
constexpr int kGrowing = 4;

/// Return the length of a thread by its revolutions, whose lead grows with each; nothing where it
/// would fall to 0.
static std::optional<double> mean_lead(double first, double growth, double length) {
  const double square = first * first + 2 * growth * length;
  if (square <= 0) return std::nullopt;
  return (first + std::sqrt(square)) / 2;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one word after the other
Result thread_by_k(MotionContext& m, BlockWords& block) {
  const Axes start = m.state.work;
  const auto [end, named] = end_point(m, block);
  if (named == 0) return std::nullopt;
  const int variant = m.state.modal[at(Group::Motion)].variant;
  // The lead stands at K, or at the letter of the centre along the axis of the thread.
  const char lead = variant < 3 || block.words.has('K') ? 'K' : block.words.has('I') ? 'I' : 'J';
  if (!block.words.has(lead)) return fault_at('K', Cause::ThreadLead, block);
  const int along = lead == 'K' ? 2 : lead == 'I' ? 0 : 1;
  if (variant >= 3 && (named & axis_bit(along)) == 0)
    return fault_at(lead, Cause::ThreadLead, block, "the axis of the lead does not move");
  if (variant >= 3 && block.words[lead] == 0)
    return fault_at(lead, Cause::ThreadLead, block, "the lead is zero");
  if (m.facts.refuses(Cause::SpindleStands) && !m.state.turns)
    return fault(Cause::SpindleStands, block);
  if (compensating(m.state) && radius_value(m) != 0) return fault(Cause::CompensationCode, block);
  Piece piece = make_piece(m, block, MoveKind::Thread, end, named);
  piece.state.feed = std::fabs(number(m, block, lead));
  piece.state.feed_mode = FeedMode::PerRevolution;
  if (variant >= kGrowing && block.words.has('F')) {
    const double growth = block.words['F'] * m.state.unit * (variant == kGrowing ? 1 : -1);
    const double length = std::fabs(end[along] - start[along]) * m.facts.share(along);
    const auto mean = mean_lead(piece.state.feed, growth, length);
    if (!mean) return fault_at('F', Cause::ThreadLead, block, "the lead would fall to 0");
    piece.state.feed = *mean;
  }
  if (auto wrong = move(m, block, piece)) return wrong;
  if (variant != 2) return std::nullopt;
  piece.end = start + piece.offset;
  return move(m, block, piece);
}

Result multiple_thread(MotionContext& m, BlockWords& block) {
  const NcWords& w = block.words;
  m.state.turn = {};
  if (auto wrong = take_run_out(m, block, true)) return wrong;
  // Several starts, and other sides of the cut: where the passes lie is not known. [TA 21]
  for (const char letter : m.facts.control->turning.thread_words_not_computed.value)
    if (w.has(letter) && block.words[letter] != (letter == 'L' ? 1 : 0))
      return fault(Cause::CodeNotComputed, block, std::string("G76 with ") + letter);
  if (!w.has('X') && !w.has('Z') && !w.has('U') && !w.has('W')) return set_thread_data(m, block);
  const auto [end, named] = target(m, block);
  ThreadForm form;
  if (auto wrong = read_thread(m, block, end, form)) return wrong;
  if (auto wrong = need_lead(m, block)) return wrong;
  if (auto wrong = cut_passes(m, block, end, form)) return wrong;
  m.state.turn = {};
  return std::nullopt;
}

}  // namespace cncsub
