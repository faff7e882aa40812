#include "cncsub/system/folder.hpp"

#include <utility>

#if __has_include(<dirent.h>) && !defined(_WIN32)
#include <dirent.h>

#include <cerrno>
#else
#include <filesystem>
#include <system_error>
#endif

namespace cncsub::system {

#if __has_include(<dirent.h>) && !defined(_WIN32)

namespace {

EntryKind kind_of(const dirent& entry) {
#ifdef DT_REG
  if (entry.d_type == DT_REG) return EntryKind::File;
  if (entry.d_type == DT_DIR) return EntryKind::Folder;
#endif
  return EntryKind::Other;
}

}  // namespace

int each_entry(const std::string& path, const std::function<bool(std::string, EntryKind)>& use) {
  DIR* const folder = opendir(path.c_str());
  if (folder == nullptr) return errno;
  const struct Close {
    DIR* folder;
    ~Close() { closedir(folder); }
  } close{folder};
  for (;;) {
    errno = 0;
    // Each folder is read by one thread. NOLINTNEXTLINE(concurrency-mt-unsafe)
    const dirent* const entry = readdir(folder);
    if (entry == nullptr) return errno;
    std::string name(static_cast<const char*>(entry->d_name));
    if (name == "." || name == "..") continue;
    if (!use(std::move(name), kind_of(*entry))) return 0;
  }
}

#else

// This does not tell whether a file is hidden, or a folder a junction: every entry is asked for.
int each_entry(const std::string& path, const std::function<bool(std::string, EntryKind)>& use) {
  namespace fs = std::filesystem;
  std::error_code error;
  const std::u8string name(path.begin(), path.end());
  for (fs::directory_iterator at(fs::path(name), error), end; !error && at != end;
       at.increment(error)) {
    const std::u8string found = at->path().filename().u8string();
    if (!use(std::string(found.begin(), found.end()), EntryKind::Other)) return 0;
  }
  return error.value();
}

#endif

}  // namespace cncsub::system
