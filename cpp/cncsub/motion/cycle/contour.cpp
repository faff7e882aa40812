// G70 to G73: a profile, read once, cut in levels, in parallel passes, or as it is written.
#include "cncsub/motion/cycle/contour.hpp"

#include <algorithm>

#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {

Result take_first_block(MotionContext& m, const BlockWords& block, Meaning meaning) {
  const NcWords& w = block.words;
  MultipleData& data = m.state.multiple;
  if (meaning == Meaning::RoughPattern) {
    if (w.has('U')) data.shift_x = number(m, block, 'U');
    if (w.has('W')) data.shift_z = number(m, block, 'W');
    if (w.has('R')) data.passes = whole(w['R']);
  } else {
    // The allowance stands in the second block, which has P and Q. [TDi 23.1; ALM 061]
    const char other = meaning == Meaning::RoughTurn ? 'W' : 'U';
    if (w.has(other)) return fault(Cause::PqMissing, block);
    const char depth = meaning == Meaning::RoughTurn ? 'U' : 'W';
    if (w.has(depth)) data.depth = std::fabs(number(m, block, depth)), data.has_depth = true;
    if (w.has('R')) data.escape = number(m, block, 'R'), data.has_escape = true;
  }
  if (data.passes < 1) return fault_at('R', Cause::PatternPasses, block);
  return data.escape < 0 ? Result(fault_at('R', Cause::CycleEscape, block)) : std::nullopt;
}

void take_one_block(MotionContext& m, const BlockWords& block, Meaning meaning) {
  const NcWords& w = block.words;
  MultipleData& data = m.state.multiple;
  if (!m.facts.control->turning.one_block_cycles.value || !w.has('D')) return;
  if (meaning == Meaning::RoughPattern) {
    data.shift_x = w.has('I') ? number(m, block, 'I') : 0;
    data.shift_z = w.has('K') ? number(m, block, 'K') : 0;
    data.passes = std::max(1, whole(block.words['D']));
  } else {
    data.depth = std::fabs(cycle_length(m, block, 'D'));
    data.has_depth = true;
  }
}

namespace {

/// Cut G73: parallel passes, the last one along the profile with its allowance.
Result rough_pattern(MotionContext& m, BlockWords& block, Contour& contour) {
  const MultipleData data = m.state.multiple;
  if (data.shift_x * contour.shift[0] < 0 && m.facts.refuses(Cause::PatternX))
    return fault_at('U', Cause::PatternX, block);
  if (data.shift_z * contour.shift[2] < 0 && m.facts.refuses(Cause::PatternZ))
    return fault_at('W', Cause::PatternZ, block);
  int passes = data.passes;
  if (passes == 1 && m.facts.control->turning.single_pattern.value != PatternPasses::One)
    passes = 2;
  for (int j = 0; j < passes; ++j) {
    const double part = passes > 1 ? static_cast<double>(passes - 1 - j) / (passes - 1) : 0;
    Axes by = contour.shift;
    by[0] += 2 * data.shift_x * part;
    by[2] += data.shift_z * part;
    if (auto wrong = contour.pass(by)) return wrong;
  }
  return move(m, block, MoveKind::Rapid, contour.start, kXz);
}

bool names_x(const NcWords& words) { return words.has('X') || words.has('U'); }
bool names_z(const NcWords& words) { return words.has('Z') || words.has('W'); }

/// Return what is wrong with the first block of a profile, which leads to its start.
Result check_first_block(const NcWords& first, const std::vector<Piece>& pieces, Meaning meaning) {
  const bool x = names_x(first), z = names_z(first);
  const bool pattern = meaning == Meaning::RoughPattern;
  if (pattern && (pieces.empty() || (!x && !z)))
    return Fault{Cause::PatternFirstBlock, first.at, 1, {}};
  if (!pattern && (pieces.empty() || pieces.front().turn != 0 || pieces.front().at != first.at))
    return Fault{Cause::ProfileFirstBlock, first.at, 1, {}};
  if (meaning == Meaning::RoughTurn && !x) return Fault{Cause::ProfileFirstX, first.at, 1, {}};
  if (meaning == Meaning::RoughFace && !z) return Fault{Cause::ProfileFirstZ, first.at, 1, {}};
  return std::nullopt;
}

/// Return a length of the block, 0 without the word.
double length_or_zero(MotionView m, const BlockWords& block, char address) {
  return block.words.has(address) ? number(m, block, address) : 0;
}

}  // namespace

