// Alarm lists as data, one for each that is printed: a file of rows for each.
#pragma once

#include <string>
#include <vector>

#include "cncsub/control.hpp"

namespace cncsub {

/// A row of an alarm list: a number and its text as printed, and the causes that show it.
struct ListedAlarm {
  enum class Row : std::uint8_t { Listed, Assumed, Meant, Directed } row = Row::Listed;
  const char* number = "";
  const char* text = "";
  std::vector<Cause> causes;
  const char* direction = "";
};

// The rows of a file alarms_<list>.def, between braces where Cause's enumerators are in use.
#define LISTED(number, text, ...) {ListedAlarm::Row::Listed, number, text, {__VA_ARGS__}, ""},
#define ASSUMED(number, ...) {ListedAlarm::Row::Assumed, number, "", {__VA_ARGS__}, ""},
#define MEANT(number, text, ...) {ListedAlarm::Row::Meant, number, text, {__VA_ARGS__}, ""},
#define DIRECTED(number, text, cause, direction) \
  {ListedAlarm::Row::Directed, number, text, {cause}, direction},

/// Gives a control the alarms of a list. Without a key of a source the list is from memory, and no
/// text of it is printed anywhere.
void take_list(Control& control, const std::vector<ListedAlarm>& list, const std::string& key,
               const std::string& memory);

}  // namespace cncsub
