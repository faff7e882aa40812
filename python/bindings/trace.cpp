// The tables of a run, of a machine that is still at work, or of a part of a stream.
#include "cncsub/trace/trace.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <numeric>

#include "bindings.hpp"
#include "cncsub/trace/parts.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "rows.hpp"
#include "step_values.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

py::list dropped(const Record& record) {
  const Record::Reading reading(record);
  const auto shared = record.code();
  const Code& code = *shared;
  py::list list;
  for (std::size_t i = 0; i < record.trace().dropped.size(); ++i) {
    const Trace::Dropped& drop = record.trace().dropped[i];
    const Block& block = code.blocks[drop.address];
    const Program& program = code.programs[static_cast<std::size_t>(code.program_at(drop.address))];
    list.append(py::make_tuple(drop.step, code.name_of(program), sequence_number(block.n),
                               block.line, code.files[program.file].name, drop.text));
  }
  return list;
}

template <class T, class Value>
py::object call_array(const Record& record, Value&& value) {
  const Trace& trace = record.trace();
  const Array<T> array(trace.ended_calls());
  work_away([&](InterruptCheck& interrupt) {
    T* out = array.data;
    auto later = trace.unfinished.begin();
    for (std::size_t row = 0; row < trace.calls.size(); ++row) {
      if (interrupt.requested(sizeof(CallRow))) return;
      if (later != trace.unfinished.end() && *later == row)
        ++later;
      else
        *out++ = static_cast<T>(value(trace.calls[row], row));
    }
  });
  return array.object;
}

py::object call_column(const Record& record, const std::string& name) {
  const Record::Reading reading(record);
  const auto column = [&](auto value) {
    return call_array<std::int64_t>(record,
                                    [=](const CallRow& call, std::size_t) { return value(call); });
  };
  const auto codes = [&](auto value) {
    return call_array<std::int32_t>(record,
                                    [=](const CallRow& call, std::size_t) { return value(call); });
  };
  if (name == "call")
    return call_array<std::int64_t>(
        record, [&](const CallRow&, std::size_t row) { return record.trace().call_number(row); });
  if (name == "parent") return column([](const CallRow& c) { return c.parent; });
  if (name == "kind") return codes([](const CallRow& c) { return static_cast<int>(c.kind); });
  if (name == "program") return codes([](const CallRow& c) { return c.program; });
  if (name == "start_n") return column([](const CallRow& c) { return c.start_n; });
  if (name == "repeats") return column([](const CallRow& c) { return c.repeats; });
  if (name == "level") return column([](const CallRow& c) { return c.level; });
  if (name == "first_step") return column([](const CallRow& c) { return c.first_step; });
  if (name == "last_step") return column([](const CallRow& c) { return c.last_step; });
  if (name == "caller_step") return column([](const CallRow& c) { return c.caller_step; });
  throw py::key_error(name);
}

std::size_t row_of_call(const Record& record, std::size_t index) {
  if (index >= record.trace().ended_calls()) throw py::index_error("no such call");
  return record.trace().ended_call(index);
}

py::tuple call_row(const Record& record, std::size_t index) {
  const Record::Reading reading(record);
  const std::size_t row = row_of_call(record, index);
  const CallRow& call = record.trace().calls[row];
  return py::make_tuple(record.trace().call_number(row), call.parent,
                        std::string(to_string(call.kind)), record.code()->name_of(call.program),
                        sequence_number(call.start_n), call.repeats, call.level, call.first_step,
                        call.last_step, call.caller_step);
}

/// Return the arguments of a call, as given.
py::dict call_arguments(const Record& record, std::size_t index) {
  const Record::Reading reading(record);
  const auto code = record.code();
  const CallRow& call = record.trace().calls[row_of_call(record, index)];
  py::dict values;
  for (std::uint32_t i = 0; i < call.arguments; ++i) {
    const Trace::Argument& argument = record.trace().arguments[call.first_argument + i];
    const NamedVariable* const named = code->named(false, argument.variable);
    const py::object key = named != nullptr ? py::object(py::str(named->name))
                                            : py::object(py::int_(argument.variable));
    values[key] = value_or_none(argument.value);
  }
  return values;
}

