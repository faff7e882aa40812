#include <array>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

#include "bindings.hpp"

namespace {

/// Texts for classes that must not be called to make objects. No object exists that `__new__` alone
/// made and nothing filled.
constexpr std::array<std::pair<std::string_view, const char*>, 3> kSources{{
    {"Alarm", "alarms come from runs"},
    {"Frame", "frames come from runs"},
    {"Control", "the controls are in cncsub.controls; changed copies come from them"},
}};

PyObject* refuse(PyTypeObject* type, PyObject*, PyObject*) {
  std::string_view name = type->tp_name;
  name.remove_prefix(name.rfind('.') + 1);
  for (const auto& [known, source] : kSources)
    if (name == known) return PyErr_Format(PyExc_TypeError, "%s", source);
  return PyErr_Format(PyExc_TypeError, "%s objects come from the engine", name.data());
}

}  // namespace

PYBIND11_MODULE_PYINIT(engine, pybind11::mod_gil_not_used())
PYBIND11_MODULE_EXEC(engine, m) {
  // The base class is used by this module alone: CMakeLists.txt.
  auto* const base =
      reinterpret_cast<PyTypeObject*>(pybind11::detail::get_internals().instance_base);
  base->tp_new = &refuse;
  m.doc() = "The engine. Use it through `cncsub`; nothing here is public by itself.";
  m.attr("__version__") = CNCSUB_VERSION;
  cncsub::bindings::add_controls(m);
  cncsub::bindings::add_codes(m);
  cncsub::bindings::add_alarms(m);
  cncsub::bindings::add_files(m);
  cncsub::bindings::add_code(m);
  cncsub::bindings::add_references(m);
  cncsub::bindings::add_check(m);
  cncsub::bindings::add_trace(m);
  cncsub::bindings::add_machine(m);
  cncsub::bindings::add_flat(m);
  cncsub::bindings::add_comparison(m);
  cncsub::bindings::add_coverage(m);
}

/// Make this thread allocate its memory for exceptions now, while there is some. It does so at its
/// first throw otherwise, and the C library ends the process where there is none then.
static bool prepare_exceptions() {
  constexpr std::size_t kEnough = 1 << 16;
  void* const some = std::malloc(kEnough);
  std::free(some);
  return some != nullptr && std::uncaught_exceptions() == 0;
}

/// Refuse a second interpreter of the process before anything waits for the first one.
extern "C" PYBIND11_EXPORT PyObject* PyInit__core() {
  if (!prepare_exceptions()) return PyErr_NoMemory();
  if (PyInterpreterState_Get() == PyInterpreterState_Main()) return PyInit_engine();
  PyErr_SetString(PyExc_ImportError,
                  "cncsub works in the main interpreter only; use threads or processes");
  return nullptr;
}
