// Writes values so that the control reads them back as the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/machine/machine.hpp"

namespace cncsub {

/// A number with the fewest digits that give it back, without an exponent: in any language that has
/// 64 bits, or in this one.
class NumberText {
 public:
  explicit NumberText(double value);
  NumberText(double value, const Spelling& language);
  std::string_view text() const { return text_; }
  std::size_t whole() const { return whole_; }
  std::size_t decimals() const {
    return text_.size() == end_of_whole_ ? 0 : text_.size() - end_of_whole_ - 1;
  }

 private:
  explicit NumberText(double value, std::string text);

  std::string text_;
  std::size_t end_of_whole_ = 0, whole_ = 0;
};

/// Return a value as an expression has it, where a number has so many digits at most: a value with
/// more is a sum, `1.6666666+0.0000000666`.
std::string expression_text(double value, int most_digits);
/// Return the same by the rule of a control or its language.
std::string expression_text(double value, const Code& code);

/// Return the value that an assignment has of a variable: a number, or the vacant one.
std::string value_text(double value, const Code& code);

/// Writes words by the rules of a control. A value is written as a plain number where the control
/// takes that for the same; where it would not (a value between two increments where it does not
/// round, a sign or a point that the address takes from a variable only) as a value in brackets.
class WordWriter {
 public:
  explicit WordWriter(const Machine& machine) : WordWriter(machine, machine) {}
  /// Write the words of a run of `machine` by the rules of the control of `to`.
  WordWriter(const Machine& machine, const Machine& to);

  /// Begin the words of a block with these codes, which has been executed.
  void begin(const BlockCodes& codes);
  /// Write a computed word, `place` as in a mask; return false where the control cannot write it.
  bool computed(std::string& to, int place, double value) const;
  /// Write the value of a word that stands in brackets of its own, as in AC(21).
  void value(std::string& to, int place, double value) const;
  /// Write a word that was written as a number, with a point or, `whole`, without.
  bool constant(std::string& to, int place, double value, bool whole) const;
  /// Write a computed code: in brackets where it would call or end as a plain number.
  bool code(std::string& to, char letter, int tenfold) const;
  /// Return whether a code calls a program where it is written as a number.
  bool calls(char letter, double code) const;
  /// Write a value in brackets in any case.
  bool bracketed(std::string& to, std::string_view address, double value) const;

 private:
  bool rounds(char letter) const;
  bool round(int place, double& value) const;
  bool takes(char letter, bool comma, double value, const NumberText& text, bool rounded) const;
  bool points(char letter, const NumberText& text) const;
  bool counts_increments(char letter, double value) const;

  const Machine& machine_;
  const Code& code_;  // an empty one where the control is another one than the machine's
  const Control& control_;
  bool lathe_;
  bool rounds_;  // one of the two controls brings computed lengths to its least increment
  bool increments_;
  bool mills_axes_;                                     // A and C are axes and nothing else
  std::vector<std::pair<char, std::int64_t>> calling_;  // tenths, sorted; -1: all of the letter
  bool dwell_ = false;
  bool plain_ = false;  // axis words are lengths
  bool arc_ = false, cycle_ = false;
};

}  // namespace cncsub