Result rough_contour(MotionContext& m, BlockWords& block, Meaning meaning, const Profile& profile,
                     std::vector<Piece> pieces) {
  const Control& c = *m.facts.control;
  const MultipleData data = m.state.multiple;
  Contour contour{m,
                  block,
                  std::move(pieces),
                  m.state.work,
                  meaning == Meaning::RoughFace ? 2 : 0,
                  data.has_depth ? data.depth : c.turning.rough_depth.value * 1e-3,
                  data.has_escape ? data.escape : c.turning.rough_escape.value * 1e-3,
                  {},
                  false};
  const NcWords& first = profile.blocks.front();
  if (auto wrong = check_first_block(first, contour.pieces, meaning)) return wrong;
  contour.pockets = c.turning.rough_type.value == RoughType::ByShape
                        ? !contour.monotone(contour.level_axis)
                        : names_x(first) && names_z(first);
  contour.shift[0] = length_or_zero(m, block, 'U');
  contour.shift[2] = length_or_zero(m, block, 'W');
  if (profile.right_behind || c.turning.after_contour.value == AfterContour::BehindProfile)
    m.outcome.behind = profile.behind;
  if (meaning == Meaning::RoughPattern) return rough_pattern(m, block, contour);
  if (contour.depth <= 0) return fault_at('D', Cause::CycleDepth, block);
  if (auto wrong = contour.check()) return wrong;
  return contour.pockets ? contour.rough_pockets() : contour.rough();
}

/// Return where the pieces cross a level, as values of the cut axis, shifted by the allowance.
std::vector<double> Contour::crossings(double level) const {
  std::vector<double> list;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    Axes from = end_of(pieces[i - 1]) + shift, to = end_of(piece) + shift;
    const double a = level_of(from), b = level_of(to);
    if (piece.turn == 0) {
      if (a == b || (level - a) * (level - b) > 0) continue;
      list.push_back(cut_of(from) + (cut_of(to) - cut_of(from)) * (level - a) / (b - a));
      continue;
    }
    Axes centre{};
    for (std::size_t k = 0; k < 3; ++k) centre[k] = piece.centre[k] - piece.offset[k] + shift[k];
    const double ls = scale(level_axis), cs = scale(cut_axis());
    const double radius =
        std::hypot((a - level_of(centre)) / ls, (cut_of(from) - cut_of(centre)) / cs);
    const double up = (level - level_of(centre)) / ls, square = radius * radius - up * up;
    if (square < 0) continue;
    for (const double side : {-1.0, 1.0}) {
      const double at = side * std::sqrt(square) * cs;
      const double low = std::min(cut_of(from), cut_of(to)) - 1e-9,
                   high = std::max(cut_of(from), cut_of(to)) + 1e-9;
      if (cut_of(centre) + at >= low && cut_of(centre) + at <= high &&
          (level - a) * (level - b) <= 1e-12)
        list.push_back(cut_of(centre) + at);
    }
  }
  return list;
}

/// Return the piece of the profile that goes back along an axis by more than it may, or null.
/// Forward is the sign of `way`; where that is 0, the direction in which the profile sets out.
const Piece* Contour::turning_back(int axis, double way) const {
  const auto along = static_cast<std::size_t>(axis);
  const auto& turning = m.facts.control->turning;
  const int micrometres =
      axis == 0 ? turning.second_axis_allowance.value : turning.first_axis_allowance.value;
  const double allowed = micrometres * 1e-3 * scale(axis) + 1e-9;
  double furthest = pieces.front().end[along];
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double step = pieces[i].end[along] - furthest;
    if (way == 0 && std::fabs(step) > allowed) way = step;
    if (step * way < 0 && std::fabs(step) > allowed) return &pieces[i];
    if (step * way > 0) furthest += step;
  }
  return nullptr;
}

/// Return whether the profile reaches further out than the point where the cycle starts.
bool Contour::starts_inside() const {
  const auto level = static_cast<std::size_t>(level_axis);
  const double away = end_of(pieces.front())[level] <= start[level] ? 1 : -1;
  for (const Piece& piece : pieces)
    if ((end_of(piece)[level] - start[level]) * away > 1e-9) return true;
  return false;
}

