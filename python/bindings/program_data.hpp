// One program of a library.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>

#include "cncsub/code/code.hpp"

namespace cncsub::bindings {

struct ProgramData {
  std::shared_ptr<const Code> code;
  std::size_t index;

  const Program& program() const { return code->programs[index]; }
  const SourceFile& file() const { return code->files[program().file]; }
  const Block& block(std::size_t i) const {
    if (i >= program().last - program().first) throw pybind11::index_error("no such block");
    return code->blocks[program().first + i];
  }
};

}  // namespace cncsub::bindings
