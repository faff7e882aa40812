// Modes that programs switch on and off, and the effect of blocks on them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub::modes {

// The values that may be in force, as four bits for each mode: the value that was found, the usual
// value, and two others.
using Modes = std::uint64_t;
constexpr int kBits = 4;
constexpr Modes kFound = 1, kUsual = 2, kOther = 4, kSecond = 8, kOne = 15;
enum Mode : std::uint8_t {
  Distance,
  Plane,
  Units,
  Radius,
  Cycle,
  Length,
  Work,
  Shift,   // of the work coordinates, by G52
  Origin,  // of the work coordinates, by G92
  Rotation,
  Scaling,
  Mirror,
  Polar,
  Feed,
  Surface,
  Macro  // a macro that each move calls
};
constexpr int kModes = Macro + 1;
// Return whether the usual value of a mode is unknown: parameters set it.
constexpr bool has_no_usual(int mode) { return mode == Units || mode == Feed || mode == Surface; }
// Return whether a mode is never off: a caller that chose another value loses it to the usual one.
constexpr bool is_choice(int mode) {
  return has_no_usual(mode) || mode == Distance || mode == Plane;
}
/// Return the values of a mode that count where they are left on.
constexpr Modes counted(int mode) { return kOther | kSecond | (is_choice(mode) ? kUsual : 0); }

constexpr Modes of(int mode, Modes value) { return value << (kBits * mode); }
constexpr Modes all(Modes value) {
  Modes modes = 0;
  for (int mode = 0; mode < kModes; ++mode) modes |= value << (kBits * mode);
  return modes;
}
// The modes that M70 and M73 keep. [LC m-code]
constexpr Modes kKept = of(Distance, kFound) | of(Plane, kFound) | of(Units, kFound) |
                        of(Radius, kFound) | of(Length, kFound) | of(Work, kFound) |
                        of(Feed, kFound) | of(Surface, kFound);
constexpr Modes value(Modes modes, int mode) { return modes >> (kBits * mode) & kOne; }

/// Set a mode. Where it is set only sometimes, the value before it may still be in force.
inline void put(Modes& modes, Modes own, bool sometimes) {
  for (int mode = 0; mode < kModes; ++mode)
    if (value(own, mode) != 0) modes = (sometimes ? modes : modes & ~of(mode, kOne)) | own;
}

/// Return what is in force when a main program begins.
inline Modes at_first() {
  Modes usual = 0;
  for (int mode = 0; mode < kModes; ++mode) usual |= of(mode, has_no_usual(mode) ? kFound : kUsual);
  return usual;
}

/// Return what is in force after a call of a program that leaves `left`.
inline Modes through(Modes modes, Modes left) {
  Modes kept = 0;
  for (int mode = 0; mode < kModes; ++mode)
    if ((value(left, mode) & kFound) != 0) kept |= modes & of(mode, kOne);
  return kept | (left & ~all(kFound));
}

struct Meant {
  Mode mode;
  Modes value;
  Meaning meaning;
};

/// Reads which modes blocks set and switch off.
class ModeReader {
 public:
  explicit ModeReader(const Checker& c) : c_(c), meant_(meant(c.machine != MachineType::Mill)) {}

  /// Return what is in force after a block, without the programs that it calls.
  Modes after(Modes before, Address at) const;
  /// Return whether a program keeps its modes by M73: its return restores them.
  bool keeps(const ProgramFlow& flow) const;
  /// Return the modes that a block sets, as bits.
  std::uint32_t set_at(Address at) const;
  bool moves(Address at) const;
  /// Return whether a search for a move goes on past a block, which does not move itself.
  bool leads_on(Address at) const;
  std::string name(int mode, Modes which) const;

 private:
  static std::vector<Meant> meant(bool lathe);
  Modes set_by(Meaning meaning, Group group) const;
  Modes set_by(int g, const Block& block) const;
  void restore(Modes& modes, const Block& block, bool sometimes) const;

  const Checker& c_;
  std::vector<Meant> meant_;
};

}  // namespace cncsub::modes
