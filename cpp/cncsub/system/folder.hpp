// The entries of a folder of the system.
#pragma once

#include <functional>
#include <string>

namespace cncsub::system {

/// The kind of an entry that the folder itself tells, without asking for the entry.
enum class EntryKind {
  File,
  Folder,
  Other,  // a link, a device, or what this system does not tell: it has to be asked for
};

/// Call `use(name, kind)` for each entry but `.` and `..`, until it returns false. Return the
/// number of the error, as in errno, or 0.
int each_entry(const std::string& path, const std::function<bool(std::string, EntryKind)>& use);

}  // namespace cncsub::system
