// Chamfers and corner rounds between two moves: the first waits for the second.
#include "cncsub/motion_facts.hpp"
#include "cncsub/motion_geometry.hpp"

namespace cncsub {

CornerWords::CornerWords(std::string_view names, bool lathe) {
  while (!names.empty()) {
    const std::size_t blank = std::min(names.find(' '), names.size());
    const std::string_view name = names.substr(0, blank);
    names.remove_prefix(std::min(blank + 1, names.size()));
    const int place = name == ",C"                                            ? kCommaC
                      : name == ",R"                                          ? kCommaR
                      : name == ",A"                                          ? kCommaA
                      : name.size() != 1                                      ? -1
                      : !lathe && (name == "A" || name == "C" || name == "R") ? -1
                                                                              : name[0] - 'A';
    if (place < 0) continue;
    places.push_back(place);
    mask |= 1u << place;
  }
}

int CornerWords::find(std::uint32_t words) const {
  if ((words & mask) == 0) return -1;
  const auto has = [&](int place) { return (words >> place & 1) != 0; };
  return *std::find_if(places.begin(), places.end(), has);
}

Motion::Result Motion::corner_words(BlockWords& block, Piece& piece) const {
  const Control& c = *facts_->control;
  const int chamfer = facts_->chamfers.find(block.words.mask);
  int round = facts_->rounds.find(block.words.mask);
  const bool arc = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
  if (arc && round == 'R' - 'A') round = -1;
  if (chamfer < 0 && round < 0) return right_angle_chamfer(block, piece);
  const bool comma = chamfer >= kCommaC || round >= kCommaC;
  if (piece.kind == MoveKind::Rapid || piece.kind == MoveKind::Thread)
    return comma ? Result(fault(Cause::CornerInRapid, block)) : std::nullopt;
  if (s_.modal[at(Group::Polar)].meaning == Meaning::PolarOn && facts_->refuses(Cause::PolarCorner))
    return fault(Cause::PolarCorner, block);
  if (block.has(Group::Radius) && facts_->refuses(Cause::CornerOffset))
    return fault(Cause::CornerOffset, block);
  if (chamfer >= 0 && round >= 0) return fault(Cause::CornerFormat, block);
  piece.corner = chamfer >= 0 ? 'C' : 'R';
  const int place = chamfer >= 0 ? chamfer : round;
  double size = block.words.value[static_cast<std::size_t>(place)];
  if ((block.words.whole >> place & 1) != 0 && c.whole_numbers.value == WholeNumbers::Increments)
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
