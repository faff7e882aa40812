// Numbers as text, the same on every system and in every language of it.
#pragma once

#include <string>
#include <string_view>

namespace cncsub::system {

/// How a number is written that is read.
enum class Decimal {
  Fixed,    // 12.5
  General,  // 12.5 or 1.25e1
};

struct Parsed {
  bool number = false;     // a number was read, and it is one that a double holds
  std::size_t length = 0;  // characters of it
};

/// The number at the head of a text, as std::from_chars reads it: the nearest double.
Parsed parse(std::string_view text, double& value, Decimal form = Decimal::General);

/// The shortest text that reads as this value again, as std::to_chars writes it.
std::string shortest(double value);
/// The same without an exponent: `0.00000125`.
std::string shortest_fixed(double value);

// What stands in where a library lacks these functions for doubles (libc++ before 20, and what
// macOS brings before 13.3). They are tested wherever they are not needed.
Parsed parse_by_stream(std::string_view text, double& value, Decimal form);
std::string shortest_by_stream(double value);
std::string shortest_fixed_by_stream(double value);

}  // namespace cncsub::system
