// The text of a file between its reading and its compiling.
#pragma once

#include <string>
#include <vector>

#include "cncsub/code/program.hpp"

namespace cncsub::bindings {

/// The bytes of a file, put together while it is read: memory that is touched once.
struct Text {
  std::string text;
  bool utf8 = false;  // without a mark of the order of bytes: it is compiled as it is
};

/// Files of a folder that are UTF-8, one behind the other.
struct Texts {
  std::vector<SourceFile> files;
};

}  // namespace cncsub::bindings
