#include "controls/alarm_list.hpp"

namespace cncsub {
namespace {

/// The number as the list prints it: PS0078 is 0078.
std::string bare(const std::string& number) {
  return number.substr(std::min(number.find_first_of("0123456789"), number.size()));
}

}  // namespace

void take_list(Control& control, const std::vector<ListedAlarm>& list, const std::string& key,
               const std::string& memory) {
  using enum ListedAlarm::Row;
  const auto text_of = [&list](const char* number) -> std::string {
    for (const ListedAlarm& row : list)
      if (row.row == Listed && std::string_view(row.number) == number) return row.text;
    return "";
  };
  const bool printed = !key.empty();
  for (const ListedAlarm& row : list) {
    const std::string at = printed ? key + " " + bare(row.number) : memory;
    for (const Cause cause : row.causes) {
      AlarmEntry& entry = control.alarms[cause];
      if (row.row == Listed)
        entry = {row.number, row.text, at, printed ? Evidence::Secondary : Evidence::Inferred,
                 printed};
      else if (row.row == Assumed)
        entry = {row.number, text_of(row.number),
                 at + " has the number; that it is raised here is inferred", Evidence::Inferred,
                 printed};
      else if (row.row == Meant)
        entry = {row.number, row.text, memory, Evidence::Inferred};
      else
        entry = {"", "", memory, Evidence::Inferred, false, std::move(entry.directed)};
      if (row.row == Directed) entry.directed.push_back({row.direction, row.number, row.text});
    }
  }
}

}  // namespace cncsub
