// The fault of a block, and the alarm that it becomes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "cncsub/control/alarm.hpp"

namespace cncsub {

using Address = std::uint32_t;
constexpr Address kNowhere = 0xffffffff;

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
  char address = 0;       // of the word that is wrong, where `at` does not say it
  int code = -1;          // or that G code, ten times its number
  std::string text = {};  // the control's own words, where they name what is wrong
  std::string name = {};  // of a variable, or numbers, for the control's words
};

struct Code;

/// Return the alarm of a fault in this block; the caller adds the frames.
Alarm alarm_of(const Code& code, Address address, const Fault& fault);

}  // namespace cncsub
