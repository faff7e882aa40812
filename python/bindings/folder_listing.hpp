// What a folder holds, found without Python.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "cncsub/text/interrupt_check.hpp"

namespace cncsub::bindings {

/// The names in a folder, in the order of files: without regard to case, numbers by their value.
/// Nothing is opened, and no link is followed.
struct FolderListing {
  std::vector<std::string> files;    // regular files that nothing can be said against
  std::vector<std::string> folders;  // the same
  std::vector<std::string> others;   // to be looked at: links, hidden names, devices, ...
  bool ordered = true;  // false: names beyond ASCII are among them, nothing is in order
  int error = 0;        // of the system, where the folder was not read
};

/// `endings`: of files that are no programs, in small letters, with their dot.
FolderListing list_folder(const std::string& path, const std::unordered_set<std::string>& endings,
                          InterruptCheck& interrupt);

}  // namespace cncsub::bindings
