// G70 to G73: a profile, read once, cut in levels, in parallel passes, or as it is written.
#include "cncsub/motion_contour.hpp"

#include <algorithm>

namespace cncsub {
namespace {

bool calls(const NcWords& words) {
  for (int i = 0; i < words.m_count; ++i)
    if (const int m = words.m[static_cast<std::size_t>(i)]; m >= 98 && m <= 99) return true;
  for (int i = 0; i < words.g_count; ++i)
    if (const int g = words.g[static_cast<std::size_t>(i)]; g >= 650 && g <= 670) return true;
  return false;
}

/// G70 to G73, which would follow the profile that they stand in.
bool follows_profile(const NcWords& words, const GCodes& codes) {
  for (int i = 0; i < words.g_count; ++i) {
    const Meaning meaning = codes.find(words.g[static_cast<std::size_t>(i)]).meaning;
    if (meaning >= Meaning::Finish && meaning <= Meaning::RoughPattern) return true;
  }
  return false;
}

/// G00 to G04, G40 to G42, G96 to G99 and the modes may stand inside. [TDi 23.1, TA 8]
bool allowed(Meaning meaning) {
  switch (meaning) {
    case Meaning::Rapid:
    case Meaning::Line:
    case Meaning::Cw:
    case Meaning::Ccw:
    case Meaning::Thread:
    case Meaning::Dwell:
    case Meaning::RadiusOff:
    case Meaning::RadiusLeft:
    case Meaning::RadiusRight:
    case Meaning::SurfaceSpeed:
    case Meaning::SpindleSpeed:
    case Meaning::PerMinute:
    case Meaning::PerRevolution:
    case Meaning::Absolute:
    case Meaning::Incremental:
      return true;
    default:
      return false;
  }
}

}  // namespace

/// The points of a piece where it crosses a level, as values of the cut axis, shifted by the
/// allowance.
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

/// The piece of the profile that goes back along an axis, or nothing.
const Piece* Contour::turning_back(int axis) const {
  int way = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double step = pieces[i].end[static_cast<std::size_t>(axis)] -
                        pieces[i - 1].end[static_cast<std::size_t>(axis)];
    if (std::fabs(step) < 1e-9) continue;
    if (way != 0 && (step > 0) != (way > 0)) return &pieces[i];
    way = step > 0 ? 1 : -1;
  }
  return nullptr;
}

/// Whether the profile reaches further out than the point where the cycle starts.
bool Contour::starts_inside() const {
  const auto level = static_cast<std::size_t>(level_axis);
  const double away = end_of(pieces.front())[level] <= start[level] ? 1 : -1;
  for (const Piece& piece : pieces)
    if ((end_of(piece)[level] - start[level]) * away > 1e-9) return true;
  return false;
}

/// How often the profile goes back in behind a shoulder.
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

Fault Contour::turns_back(int axis) const {
  const Piece* piece = turning_back(axis);
  return {.cause = Cause::ProfileNotMonotone,
          .at = (piece != nullptr ? *piece : pieces.back()).at,
          .detail = {},
          .address = axis == 0 ? 'X' : 'Z'};
}

Contour::Result Contour::check() const {
  const Control& c = *motion.facts_->control;
  const MonotoneCheck check = c.profile_monotone.value;
  const bool checked =
      check == MonotoneCheck::Always ||
      (check == MonotoneCheck::WithK && block.words.has('K') && block.words['K'] == 1);
  if (checked) {
    if (turning_back(cut_axis()) != nullptr) return turns_back(cut_axis());
    if (!pockets && turning_back(level_axis) != nullptr) return turns_back(level_axis);
  }
  if (const int most = c.max_pockets.value; most > 0 && pocket_count() > most)
    return motion.fault(Cause::ProfilePockets, block);
  if (motion.facts_->refuses(Cause::ProfileStart) && starts_inside())
    return motion.fault(Cause::ProfileStart, block);
  return std::nullopt;
}

