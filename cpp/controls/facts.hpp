// The controls of each maker, in listing order.
#pragma once

#include <vector>

#include "cncsub/control.hpp"

namespace cncsub {

std::vector<Control> gsk_controls();
std::vector<Control> mitsubishi_controls();
std::vector<Control> fanuc_controls();
std::vector<Control> hnc_controls();

/// A row of an alarm list: a number and its text as printed, and the causes that show it.
struct ListedAlarm {
  enum class Row : std::uint8_t { Listed, Assumed, Meant, Directed } row = Row::Listed;
  const char* number = "";
  const char* text = "";
  std::vector<Cause> causes;
  const char* direction = "";
};

const std::vector<ListedAlarm>& fanuc_16i_alarms();
const std::vector<ListedAlarm>& fanuc_30i_alarms();

/// Gives a control the alarms of a list. Without a key of a source the list is from memory, and no
/// text of it is printed anywhere.
void take_list(Control& control, const std::vector<ListedAlarm>& list, const std::string& key,
               const std::string& memory);

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