bool is_small(const std::string& name) {
  return name == "kind" || name == "feed_mode" || name == "skip" || name == "cycle" ||
         name == "compensated";
}
bool is_whole(const std::string& name) {
  return name == "move" || name == "step" || name == "plane" || name == "tool" || name == "h" ||
         name == "d" || is_small(name);
}

/// Return a column of the moves that follows from their steps. Each row holds the last bits of its
/// step first, then what follows from the step; -1 where the step is no longer known.
py::object column_by_step(const Record& record, const std::string& name) {
  const Trace& trace = record.trace();
  const Array<std::int32_t> array(trace.moves.size());
  std::int32_t* const out = array.data;
  work_away([&](InterruptCheck& interrupt) {
    trace.moves.column("step", out, &interrupt);
    with_step_value(record, name, [&](const auto& value) {
      in_parts(trace.moves.size(), &interrupt, [&](std::size_t first, std::size_t last) {
        auto own = value;
        std::uint32_t known = 0;
        std::int32_t held = -1;
        bool any = false;
        for (std::size_t i = first; i < last; ++i) {
          const auto bits = static_cast<std::uint32_t>(out[i]);
          if (!any || bits != known) {
            const Trace::Step* const step = trace.find_step(trace.step_of_move(bits));
            held = step == nullptr ? -1 : static_cast<std::int32_t>(own(*step));
            known = bits;
            any = true;
          }
          out[i] = held;
        }
      });
    });
  });
  return array.object;
}

bool is_of_step(const std::string& name) {
  return name == "program" || name == "n" || name == "line" || name == "frame" || name == "depth";
}

/// Change the steps or moves of this part to their numbers in the run.
void number_through(const Trace& trace, bool steps, std::int64_t* first, const std::int64_t* last) {
  for (; first != last; ++first)
    *first =
        steps ? trace.step_of_move(static_cast<std::uint32_t>(*first)) : *first + trace.first_move;
}

template <class Whole>
py::object whole_move_column(const Record& record, const std::string& name) {
  const Moves& moves = record.trace().moves;
  const Array<Whole> array(moves.size());
  Whole* const out = array.data;
  work_away([&](InterruptCheck& interrupt) {
    moves.column(name, out, &interrupt);
    if constexpr (sizeof(Whole) == 8)
      if (name == "step" || name == "move")
        in_parts(moves.size(), &interrupt, [&](std::size_t first, std::size_t last) {
          number_through(record.trace(), name == "step", out + first, out + last);
        });
  });
  return array.object;
}

/// Return columns of the moves. The columns that are computed from the rows are computed together.
py::dict move_columns(const Record& record, const std::vector<std::string>& names) {
  const Record::Reading reading(record);
  const Moves& moves = record.trace().moves;
  py::dict columns;
  std::vector<std::string> lengths;
  std::vector<double*> places;
  for (const std::string& name : names) {
    if (columns.contains(name)) continue;  // its array is being filled
    if (is_of_step(name)) {
      columns[py::str(name)] = column_by_step(record, name);
      continue;
    }
    if (is_whole(name)) {
      columns[py::str(name)] = is_small(name) ? whole_move_column<std::int32_t>(record, name)
                                              : whole_move_column<std::int64_t>(record, name);
      continue;
    }
    const Array<double> array(moves.size());
    lengths.push_back(name);
    places.push_back(array.data);
    columns[py::str(name)] = array.object;
  }
  bool known = false;
  work_away([&](InterruptCheck& interrupt) { known = moves.columns(lengths, places, &interrupt); });
  if (!known) throw py::key_error("no such column");
  return columns;
}

std::string axis_name(char axis, const char* before = "") {
  return before + std::string(1, static_cast<char>(axis - 'A' + 'a'));
}

