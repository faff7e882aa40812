#include "controls/alarm_list.hpp"

#include <algorithm>

namespace cncsub {
namespace {

using Row = ListedAlarm::Row;

/// Return the number as the list prints it: PS0078 is 0078.
std::string bare(const std::string& number) {
  return number.substr(std::min(number.find_first_of("0123456789"), number.size()));
}

std::string text_of(const AlarmList& list, const char* number) {
  for (const ListedAlarm& row : list.rows)
    if (row.row == Row::Listed && std::string_view(row.number) == number) return row.text;
  return "";
}

/// Return the source of numbers by direction: those of the list from the first to the last, or
/// memory.
std::string directed_source(const AlarmList& list) {
  if (!list.memory.empty()) return list.memory;
  std::string first, last;
  for (const ListedAlarm& row : list.rows) {
    if (row.row != Row::Directed) continue;
    if (first.empty()) first = bare(row.number);
    last = bare(row.number);
  }
  return list.key + " " + first + " to " + last;
}

AlarmEntry entry_of(const AlarmList& list, const ListedAlarm& row) {
  const std::string at = list.key.empty() ? list.memory : list.key + " " + bare(row.number);
  switch (row.row) {
    case Row::Listed:
      return {row.number, row.text, at, list.evidence, list.printed};
    case Row::Assumed:
      return {row.number, text_of(list, row.number),
              at + " has the number; that it is raised here is inferred", Evidence::Inferred,
              list.printed};
    case Row::Meant:
      return {row.number, row.text, list.memory, Evidence::Inferred};
    case Row::Directed:
      return {"", "", directed_source(list),
              list.memory.empty() ? list.evidence : Evidence::Inferred};
    case Row::From:
      return {row.number, row.text, row.source, row.evidence};
  }
  return {};
}

constexpr Refusals kRefusals = {
#define REFUSAL(cause, example) Cause::cause,
#include "cncsub/control/refusals.def"
#undef REFUSAL
};

}  // namespace

namespace {

/// Causes of values, which a list has a number for whatever else a control refuses by them.
constexpr Refusals kOfValues{Cause::FeedOutOfRange, Cause::ValueOutOfRange};

}  // namespace

void refuse_listed(Control& control, const AlarmList& list, const Refusals& besides) {
  for (const ListedAlarm& row : list.rows) {
    if (row.row != Row::Listed && row.row != Row::Directed) continue;
    for (const Cause cause : row.causes)
      if (kRefusals.has(cause) && !kOfValues.has(cause) && !besides.has(cause))
        has(control.common.refuses, {cause}, list.key + " " + bare(row.number), list.evidence);
  }
}

void take_list(Control& control, const AlarmList& list,
               std::initializer_list<std::string_view> only) {
  for (const ListedAlarm& row : list.rows) {
    if (only.size() != 0 && std::find(only.begin(), only.end(), row.number) == only.end()) continue;
    for (const Cause cause : row.causes) {
      AlarmEntry& entry = control.alarms[cause];
      const bool directed = row.row == Row::Directed;
      if (!directed || entry.number.empty()) {
        std::vector<DirectedNumber> own = std::move(entry.directed);
        entry = entry_of(list, row);
        if (directed) entry.directed = std::move(own);
      }
      if (directed) entry.directed.push_back({row.direction, row.number, row.text});
    }
  }
}

}  // namespace cncsub
