#include "rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>

#include "cncsub/system/decimal.hpp"

namespace cncsub::selftest {

namespace {

std::string plain(std::string_view field) {
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] != '\\' || i + 1 == field.size()) {
      text += field[i];
      continue;
    }
    const char c = field[++i];
    text += c == 't' ? '\t' : c == 'n' ? '\n' : c == 'r' ? '\r' : c;
  }
  return text;
}

std::int64_t whole_of(const std::string& field) { return std::atoll(field.c_str()); }
std::int32_t index_of(const std::string& field) {
  return static_cast<std::int32_t>(whole_of(field));
}
bool yes(const std::string& field) { return field == "1"; }
char axis_of(const std::string& field) { return field.empty() ? ' ' : field[0]; }

using Take = std::function<void(Row&, const Fields&)>;

void take_control(Row& row, const Fields& f) {
  for (const Control& control : all_controls())
    if (control.name == f.at(1)) row.control = std::make_shared<Control>(control);
  if (!row.control) row.wrong = "there is no control " + f.at(1);
}

void take_parameter(Row& row, const Fields& f) {
  if (auto wrong = row.control->set_parameter(f.at(1), number_of(f.at(2)))) row.wrong = *wrong;
}

void take_rule(Row& row, const Fields& f) {
  RuleValue value = f.at(3);
  if (f.at(2) == "yes") value = yes(f.at(3));
  if (f.at(2) == "number") value = whole_of(f.at(3));
  if (auto wrong = set_rule(*row.control, f.at(1), value, f.at(4))) row.wrong = *wrong;
}

void take_trace(Row& row, const Fields& f) {
  constexpr std::string_view kNames[] = {"none", "calls", "blocks", "moves"};
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (kNames[i] == f.at(1)) row.options.trace = static_cast<Trace::Depth>(i);
}

void take_tool(Row& row, const Fields& f) {
  Setup::Tool& tool = row.options.setup.tools[index_of(f.at(1))];
  if (f.at(2) == "tip")
    tool.tip = static_cast<int>(number_of(f.at(3)));
  else if (f.at(2) == "R")
    tool.radius = number_of(f.at(3));
  else
    tool.values[axis_of(f.at(2))] = number_of(f.at(3));
}

void take_skip(Row& row, const Fields& f) {
  SkipSignal skip{SkipSignal::Comes::Never};
  if (f.at(2) == "fraction")
    skip = {SkipSignal::Comes::AtFraction, number_of(f.at(3))};
  else if (f.at(2) != "never")
    skip = {SkipSignal::Comes::AtCoordinate, number_of(f.at(3)),
            static_cast<int>(kAxisNames.find(axis_of(f.at(2))))};
  row.options.inputs.skips.at(static_cast<std::size_t>(index_of(f.at(1)))).push_back(skip);
}

void take_write(Row& row, const Fields& f) {
  auto& writes = row.options.inputs.writes;
  const auto which = static_cast<std::size_t>(index_of(f.at(1)));
  if (writes.size() <= which) writes.resize(which + 1);
  if (f.size() > 2) writes[which][index_of(f.at(2))] = number_of(f.at(3));
}

void take_operator(Row& row, const Fields& f) {
  row.options.inputs.operator_given = true;
  for (std::size_t i = 1; i < f.size(); ++i)
    row.options.inputs.operator_starts.push_back(f[i] == "start");
}

/// Return the keys for what is run, and how.
const std::map<std::string_view, Take>& run_keys() {
  static const std::map<std::string_view, Take> keys = {
      {"row", [](Row& r, const Fields& f) { r.name = f.at(1); }},
      {"control", take_control},
      {"parameter", take_parameter},
      {"rule", take_rule},
      {"file",
       [](Row& r, const Fields& f) {
         r.files.push_back({f.at(1), f.at(2), FileText(f.at(4)), yes(f.at(3))});
       }},
      {"device", [](Row& r, const Fields&) { r.device = true; }},
      {"typed", [](Row& r, const Fields& f) { r.typed = f.at(1); }},
      {"main",
       [](Row& r, const Fields& f) { r.main = static_cast<std::size_t>(whole_of(f.at(1))); }},
      {"mdi", [](Row& r, const Fields& f) { r.options.mdi = yes(f.at(1)); }},
      {"start",
       [](Row& r, const Fields& f) {
         if (f.size() == 2)
           r.options.start = whole_of(f.at(1));
         else
           r.options.setup.start[axis_of(f.at(1))] = number_of(f.at(2));
       }},
      {"optional_stop", [](Row& r, const Fields& f) { r.options.optional_stop = yes(f.at(1)); }},
      {"max_cycles", [](Row& r, const Fields& f) { r.options.max_cycles = whole_of(f.at(1)); }},
      {"max_blocks", [](Row& r, const Fields& f) { r.options.max_blocks = whole_of(f.at(1)); }},
      {"trace", take_trace},
      {"given",
       [](Row& r, const Fields& f) {
         r.options.variables[index_of(f.at(1))] = number_of(f.at(2));
       }},
      {"skip_switch",
       [](Row& r, const Fields& f) {
         r.options.skips = static_cast<std::uint16_t>(r.options.skips | 1U << index_of(f.at(1)));
       }},
  };
  return keys;
}

