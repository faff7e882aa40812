// The table of steps, and a step as an object.
#include <pybind11/stl.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "bindings.hpp"
#include "cncsub/trace/parts.hpp"
#include "gil.hpp"
#include "rows.hpp"
#include "step_values.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

py::object step_column(const Record& record, const std::string& name) {
  const Record::Reading reading(record);
  const auto& steps = record.trace().steps;
  if (name == "step") {
    const Array<std::int64_t> array(steps.size());
    std::iota(array.data, array.data + steps.size(), record.trace().first_step);
    return array.object;
  }
  const Array<std::int32_t> array(steps.size());
  std::int32_t* const out = array.data;
  bool known = false;
  work_away([&](InterruptCheck& interrupt) {
    known = with_step_value(record, name, [&](const auto& value) {
      in_parts(steps.size(), &interrupt, [&](std::size_t first, std::size_t last) {
        auto own = value;
        std::int32_t* next = out + first;
        steps.for_each_run(first, last, [&](const Trace::Step* rows, std::size_t count) {
          for (std::size_t i = 0; i < count; ++i) *next++ = static_cast<std::int32_t>(own(rows[i]));
        });
      });
    });
  });
  if (!known) throw py::key_error(name);
  return array.object;
}

std::string_view text_at(const Code& code, Address address) {
  const Program& program = code.programs[static_cast<std::size_t>(code.program_at(address))];
  return code.text_of(code.blocks[address], program);
}

/// Return the texts of the blocks of all steps: a number for each step, and the texts by number.
py::tuple step_text_column(const Record& record) {
  const Record::Reading reading(record);
  const auto shared = record.code();
  const Code& code = *shared;
  const auto& steps = record.trace().steps;
  const Array<std::int32_t> array(steps.size());
  std::vector<std::string_view> texts;
  work_away([&](InterruptCheck& interrupt) {
    constexpr std::int32_t kNew = -1;
    std::vector<std::int32_t> of_block(code.blocks.size(), kNew);
    std::unordered_map<std::string_view, std::int32_t> places;
    std::int32_t* next = array.data;
    steps.for_each_run(0, steps.size(), [&](const Trace::Step* rows, std::size_t count) {
      if (interrupt.requested(count * sizeof(Trace::Step))) return;
      for (std::size_t i = 0; i < count; ++i) {
        std::int32_t& place = of_block[rows[i].address];
        if (place == kNew) {
          const std::string_view text = text_at(code, rows[i].address);
          place = places.try_emplace(text, static_cast<std::int32_t>(texts.size())).first->second;
          if (static_cast<std::size_t>(place) == texts.size()) texts.push_back(text);
        }
        *next++ = place;
      }
    });
  });
  py::list written;
  for (const std::string_view text : texts) written.append(py::str(std::string(text)));
  return py::make_tuple(array.object, written);
}

/// Return the blocks of some steps as they are written, from row `first` on.
py::list step_texts(const Record& record, std::size_t first, std::size_t last) {
  const Record::Reading reading(record);
  const auto code = record.code();
  const auto& steps = record.trace().steps;
  py::list texts;
  for (std::size_t i = first; i < std::min(last, steps.size()); ++i)
    texts.append(py::str(std::string(text_at(*code, steps[i].address))));
  return texts;
}

/// How the step after another one came to be that.
enum class Way : std::int8_t { On, Skips, Jumps, Returns, Other };

/// Return how a step leads to the next one.
Way way_to(const Code& code, const Trace& trace, const Trace::Step& from, const Trace::Step& to) {
  if (to.call != from.call)
    return trace.depth_of(to.call) < trace.depth_of(from.call) ? Way::Returns : Way::Other;
  if (to.repeat != from.repeat) return Way::Other;
  const std::uint32_t next = from.address + 1;
  if (to.address == next) return Way::On;
  if (to.address < next) return Way::Jumps;
  for (std::uint32_t at = next; at < to.address; ++at)
    if (!code.blocks[at].can_be_skipped()) return Way::Jumps;
  return Way::Skips;
}

