// The fault of a block, and the alarm that it becomes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "cncsub/control/alarm.hpp"

namespace cncsub {

using Address = std::uint32_t;
constexpr Address kNowhere = 0xffffffff;

/// The word of its block that a fault is about: the first that has one of these names. Where none
/// of them is written there, it is the code by which the block acts, or else what that moves.
struct WordName {
  std::uint32_t addresses = 0;  // a bit each
  std::uint32_t groups = 0;     // of G codes, a bit each
  int code = -1;                // a G code, ten times its number

  bool any() const { return addresses != 0 || groups != 0 || code >= 0; }
};

/// The fault of a block, with its place in the file.
struct Fault {
  Cause cause{};
  std::uint32_t at = 0;     // byte offset in the file's text
  std::uint32_t width = 1;  // bytes; 0 = the name, number or sign that stands there
  std::string detail;
  Address block = kNowhere;  // the block it stands in; otherwise the one that is being executed
  // "X+", "LA" of a line and the arc after it, or "EX" of a call of the external device, where the
  // control may have a number for each
  std::array<char, 2> kind{};
  WordName word = {};     // that is wrong, where `at` does not say it
  std::string text = {};  // the control's own words, where they name what is wrong
  std::string name = {};  // of a variable, or numbers, for the control's words
};

struct Code;

/// Return the alarm of a fault in this block; the caller adds the frames.
Alarm alarm_of(const Code& code, Address address, const Fault& fault);

}  // namespace cncsub
