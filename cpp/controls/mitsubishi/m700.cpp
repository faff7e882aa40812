// Mitsubishi M700, M70, E70, C70.
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

using namespace mitsubishi;

/// The format of its words is printed.
Control mitsubishi_m700() {
  Control c = family();
  c.reading.max_program_number = {99999999, "M7 p.23: O and eight digits", Manual};
  c.reading.max_sequence_number = {999999, "M7 p.23: N and six digits", Manual};
  c.calls.max_program_digits = {8, "M7 p.23: P and eight digits", Manual};
  c.calls.max_repeats = {9999, "M7 p.23: L and four digits", Manual};
  c.title = "Mitsubishi M700, M70, E70, C70";
  return c;
}

}  // namespace cncsub
