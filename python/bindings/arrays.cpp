// The memory of large arrays.
#include <pybind11/numpy.h>

#include <memory>

#include "bindings.hpp"
#include "cncsub/system/kept_memory.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// The memory of an array. The last array that views it releases it.
class ArrayMemory {
 public:
  explicit ArrayMemory(std::size_t bytes) : at_(system::take_memory(bytes)), bytes_(bytes) {}
  ArrayMemory(const ArrayMemory&) = delete;
  ArrayMemory& operator=(const ArrayMemory&) = delete;
  ~ArrayMemory() { system::give_memory(at_, bytes_); }

  void* at() const { return at_; }

 private:
  void* at_;
  std::size_t bytes_;
};

}  // namespace

py::object empty_array(std::size_t items, std::size_t item_bytes, const std::string& type) {
  const std::size_t bytes = items * item_bytes;
  if (bytes < system::kLargePage) return py::module_::import("numpy").attr("empty")(items, type);
  auto memory = std::make_unique<ArrayMemory>(bytes);
  const py::capsule owner(memory.get(), [](void* of) { delete static_cast<ArrayMemory*>(of); });
  const ArrayMemory* const owned = memory.release();
  return py::array(py::dtype(type), {items}, {item_bytes}, owned->at(), owner);
}

}  // namespace cncsub::bindings