/// Return how each of some steps leads to the next one, a `Way` each.
py::object step_ways(const Record& record, std::size_t first, std::size_t last) {
  const Record::Reading reading(record);
  const auto code = record.code();
  const Trace& trace = record.trace();
  const auto& steps = trace.steps;
  last = std::min(last, steps.size());
  first = std::min(first, last);
  const Array<std::int8_t> array(last - first);
  for (std::size_t i = first; i < last; ++i)
    array.data[i - first] = static_cast<std::int8_t>(
        i + 1 < steps.size() ? way_to(*code, trace, steps[i], steps[i + 1]) : Way::Other);
  return array.object;
}

/// Return the blocks between a step and the next one as they are written.
py::list texts_after(const Record& record, std::size_t index) {
  const Record::Reading reading(record);
  const auto& steps = record.trace().steps;
  if (index + 1 >= steps.size()) throw py::index_error("no step follows");
  const auto code = record.code();
  py::list texts;
  for (std::uint32_t at = steps[index].address + 1; at < steps[index + 1].address; ++at)
    texts.append(py::str(std::string(text_at(*code, at))));
  return texts;
}

py::object step_row(const Record& record, std::size_t index, const py::type& row) {
  const Record::Reading reading(record);
  if (index >= record.trace().steps.size()) throw py::index_error("no such step");
  return step_object(record.trace(), record.code(), index, row);
}

/// Make a row of a frozen class. The engine sets its fields in order, as the class itself sets
/// them.
template <class... Values>
py::object row_object(const py::type& row, const Values&... values) {
  const py::tuple names = row.attr("_of_engine");
  py::object object = row.attr("__new__")(row);
  std::size_t place = 0;
  const auto set = [&](const py::object& value) {
    const py::object name = names[place++];
    if (PyObject_GenericSetAttr(object.ptr(), name.ptr(), value.ptr()) != 0)
      throw py::error_already_set();
  };
  (set(values), ...);
  return object;
}

}  // namespace

py::object step_object(const Trace& trace, const std::shared_ptr<const Code>& code,
                       std::size_t index, const py::type& row) {
  const Trace::Step step = trace.steps[index];
  const Block& block = code->blocks[step.address];
  return row_object(row, py::int_(trace.first_step + static_cast<std::int64_t>(index)),
                    py::str(code->name_of(code->program_at(step.address))),
                    sequence_number(block.n), py::int_(block.line),
                    py::int_(trace.depth_of(step.call)), py::int_(step.call), py::int_(step.repeat),
                    py::cast(std::const_pointer_cast<Code>(code)),
                    py::int_(static_cast<std::uint32_t>(step.address)));
}

void add_block(py::dict& fields, const Record& record, std::uint32_t step_of_move) {
  const Trace& trace = record.trace();
  const auto shared = record.code();
  const Code& code = *shared;
  const Trace::Step* const step = trace.find_step(trace.step_of_move(step_of_move));
  if (step == nullptr) {
    for (const char* name : {"program", "n", "line"}) fields[name] = py::none();
    return;
  }
  const Block& block = code.blocks[step->address];
  fields["program"] = code.name_of(code.program_at(step->address));
  fields["n"] = sequence_number(block.n);
  fields["line"] = block.line;
}

void add_steps(py::class_<Record>& trace) {
  trace
      .def_property_readonly("steps",
                             [](const Record& record) {
                               const Record::Reading reading(record);
                               return record.trace().steps.size();
                             })
      .def("step_row", &step_row, py::arg("index"), py::arg("row"))
      .def("step_column", &step_column, py::arg("name"))
      .def("step_ways", &step_ways, py::arg("first"), py::arg("last"))
      .def("texts_after", &texts_after, py::arg("index"))
      .def("step_texts", &step_texts, py::arg("first"), py::arg("last"))
      .def("step_text_column", &step_text_column);
}

}  // namespace cncsub::bindings
