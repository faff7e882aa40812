// Threads: the lead, the run-out at the end, G32 G33 G34, and the multiple thread G76.
#include <algorithm>

#include "cncsub/motion_facts.hpp"

namespace cncsub {
namespace {

bool is_thread(Meaning meaning) {
  return meaning == Meaning::Thread || meaning == Meaning::VariableThread ||
         meaning == Meaning::ThreadCycle || meaning == Meaning::TapCycle;
}

double sign_of(double value) { return value < 0 ? -1 : 1; }

}  // namespace

/// Whether F of this block is the lead of a thread.
bool Motion::cuts_thread(const BlockWords& block) const {
  if (block.meaning(Group::OneShot) == Meaning::MultipleThread) return true;
  if (block.has(Group::OneShot) && block.meaning(Group::OneShot) != Meaning::ExactStop)
    return false;
  return is_thread((block.has(Group::Motion) ? block.codes : s_.modal)[at(Group::Motion)].meaning);
}

/// F of a thread, or I: so many threads an inch. [TDi 24.1]
void Motion::set_lead(const BlockWords& block) {
  const Control& c = *facts_->control;
  if (!c.lead_apart.value) {
    s_.lead = s_.feed;
    return;
  }
  if (!cuts_thread(block)) return;
  if (block.words.has('F'))
    s_.lead = raw(block, 'F') * s_.unit;
  else if (block.words.has('I') && raw(block, 'I') > 0)
    s_.lead = kInch / raw(block, 'I');
}

Motion::Result Motion::need_lead(const BlockWords& block) const {
  const Control& c = *facts_->control;
  if (s_.lead <= 0) return fault(Cause::ThreadLead, block);
  if (c.thread_needs_spindle.value &&
      (s_.spindle == 5 || (s_.surface ? s_.surface_speed : s_.speed) <= 0))
    return fault(Cause::SpindleStands, block);
  return std::nullopt;
}

/// The run-out that J, K and the tenths of a lead give, all radius values; `across` has no sign.
Motion::RunOut Motion::run_out(double tenths) const {
  const TurnData& turn = s_.turn;
  const double own = tenths * 0.1 * s_.lead;
  switch (facts_->control->run_out_words.value) {
    case RunOutWords::None:
      return {own, own};
    case RunOutWords::Equal:  // [TDi 24.9 notes 2 to 7]
      if (!turn.has_j) return {turn.has_k && turn.k > 0 ? turn.k : own, own};
      if (turn.j == 0) return {};
      return {turn.has_k && turn.k != 0 ? std::fabs(turn.k) : std::fabs(turn.j), std::fabs(turn.j)};
    case RunOutWords::Across:  // [TA 18, ordinary mode]
      if (!turn.has_j && !turn.has_k) return {own, own};
      if (!turn.has_j || turn.j == 0 || (turn.has_k && turn.k == 0)) return {};
      return {turn.has_k ? std::fabs(turn.k) : 0, std::fabs(turn.j)};
  }
  return {};
}

/// Cuts to `end`; the run-out leaves the line `along` before it and goes `across` to the side
/// `way`, both radius values. The lead grows by `growth` with every revolution.
Motion::Result Motion::cut_thread(BlockWords& block, const Axes& end, std::uint32_t named,
                                  RunOut out, double way, double growth) {
  const Axes start = s_.work;
  const auto travel = [&](int i) { return (end[i] - start[i]) * facts_->share(i); };
  const int across = std::fabs(travel(0)) > std::fabs(travel(2)) ? 2 : 0, along = 2 - across;
  const double length = std::max(std::fabs(travel(along)), std::fabs(travel(1)));
  double lead = s_.lead;
  const auto cut = [&](const Axes& to, std::uint32_t axes, double bit) -> Result {
    const double square = lead * lead + 2 * growth * bit;
    if (square <= 0)
      return fault_at(block.words.has('R') ? 'R' : 'K', Cause::ThreadLead, block,
                      "the lead would come to 0");
    Piece piece = make_piece(block, MoveKind::Thread, to, axes);
    const double last = std::sqrt(square);
    piece.state.feed = (lead + last) / 2;  // the mean: the length by the revolutions
    piece.state.feed_mode = FeedMode::PerRevolution;
    if (auto wrong = corner_words(block, piece)) return wrong;
    lead = last;
    return move(block, piece);
  };
  if (out.across == 0) return cut(end, named, length);
  if (out.along > length + 1e-9)
    return fault(Cause::ThreadRunOut, block, "the run-out is longer than the thread");
  Axes leave = end;
  if (length > 0)
    for (const int i : {0, 2}) leave[i] -= (end[i] - start[i]) * out.along / length;
  if (auto wrong = cut(leave, named, length - out.along)) return wrong;
  Axes last = end;
  last[across] = leave[across] + way * out.across / facts_->share(across);
  if (out.along == 0) return move(block, MoveKind::Rapid, last, axis_bit(across));
  return cut(last, axis_bit(0) | axis_bit(2), out.along);
}

/// G32, G33, G34.
Motion::Result Motion::thread(BlockWords& block, Meaning meaning) {
  const Control& c = *facts_->control;
  std::uint32_t named = 0;
  const Axes end = end_point(block, named);
  take_run_out(block);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_lead(block)) return wrong;
  const char letter = c.lead_growth.value.empty() ? 'K' : c.lead_growth.value[0];
  const bool grows = meaning == Meaning::VariableThread && block.words.has(letter);
  RunOut out;
  if (c.run_out_words.value != RunOutWords::None && s_.turn.has_j) out = run_out(0);
  return cut_thread(block, end, named, out, sign_of(s_.turn.j), grows ? number(block, letter) : 0);
}

