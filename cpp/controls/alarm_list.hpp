// Alarm lists as data. Each printed list has a file alarms_<list>.def beside its control.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/control.hpp"

namespace cncsub {

/// A row of an alarm list: a number and its text, and the causes that show it.
struct ListedAlarm {
  enum class Row : std::uint8_t { Listed, Assumed, Meant, Directed, From } row = Row::Listed;
  const char* number = "";
  const char* text = "";
  std::vector<Cause> causes;
  const char* direction = "";  // of a Directed row
  const char* source = "";     // of a From row, and its evidence
  Evidence evidence = Evidence::Inferred;
};

struct AlarmList {
  std::string key;     // of sources.def; empty where no list was found and the rows are from memory
  Evidence evidence;   // of what the list has
  bool printed;        // the texts are the list's own words, not ours
  std::string memory;  // the source of what it has not; empty where it has everything
  std::vector<ListedAlarm> rows;
};

// The rows of a file, between braces where the enumerators of Cause are in use:
//   a number, its text, the causes that the list's words cover;
//   a number of the list, causes that show it too, as far as is known;
//   a number whose text the list has wrong: it repeats a neighbour's; the text is from memory;
//   one number a direction of an axis ("X+", or "-" of any), or a kind of two moves ("LA"), after
//   the row of the others; a number with a source of its own.
#define LISTED(number, text, ...) {ListedAlarm::Row::Listed, number, text, {__VA_ARGS__}},
#define ASSUMED(number, ...) {ListedAlarm::Row::Assumed, number, "", {__VA_ARGS__}},
#define MEANT(number, text, ...) {ListedAlarm::Row::Meant, number, text, {__VA_ARGS__}},
#define DIRECTED(number, text, cause, direction) \
  {ListedAlarm::Row::Directed, number, text, {cause}, direction},
#define FROM(number, text, source, evidence, ...) \
  {ListedAlarm::Row::From, number, text, {__VA_ARGS__}, "", source, Evidence::evidence},

/// Give a control the alarms of a list, or only those of some numbers.
void take_list(Control& control, const AlarmList& list,
               std::initializer_list<std::string_view> only = {});

/// Make a control refuse what its printed list has a number for and others run, each by that
/// number; `besides` are causes of the list that other rules decide.
void refuse_listed(Control& control, const AlarmList& list, const Refusals& besides = {});

}  // namespace cncsub
