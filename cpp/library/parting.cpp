#include "parting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "cncsub/code/references.hpp"
#include "cncsub/control/roles.hpp"
#include "pair.hpp"

namespace cncsub::api {

namespace {

bool has(const cncsub::Machine& machine, std::int32_t number) {
  double value = 0;
  return !machine.read(number, 0, value);
}

double value_of_main(const cncsub::Machine& machine, std::int32_t number) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (machine.read(number, 0, value)) return std::numeric_limits<double>::quiet_NaN();
  return is_vacant(value) ? std::numeric_limits<double>::quiet_NaN() : value;
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

}  // namespace

std::optional<Parting> Pair::earliest() {
  if (!of_moves()) of_lengths();
  for (const char kind : {'M', 'T'}) of_codes(kind);
  of_messages();
  of_dwells();
  of_variables();
  if (sides_[0].code->control->dialect == sides_[1].code->control->dialect) {
    of_calls();
    of_steps();
  }
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

void Pair::say(std::array<std::int64_t, 2> at, const Does& does) {
  std::string what;
  for (std::size_t side = 0; side < 2; ++side)
    what +=
        (side == 0 ? "" : "\n") + sides_[side].name + ": " + side_text(side, at[side], does[side]);
  found_.push_back({at[0], at[1], what});
}

std::string Pair::side_text(std::size_t side, std::int64_t at, const std::string& does) const {
  if (static_cast<std::size_t>(at) >= steps(side)) {
    const std::string stopped = summary(side);
    if (does.empty()) return "stopped: " + stopped;
    return does + " until " + (stopped == "end" ? "the end" : stopped);
  }
  const Place place =
      place_of(*sides_[side].code, trace(side).steps[static_cast<std::size_t>(at)].address);
  const std::string n = place.n ? " N" + std::to_string(*place.n) : "";
  return place.program + n + ", line " + std::to_string(place.line) + (does.empty() ? "" : ": ") +
         does;
}

std::string Pair::summary(std::size_t side) const {
  const auto& alarm = runs_[side]->alarm();
  if (!alarm) return std::string(to_string(stop_of(runs_[side]->stop())));
  const std::string n = alarm->n < 0 ? "" : " N" + std::to_string(alarm->n);
  const std::string number = alarm->number.empty() ? "" : alarm->number + " ";
  return "alarm " + number + std::string(info(alarm->cause).slug) + " at " + alarm->program + n;
}

// ---- codes and messages ----

/// Return the codes of a kind that were sent, without the M codes that end a program: the stop is
/// compared, and controls differ in which of these they send.
std::vector<Trace::Sent> Pair::sent(std::size_t side, char kind) const {
  const auto& codes = trace(side).codes;
  const Roles& roles = sides_[side].code->control->calls.roles.value;
  std::vector<Trace::Sent> all;
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (codes[i].kind == kind &&
        (kind != 'M' || roles.of_m(static_cast<int>(codes[i].value)) != Role::End))
      all.push_back(codes[i]);
  return all;
}

void Pair::of_codes(char kind) {
  const std::array<std::vector<Trace::Sent>, 2> lists{sent(0, kind), sent(1, kind)};
  std::size_t at = 0;
  const std::size_t count = std::min(lists[0].size(), lists[1].size());
  while (at < count && lists[0][at].value == lists[1][at].value) ++at;
  if (at == lists[0].size() && at == lists[1].size()) return;
  std::array<std::int64_t, 2> where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    const bool there = at < lists[side].size();
    where[side] = there ? lists[side][at].step : static_cast<std::int64_t>(steps(side));
    does[side] = there ? kind + short_text(lists[side][at].value)
                       : "no further " + std::string(1, kind) + " code";
  }
  say(where, does);
}

void Pair::of_messages() {
  const auto& a = trace(0).messages;
  const auto& b = trace(1).messages;
  std::size_t at = 0;
  while (at < std::min(a.size(), b.size()) && a[at] == b[at]) ++at;
  if (at == a.size() && at == b.size()) return;
  std::array<std::int64_t, 2> where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& said = trace(side).messages;
    where[side] = static_cast<std::int64_t>(steps(side));
    does[side] = "no further message";
    if (at >= said.size()) continue;
    does[side] = "message '" + said[at] + "'";
    // Messages do not know their step: shorter and shorter runs find it.
    std::int64_t low = 0, high = where[side];
    while (low < high) {
      const std::int64_t middle = (low + high) / 2;
      const auto shorter = run_(sides_[side], middle + 1, {});
      if (shorter && shorter->trace().messages.size() > at)
        high = middle;
      else
        low = middle + 1;
    }
    where[side] = low;
  }
  say(where, does);
}

// ---- variables ----