py::dict move_row(const Record& record, std::size_t index) {
  const Record::Reading reading(record);
  if (index >= record.trace().moves.size()) throw py::index_error("no such move");
  const MoveRow row = record.trace().moves.row(index);
  const MoveState& state = *row.state;
  py::dict fields;
  fields["move"] = record.trace().first_move + static_cast<std::int64_t>(index);
  fields["step"] = record.trace().step_of_move(row.step);
  fields["kind"] = std::string(to_string(row.kind));
  for (std::size_t place = 0; place < kAxisNames.size(); ++place) {
    fields[py::str(axis_name(kAxisNames[place]))] = row.point[place];
    fields[py::str(axis_name(kAxisNames[place], "m"))] = row.machine[place];
  }
  fields["cx"] = row.centre[0];
  fields["cy"] = row.centre[1];
  fields["cz"] = row.centre[2];
  fields["plane"] = static_cast<int>(state.plane);
  fields["feed"] = row.feed;
  fields["spindle"] = row.spindle;
  fields["tool"] = state.tool;
  fields["feed_mode"] = static_cast<int>(state.feed_mode);
  fields["skip"] = std::string(to_string(row.skip));
  fields["h"] = state.h;
  fields["d"] = state.d;
  fields["length"] = row.length;
  fields["time"] = row.time;
  add_block(fields, record, row.step);
  add_begin(fields, record.trace().moves, index);
  return fields;
}

py::dict bounds_of(const Record& record) {
  const Record::Reading reading(record);
  py::dict bounds;
  const Moves& moves = record.trace().moves;
  Moves::Bounds box;
  work_away([&](InterruptCheck& interrupt) { box = moves.bounds(&interrupt); });
  for (const char axis : moves.axes()) {
    const auto place = kAxisNames.find(axis);
    if (!std::isnan(box.low[place]))
      bounds[py::str(axis_name(axis))] = py::make_tuple(box.low[place], box.high[place]);
  }
  return bounds;
}

template <class T>
py::list listed(const Record& record, const Column<T>& column) {
  const Record::Reading reading(record);
  py::list list;
  for (std::size_t i = 0; i < column.size(); ++i) {
    list.append(py::cast(column[i]));
    if (i % 4096 == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return list;
}

double path_length(const Record& record) {
  const Record::Reading reading(record);
  double length = 0;
  work_away([&](InterruptCheck& interrupt) { length = record.trace().moves.length(&interrupt); });
  return length;
}

template <class Kind>
std::vector<std::string> names_to(Kind last) {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(last); ++i)
    names.emplace_back(to_string(static_cast<Kind>(i)));
  return names;
}

std::vector<std::string> program_names(const Record& record) {
  std::vector<std::string> names;
  const auto code = record.code();
  for (const Program& program : code->programs) names.push_back(code->name_of(program));
  return names;
}

std::vector<std::string> move_axes(const Record& record) {
  const Record::Reading reading(record);
  std::vector<std::string> names;
  for (const char axis : record.trace().moves.axes()) names.push_back(axis_name(axis));
  return names;
}

}  // namespace

void add_trace(py::module_& m) {
  const auto size = [](auto rows) {
    return [rows](const Record& record) {
      const Record::Reading reading(record);
      return rows(record.trace());
    };
  };
  py::class_<Record> trace(m, "Trace", py::is_final());
  add_watch(trace);
  add_conditions(trace);
  add_sent_codes(trace);
  add_paths(trace);
  add_steps(trace);
  trace.def_property_readonly("program_names", &program_names)
      .def_property_readonly("calls", size([](const Trace& trace) { return trace.ended_calls(); }))
      .def("call_row", &call_row, py::arg("index"))
      .def("call_column", &call_column, py::arg("name"))
      .def("call_arguments", &call_arguments, py::arg("index"))
      .def_property_readonly("kind_names", [](const Record&) { return names_to(CallKind::Typed); })
      .def_property_readonly("moves", size([](const Trace& trace) { return trace.moves.size(); }))
      .def("move_row", &move_row, py::arg("index"))
      .def("move_columns", &move_columns, py::arg("names"))
      .def_property_readonly("move_kinds", [](const Record&) { return names_to(MoveKind::Dwell); })
      .def_property_readonly("skip_names", [](const Record&) { return names_to(SkipMove::Missed); })
      .def_property_readonly("move_axes", &move_axes)
      .def_property_readonly("path_length", &path_length)
      .def_property_readonly("time", &Record::time)
      .def_property_readonly("bounds", &bounds_of)
      .def_property_readonly("control",
                             [](const Record& record) {
                               return std::const_pointer_cast<Control>(record.code()->control);
                             })
      .def_property_readonly("dropped", &dropped)
      .def_property_readonly(
          "messages", [](const Record& record) { return listed(record, record.trace().messages); });
}

}  // namespace cncsub::bindings
