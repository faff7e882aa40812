// The contents of a folder, found without Python.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "cncsub/text/interrupt_check.hpp"

namespace cncsub::bindings {

/// The names in a folder, in the order of files: without regard to case, numbers by their value. No
/// file is opened and no link is followed.
struct FolderListing {
  std::vector<std::string> files;    // regular files without any objection
  std::vector<std::string> folders;  // folders without any objection
  std::vector<std::string> others;   // to be checked by Python: links, hidden names, devices, ...
  bool ordered = true;               // false where a name is beyond ASCII: nothing is in order
  int error = 0;                     // of the system, where the folder was not read
};

/// List a folder. `endings` are those of files that are no programs, in small letters, with their
/// dot.
FolderListing list_folder(const std::string& path, const std::unordered_set<std::string>& endings,
                          InterruptCheck& interrupt);

}  // namespace cncsub::bindings
