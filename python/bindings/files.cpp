#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <unordered_set>
#include <vector>

#include "bindings.hpp"
#include "cncsub/system/file.hpp"
#include "cncsub/text/utf8.hpp"
#include "file_reading.hpp"
#include "folder_listing.hpp"
#include "gil.hpp"
#include "text.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

std::string system_name(const py::handle& name) {
  const auto bytes = py::reinterpret_steal<py::bytes>(PyUnicode_EncodeFSDefault(name.ptr()));
  if (!bytes) throw py::error_already_set();
  return bytes;
}

PyObject* python_name(void* name) {
  return PyUnicode_DecodeFSDefault(static_cast<const char*>(name));
}

/// Report a path to the audit hooks for `open`, which may refuse. Without hooks no object is made.
void tell_of_opening(std::string& path) {
  if (PySys_Audit("open", "O&Oi", &python_name, path.data(), Py_None, system::kReadOnly) != 0)
    throw py::error_already_set();
}

/// Return a `Text`, the number of the system's error where the file was not opened, or the reason
/// of another failure.
py::object text_or_fault(ReadFile& file, std::size_t largest) {
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

std::vector<ReadFile> read_all(std::vector<std::string>& paths, const ReadingBounds& bounds) {
  for (std::string& path : paths) tell_of_opening(path);
  std::vector<ReadFile> files;
  work_away([&](InterruptCheck& interrupt) { files = read_files(paths, bounds, interrupt); });
  return files;
}

py::object read_text(const py::str& path, std::size_t largest) {
  std::vector<std::string> paths{system_name(path)};
  return text_or_fault(read_all(paths, {largest, false}).front(), largest);
}

/// Return the name without its ending; a dot at its end begins none.
std::string stem_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  const bool ends = dot != std::string_view::npos && dot > 0 && dot + 1 < name.size();
  return std::string(ends ? name.substr(0, dot) : name);
}

bool is_text(std::string_view name) {
  return is_utf8(name, [](std::size_t) { return false; });
}

/// Read files of a folder. Consecutive files that compile as they are form one `Texts`. Each other
/// one gives its place with a `Text` or a fault.
py::list read_found(const py::str& before, const py::list& names, std::size_t largest,
                    bool as_utf8) {
  const std::string folder = system_name(before);
  std::vector<std::string> paths;
  paths.reserve(names.size());
  for (const py::handle& name : names) paths.push_back(folder + system_name(name));
  std::vector<ReadFile> files = read_all(paths, {largest, true});
  py::list found;
  Texts together;
  const auto give = [&] {
    if (!together.files.empty()) found.append(py::cast(std::exchange(together, {})));
  };
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string_view name = std::string_view(paths[i]).substr(folder.size());
    if (as_utf8 && files[i].fault == FileFault::None && files[i].utf8 && is_text(paths[i])) {
      together.files.push_back({paths[i], stem_of(name), std::move(files[i].text), false});
      continue;
    }
    give();
    found.append(py::make_tuple(i, text_or_fault(files[i], largest)));
  }
  give();
  return found;
}

py::list python_names(const std::vector<std::string>& names) {
  py::list list(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto name = py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefaultAndSize(
        names[i].data(), static_cast<py::ssize_t>(names[i].size())));
    if (!name) throw py::error_already_set();
    list[i] = std::move(name);
  }
  return list;
}

/// Return files, folders, others, and whether they are in order; or the number of the system's
/// error.
py::object names_in(const py::str& folder, const py::iterable& no_programs) {
  if (PySys_Audit("os.scandir", "O", folder.ptr()) != 0) throw py::error_already_set();
  const std::string path = system_name(folder);
  std::unordered_set<std::string> endings;
  for (const py::handle& ending : no_programs) endings.insert(ending.cast<std::string>());
  FolderListing listing;
  work_away([&](InterruptCheck& interrupt) { listing = list_folder(path, endings, interrupt); });
  if (listing.error != 0) return py::int_(listing.error);
  return py::make_tuple(python_names(listing.files), python_names(listing.folders),
                        python_names(listing.others), listing.ordered);
}

}  // namespace

void add_files(py::module_& m) {
  py::class_<Text>(m, "Text", py::is_final())
      .def(
          "part",
          [](const Text& t, std::size_t at, std::size_t count) {
            return bytes_of(t.text, at, count);
          },
          py::arg("at"), py::arg("count"))
      .def_readonly("utf8", &Text::utf8)
      .def("__len__", [](const Text& t) { return t.text.size(); });
  py::class_<Texts>(m, "Texts", py::is_final())
      .def_property_readonly("names",
                             [](const Texts& texts) {
                               py::list names(texts.files.size());
                               for (std::size_t i = 0; i < texts.files.size(); ++i)
                                 names[i] = py::str(texts.files[i].name);
                               return names;
                             })
      .def(
          "file",
          [](const Texts& texts, std::size_t index) {
            if (index >= texts.files.size()) throw py::index_error("no such file");
            const SourceFile& file = texts.files[index];
            return py::make_tuple(file.name, file.stem, bytes_of(file.text));
          },
          py::arg("index"))
      .def("__len__", [](const Texts& texts) { return texts.files.size(); });
  m.def("read_file", &read_text, py::arg("path"), py::arg("largest"));
  m.def("read_found", &read_found, py::arg("before"), py::arg("names"), py::arg("largest"),
        py::arg("as_utf8"));
  m.def("names_in", &names_in, py::arg("folder"), py::arg("no_programs"));
}

}  // namespace cncsub::bindings