/// Return the fault of the first block that goes another way than the profile: across the cuts back
/// to where the cycle starts, along them from its first point to its last.
Fault Contour::turns_back(int axis) const {
  const auto along = static_cast<std::size_t>(axis);
  const double to = axis == level_axis ? start[along] : end_of(pieces.back())[along];
  const Piece* piece = turning_back(axis, to - end_of(pieces.front())[along]);
  if (piece == nullptr) piece = turning_back(axis);
  return {.cause = Cause::ProfileNotMonotone,
          .at = (piece != nullptr ? *piece : pieces.back()).at,
          .detail = {},
          .word = {.addresses = bit(axis == 0 ? 'X' : 'Z')}};
}

Result Contour::check() const {
  const Control& c = *m.facts.control;
  const MonotoneCheck check = c.turning.profile_monotone.value;
  const bool checked =
      check == MonotoneCheck::Always ||
      (check == MonotoneCheck::WithK && block.words.has('K') && block.words['K'] == 1);
  if (checked) {
    if (turning_back(cut_axis()) != nullptr) return turns_back(cut_axis());
    if (!pockets && turning_back(level_axis) != nullptr) return turns_back(level_axis);
  }
  if (const int most = c.turning.max_pockets.value; most > 0 && pocket_count() > most)
    return fault(Cause::ProfilePockets, block);
  if (m.facts.refuses(Cause::ProfileStart) && starts_inside())
    return fault(Cause::ProfileStart, block);
  return std::nullopt;
}

/// Follow the profile, moved by `by`, from a piece on.
Result Contour::follow(const Axes& by, std::size_t from) {
  for (std::size_t i = from; i < pieces.size(); ++i) {
    Piece piece = make_piece(m, block, pieces[i].kind, end_of(pieces[i]) + by, pieces[i].named);
    piece.turn = pieces[i].turn;
    piece.plane = pieces[i].plane;
    for (std::size_t k = 0; k < 3; ++k)
      piece.centre[k] = pieces[i].centre[k] - pieces[i].offset[k] + by[k] + piece.offset[k];
    if (auto wrong = move(m, block, piece)) return wrong;
  }
  return std::nullopt;
}

/// Cut one level: in, along to the profile, out at 45 degrees, back.
Result Contour::rough_level(double level, double back, double away) {
  const MoveKind in = pieces.front().kind == MoveKind::Rapid ? MoveKind::Rapid : MoveKind::Feed;
  const double home = m.state.work[static_cast<std::size_t>(cut_axis())];
  if (auto wrong = go_axis(in, level_axis, level)) return wrong;
  const std::vector<double> meets = crossings(level);
  Axes last = end_of(pieces.back()) + shift;
  double stop = cut_of(last);
  if (!meets.empty()) {  // the first one on the path
    stop = meets.front();
    for (const double meet : meets)
      if ((meet - home) * back > (stop - home) * back) stop = meet;
  }
  if (auto wrong = go_axis(MoveKind::Feed, cut_axis(), stop)) return wrong;
  Axes out = m.state.work;
  level_of(out) += away * escape * scale(level_axis);
  cut_of(out) += back * escape * scale(cut_axis());
  const MoveKind kind = m.facts.control->turning.escape.value == ReturnedEscape::Feed
                            ? MoveKind::Feed
                            : MoveKind::Rapid;
  if (auto wrong = go(kind, out)) return wrong;
  return go_axis(MoveKind::Rapid, cut_axis(), home);
}

Result Contour::rough() {
  Axes first = end_of(pieces.front()) + shift, begin = start + shift, last = end_of(pieces.back());
  const double away = level_of(first) <= level_of(begin) ? 1 : -1;
  const double back = cut_of(last) <= cut_of(start) ? 1 : -1;
  if (auto wrong = go(MoveKind::Rapid, begin)) return wrong;
  const double step = depth * scale(level_axis);
  const double levels = std::fabs(level_of(begin) - level_of(first)) / step;
  if (levels * static_cast<double>(pieces.size()) > kMostCrossings)
    return fault(Cause::ValueOutOfRange, block, "the block would cut too many levels");
  for (double level = level_of(begin) - away * step; (level - level_of(first)) * away > 1e-9;
       level -= away * step) {
    if (m.inputs.over(pieces.size() / 64)) return broken_off(block.words.at);
    if (auto wrong = rough_level(level, back, away)) return wrong;
  }
  if (auto wrong = follow(shift, 0)) return wrong;
  return go(MoveKind::Rapid, start);
}

Result Contour::pass(const Axes& by) {
  if (auto wrong = go(MoveKind::Rapid, start + by)) return wrong;
  return follow(by, 0);
}

}  // namespace cncsub
