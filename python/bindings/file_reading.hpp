// Files opened and read in parallel, without Python.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/file_text.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub::bindings {

enum class FileFault { None, NotOpened, NotRead, NotRegular, TooLarge, NotText };

/// The bytes of a file, or the reason why there are none.
struct ReadFile {
  FileText text;
  FileFault fault = FileFault::None;
  int error = 0;      // of the system, where the file was not opened or not read
  bool utf8 = false;  // and without a byte order mark
};

struct ReadingBounds {
  std::size_t largest;  // bytes
  bool found;           // in a folder, as regular files: plain non-texts are left out
};

/// Read regular files on all cores. A pipe or a device is never waited for. The result is not
/// usable where the interrupt was requested.
std::vector<ReadFile> read_files(const std::vector<std::string>& paths, const ReadingBounds& bounds,
                                 InterruptCheck& interrupt);

}  // namespace cncsub::bindings
