// A file of the system, open for reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace cncsub::system {

/// The mode in which a file is opened: O_RDONLY, which is the same everywhere.
constexpr int kReadOnly = 0;

/// An open file. It opens without waiting for anybody: a pipe that nobody writes opens at once, and
/// is no regular file.
class File {
 public:
  /// Open a path as the system has it: bytes, and UTF-8 where its paths are UTF-16 (Windows), with
  /// what no text holds, such as half a pair, encoded in the same way.
  explicit File(const std::string& path);
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File();

  struct Facts {
    bool known = false;  // the system answered
    bool regular = false;
    std::uint64_t size = 0;
  };

  bool is_open() const { return number_ >= 0; }
  Facts facts();
  /// Read bytes from a place on. Return how many came, 0 at the end; below 0, the negated number of
  /// the error, as in errno. Several threads may read.
  std::ptrdiff_t read(char* into, std::size_t most, std::uint64_t from) const;
  /// Return the number of the error for which it was not opened, or told no facts.
  int error() const { return error_; }

 private:
  int number_ = -1;
  int error_ = 0;
};

/// Give this thread, which opens many files and ends soon, a table of file numbers of its own. In
/// the one table of the process, several threads wait for each other. In the new one only what a
/// process begins with is open: nothing that others opened is kept open by it, nor may be used. On
/// a system that has no such thing, do nothing.
void open_files_apart();

}  // namespace cncsub::system