/// Along the profile, moved by `by`, from a piece on.
Contour::Result Contour::follow(const Axes& by, std::size_t from) {
  for (std::size_t i = from; i < pieces.size(); ++i) {
    Piece piece = motion.make_piece(block, pieces[i].kind, end_of(pieces[i]) + by, pieces[i].named);
    piece.turn = pieces[i].turn;
    piece.plane = pieces[i].plane;
    for (std::size_t k = 0; k < 3; ++k)
      piece.centre[k] = pieces[i].centre[k] - pieces[i].offset[k] + by[k] + piece.offset[k];
    if (auto wrong = motion.move(block, piece)) return wrong;
  }
  return std::nullopt;
}

/// One level: in, along to the profile, out at 45 degrees, back.
Contour::Result Contour::rough_level(double level, double back, double away) {
  const MoveKind in = pieces.front().kind == MoveKind::Rapid ? MoveKind::Rapid : MoveKind::Feed;
  const double home = motion.s_.work[static_cast<std::size_t>(cut_axis())];
  if (auto wrong = go_axis(in, level_axis, level)) return wrong;
  const std::vector<double> meets = crossings(level);
  Axes last = end_of(pieces.back()) + shift;
  double stop = cut_of(last);
  if (!meets.empty()) {  // the first one on the way
    stop = meets.front();
    for (const double meet : meets)
      if ((meet - home) * back > (stop - home) * back) stop = meet;
  }
  if (auto wrong = go_axis(MoveKind::Feed, cut_axis(), stop)) return wrong;
  Axes out = motion.s_.work;
  level_of(out) += away * escape * scale(level_axis);
  cut_of(out) += back * escape * scale(cut_axis());
  const MoveKind kind = motion.facts_->control->escape.value == ReturnedEscape::Feed
                            ? MoveKind::Feed
                            : MoveKind::Rapid;
  if (auto wrong = go(kind, out)) return wrong;
  return go_axis(MoveKind::Rapid, cut_axis(), home);
}

Contour::Result Contour::rough() {
  Axes first = end_of(pieces.front()) + shift, begin = start + shift, last = end_of(pieces.back());
  const double away = level_of(first) <= level_of(begin) ? 1 : -1;
  const double back = cut_of(last) <= cut_of(start) ? 1 : -1;
  if (auto wrong = go(MoveKind::Rapid, begin)) return wrong;
  const double step = depth * scale(level_axis);
  const double levels = std::fabs(level_of(begin) - level_of(first)) / step;
  if (levels * static_cast<double>(pieces.size()) > kMostCrossings)
    return motion.fault(Cause::ValueOutOfRange, block, "the block would cut too many levels");
  for (double level = level_of(begin) - away * step; (level - level_of(first)) * away > 1e-9;
       level -= away * step) {
    if (block.outside.over(pieces.size() / 64)) return broken_off(block.words.at);
    if (auto wrong = rough_level(level, back, away)) return wrong;
  }
  if (auto wrong = follow(shift, 0)) return wrong;
  return go(MoveKind::Rapid, start);
}

Contour::Result Contour::pass(const Axes& by) {
  if (auto wrong = go(MoveKind::Rapid, start + by)) return wrong;
  return follow(by, 0);
}

/// What the blocks do, as pieces, tried out on a copy.
Motion::Result Motion::capture(const std::vector<NcWords>& blocks, Outside& outside,
                               std::vector<Piece>& pieces) const {
  Motion trial = *this;
  trial.captured_ = &pieces;
  trial.end_cycles();
  for (const NcWords& words : blocks) {
    const bool calling = calls(words);
    if (calling) return Fault{Cause::ProfileCall, words.at, 1, {}};
    for (int i = 0; i < words.g_count; ++i)
      if (!allowed(facts_->codes.find(words.g[static_cast<std::size_t>(i)]).meaning))

        return Fault{.cause = Cause::ProfileCode,
                     .at = words.at,
                     .detail = {},
                     .address = 'G',
                     .code = words.g[static_cast<std::size_t>(i)]};
    if (outside.over(1)) return broken_off(words.at);
    Outcome outcome;
    NcWords plain = words;
    trial.s_.modal[at(Group::Radius)] = facts_->codes.of(Meaning::RadiusOff);
    if (auto wrong = trial.run(plain, 0, nullptr, outcome, outside)) return wrong;
  }
  if (trial.s_.angled.waiting)
    return Fault{
        .cause = Cause::AngleNoEnd, .at = trial.s_.angled.piece.at, .detail = {}, .address = 'A'};
  if (!trial.s_.held.corner.empty())
    return Fault{.cause = Cause::CornerNoMove,
                 .at = trial.s_.held.corner.back().at,
                 .detail = {},
                 .address = trial.s_.held.corner.back().corner};
  std::erase_if(pieces, [](const Piece& piece) { return piece.kind == MoveKind::Dwell; });
  return std::nullopt;
}