/// J and K stay until another motion code. [TDi 24.1 note 1]
void Motion::take_run_out(const BlockWords& block) {
  if (facts_->control->run_out_words.value == RunOutWords::None) return;
  if (block.words.has('J')) s_.turn.j = number(block, 'J'), s_.turn.has_j = true;
  if (block.words.has('K')) s_.turn.k = number(block, 'K'), s_.turn.has_k = true;
}

/// The thread of a cycle: it runs out towards the start, and not beyond it. [TA 18 note 5]
Motion::Result Motion::cut_cycle_thread(BlockWords& block, const Axes& end, double tenths,
                                        double level) {
  RunOut out = run_out(tenths);
  const double way = level - end[0];
  out.across = std::min(out.across, std::fabs(way) * facts_->share(0));
  return cut_thread(block, end, axis_bit(0) | axis_bit(2), out, sign_of(way), 0);
}

namespace {

/// The depths of the passes: sqrt(n) of the first cut, at least the least cut each, then the
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

}  // namespace

/// P of the first block: passes, run-out and angle, two digits each; fewer digits name the last of
/// them. [TDi 24.12 note 4]
Motion::Result Motion::set_thread_data(BlockWords& block) {
  const NcWords& w = block.words;
  MultipleData& data = s_.multiple;
  if (w.has('P')) {
    const int p = whole(raw(block, 'P'));
    const bool all = !facts_->control->thread_digits_apart.value;
    if (p < 0 || p > 999999) return fault(Cause::ThreadPasses, block);
    if (all && p / 10000 == 0 && facts_->refuses(Cause::ThreadPasses))
      return fault(Cause::ThreadPasses, block);
    if (all || p > 9999) data.finish_passes = p / 10000;
    if (all || p > 99) data.chamfer = p / 100 % 100;
    data.angle = p % 100;
  }
  if (w.has('Q')) data.least_cut = cycle_length(block, 'Q');
  if (w.has('R')) data.allowance = number(block, 'R');
  if (data.least_cut < 0) return fault(Cause::ThreadLeastCut, block);
  if (data.allowance < 0) return fault(Cause::ThreadAllowance, block);
  return std::nullopt;
}

/// Height, first cut and taper of the second block, or of the one block of the older form.
Motion::Result Motion::read_thread(const BlockWords& block, const Axes& end, ThreadForm& form) {
  const NcWords& w = block.words;
  MultipleData& data = s_.multiple;
  const bool one_block = facts_->control->one_block_cycles.value && w.has('K');
  const char height = one_block ? 'K' : 'P', first = one_block ? 'D' : 'Q';
  const char taper = one_block ? 'I' : 'R';
  if (!w.has(height)) return fault(Cause::ThreadHeight, block);
  form.height = one_block ? number(block, 'K') : cycle_length(block, 'P');
  form.first = w.has(first) ? std::fabs(cycle_length(block, first)) : 0;
  form.taper = w.has(taper) ? number(block, taper) : 0;
  if (one_block && w.has('A')) data.angle = whole(raw(block, 'A'));
  const Axes& start = s_.work;
  const double x = (end[0] - start[0]) * facts_->share(0), z = end[2] - start[2];
  if (form.height <= 0) return fault(Cause::ThreadHeightValue, block);
  if (form.first <= 0) return fault(Cause::ThreadCut, block);
  if (data.least_cut > form.height) return fault_at(height, Cause::ThreadLeastCut, block);
  if (data.allowance >= form.height) return fault_at(height, Cause::ThreadAllowance, block);
  if (x == 0 || z == 0) return fault(Cause::ThreadTravel, block);
  if (std::fabs(form.taper) > std::fabs(z)) return fault(Cause::ThreadSteep, block);
  if (form.taper * x < 0 && std::fabs(form.taper) > std::fabs(x))
    return fault(Cause::ThreadTaper, block);
  return std::nullopt;
}

Motion::Result Motion::multiple_thread(BlockWords& block) {
  const NcWords& w = block.words;
  s_.turn = {};
  take_run_out(block);
  // Several starts, and other sides of the cut: where the passes lie is not known. [TA 21]
  for (const char letter : facts_->control->thread_words_not_computed.value)
    if (w.has(letter) && raw(block, letter) != (letter == 'L' ? 1 : 0))
      return fault(Cause::CodeNotComputed, block, std::string("G76 with ") + letter);
  if (!w.has('X') && !w.has('Z') && !w.has('U') && !w.has('W')) return set_thread_data(block);
  std::uint32_t named = 0;
  const Axes start = s_.work, end = target(block, named);
  ThreadForm form;
  if (auto wrong = read_thread(block, end, form)) return wrong;
  if (auto wrong = need_lead(block)) return wrong;
  const MultipleData data = s_.multiple;
  const double outside = start[0] >= end[0] + 2 * form.taper ? 1 : -1;
  const double along = end[2] < start[2] ? -1 : 1;
  const double slope = std::tan(data.angle / 2.0 * kPi / 180);
  for (const double depth : thread_depths(form.height, form.first, data)) {
    const double above = outside * 2 * (form.height - depth);
    Axes in = start, out = end;
    in[0] = end[0] + 2 * form.taper + above;
    in[2] = start[2] + along * depth * slope;
    out[0] = end[0] + above;
    if (auto wrong = move(block, MoveKind::Rapid, in, axis_bit(0) | axis_bit(2))) return wrong;
    if (auto wrong = cut_cycle_thread(block, out, data.chamfer, start[0])) return wrong;
    if (auto wrong = move_axis(block, MoveKind::Rapid, 0, start[0])) return wrong;
    if (auto wrong = move_axis(block, MoveKind::Rapid, 2, start[2])) return wrong;
  }
  s_.turn = {};
  return std::nullopt;
}

}  // namespace cncsub
