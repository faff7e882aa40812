// A file of the system, open for reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace cncsub::system {

/// How a file is opened, for whoever is told of it: O_RDONLY, which is the same everywhere.
constexpr int kReadOnly = 0;

/// Opens without waiting for anybody: a pipe that nobody writes opens at once, and is no regular
/// file.
class File {
 public:
  /// A path as the system has it: bytes, and UTF-8 where its paths are UTF-16 (Windows), with what
  /// no text holds, such as half a pair, encoded in the same way.
  explicit File(const std::string& path);
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File();

  struct Facts {
    bool known = false;  // the system told
    bool regular = false;
    std::uint64_t size = 0;
  };

  bool is_open() const { return number_ >= 0; }
  Facts facts();
  /// Reads bytes from a place on: how many came, 0 at the end; the number of the error, as in
  /// errno, below 0 where it failed. Several threads may read.
  std::ptrdiff_t read(char* into, std::size_t most, std::uint64_t from) const;
  /// The number of the error that it was not opened for, or told no facts.
  int error() const { return error_; }

 private:
  int number_ = -1;
  int error_ = 0;
};

/// For a thread that opens many files and ends soon: the system finds and gives back their numbers
/// in one table of the process, where several threads wait for each other. From here on this thread
/// has a table of its own, in which only what a process begins with is open: nothing that others
/// opened is kept open by it, nor may be used. Nothing happens on a system that has no such thing.
void open_files_apart();

}  // namespace cncsub::system
