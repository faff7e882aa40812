#include "file_reading.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "cncsub/system/cores.hpp"
#include "cncsub/system/file.hpp"
#include "cncsub/text/helpers.hpp"
#include "cncsub/text/text_start.hpp"
#include "cncsub/text/utf8.hpp"

namespace cncsub::bindings {

namespace {

constexpr std::size_t kPiece = std::size_t{1} << 18;  // small enough for a processor cache
constexpr std::size_t kAlone = 16;         // pieces for which a further thread is worth its start
constexpr std::size_t kAtOnce = 64;        // files for which a further thread is worth its start
constexpr std::size_t kTogether = 16;      // files that a thread takes: they lie side by side
constexpr std::size_t kFileBytes = 4096;   // the work of opening a file, in bytes for the interrupt
constexpr std::size_t kLittle = 16 << 10;  // bytes of the first read
using Stopped = std::function<bool(std::size_t)>;  // called after so many bytes

ReadFile failed(FileFault fault, int error = 0) {
  ReadFile file;
  file.fault = fault;
  file.error = error;
  return file;
}

/// Reads an open file, piece by piece, into a text that has room for it. Several threads read a
/// large file.
class Filling {
 public:
  Filling(const system::File& open, FileText& text) : open_(open), text_(text), end_(text.size()) {}

  /// Read the next piece; return false where none is left.
  bool one() {
    const std::size_t from = next_.fetch_add(kPiece);
    if (from >= text_.size()) return false;
    const std::size_t to = std::min(from + kPiece, text_.size());
    std::size_t at = from;
    // The last byte is spare: only a file that has grown fills it, so it is never asked for alone.
    while (at < to && (at == from || at + 1 != text_.size())) {
      const std::ptrdiff_t count = open_.read(text_.data() + at, to - at, at);
      if (count < 0) error_ = static_cast<int>(-count);
      if (count <= 0) break;
      at += static_cast<std::size_t>(count);
    }
    if (at < to) end_at(at);
    if (!is_ascii(text_.view().substr(from, at - from))) ascii_ = false;
    return true;
  }
  void all(const Stopped& stopped) {
    const std::size_t more = text_.size() / kPiece / kAlone;
    const Helpers helpers(more == 0 ? 0 : std::min(system::cores() - 1, more), [this] {
      while (one()) {
      }
    });
    while (one())
      if (stopped(std::min(kPiece, text_.size()))) next_ = text_.size();
  }

  std::string_view read() const {
    return text_.view().substr(0, std::min<std::size_t>(end_, next_));
  }
  bool ascii() const { return ascii_; }
  int error() const { return error_; }

 private:
  void end_at(std::size_t at) {
    std::size_t end = end_;
    while (at < end && !end_.compare_exchange_weak(end, at)) {
    }
  }

