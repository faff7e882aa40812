#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cerrno>

#include "bindings.hpp"
#include "cncsub/system/file.hpp"
#include "file_reading.hpp"
#include "gil.hpp"
#include "text.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// The path for the system. Who listens to what Python opens is told of it, and may refuse.
std::string path_of(const py::handle& path) {
  if (PySys_Audit("open", "OOi", path.ptr(), Py_None, system::kReadOnly) != 0) throw py::error_already_set();
  const auto bytes = py::reinterpret_steal<py::bytes>(PyUnicode_EncodeFSDefault(path.ptr()));
  if (!bytes) throw py::error_already_set();
  return bytes;
}

/// A `Text`, the number of the system's error where the file was not opened, or else why not.
py::object text_or_fault(FileText& file, std::size_t largest) {
  switch (file.fault) {
    case FileFault::None:
      break;
    case FileFault::NotOpened:
      return py::int_(file.error);
    case FileFault::NotRead:
      errno = file.error;
      PyErr_SetFromErrno(PyExc_OSError);
      throw py::error_already_set();
    case FileFault::NotRegular:
      return py::str("not a regular file");
    case FileFault::TooLarge:
      return py::str("larger than " + std::to_string(largest >> 20U) + " MiB");
    case FileFault::NotText:
      return py::str("not a text");
  }
  return py::cast(Text{std::move(file.text), file.utf8});
}

py::list read_texts(const py::list& paths, std::size_t largest, bool only_texts) {
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const py::handle& path : paths) names.push_back(path_of(path));
  std::vector<FileText> files;
  work_away([&](InterruptCheck& interrupt) {
    files = read_files(names, {largest, only_texts}, interrupt);
  });
  py::list found;
  for (FileText& file : files) found.append(text_or_fault(file, largest));
  return found;
}

}  // namespace

void add_files(py::module_& m) {
  py::class_<Text>(m, "Text", py::is_final())
      .def(
          "part",
          [](const Text& t, std::size_t at, std::size_t count) {
            return py::bytes(t.text.substr(std::min(at, t.text.size()), count));
          },
          py::arg("at"), py::arg("count"))
      .def_readonly("utf8", &Text::utf8)
      .def("__len__", [](const Text& t) { return t.text.size(); });
  m.def("read_files", &read_texts, py::arg("paths"), py::arg("largest"), py::arg("only_texts"));
}

}  // namespace cncsub::bindings
