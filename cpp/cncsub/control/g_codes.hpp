// The meanings of G codes on a machine: the tables of mills and lathes, and what a control changes
// in them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/control.hpp"

namespace cncsub {

/// Return whether no path depends on a code. G11 ends data, which alarms where none were begun.
inline bool is_neutral(Meaning meaning) {
  return meaning == Meaning::Neutral || meaning == Meaning::DataEnd ||
         meaning == Meaning::LookAheadLimit;
}

/// Return whether a code roughs, finishes, pecks or threads along a profile or in many passes: a
/// lathe's G70 to G76.
inline bool is_multiple_cycle(Meaning meaning) {
  switch (meaning) {
    case Meaning::Finish:
    case Meaning::RoughTurn:
    case Meaning::RoughFace:
    case Meaning::RoughPattern:
    case Meaning::PeckFace:
    case Meaning::PeckTurn:
    case Meaning::MultipleThread:
      return true;
    default:
      return false;
  }
}

/// Return "G54.1" for 541, and the word of a code that is written as one.
std::string code_name(int code);

/// Return the kind of machine of a name such as "lathe-a"; the control's own where it is none.
MachineType machine_of(const Control& control, const std::string& name);

class GCodes {
 public:
  GCodes(const Control& control, MachineType machine);
  /// Return the meaning of a code times ten: None where the machine does not have it, Neutral where
  /// no path depends on it, Uncomputed where the engine does not know its moves, Unknown where no
  /// source says whether the control has it.
  GCode find(int code) const {
    const std::size_t place =
        code >= 0 && code < kCodes ? places_[static_cast<std::size_t>(code)] : 0;
    return place == 0 ? GCode{-1, Group::OneShot, unlisted_} : codes_[place - 1];
  }
  /// Return the code of a meaning as this machine writes it; code -1 where it has none.
  GCode of(Meaning meaning) const;
  /// Return the code of a meaning and a variant of it; code -1 where the machine has none.
  GCode of(Meaning meaning, std::int16_t variant) const;

 private:
  void set(GCode entry);
  void keep(const Codes& list, bool complete);
  void name_systems(const Control& control);

  static constexpr int kCodes = 10001;  // ten times the largest, and one

  std::vector<GCode> codes_;
  std::vector<std::uint16_t> places_;  // of a code there, from 1
  Meaning unlisted_ = Meaning::Unknown;
};

}  // namespace cncsub
