// What the library of Emscripten 3.1 lacks of C++20. The compiler reads this file before every
// other one, in the build for the browser alone: a newer Emscripten does without it.
#pragma once

#include <bit>
#include <memory>
#include <version>

#ifndef __cpp_lib_bit_cast
namespace std {
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif

#ifndef __cpp_lib_smart_ptr_for_overwrite
namespace std {
/// Value-initialises what the library would leave as it is: slower, and the same to whoever writes
/// before he reads.
template <class T, class Allocator>
shared_ptr<T> allocate_shared_for_overwrite(const Allocator& allocator) {
  return allocate_shared<T>(allocator);
}
template <class T>
unique_ptr<T> make_unique_for_overwrite(size_t size) {
  return unique_ptr<T>(new remove_extent_t<T>[size]);
}
}  // namespace std
#endif
