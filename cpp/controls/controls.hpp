// The controls of each maker, in listing order.
#pragma once

#include <vector>

#include "cncsub/control.hpp"

namespace cncsub {

std::vector<Control> gsk_controls();
std::vector<Control> mitsubishi_controls();
std::vector<Control> fanuc_controls();
std::vector<Control> hnc_controls();

/// Give a maker's controls their motion rules, parameters and alarms.
void add_gsk_motion(std::vector<Control>& controls);
void add_mitsubishi_motion(std::vector<Control>& controls);
void add_fanuc_motion(std::vector<Control>& controls);
void add_hnc_motion(std::vector<Control>& controls);

/// The number of a modal word among #4101 to #4120: B, M, N, O, S and T by the alphabet, D, E, F
/// and H as the locals of a macro's arguments. All makers of the family share it. [M7 printed
/// p.331; TDi28 3.28.1.3, F to T; REG]
inline std::int32_t modal_word_number(char address) {
  switch (address) {
    case 'D':
      return 4107;
    case 'E':
      return 4108;
    case 'F':
      return 4109;
    case 'H':
      return 4111;
    default:
      return 4101 + (address - 'A');
  }
}

}  // namespace cncsub