  const system::File& open_;
  FileText& text_;
  std::atomic<std::size_t> next_ = 0, end_;
  std::atomic<bool> ascii_ = true;
  std::atomic<int> error_ = 0;
};

/// Read the bytes of an open file. A file that has grown is read once more.
ReadFile read_open(const system::File& open, std::size_t size, const ReadingBounds& bounds,
                   const Stopped& stopped) {
  for (std::size_t room = size + 1;; room = 2 * room + kPiece) {
    ReadFile file;
    file.text = FileText(room);
    Filling filling(open, file.text);
    filling.one();
    if (filling.error() == 0 && bounds.found && !looks_like_text(filling.read()))
      return failed(FileFault::NotText);
    filling.all(stopped);
    if (filling.error() != 0) return failed(FileFault::NotRead, filling.error());
    const std::string_view text = filling.read();
    if (text.size() == room && room < bounds.largest && !stopped(0)) continue;
    file.utf8 = filling.ascii() || (!text.starts_with(kMarkOfBytes) && is_utf8(text, stopped));
    file.text.shorten(text.size());
    return file;
  }
}

/// Read a small file at once; nothing where it fills the buffer. The read itself shows its size. It
/// is not empty and its folder lists it as a regular file, so that no other question is needed.
std::optional<ReadFile> read_small(const system::File& open, std::size_t largest) {
  std::array<char, kLittle> bytes;  // NOLINT(cppcoreguidelines-pro-type-member-init): written next
  const std::ptrdiff_t count = open.read(bytes.data(), bytes.size(), 0);
  const std::size_t size = count < 0 ? 0 : static_cast<std::size_t>(count);
  if (size == 0 || size == bytes.size() || size > largest) return std::nullopt;
  const std::string_view text(bytes.data(), size);
  if (!looks_like_text(text)) return failed(FileFault::NotText);
  ReadFile file;
  file.text = FileText(text);
  file.utf8 = is_ascii(text) ||
              (!text.starts_with(kMarkOfBytes) && is_utf8(text, [](std::size_t) { return false; }));
  return file;
}

ReadFile read_file(const std::string& path, const ReadingBounds& bounds, const Stopped& stopped) {
  system::File open(path);
  if (!open.is_open()) return failed(FileFault::NotOpened, open.error());
  if (bounds.found)
    if (std::optional<ReadFile> file = read_small(open, bounds.largest)) return std::move(*file);
  const system::File::Facts facts = open.facts();
  if (!facts.known) return failed(FileFault::NotRead, open.error());
  if (!facts.regular) return failed(FileFault::NotRegular);
  if (facts.size > bounds.largest) return failed(FileFault::TooLarge);
  return read_open(open, static_cast<std::size_t>(facts.size), bounds, stopped);
}

/// The files of one call, which several threads take in turn.
class Pool {
 public:
  Pool(const std::vector<std::string>& paths, const ReadingBounds& bounds)
      : paths_(paths), bounds_(bounds), files_(paths.size()) {}

  std::vector<ReadFile> read(InterruptCheck& interrupt) {
    start_helpers();
    work([&](std::size_t bytes) {
      if (interrupt.requested(bytes)) stop_ = true;
      return stop_.load(std::memory_order_relaxed);
    });
    await(interrupt);
    for (std::thread& helper : helpers_) helper.join();
    if (fault_) std::rethrow_exception(fault_);
    return std::move(files_);
  }

 private:
  void start_helpers() {
    const std::size_t wanted = std::min(system::cores(), paths_.size() / kAtOnce + 1) - 1;
    helpers_.reserve(wanted);
    try {
      while (helpers_.size() < wanted) {
        const std::scoped_lock lock(mutex_);
        helpers_.emplace_back([this] { help(); });
        ++busy_;
      }
    } catch (const std::system_error&) {  // NOLINT: those that there are do it
    }
  }

  void help() {
    system::open_files_apart();
    work([this](std::size_t) { return stop_.load(std::memory_order_relaxed); });
    const std::scoped_lock lock(mutex_);
    --busy_;
    ended_.notify_one();
  }

  void work(const Stopped& stopped) noexcept {
    try {
      for (std::size_t i = 0; (i = next_.fetch_add(kTogether)) < paths_.size();)
        for (const std::size_t end = std::min(i + kTogether, paths_.size()); i < end; ++i) {
          if (stopped(kFileBytes)) return;
          files_[i] = read_file(paths_[i], bounds_, stopped);
        }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      fault_ = std::current_exception();
      stop_ = true;
    }
  }

  /// Wait for the other threads, which may still read a large file, and check for an interrupt
  /// meanwhile.
  void await(InterruptCheck& interrupt) {
    constexpr std::size_t kLook = std::size_t{1} << 16;  // bytes between interrupt checks
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::milliseconds(20), [this] { return busy_ == 0; })) {
      lock.unlock();
      if (interrupt.requested(kLook)) stop_ = true;
      lock.lock();
    }
  }

  const std::vector<std::string>& paths_;
  const ReadingBounds& bounds_;
  std::vector<ReadFile> files_;
  std::vector<std::thread> helpers_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::size_t busy_ = 0;
  std::exception_ptr fault_;
};

}  // namespace

std::vector<ReadFile> read_files(const std::vector<std::string>& paths, const ReadingBounds& bounds,
                                 InterruptCheck& interrupt) {
  return Pool(paths, bounds).read(interrupt);
}

}  // namespace cncsub::bindings
