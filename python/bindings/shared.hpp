// How Python gets objects that a shared pointer holds: a control, code, a machine.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <type_traits>

namespace pybind11::detail {

/// A caster like pybind11's own, except that the new Python object never owns the bare pointer.
/// With pybind11's own it does until it is registered. Where there is no memory to register it, it
/// frees that pointer, which was never allocated by itself.
template <typename T>
  requires std::is_class_v<T>
class type_caster<std::shared_ptr<T>> : public copyable_holder_caster<T, std::shared_ptr<T>> {
 public:
  static handle cast(const std::shared_ptr<T>& from, return_value_policy /*policy*/,
                     handle /*parent*/) {
    return type_caster_generic::cast(typename type_caster_base<T>::cast_sources{from.get()},
                                     return_value_policy::reference, {}, nullptr, nullptr, &from);
  }
};

}  // namespace pybind11::detail