/// G70: the blocks as they are written, with their own F, S and T, then back.
Motion::Result Motion::finish_contour(BlockWords& block, const std::vector<NcWords>& blocks) {
  const Axes start = s_.work;
  for (const NcWords& words : blocks) {
    if (calls(words)) return Fault{Cause::ProfileCall, words.at, 1, {}};
    if (follows_profile(words, facts_->codes)) return Fault{Cause::ProfileCode, words.at, 1, {}};
    if (auto wrong = run(words, block.step, block.moves, block.outcome, block.outside))
      return wrong;
  }
  const GCode radius = s_.modal[at(Group::Radius)];
  s_.modal[at(Group::Radius)] = facts_->codes.of(Meaning::RadiusOff);
  auto wrong = move(block, MoveKind::Rapid, start, kXz);
  if (facts_->codes.of(Meaning::RadiusOff).code != radius.code && !compensating())
    s_.held.engaged = false;
  return wrong;
}

namespace {

/// Depth and escape of the first block of G71 and G72, shift and passes of G73.
void take_first_block(const NcWords& w, Meaning meaning, MultipleData& data, double u, double r,
                      double wz) {
  if (meaning == Meaning::RoughPattern) {
    if (w.has('U')) data.shift_x = u;
    if (w.has('W')) data.shift_z = wz;
    if (w.has('R')) data.passes = whole(w['R']);
    return;
  }
  const char depth = meaning == Meaning::RoughTurn ? 'U' : 'W';
  if (w.has(depth)) data.depth = std::fabs(depth == 'U' ? u : wz), data.has_depth = true;
  if (w.has('R')) data.escape = r, data.has_escape = true;
}

}  // namespace

Motion::Result Motion::contour(BlockWords& block, Meaning meaning) {
  const NcWords& w = block.words;
  const Control& c = *facts_->control;
  const double u = w.has('U') ? number(block, 'U') : 0, wz = w.has('W') ? number(block, 'W') : 0;
  if (!w.has('P') && !w.has('Q')) {
    if (meaning == Meaning::Finish) return fault(Cause::PqMissing, block);
    take_first_block(w, meaning, s_.multiple, u, w.has('R') ? number(block, 'R') : 0, wz);
    if (s_.multiple.passes < 1) return fault(Cause::PatternPasses, block);
    return s_.multiple.escape < 0 ? Result(fault(Cause::CycleEscape, block)) : std::nullopt;
  }
  if (!w.has('P') || !w.has('Q')) return fault(Cause::PqMissing, block);
  if (!block.outside.profile) return fault(Cause::PqNotFound, block);
  Profile profile;
  const int ns = whole(raw(block, 'P')), nf = whole(raw(block, 'Q'));
  if (ns == nf && facts_->refuses(Cause::PqSame)) return fault(Cause::PqSame, block);
  if (auto wrong = block.outside.profile(ns, nf, profile)) return wrong;
  const int most = c.max_profile_blocks.value;
  if (most > 0 && profile.blocks.size() > static_cast<std::size_t>(most))
    return fault(Cause::ProfileTooLong, block);
  if (profile.blocks.empty()) return fault(Cause::PqNotFound, block);
  if (meaning == Meaning::Finish) return finish_contour(block, profile.blocks);
  return rough_contour(block, meaning, profile);
}

