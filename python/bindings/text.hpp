// The text of a file between its reading and its compiling.
#pragma once

#include <string>

namespace cncsub::bindings {

/// The bytes of a file, put together while it is read: memory that is touched once.
struct Text {
  std::string text;
  bool utf8 = false;  // without a mark of the order of bytes: it is compiled as it is
};

}  // namespace cncsub::bindings
