// The memory of large arrays.
#include <utility>

#include "bindings.hpp"
#include "cncsub/system/kept_memory.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// What an array lies in; it is given back with the last array that looks at it.
class ArrayMemory {
 public:
  explicit ArrayMemory(std::size_t bytes) : at_(system::take_memory(bytes)), bytes_(bytes) {}
  ArrayMemory(ArrayMemory&& other) noexcept
      : at_(std::exchange(other.at_, nullptr)), bytes_(other.bytes_) {}
  ArrayMemory& operator=(ArrayMemory&&) = delete;
  ~ArrayMemory() {
    if (at_ != nullptr) system::give_memory(at_, bytes_);
  }

  py::buffer_info view() const {
    return {static_cast<unsigned char*>(at_), static_cast<py::ssize_t>(bytes_)};
  }

 private:
  void* at_;
  std::size_t bytes_;
};

}  // namespace

py::object empty_array(std::size_t items, std::size_t item_bytes, const std::string& type) {
  const py::module_ numpy = py::module_::import("numpy");
  const std::size_t bytes = items * item_bytes;
  if (bytes < system::kLargePage) return numpy.attr("empty")(items, type);
  return numpy.attr("frombuffer")(py::cast(ArrayMemory(bytes)), type);
}

void add_arrays(py::module_& m) {
  py::class_<ArrayMemory>(m, "ArrayMemory", py::is_final(), py::buffer_protocol())
      .def_buffer([](const ArrayMemory& memory) { return memory.view(); });
}

}  // namespace cncsub::bindings
