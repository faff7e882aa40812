#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "cncsub/dialect/library.hpp"
#include "cncsub/machine/machine.hpp"
#include "cncsub/motion/query.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub::selftest {

namespace {

constexpr std::size_t kMost = 300;  // steps and moves that are compared, as in the rows
constexpr double kApart = 1e-7;     // allowed difference: absolute, or as a share of larger numbers

using Field = std::variant<std::string, double>;
using Line = std::vector<Field>;

std::string text(std::int64_t whole) { return std::to_string(whole); }

template <class T>
std::vector<T> all_of(const Column<T>& column) {
  std::vector<T> values;
  for (std::size_t i = 0; i < column.size(); ++i) values.push_back(column[i]);
  return values;
}

void tell_stop(std::vector<Line>& lines, const Machine& machine) {
  lines.push_back({"stop", std::string(to_string(machine.stop()))});
  if (!machine.alarm()) return;
  const Alarm& a = *machine.alarm();
  lines.push_back({"alarm", std::string(info(a.cause).slug), a.number, a.program, text(a.n),
                   text(a.line), text(a.column), a.word});
  lines.push_back({"message", message(a)});
}

void tell_steps(std::vector<Line>& lines, const Machine& machine) {
  const Code& code = machine.code();
  const Trace& trace = machine.trace();
  lines.push_back({"steps", text(static_cast<std::int64_t>(trace.steps.size()))});
  for (std::size_t i = 0; i < std::min(trace.steps.size(), kMost); ++i) {
    const Address address = trace.steps[i].address;
    const Block& block = code.blocks[address];
    lines.push_back(
        {"step", code.name_of(code.programs[static_cast<std::size_t>(code.program_at(address))]),
         text(block.line), text(block.n)});
  }
}

void tell_values(std::vector<Line>& lines, const Machine& machine) {
  const Trace& trace = machine.trace();
  for (const auto& [number, stored] : machine.variables(0)) {
    double value = stored;
    machine.read(number, 0, value);  // some are counted when they are read
    lines.push_back({"variable", text(number), value});
  }
  for (const auto& [kind, line] : {std::pair{'M', "m_codes"}, std::pair{'T', "t_codes"}})
    for (const Trace::Sent& sent : all_of(trace.codes))
      if (sent.kind == kind) lines.push_back({line, text(static_cast<std::int64_t>(sent.value))});
  for (const std::string& said : all_of(trace.messages)) lines.push_back({"messages", said});
  for (const auto& [axis, value] : position(machine.motion().view()))
    lines.push_back({"position", axis, value});
  for (const auto& [group, code] : modal(machine.motion().view()))
    lines.push_back({"modal", group, code});
}

void tell_calls(std::vector<Line>& lines, const Machine& machine) {
  const Code& code = machine.code();
  for (const CallRow& call : all_of(machine.trace().calls))
    lines.push_back({"call", std::string(to_string(call.kind)),
                     code.name_of(code.programs[static_cast<std::size_t>(call.program)]),
                     text(call.level), text(call.caller_step)});
}

void tell_moves(std::vector<Line>& lines, const Machine& machine) {
  const Moves& moves = machine.trace().moves;
  lines.push_back(
      {"moves", text(static_cast<std::int64_t>(moves.size())), moves.length(), moves.time()});
  for (std::size_t i = 0; i < std::min(moves.size(), kMost); ++i) {
    const MoveRow row = moves.row(i);
    lines.push_back({"move", std::string(to_string(row.kind)), row.point[0], row.point[1],
                     row.point[2], row.machine[0], row.machine[1], row.machine[2], row.feed,
                     row.time});
  }
}

bool same(const std::string& reported, const Field& found) {
  if (const auto* word = std::get_if<std::string>(&found)) return *word == reported;
  const double a = number_of(reported), b = std::get<double>(found);
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b || std::fabs(a - b) <= kApart * std::max({1.0, std::fabs(a), std::fabs(b)});
}

bool same(const Fields& reported, const Line& found) {
  return std::equal(reported.begin(), reported.end(), found.begin(), found.end(),
                    [](const std::string& a, const Field& b) { return same(a, b); });
}

std::string shown(const Line& line) {
  std::string text;
  for (const Field& field : line) {
    if (!text.empty()) text += ' ';
    if (const auto* word = std::get_if<std::string>(&field))
      text += *word;
    else
      text += system::shortest(std::get<double>(field));
  }
  return text.empty() ? "nothing" : text;
}

Line plain(const Fields& fields) { return {fields.begin(), fields.end()}; }

}  // namespace

std::string difference(Row row) {
  if (!row.wrong.empty()) return row.wrong;
  auto code = compile(row.control, std::move(row.files), row.device);
  if (row.typed) code = compile_mdi(*code, *row.typed);
  if (row.main >= code->programs.size()) return "its main program was not read";
  const auto given = row.options.variables;
  Machine machine(code, static_cast<std::int32_t>(row.main), std::move(row.options));
  for (const auto& [number, value] : given) machine.write(number, 0, value);
  machine.run({});
  std::vector<Line> lines;
  tell_stop(lines, machine);
  tell_steps(lines, machine);
  tell_values(lines, machine);
  tell_calls(lines, machine);
  tell_moves(lines, machine);
  for (std::size_t i = 0; i < std::max(lines.size(), row.outcome.size()); ++i) {
    const Fields& reported = i < row.outcome.size() ? row.outcome[i] : Fields{};
    const Line& found = i < lines.size() ? lines[i] : Line{};
    if (!same(reported, found))
      return "expected " + shown(plain(reported)) + "\n  got      " + shown(found);
  }
  return {};
}

}  // namespace cncsub::selftest
