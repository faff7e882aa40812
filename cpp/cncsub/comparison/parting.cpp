#include "cncsub/comparison/parting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "cncsub/code/references.hpp"
#include "cncsub/comparison/pair.hpp"
#include "cncsub/control/roles.hpp"
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/system/decimal.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr double kNear = 1e-9;
constexpr std::size_t kWatched = 1000;  // variables that can be watched at once

std::string short_text(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

bool has(const Machine& machine, std::int32_t number) {
  double value = 0;
  return !machine.read(number, 0, value);
}

/// Return the value of a variable of the main program; NaN where it is vacant or there is none.
double value_of_main(const Machine& machine, std::int32_t number) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double value = kNone;
  if (machine.read(number, 0, value) || is_vacant(value)) return kNone;
  return value;
}

/// Add the numbers of the variables that blocks write.
void add_written(const Code& code, std::set<std::int32_t>& numbers) {
  for (std::size_t i = 0; i < code.programs.size(); ++i) {
    const Program& program = code.programs[i];
    if (!is_listed(code, program)) continue;
    for (Address at = program.first; at < program.last; ++at)
      for (const VariableReference& use :
           references_of(code, code.blocks[at], static_cast<std::int32_t>(i)).writes)
        if (!use.computed && use.name.empty() && use.number >= 0)
          numbers.insert(static_cast<std::int32_t>(use.number));
  }
}

/// Return how exactly the coarser of two languages reads numbers; 0 where they read the same.
double coarser(const Control& one, const Control& other) {
  const double first = find_dialect(one.dialect)->precision;
  const double second = find_dialect(other.dialect)->precision;
  return first == second ? 0 : std::max(first, second);
}

using Changes = std::vector<Trace::Change>;

/// Return a variable as the programs write it.
std::string variable_name(const Code& code, std::int32_t number) {
  return code.spelling->name_of_variable(*code.control, number);
}

/// Return a change as text, with as many digits as tell it from the one of the other side.
std::string change_text(const Code& code, const Trace::Change& row, const Changes& others,
                        std::size_t at) {
  const bool alike_name = at < others.size() && others[at].variable == row.variable;
  const double beside = alike_name ? others[at].value : row.value;
  return variable_name(code, row.variable) + " = " +
         (is_vacant(row.value) ? "vacant" : texts_of(row.value, beside)[0]);
}

/// Return the values that variables hold at the stop, by their numbers after an edit.
std::map<std::int32_t, double> values_of(const Machine& machine,
                                         const std::map<std::int32_t, std::int32_t>& renumbered) {
  std::map<std::int32_t, double> values;
  for (const auto& [number, value] : machine.variables(0)) {
    const auto other = renumbered.find(number);
    if (!is_vacant(value)) values[other == renumbered.end() ? number : other->second] = value;
  }
  return values;
}

}  // namespace

bool alike(double a, double b, double precision) {
  const double near = kNear + precision * std::max({std::fabs(a), std::fabs(b), 1.0});
  return a == b || std::fabs(a - b) < near || (std::isnan(a) && std::isnan(b));
}

std::array<std::string, 2> texts_of(double a, double b) {
  std::array<std::string, 2> texts = {short_text(a), short_text(b)};
  if (texts[0] == texts[1] && a != b && !std::isnan(a))
    texts = {system::shortest(a), system::shortest(b)};
  return texts;
}

Pair::Pair(Question question, const Sides& sides, InterruptCheck& interrupt, const Renamed& renamed)
    : sides_(sides),
      interrupt_(interrupt),
      renamed_(renamed),
      question_(question),
      asked_(asked(question, code(0).control->dialect == code(1).control->dialect)),
      precision_(coarser(*code(0).control, *code(1).control)) {}

