// Writes blocks for another control: by what the codes of the program mean, in the numbers that the
// control takes, between the words that begin and end a program there.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "cncsub/flat/numbers.hpp"
#include "cncsub/machine/machine.hpp"
#include "cncsub/motion/state/facts.hpp"

namespace cncsub {

inline const MotionFacts& facts_of(const Machine& machine) { return machine.motion().view().facts; }
inline const Control& control_of(const Machine& machine) { return *machine.code().control; }

class OtherWriter {
 public:
  /// `from`: the machine that runs; `to`: one of the other control that has executed nothing. Both
  /// are to outlive this.
  OtherWriter(const Machine& from, const Machine& to);

  /// Return why no program of the one can be one of the other; empty where it can.
  std::string refusal() const;
  /// Return the head of a program of a name, with its line feed; empty where it has none.
  std::string head(const std::string& name) const;
  /// Return the blocks that switch on what is in force at power-on here, and not there.
  std::string modes();
  /// Write the words of a block that has been executed. Return false where they cannot be written:
  /// then `refused` says why.
  bool write(std::string& to, const Block& block, const NcWords& words);
  /// Keep the point from which the block that comes next moves.
  void begin_block();
  /// Return what ends a program; empty where the control has no such code.
  std::string end() const;
  const std::string& refused() const { return refused_; }
  const Machine& machine() const { return to_; }

 private:
  bool refuse(std::string reason);
  int code_of(const GCode& own, bool& idle) const;
  bool put_codes(std::string& to, std::span<const int> codes, bool leaves_line);
  bool leaves_line(const NcWords& words) const;
  bool moves_by_line(const NcWords& words) const;
  bool put_values(std::string& to, const NcWords& words);
  bool put_others(std::string& to, const NcWords& words, std::uint32_t left);
  bool put_m(std::string& to, const NcWords& words, bool ends);
  /// Return the address of a word here, for people.
  bool put_word(std::string& to, int place, double value);
  bool put_dwell(std::string& to, double seconds);
  double value_of(const NcWords& words, int place) const;
  double feed_there(double feed) const;
  bool put_hole_dwell(std::string& to, double seconds);
  bool put_beside_path(std::string& to, const NcWords& words);
  bool put_as_path(std::string& to);
  bool put_modes_again(std::string& to);
  std::string code_text(const GCode& own) const;
  bool put_lent(std::string& to, int place, const NcWords& words);
  bool put_letter(std::string& to, const NcWords& words, char letter);
  bool drills(const NcWords& words) const;
  void put_repeats(std::string& to, char letter, double count) const;

  const Machine &from_, &to_;
  WordWriter words_;
  std::array<GCode, kGroups> at_power_on_;  // what was in force before the first block
  Axes start_{};                            // where the block began that is written
  bool line_is_owed_ = false;               // G01 is in force here, and not yet written there
  std::string refused_;
};

/// Return the words of a block that are all written as numbers.
NcWords constant_words(const Machine& machine, const Block& block);

}  // namespace cncsub
