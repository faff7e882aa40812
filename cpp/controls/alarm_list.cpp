// Alarm lists as data, one for each that is printed.
#include "controls/facts.hpp"

namespace cncsub {

#define LISTED(number, text, ...) {Row::Listed, number, text, {__VA_ARGS__}, ""},
#define ASSUMED(number, ...) {Row::Assumed, number, "", {__VA_ARGS__}, ""},
#define MEANT(number, text, ...) {Row::Meant, number, text, {__VA_ARGS__}, ""},
#define DIRECTED(number, text, cause, direction) {Row::Directed, number, text, {cause}, direction},

const std::vector<ListedAlarm>& fanuc_16i_alarms() {
  using enum Cause;
  using Row = ListedAlarm::Row;
  static const std::vector<ListedAlarm> list = {
#include "controls/fanuc/alarms_16i.def"
  };
  return list;
}

const std::vector<ListedAlarm>& fanuc_30i_alarms() {
  using enum Cause;
  using Row = ListedAlarm::Row;
  static const std::vector<ListedAlarm> list = {
#include "controls/fanuc/alarms_30i.def"
  };
  return list;
}

#undef LISTED
#undef ASSUMED
#undef MEANT
#undef DIRECTED

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