std::optional<Parting> Pair::earliest() {
  // Of two differences in one block the one that is looked for first is told.
  const bool calls_first = !asked_.places;
  if (asked_.calls && calls_first) of_calls();
  if (!of_moves() && asked_.two_controls) of_lengths();
  for (const char kind : {'M', 'T'}) of_codes(kind);
  of_messages();
  of_times();
  if (asked_.variables) renamed_.variables.empty() ? of_variables() : of_renumbered_variables();
  if (asked_.calls && !calls_first) of_calls();
  if (asked_.steps) of_steps();
  of_stop();
  const auto place = [](const Parting& p) {
    return std::tuple(std::min(p.first, p.second), p.first, p.second);
  };
  const auto first =
      std::min_element(found_.begin(), found_.end(),
                       [&](const Parting& a, const Parting& b) { return place(a) < place(b); });
  return first == found_.end() ? std::nullopt : std::optional(*first);
}

// ---- words ----

void Pair::say(const Steps& at, const Does& does, const std::string& column) {
  std::string what;
  for (std::size_t side = 0; side < 2; ++side)
    what +=
        (side == 0 ? "" : "\n") + sides_[side].name + ": " + side_text(side, at[side], does[side]);
  found_.push_back({at[0], at[1], std::move(what), column});
}

/// Return what a run does at a step, or that it has stopped without doing it.
std::string Pair::side_text(std::size_t side, std::int64_t at, const std::string& does) const {
  if (at >= steps(side)) {
    const std::string stopped = summary(*sides_[side].run);
    if (does.empty()) return "stopped: " + stopped;
    return does + " until " + (stopped == "end" ? "the end" : stopped);
  }
  const Address address = trace(side).steps[static_cast<std::size_t>(at)].address;
  const Block& block = code(side).blocks[address];
  const std::string n = block.n < 0 ? "" : " N" + std::to_string(block.n);
  return code(side).name_of(code(side).program_at(address)) + n + ", line " +
         std::to_string(block.line) + (does.empty() ? "" : ": ") + does;
}

std::string summary(const Machine& run) {
  const auto& alarm = run.alarm();
  if (!alarm) return std::string(to_string(run.stop()));
  const std::string n = alarm->n < 0 ? "" : " N" + std::to_string(alarm->n);
  const std::string number = alarm->number.empty() ? "" : alarm->number + " ";
  return "alarm " + number + std::string(info(alarm->cause).slug) + " at " + alarm->program + n;
}

// ---- codes and messages ----

/// Return the codes of a kind that were sent. Two controls differ in which M codes that end a
/// program they send: the stop is compared instead.
std::vector<Trace::Sent> Pair::sent(std::size_t side, char kind) const {
  const auto& codes = trace(side).codes;
  const Roles& roles = code(side).control->calls.roles.value;
  std::vector<Trace::Sent> all;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (codes[i].kind != kind) continue;
    const bool ends = kind == 'M' && roles.of_m(static_cast<int>(codes[i].value)) == Role::End;
    if (!asked_.two_controls || !ends) all.push_back(codes[i]);
  }
  return all;
}

void Pair::of_codes(char kind) {
  const std::array<std::vector<Trace::Sent>, 2> lists{sent(0, kind), sent(1, kind)};
  std::size_t at = 0;
  const std::size_t count = std::min(lists[0].size(), lists[1].size());
  while (at < count && lists[0][at].value == lists[1][at].value) ++at;
  if (at == lists[0].size() && at == lists[1].size()) return;
  Steps where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    const bool there = at < lists[side].size();
    where[side] = there ? lists[side][at].step : steps(side);
    does[side] = there ? kind + system::shortest(lists[side][at].value)
                       : "no further " + std::string(1, kind) + " code";
  }
  say(where, does);
}

