#include "bindings.hpp"

PYBIND11_MODULE(_core, m, pybind11::mod_gil_not_used()) {
  m.doc() = "The engine. Use it through `cncsub`; nothing here is public by itself.";
  m.attr("__version__") = CNCSUB_VERSION;
  cncsub::bindings::add_controls(m);
  cncsub::bindings::add_alarms(m);
  cncsub::bindings::add_code(m);
  cncsub::bindings::add_trace(m);
  cncsub::bindings::add_machine(m);
}
