// The path of a run as points.
#include <algorithm>

#include "bindings.hpp"
#include "cncsub/trace/move_walk.hpp"
#include "cncsub/trace/polyline.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

PathFrame frame_of(const std::string& name) {
  if (name == "work") return PathFrame::Work;
  if (name == "tool") return PathFrame::Tool;
  if (name == "machine") return PathFrame::Machine;
  throw py::value_error("the coordinates must be work, tool or machine");
}

/// Return x, y, z, move, begins of the moves [first, last); the number of points where that is more
/// than `most`.
py::object polyline(const Record& record, const std::string& frame, double tolerance,
                    std::size_t first, std::size_t last, std::size_t most) {
  const Record::Reading reading(record);
  const Trace& trace = record.trace();
  Sampler sampler(trace.moves, frame_of(frame), tolerance, first, last);
  std::size_t count = 0;
  work_away([&](InterruptCheck& interrupt) { count = sampler.count(&interrupt); });
  if (count > most) return py::int_(count);
  const Array<double> x(count), y(count), z(count);
  const Array<std::int64_t> move(count);
  const Array<std::uint8_t> begins(count);
  work_away([&](InterruptCheck& interrupt) {
    sampler.write({x.data, y.data, z.data, move.data, begins.data}, &interrupt);
    std::for_each(move.data, move.data + count,
                  [&](std::int64_t& row) { row += trace.first_move; });
  });
  return py::make_tuple(x.object, y.object, z.object, move.object, begins.object.attr("view")("?"));
}

template <class To, class From>
py::object as_array(const std::vector<From>& from) {
  const Array<To> array(from.size());
  std::copy(from.begin(), from.end(), array.data);
  return array.object;
}

/// Return the numbers of a contiguous array of one dimension.
template <class T>
const T* numbers(const py::buffer_info& info, std::size_t count) {
  if (info.ndim != 1 || !info.item_type_is_equivalent_to<T>() ||
      info.strides[0] != static_cast<py::ssize_t>(sizeof(T)) ||
      static_cast<std::size_t>(info.size) != count)
    throw py::type_error("three columns of float64 and one of int32, equally long");
  return static_cast<const T*>(info.ptr);
}

/// Return x, y, z, move, key, time of the points that a picture needs, the number of points before,
/// and the number of those at which the path begins anew.
py::tuple outline(const Record& record, const std::string& frame, double tolerance, double thinner,
                  std::size_t first, std::size_t last, const py::buffer& key) {
  const Record::Reading reading(record);
  const Moves& moves = record.trace().moves;
  const py::buffer_info of_key = key.request();
  if (first > last || last > moves.size()) throw py::index_error("no such moves");
  const auto* const keys = numbers<std::int32_t>(of_key, last - first);
  const Sampler sampler(moves, frame_of(frame), tolerance, first, last);
  Outline found;
  work_away([&](InterruptCheck& interrupt) { found = sampler.outline(keys, thinner, &interrupt); });
  py::object row = as_array<std::int64_t>(found.row);
  if (record.trace().first_move != 0) row += py::int_(record.trace().first_move);
  return py::make_tuple(as_array<double>(found.x), as_array<double>(found.y),
                        as_array<double>(found.z), row, as_array<std::int32_t>(found.key),
                        as_array<double>(found.time), found.points, found.begins);
}

py::object thinned(const py::buffer& x, const py::buffer& y, const py::buffer& z,
                   const py::buffer& key, double tolerance) {
  const py::buffer_info of_x = x.request(), of_y = y.request(), of_z = z.request(),
                        of_key = key.request();
  const auto count = static_cast<std::size_t>(of_x.size);
  const double* const along_x = numbers<double>(of_x, count);
  const double* const along_y = numbers<double>(of_y, count);
  const double* const along_z = numbers<double>(of_z, count);
  const auto* const keys = numbers<std::int32_t>(of_key, count);
  const Array<std::uint8_t> keep(count);
  work_away([&](InterruptCheck& interrupt) {
    simplify(along_x, along_y, along_z, keys, count, tolerance, keep.data, &interrupt);
  });
  return keep.object.attr("view")("?");
}

}  // namespace

void add_begin(py::dict& fields, const Moves& moves, std::size_t index) {
  const MoveBegin begin = MoveReader(moves).begin_of(index);
  constexpr std::string_view kNames = "xyz";
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const std::string axis(1, kNames[i]);
    fields[py::str("s" + axis)] = begin.point[i];
    fields[py::str("ms" + axis)] = begin.machine[i];
    fields[py::str("mc" + axis)] = begin.centre[i];
  }
  fields["cycle"] = begin.cycle;
  fields["compensated"] = begin.compensated;
}

void add_paths(py::class_<Record>& trace) {
  trace
      .def("polyline", &polyline, py::arg("frame"), py::arg("tolerance"), py::arg("first"),
           py::arg("last"), py::arg("most"))
      .def("outline", &outline, py::arg("frame"), py::arg("tolerance"), py::arg("thinner"),
           py::arg("first"), py::arg("last"), py::arg("key"))
      .def_property_readonly("diameters",
                             [](const Record& record) {
                               const Record::Reading reading(record);
                               return MoveReader(record.trace().moves).diameters();
                             })
      .def_static("thinned", &thinned, py::arg("x"), py::arg("y"), py::arg("z"), py::arg("key"),
                  py::arg("tolerance"));
}

}  // namespace cncsub::bindings
