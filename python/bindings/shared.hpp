// How Python is given what it holds by a shared pointer: a control, code, a machine.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <type_traits>

namespace pybind11::detail {

/// As pybind11's own, but the new object of Python never owns the bare pointer, only the shared
/// one. With pybind11's own it owns the bare pointer until it is registered, and where there is no
/// memory to register it that pointer, which was never allocated by itself, is freed.
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