Motion::Result Motion::rough_contour(BlockWords& block, Meaning meaning, const Profile& profile) {
  const NcWords& w = block.words;
  const Control& c = *facts_->control;
  take_one_block(block, meaning);
  const MultipleData data = s_.multiple;
  if (auto wrong = need_feed(block, Meaning::Line)) return wrong;
  Contour contour{*this,
                  block,
                  {},
                  s_.work,
                  meaning == Meaning::RoughFace ? 2 : 0,
                  data.has_depth ? data.depth : c.rough_depth.value * 1e-3,
                  data.has_escape ? data.escape : c.rough_escape.value * 1e-3,
                  {},
                  false};
  if (auto wrong = capture(profile.blocks, block.outside, contour.pieces)) return wrong;
  const NcWords& first = profile.blocks.front();
  const bool x = first.has('X') || first.has('U'), z = first.has('Z') || first.has('W');
  const bool pattern = meaning == Meaning::RoughPattern;
  if (pattern && (contour.pieces.empty() || (!x && !z)))
    return Fault{Cause::PatternFirstBlock, first.at, 1, {}};
  if (!pattern && (contour.pieces.empty() || contour.pieces.front().turn != 0))
    return Fault{Cause::ProfileFirstBlock, first.at, 1, {}};
  if (meaning == Meaning::RoughTurn && !x) return Fault{Cause::ProfileFirstX, first.at, 1, {}};
  if (meaning == Meaning::RoughFace && !z) return Fault{Cause::ProfileFirstZ, first.at, 1, {}};
  contour.pockets = c.type_by_shape.value ? !contour.monotone(contour.level_axis) : x && z;
  contour.shift[0] = w.has('U') ? number(block, 'U') : 0;
  contour.shift[2] = w.has('W') ? number(block, 'W') : 0;
  if (profile.right_behind || c.contour_behind.value) block.outcome.behind = profile.behind;
  if (meaning == Meaning::RoughPattern) return rough_pattern(block, contour);
  if (contour.depth <= 0) return fault(Cause::CycleDepth, block);
  if (auto wrong = contour.check()) return wrong;
  return contour.pockets ? contour.rough_pockets() : contour.rough();
}

/// The older form: what the first of two blocks holds stands in the one block. [K]
void Motion::take_one_block(const BlockWords& block, Meaning meaning) {
  const NcWords& w = block.words;
  MultipleData& data = s_.multiple;
  if (!facts_->control->one_block_cycles.value || !w.has('D')) return;
  if (meaning == Meaning::RoughPattern) {
    data.shift_x = w.has('I') ? number(block, 'I') : 0;
    data.shift_z = w.has('K') ? number(block, 'K') : 0;
    data.passes = std::max(1, whole(raw(block, 'D')));
  } else {
    data.depth = std::fabs(cycle_length(block, 'D'));
    data.has_depth = true;
  }
}

/// G73: parallel passes, the last one along the profile with its allowance.
Motion::Result Motion::rough_pattern(BlockWords& block, Contour& contour) {
  const MultipleData data = s_.multiple;
  if (data.shift_x * contour.shift[0] < 0 && facts_->refuses(Cause::PatternX))
    return fault(Cause::PatternX, block);
  if (data.shift_z * contour.shift[2] < 0 && facts_->refuses(Cause::PatternZ))
    return fault(Cause::PatternZ, block);
  int passes = data.passes;
  if (passes == 1 && !facts_->control->single_pass_pattern.value) passes = 2;
  for (int j = 0; j < passes; ++j) {
    const double part = passes > 1 ? static_cast<double>(passes - 1 - j) / (passes - 1) : 0;
    Axes by = contour.shift;
    by[0] += 2 * data.shift_x * part;
    by[2] += data.shift_z * part;
    if (auto wrong = contour.pass(by)) return wrong;
  }
  return move(block, MoveKind::Rapid, contour.start, kXz);
}

}  // namespace cncsub