std::vector<std::int32_t> Pair::shared_variables() const {
  std::set<std::int32_t> held;
  for (const cncsub::Machine* run : runs_)
    for (const auto& [number, value] : run->variables(0))
      if (!is_vacant(value)) held.insert(number);
  const auto both = [&](std::int32_t n) { return has(*runs_[0], n) && has(*runs_[1], n); };
  if (!std::all_of(held.begin(), held.end(), both))
    for (const Side& side : sides_) add_written(*side.code, held);
  std::vector<std::int32_t> shared;
  std::copy_if(held.begin(), held.end(), std::back_inserter(shared), both);
  return shared;
}

void Pair::of_variables() {
  std::vector<std::int32_t> apart;
  for (const std::int32_t number : shared_variables())
    if (!alike(value_of_main(*runs_[0], number), value_of_main(*runs_[1], number)))
      apart.push_back(number);
  if (apart.empty()) return;
  apart.resize(std::min(apart.size(), kWatched));
  std::array<std::vector<Trace::Change>, 2> rows;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto watched = run_(sides_[side], sides_[side].options.max_blocks, apart);
    if (!watched) return;
    const auto& changes = watched->trace().changes;
    for (std::size_t i = 0; i < changes.size(); ++i) rows[side].push_back(changes[i]);
  }
  std::size_t at = 0;
  const std::size_t count = std::min(rows[0].size(), rows[1].size());
  while (at < count && rows[0][at].variable == rows[1][at].variable &&
         alike(rows[0][at].value, rows[1][at].value))
    ++at;
  if (at == rows[0].size() && at == rows[1].size()) at = 0;  // the values at the beginning differ
  std::array<std::int64_t, 2> where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    where[side] = static_cast<std::int64_t>(steps(side));
    does[side] = "no further change";
    if (at >= rows[side].size()) continue;
    const Trace::Change& row = rows[side][at];
    if (row.step >= 0) where[side] = row.step;
    does[side] = "#" + std::to_string(row.variable) + " = " +
                 (is_vacant(row.value) ? "vacant" : short_text(row.value));
  }
  say(where, does);
}

// ---- calls, blocks and the stop ----

/// Return what a program is compared by: its file and its last line, whatever the control calls it.
std::string Pair::end_of(std::size_t side, std::int32_t number) const {
  const Code& code = *sides_[side].code;
  const Program& program = code.programs[static_cast<std::size_t>(number)];
  if (program.first >= program.last) return code.name_of(program);
  return code.files[program.file].name + ":" + std::to_string(code.blocks[program.last - 1].line);
}

void Pair::of_calls() {
  const auto &a = trace(0).calls, &b = trace(1).calls;
  const auto same = [&](const CallRow& one, const CallRow& other) {
    return one.kind == other.kind && one.start_n == other.start_n && one.repeats == other.repeats &&
           end_of(0, one.program) == end_of(1, other.program);
  };
  std::size_t at = 0;
  while (at < std::min(a.size(), b.size()) && same(a[at], b[at])) ++at;
  if (at == a.size() && at == b.size()) return;
  std::array<std::int64_t, 2> where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    where[side] = static_cast<std::int64_t>(steps(side));
    does[side] = "no further call";
    if (at >= trace(side).calls.size()) continue;
    const CallRow& row = trace(side).calls[at];
    where[side] = row.caller_step;
    does[side] = std::string(cncsub::to_string(row.kind)) + " " +
                 sides_[side].code->name_of(row.program) +
                 (row.start_n < 0 ? "" : " from N" + std::to_string(row.start_n)) + ", " +
                 std::to_string(row.repeats) + (row.repeats == 1 ? " pass" : " passes");
  }
  say(where, does);
}

void Pair::of_steps() {
  const auto &a = trace(0).steps, &b = trace(1).steps;
  const auto place = [&](std::size_t side, const Trace::Step& step) {
    const Code& code = *sides_[side].code;
    const Program& program = code.programs[static_cast<std::size_t>(code.program_at(step.address))];
    return std::pair(std::string_view(code.files[program.file].name),
                     code.blocks[step.address].line);
  };
  std::size_t at = 0;
  while (at < std::min(a.size(), b.size()) && place(0, a[at]) == place(1, b[at])) ++at;
  if (at == a.size() && at == b.size()) return;
  say({static_cast<std::int64_t>(at), static_cast<std::int64_t>(at)}, {});
}

void Pair::of_stop() {
  const auto stop = [](const cncsub::Machine& run) {
    const auto& alarm = run.alarm();
    return std::tuple(run.stop(), run.state().waiting_for, alarm ? info(alarm->cause).slug : "",
                      alarm ? alarm->n : -1, alarm ? alarm->file : "", alarm ? alarm->line : 0);
  };
  if (stop(*runs_[0]) != stop(*runs_[1]))
    say({static_cast<std::int64_t>(steps(0)), static_cast<std::int64_t>(steps(1))}, {});
}

std::optional<Parting> parting_of(const std::array<Side, 2>& sides, const cncsub::Machine& one,
                                  const cncsub::Machine& other, const Runner& run) {
  return Pair(sides, one, other, run).earliest();
}

}  // namespace cncsub::api
