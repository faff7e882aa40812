// The profile of G71 to G73 and what is cut along it.
#pragma once

#include <vector>

#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"

namespace cncsub {

constexpr std::uint32_t kXz = 5;  // the bits of X and Z

/// A profile in true lengths: along the cut (u) and across the levels (v).
struct Contour {
  MotionContext& m;
  BlockWords& block;
  std::vector<Piece> pieces;  // the profile; the first leads to its start
  Axes start{};               // A, work coordinates
  int level_axis = 0;         // the axis the levels lie across: X of G71, Z of G72
  double depth = 0, escape = 0;
  Axes shift{};  // finishing allowance
  bool pockets = false;

  int cut_axis() const { return level_axis == 0 ? 2 : 0; }
  double scale(int axis) const { return axis == 0 ? 2 : 1; }
  double& level_of(Axes& p) const { return p[static_cast<std::size_t>(level_axis)]; }
  double& cut_of(Axes& p) const { return p[static_cast<std::size_t>(cut_axis())]; }
  Axes end_of(const Piece& piece) const { return piece.end - piece.offset; }

  Result go(MoveKind kind, const Axes& end, std::uint32_t named = kXz) {
    return move(m, block, kind, end, named);
  }
  Result go_axis(MoveKind kind, int axis, double value) {
    return move_axis(m, block, kind, axis, value);
  }

  Result check() const;
  bool starts_inside() const;
  const Piece* turning_back(int axis, double way = 0) const;
  bool monotone(int axis) const { return turning_back(axis) == nullptr; }
  Fault turns_back(int axis) const;
  Result rough();
  Result rough_level(double level, double back, double away);
  std::vector<double> crossings(double level) const;
  Result follow(const Axes& by, std::size_t from);
  // pockets.cpp
  int pocket_count() const;
  Result rough_pockets();
  Result pass(const Axes& by);
};

/// Take depth and escape from the first block of G71 and G72, shift and passes from that of G73.
Result take_first_block(MotionContext& m, const BlockWords& block, Meaning meaning);
/// Take depth, shift and passes from the block itself, in the older one-block form.
/// [general knowledge]
void take_one_block(MotionContext& m, const BlockWords& block, Meaning meaning);
/// Cut along a profile whose pieces are known.
Result rough_contour(MotionContext& m, BlockWords& block, Meaning meaning, const Profile& profile,
                     std::vector<Piece> pieces);

}  // namespace cncsub
