// Chamfers and corner rounds between two moves: the first waits for the second.
#include "cncsub/motion_facts.hpp"
#include "cncsub/motion_geometry.hpp"

namespace cncsub {
namespace {

/// The value of a word written ",C" or "L"; false where the block has none.
bool corner_word(const NcWords& words, std::string_view name, double& value, std::uint32_t& mask) {
  int place = -1;
  if (name == ",C")
    place = kCommaC;
  else if (name == ",R")
    place = kCommaR;
  else if (name.size() == 1)
    place = name[0] - 'A';
  if (place < 0 || (words.mask >> place & 1) == 0) return false;
  value = words.value[static_cast<std::size_t>(place)];
  mask = 1u << place;
  return true;
}

/// C and R without a comma are words of lathes only.
bool any_corner_word(const NcWords& words, std::string_view names, bool lathe, double& value,
                     std::uint32_t& mask) {
  for (std::size_t first = 0; first < names.size();) {
    const std::size_t blank = std::min(names.find(' ', first), names.size());
    const std::string_view name = names.substr(first, blank - first);
    if ((lathe || (name != "C" && name != "R")) && corner_word(words, name, value, mask))
      return true;
    first = blank + 1;
  }
  return false;
}

}  // namespace

Motion::Result Motion::corner_words(BlockWords& block, Piece& piece) const {
  const Control& c = *facts_->control;
  double chamfer = 0, round = 0;
  std::uint32_t chamfer_mask = 0, round_mask = 0;
  const bool has_chamfer =
      any_corner_word(block.words, c.chamfer_words.value, facts_->lathe(), chamfer, chamfer_mask);
  bool has_round =
      any_corner_word(block.words, c.round_words.value, facts_->lathe(), round, round_mask);
  const bool arc = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
  if (arc && round_mask == bit('R')) has_round = false;
  if (!has_chamfer && !has_round) return right_angle_chamfer(block, piece);
  const bool comma = ((chamfer_mask | round_mask) >> kCommaC) != 0;
  if (piece.kind == MoveKind::Rapid || piece.kind == MoveKind::Thread)
    return comma ? Result(fault(Cause::CornerInRapid, block)) : std::nullopt;
  if (s_.modal[at(Group::Polar)].meaning == Meaning::PolarOn && facts_->refuses(Cause::PolarCorner))
    return fault(Cause::PolarCorner, block);
  if (block.has(Group::Radius) && facts_->refuses(Cause::CornerOffset))
    return fault(Cause::CornerOffset, block);
  if (has_chamfer && has_round) return fault(Cause::CornerFormat, block);
  piece.corner = has_chamfer ? 'C' : 'R';
  double size = has_chamfer ? chamfer : round;
  const std::uint32_t mask = has_chamfer ? chamfer_mask : round_mask;
  if ((block.words.whole & mask) != 0 && c.whole_numbers.value == WholeNumbers::Increments)
    size *= facts_->increment * (g20() ? 0.1 : 1);
  piece.corner_size = size * s_.unit;
  if (piece.corner_size == 0) piece.corner = 0;
  return std::nullopt;
}

/// `G01 Z_ I_` and `G01 X_ K_`: the older form between moves at right angles. [motion 7.2]
Motion::Result Motion::right_angle_chamfer(const BlockWords& block, Piece& piece) const {
  const NcWords& w = block.words;
  const bool written = w.has('I') || w.has('K');
  if (!facts_->control->chamfer_ik.value || !facts_->lathe() || !written ||
      piece.kind != MoveKind::Feed || piece.turn != 0)
    return std::nullopt;
  const Axes end = piece.end - piece.offset;
  if (end[0] != s_.work[0] && end[2] != s_.work[2]) return fault(Cause::CornerTaper, block);
  if (w.has('I') && w.has('K')) return fault(Cause::CornerFormat, block);
  piece.corner_size = std::fabs(number(block, w.has('I') ? 'I' : 'K'));
  if (piece.corner_size > 0) piece.corner = 'C';
  return std::nullopt;
}

Motion::Result Motion::through_corner(Piece piece, Axes from, Moves* moves) {
  Held& held = s_.held;
  if (!held.corner.empty()) {
    const Piece first = held.corner.back();
    held.corner.clear();
    if (piece.kind != MoveKind::Feed && piece.kind != MoveKind::Cw && piece.kind != MoveKind::Ccw)
      return Fault{Cause::CornerNextMove, piece.at, 1, {}};
    CornerPieces corner;
    const PlaneView view{plane_axes(first.plane), facts_->share(0)};
    const bool line = facts_->control->chamfer_length.value == ChamferLength::Line;
    if (!cut_corner(view, held.corner_from, first, piece, line, corner))
      return Fault{Cause::CornerTooShort, first.at, 1, {}};
    if (auto wrong = through_radius(corner.first, held.corner_from, moves)) return wrong;
    if (corner.has_between)
      if (auto wrong = through_radius(corner.between, corner.at_first, moves)) return wrong;
    piece = corner.second;
    from = corner.at_second;
  }
  if (piece.corner != 0) {
    held.corner_from = from;
    held.corner.push_back(piece);
    return std::nullopt;
  }
  return through_radius(piece, from, moves);
}

}  // namespace cncsub