/// Return the keys for the settings of the machine and for the answers from outside.
const std::map<std::string_view, Take>& world_keys() {
  static const std::map<std::string_view, Take> keys = {
      {"machine", [](Row& r, const Fields& f) { r.options.setup.machine = f.at(1); }},
      {"increment",
       [](Row& r, const Fields& f) { r.options.setup.increment = number_of(f.at(1)); }},
      {"rapid",
       [](Row& r, const Fields& f) {
         r.options.setup.rapid[axis_of(f.at(1))] = number_of(f.at(2));
       }},
      {"length_offsets",
       [](Row& r, const Fields& f) {
         r.options.setup.length_offsets[index_of(f.at(1))] = number_of(f.at(2));
       }},
      {"radius_offsets",
       [](Row& r, const Fields& f) {
         r.options.setup.radius_offsets[index_of(f.at(1))] = number_of(f.at(2));
       }},
      {"limits",
       [](Row& r, const Fields& f) {
         r.options.setup.limits[axis_of(f.at(1))] = {number_of(f.at(2)), number_of(f.at(3))};
       }},
      {"stroke_area",
       [](Row& r, const Fields& f) {
         r.options.setup.area[axis_of(f.at(1))] = {number_of(f.at(2)), number_of(f.at(3))};
       }},
      {"work_offsets",
       [](Row& r, const Fields& f) {
         r.options.setup.work_offsets[f.at(1)][axis_of(f.at(2))] = number_of(f.at(3));
       }},
      {"reference",
       [](Row& r, const Fields& f) {
         r.options.setup.reference[index_of(f.at(1))][axis_of(f.at(2))] = number_of(f.at(3));
       }},
      {"tools", take_tool},
      {"clock_ms", [](Row& r, const Fields& f) { r.options.inputs.clock_ms = number_of(f.at(1)); }},
      {"date", [](Row& r, const Fields& f) { r.options.inputs.date = number_of(f.at(1)); }},
      {"time", [](Row& r, const Fields& f) { r.options.inputs.time = number_of(f.at(1)); }},
      {"signal",
       [](Row& r, const Fields& f) {
         r.options.inputs.signals[index_of(f.at(1))] = number_of(f.at(2));
       }},
      {"operator", take_operator},
      {"write", take_write},
      {"answer",
       [](Row& r, const Fields& f) {
         r.options.inputs.answers[{axis_of(f.at(1)), whole_of(f.at(2))}][index_of(f.at(3))] =
             number_of(f.at(4));
       }},
      {"skip", take_skip},
  };
  return keys;
}

void take(Row& row, Fields&& fields) {
  for (const auto* keys : {&run_keys(), &world_keys()})
    if (const auto found = keys->find(fields.at(0)); found != keys->end()) {
      found->second(row, fields);
      return;
    }
  row.outcome.push_back(std::move(fields));
}

}  // namespace

double number_of(const std::string& field) {
  double value = 0;
  if (field == "vacant") return kVacant;
  if (field == "inf" || field == "-inf") return field[0] == '-' ? -HUGE_VAL : HUGE_VAL;
  if (system::parse(field, value).length != field.size() || field.empty())
    throw std::runtime_error("'" + field + "' is no number");
  return value;
}

Reader::Reader(std::string_view text) : left_(text) {
  const auto first = line();
  if (!first || first->at(0) != "cncsub-selftest")
    throw std::runtime_error("this is no file of rows; tools/selftest_rows.py writes one");
  if (first->size() != 2 || first->at(1) != std::to_string(kFormat))
    throw std::runtime_error("these rows are of another format; write them again");
}

std::optional<Row> Reader::next() {
  Row row;
  while (auto fields = line()) {
    if (fields->at(0) == "end") return row;
    if (!row.wrong.empty()) continue;
    try {
      take(row, std::move(*fields));
    } catch (const std::exception& error) {
      row.wrong = error.what();
    }
  }
  return std::nullopt;
}

std::optional<Fields> Reader::line() {
  if (left_.empty()) return std::nullopt;
  const std::size_t end = std::min(left_.find('\n'), left_.size());
  std::string_view text = left_.substr(0, end);
  left_.remove_prefix(std::min(end + 1, left_.size()));
  Fields fields;
  for (std::size_t tab = 0; tab != std::string_view::npos;) {
    tab = text.find('\t');
    fields.push_back(plain(text.substr(0, tab)));
    text.remove_prefix(tab == std::string_view::npos ? text.size() : tab + 1);
  }
  return fields;
}

}  // namespace cncsub::selftest
