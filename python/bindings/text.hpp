// The text of a file between its reading and its compiling.
#pragma once

#include <pybind11/pytypes.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "cncsub/code/program.hpp"

namespace cncsub::bindings {

/// The bytes of a file, joined while it is read, so that its memory is touched once.
struct Text {
  FileText text;
  bool utf8 = false;  // no byte order mark: it compiles as it is
};

inline pybind11::bytes bytes_of(const FileText& text, std::size_t at = 0,
                                std::size_t count = std::string_view::npos) {
  const std::string_view part = text.view().substr(std::min(at, text.size()), count);
  return {part.data(), part.size()};
}

/// Files of a folder that are UTF-8, in one sequence.
struct Texts {
  std::vector<SourceFile> files;
};

}  // namespace cncsub::bindings
