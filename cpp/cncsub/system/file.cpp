#include "cncsub/system/file.hpp"

#include <sys/stat.h>

#include <cerrno>

#include "cncsub/system/wide.hpp"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#else
#include <fcntl.h>
#include <unistd.h>
#endif
#ifdef __linux__
#include <sys/syscall.h>
#endif

namespace cncsub::system {

namespace {

#ifdef _WIN32

using Status = struct _stat64;

int open_file(const std::string& path) {
  return _wopen(wide(path).c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}
void close_file(int number) { _close(number); }
int ask(int number, Status& status) { return _fstat64(number, &status); }
bool is_regular(const Status& status) { return (status.st_mode & _S_IFMT) == _S_IFREG; }
std::ptrdiff_t read_file(int number, char* into, std::size_t most, std::uint64_t from) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(from);
  place.OffsetHigh = static_cast<DWORD>(from >> 32U);
  auto* const file = reinterpret_cast<HANDLE>(_get_osfhandle(number));  // NOLINT: as it is given
  DWORD count = 0;
  if (ReadFile(file, into, static_cast<DWORD>((std::min)(most, kMost)), &count, &place) != 0)
    return count;
  if (GetLastError() == ERROR_HANDLE_EOF) return 0;
  errno = EIO;
  return -1;
}

#else

using Status = struct stat;

int open_file(const std::string& path) {
  return open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
}
void close_file(int number) { close(number); }
int ask(int number, Status& status) { return fstat(number, &status); }
bool is_regular(const Status& status) { return S_ISREG(status.st_mode); }
std::ptrdiff_t read_file(int number, char* into, std::size_t most, std::uint64_t from) {
  return ::pread(number, into, most, static_cast<off_t>(from));
}

#endif

}  // namespace

File::File(const std::string& path) {
  do number_ = open_file(path);
  while (number_ < 0 && errno == EINTR);
  if (number_ < 0) error_ = errno;
}

File::~File() {
  if (number_ >= 0) close_file(number_);
}

File::Facts File::facts() {
  Status status{};
  if (ask(number_, status) != 0) {
    error_ = errno;
    return {};
  }
  return {true, is_regular(status), static_cast<std::uint64_t>(status.st_size)};
}

std::ptrdiff_t File::read(char* into, std::size_t most, std::uint64_t from) const {
  while (true) {
    const std::ptrdiff_t count = read_file(number_, into, most, from);
    if (count >= 0) return count;
    if (errno != EINTR) return -errno;
  }
}

// The thread sanitizer knows the numbers of one table only.
#if defined(SYS_close_range) && !defined(__SANITIZE_THREAD__)
void open_files_apart() {
  constexpr unsigned kFirst = 3;  // messages of the last moment go to those before it
  constexpr unsigned kApart = 2;  // CLOSE_RANGE_UNSHARE: what is closed was never copied
  syscall(SYS_close_range, kFirst, ~0U, kApart);
}
#else
void open_files_apart() {}
#endif

}  // namespace cncsub::system
