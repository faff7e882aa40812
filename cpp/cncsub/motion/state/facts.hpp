// What never changes during a run.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/control/control.hpp"
#include "cncsub/motion/state/setup.hpp"
#include "cncsub/motion/state/state.hpp"
#include "cncsub/text/number.hpp"

namespace cncsub {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInch = 25.4;
constexpr double kStanding = 1e-9;  // mm: a shorter path comes of rounding alone and is none

/// Return the axis of a letter, -1 where it is none.
constexpr int axis_of(char letter) {
  if (letter >= 'X' && letter <= 'Z') return letter - 'X';
  if (letter >= 'A' && letter <= 'C') return letter - 'A' + 3;
  return letter >= 'U' && letter <= 'W' ? letter - 'U' + 6 : -1;
}
static_assert(kAxisNames == "XYZABCUVW");
/// Return the plane of G17, G18 or G19.
constexpr Plane plane_of(Meaning meaning) {
  if (meaning == Meaning::PlaneZX) return Plane::ZX;
  return meaning == Meaning::PlaneYZ ? Plane::YZ : Plane::XY;
}
/// Take over the values of the axes that are named.
void fill(Axes& axes, const std::map<char, double>& values);
/// Return the number of a system: "G54", "G54.1 P3", "EXT" are 1, 9, 0; -1 for another name.
int system_of(const std::string& name);
/// Return whether a control has the system of this name.
bool has_system(const Control& control, const std::string& name);
constexpr std::uint32_t axis_bit(int axis) { return 1u << axis; }
/// Return the whole number of a word, whatever the word holds.
inline int whole(double value) { return to_whole<int>(value, -2'000'000'000, 2'000'000'000); }
/// Return whether all of these are numbers that a position, a length or a time may be.
template <std::size_t Size>
bool in_range(const std::array<double, Size>& values) {
  // All are tested at once, without a branch: as whole numbers the bits of doubles without their
  // signs stand in the order of the doubles, and those of a NaN after all others.
  constexpr auto kSign = std::uint64_t{1} << 63, kMost = std::bit_cast<std::uint64_t>(kLargest);
  std::uint64_t beyond = 0;
  for (const double value : values)
    beyond |= kMost - (std::bit_cast<std::uint64_t>(value) & ~kSign);
  return (beyond & kSign) == 0;
}
/// Return the same of single values. In an array they would be read back with one wide load, which
/// store forwarding cannot serve.
template <class... Values>
  requires(std::is_same_v<Values, double> && ...)
bool in_range(Values... values) {
  constexpr auto kSign = std::uint64_t{1} << 63, kMost = std::bit_cast<std::uint64_t>(kLargest);
  return (((kMost - (std::bit_cast<std::uint64_t>(values) & ~kSign)) | ...) & kSign) == 0;
}
inline Fault out_of_range(std::uint32_t at) {
  return {Cause::ValueOutOfRange, at, 1, "the numbers of the move are out of range"};
}
/// No block makes more moves than this, however small its steps and however large its counts are.
#ifdef CNCSUB_FUZZ  // a fuzzer has better things to do
constexpr std::uint32_t kMostMoves = 2'000;
#else
constexpr std::uint32_t kMostMoves = 1'000'000;
#endif
/// Return the fault that ends a block that is broken off; nobody reads it.
inline Fault broken_off(std::uint32_t at) { return {Cause::ValueOutOfRange, at, 1, "interrupted"}; }
/// No block looks for more crossings of its levels with the pieces of a profile than this.
constexpr double kMostCrossings = 1e8;
inline bool is_rotary(int axis) { return axis >= 3 && axis <= 5; }

inline Axes operator+(const Axes& a, const Axes& b) {
  Axes sum;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = a[i] + b[i];
  return sum;
}
inline Axes operator-(const Axes& a, const Axes& b) {
  Axes difference;
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] = a[i] - b[i];
  return difference;
}

/// The words of a block that say one thing of a corner: their places in its mask, and these as a
/// mask. C and R without a comma are words of lathes only.
struct CornerWords {
  CornerWords(const CornerLetters& words, bool lathe);
  /// Return the place of the first word that the block has, -1 where it has none.
  int find(std::uint32_t words) const;

  std::vector<int> places;
  std::uint32_t mask = 0;
};

struct Conflict;  // words or codes that do not go together

struct MotionFacts {
  MotionFacts(std::shared_ptr<const Control> c, const Setup& setup,
              std::shared_ptr<const CodeMeanings> of, bool general);

  std::shared_ptr<const Control> control;
  std::shared_ptr<const CodeMeanings> meanings;
  MachineType machine;
  const GCodes& codes;
  std::array<GCode, 4> path_codes;  // G00 to G03, as this control calls them
  std::string axis_order;           // the control's axes by number
  std::array<int, kGroups> group_numbers{};
  std::uint32_t diameters = 0;
  double increment = 0.001;
  Axes rapid{};
  std::map<int, Axes> reference;
  bool homed = false;  // the setup names a reference point
  struct Limit {
    int axis;
    double low, high;
  };
  std::vector<Limit> limits;
  std::vector<const Conflict*> conflicts;
  std::vector<const Conflict*> conflicts_of_words;  // of a block without G codes
  std::vector<const Conflict*> conflicts_of_moves;  // of a block with plain motion codes only
  CornerWords chamfers, rounds, angles;
  std::uint32_t contour_modes = 0;  // words of corners and contours that hold for the moves after
  bool keeps_heading;               // a program has arcs that go on from the move before
  bool general_only;                // no block takes the fast path
  std::uint32_t other_axes = 0;  // of a mill: axis letters beside X, Y and Z that mean nothing else
  std::uint32_t increments = 0;  // of a lathe, G code system A: U and W that are no corner words

  /// Return whether the control refuses what this cause names.
  bool refuses(Cause cause) const { return control->common.refuses.value.has(cause); }
  void list_conflicts();
  bool lathe() const { return machine != MachineType::Mill; }
  /// Return the words that may say a corner: those of its rules, and I and K of a lathe.
  std::uint32_t corner_words() const {
    return chamfers.mask | rounds.mask | (lathe() ? bit('I') | bit('K') : 0);
  }
  /// Return the words of which one says the corner of a move. The R of an arc is its radius.
  WordName corner_name(const Piece& piece) const {
    const bool arc = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
    return {.addresses = corner_words() & ~(arc ? bit('R') : 0)};
  }
  /// Return what a length of this axis counts in a path: half on a diameter axis.
  double share(int axis) const { return (diameters >> axis & 1) != 0 ? 0.5 : 1; }
};

}  // namespace cncsub