/// Return the step that said a message. Messages do not know it: shorter and shorter runs find it.
std::int64_t Pair::step_of_message(std::size_t side, std::size_t at) const {
  std::int64_t low = 0, high = steps(side);
  while (low < high) {
    const std::int64_t middle = low + (high - low) / 2;
    const Ran shorter = sides_[side].again(middle + 1, {});
    if (shorter && shorter->trace().messages.size() > at)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

void Pair::of_messages() {
  const auto& a = trace(0).messages;
  const auto& b = trace(1).messages;
  std::size_t at = 0;
  while (at < std::min(a.size(), b.size()) && a[at] == b[at]) ++at;
  if (at == a.size() && at == b.size()) return;
  Steps where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& said = trace(side).messages;
    const bool there = at < said.size();
    where[side] = there ? step_of_message(side, at) : steps(side);
    const char* const quote = there && said[at].find('\'') != std::string::npos ? "\"" : "'";
    does[side] = there ? "message " + (quote + said[at] + quote) : "no further message";
  }
  say(where, does);
}

// ---- variables ----

std::vector<std::int32_t> shared_variables(const Machine& one, const Machine& other) {
  const std::array<const Machine*, 2> runs = {&one, &other};
  std::set<std::int32_t> held;
  for (const Machine* run : runs)
    for (const auto& [number, value] : run->variables(0))
      if (!is_vacant(value)) held.insert(number);
  const auto both = [&](std::int32_t n) { return has(one, n) && has(other, n); };
  if (!std::all_of(held.begin(), held.end(), both))
    for (const Machine* run : runs) add_written(run->code(), held);
  std::vector<std::int32_t> shared;
  std::copy_if(held.begin(), held.end(), std::back_inserter(shared), both);
  return shared;
}

std::vector<std::int32_t> Pair::variables_apart() const {
  const Machine &one = *sides_[0].run, &other = *sides_[1].run;
  std::vector<std::int32_t> apart;
  for (const std::int32_t number : shared_variables(one, other))
    if (!alike(value_of_main(one, number), value_of_main(other, number), precision_))
      apart.push_back(number);
  apart.resize(std::min(apart.size(), kWatched));
  return apart;
}

void Pair::of_variables() {
  const std::vector<std::int32_t> apart = variables_apart();
  if (apart.empty()) return;
  std::array<Changes, 2> rows;
  for (std::size_t side = 0; side < 2; ++side) {
    const Ran watched = sides_[side].again(kAnyBlocks, apart);
    if (!watched) return;
    const auto& changes = watched->trace().changes;
    for (std::size_t i = 0; i < changes.size(); ++i) rows[side].push_back(changes[i]);
  }
  std::size_t at = 0;
  const std::size_t count = std::min(rows[0].size(), rows[1].size());
  while (at < count && rows[0][at].variable == rows[1][at].variable &&
         alike(rows[0][at].value, rows[1][at].value, precision_))
    ++at;
  if (at == rows[0].size() && at == rows[1].size()) at = 0;  // the values at the beginning differ
  Steps where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    const bool there = at < rows[side].size();
    where[side] = there && rows[side][at].step >= 0 ? rows[side][at].step : steps(side);
    does[side] =
        there ? change_text(code(side), rows[side][at], rows[1 - side], at) : "no further change";
  }
  say(where, does);
}

/// Compare the variables of programs in which they have other numbers: by their values at the stop.
void Pair::of_renumbered_variables() {
  const std::map<std::int32_t, double> before = values_of(*sides_[0].run, renamed_.variables);
  const std::map<std::int32_t, double> after = values_of(*sides_[1].run, {});
  const auto value = [](const auto& values, std::int32_t number) {
    const auto found = values.find(number);
    return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  };
  std::set<std::int32_t> numbers;
  for (const auto* values : {&before, &after})
    for (const auto& [number, held] : *values) numbers.insert(number);
  for (const std::int32_t number : numbers) {
    if (alike(value(before, number), value(after, number), precision_)) continue;
    say({steps(0), steps(1)}, {"", variable_name(code(1), number) + " is another value"});
    return;
  }
}

// ---- calls, blocks and the stop ----

