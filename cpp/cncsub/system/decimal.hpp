// Numbers as text, the same on every system and in every language of it.
#pragma once

#include <string>
#include <string_view>

namespace cncsub::system {

/// The forms in which a number may be written.
enum class Decimal {
  Fixed,    // 12.5
  General,  // 12.5 or 1.25e1
};

struct Parsed {
  bool number = false;     // a number was read, and it is one that a double holds
  std::size_t length = 0;  // characters that were read
};

/// Read the number at the head of a text, as std::from_chars reads it: the nearest double.
Parsed parse(std::string_view text, double& value, Decimal form = Decimal::General);

/// Return the shortest text that reads as this value again, as std::to_chars writes it.
std::string shortest(double value);
/// Return the same without an exponent: `0.00000125`.
std::string shortest_fixed(double value);

// Substitutes for these functions where a library lacks them for doubles (libc++ before 20, and
// what macOS brings before 13.3). They are tested wherever they are not needed.
Parsed parse_by_stream(std::string_view text, double& value, Decimal form);
std::string shortest_by_stream(double value);
std::string shortest_fixed_by_stream(double value);

}  // namespace cncsub::system