/// Return the name of a program before an edit, in capitals: languages do not tell them apart.
std::string Pair::called(std::size_t side, const std::string& name) const {
  if (question_ != Question::Edited) return name;
  const auto old = side == 0 ? renamed_.programs.end() : renamed_.programs.find(name);
  return capitals(old == renamed_.programs.end() ? name : old->second);
}

/// Return what a program is compared by. Its file and its last line are the same whatever a control
/// calls the program.
std::string Pair::program(std::size_t side, std::int32_t number) const {
  const Program& of = code(side).programs[static_cast<std::size_t>(number)];
  if (!asked_.places || of.first >= of.last) return called(side, code(side).name_of(of));
  return code(side).files[of.file].name + ":" + std::to_string(code(side).blocks[of.last - 1].line);
}

void Pair::of_calls() {
  const auto &a = trace(0).calls, &b = trace(1).calls;
  const auto same = [&](const CallRow& one, const CallRow& other) {
    return one.kind == other.kind && (!asked_.starts || one.start_n == other.start_n) &&
           one.repeats == other.repeats && (!asked_.levels || one.level == other.level) &&
           program(0, one.program) == program(1, other.program);
  };
  std::size_t at = 0;
  while (at < std::min(a.size(), b.size()) && same(a[at], b[at])) ++at;
  if (at == a.size() && at == b.size()) return;
  Steps where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    where[side] = steps(side);
    does[side] = "no further call";
    if (at >= trace(side).calls.size()) continue;
    const CallRow& row = trace(side).calls[at];
    where[side] = row.caller_step;
    does[side] = std::string(to_string(row.kind)) + " " + code(side).name_of(row.program) +
                 (row.start_n < 0 ? "" : " from N" + std::to_string(row.start_n)) + ", " +
                 std::to_string(row.repeats) + (row.repeats == 1 ? " pass" : " passes");
  }
  say(where, does);
}

void Pair::of_steps() {
  const auto &a = trace(0).steps, &b = trace(1).steps;
  const auto place = [&](std::size_t side, const Trace::Step& step) {
    const Code& of = code(side);
    const Program& program = of.programs[static_cast<std::size_t>(of.program_at(step.address))];
    return std::pair(std::string_view(of.files[program.file].name), of.blocks[step.address].line);
  };
  std::size_t at = 0;
  while (at < std::min(a.size(), b.size()) && place(0, a[at]) == place(1, b[at])) ++at;
  if (at == a.size() && at == b.size()) return;
  say({static_cast<std::int64_t>(at), static_cast<std::int64_t>(at)}, {});
}

bool Pair::is_same_alarm(const Alarm& one, const Alarm& other) const {
  if (one.cause != other.cause) return false;
  switch (asked_.alarm) {
    case AlarmPart::Cause:
      return true;
    case AlarmPart::Number:
      return one.number == other.number;
    case AlarmPart::Program:
      return one.n == other.n && one.program == other.program;
    case AlarmPart::Line:
      return one.n == other.n && one.line == other.line && one.file == other.file;
    case AlarmPart::Edited:
      return one.line == other.line && called(0, one.program) == called(1, other.program);
  }
  return false;
}

bool Pair::is_same_stop() const {
  const Machine &one = *sides_[0].run, &other = *sides_[1].run;
  if (one.stop() != other.stop()) return false;
  // What a run waits for may name a variable.
  if (renamed_.variables.empty() && one.state().waiting_for != other.state().waiting_for)
    return false;
  if (asked_.alarm == AlarmPart::Edited && steps(0) != steps(1)) return false;
  const auto &a = one.alarm(), &b = other.alarm();
  return a.has_value() == b.has_value() && (!a || is_same_alarm(*a, *b));
}

void Pair::of_stop() {
  if (!is_same_stop()) say({steps(0), steps(1)}, {});
}

std::optional<Parting> parting_of(Question question, const Sides& sides, InterruptCheck& interrupt,
                                  const Renamed& renamed) {
  return Pair(question, sides, interrupt, renamed).earliest();
}

}  // namespace cncsub
