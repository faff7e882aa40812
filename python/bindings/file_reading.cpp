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
#include <span>
#include <system_error>
#include <thread>

#include "cncsub/system/cores.hpp"
#include "cncsub/system/file.hpp"
#include "cncsub/system/memory.hpp"
#include "cncsub/text/helpers.hpp"
#include "cncsub/text/utf8.hpp"

namespace cncsub::bindings {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t kPiece = std::size_t{1} << 20;  // little enough to stay near the processor
constexpr std::size_t kAhead = 4;  // pieces of a large file, one of which is looked at
constexpr std::size_t kSample = 4096;
constexpr std::size_t kAtOnce = 64;  // files for which a further thread is worth its start
constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf"sv;

// First bytes of files that people keep beside their programs.
constexpr std::string_view kOtherStarts[] = {"PK\x03\x04"sv,
                                             "PK\x05\x06"sv,
                                             "%PDF-"sv,
                                             "\x89PNG"sv,
                                             "\xff\xd8\xff"sv,
                                             "GIF8"sv,
                                             "\x7f"
                                             "ELF"sv,
                                             "MZ\x90"sv,
                                             "\x1f\x8b"sv,
                                             "BZh"sv,
                                             "\xfd"
                                             "7zXZ"sv,
                                             "7z\xbc\xaf"sv,
                                             "Rar!"sv,
                                             "SQLite format"sv,
                                             "\xd0\xcf\x11\xe0"sv};
constexpr std::string_view kMarks[] = {kUtf8Mark, "\xff\xfe"sv, "\xfe\xff"sv, "\0\0\xfe\xff"sv};

/// Bytes of no text and no punched tape: those have NUL, tab, line ends, SO, SI, DC1 to DC4 but
/// DLE, the DOS end of file and ESC.
constexpr bool is_strange(char c) {
  constexpr std::uint32_t kKnown = [] {
    std::uint32_t marks = 0;
    for (const char of : "\0\t\n\v\f\r\x0e\x0f\x11\x12\x13\x14\x1a\x1b"sv) marks |= 1U << of;
    return marks;
  }();
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 && (kKnown >> byte & 1U) == 0;
}

bool starts_like(std::string_view bytes, std::span<const std::string_view> starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](std::string_view start) { return bytes.starts_with(start); });
}

using Stopped = std::function<bool(std::size_t)>;  // asked behind so many bytes

FileText failed(FileFault fault, int error = 0) {
  FileText file;
  file.fault = fault;
  file.error = error;
  return file;
}

struct Piece {
  std::unique_ptr<char[]> bytes;  // NOLINT: bytes
  std::ptrdiff_t count = 0;       // 0: the end; -1: the file cannot be read
  bool ascii = true;

  std::string_view text() const { return {bytes.get(), static_cast<std::size_t>(count)}; }
};
using Ring = std::array<Piece, kAhead>;

/// Those that are needed for a file.
std::span<Piece> made(Ring& ring, std::size_t size) {
  const std::span<Piece> used(ring.data(), size > kAhead * kPiece ? kAhead : 1);
  for (Piece& piece : used)
    if (!piece.bytes) piece.bytes = std::make_unique_for_overwrite<char[]>(kPiece);  // NOLINT: bytes
  return used;
}

/// The pieces of an open file, one after the other. Of a large file another thread reads the next
/// ones meanwhile.
class Pieces {
 public:
  Pieces(system::File& open, std::size_t size, std::span<Piece> ring)
      : open_(open),
        size_(size),
        ring_(ring),
        helper_(ring.size() > 1 && system::cores() > 1 ? 1 : 0, [this] { read_ahead(); }) {}
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;
  ~Pieces() {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  /// Is there until the next one is asked for.
  const Piece& next() {
    std::unique_lock lock(mutex_);
    ++taken_;
    changed_.notify_all();
    while (read_ < taken_) {
      if (reading_)
        changed_.wait(lock);
      else
        read_one(lock);
    }
    return ring_[(taken_ - 1) % ring_.size()];
  }

 private:
  void read_ahead() {
    std::unique_lock lock(mutex_);
    while (!ended_) {
      if (!reading_ && read_ + 1 < taken_ + ring_.size())
        read_one(lock);
      else
        changed_.wait(lock);
    }
  }

  void read_one(std::unique_lock<std::mutex>& lock) {
    Piece& piece = ring_[read_ % ring_.size()];
    reading_ = true;
    lock.unlock();
    const std::size_t once = std::min(size_ + 1, kPiece);
    piece.count = at_end_ ? 0 : open_.read(piece.bytes.get(), once);
    piece.ascii = piece.count <= 0 || is_ascii(piece.text());
    lock.lock();
    reading_ = false;
    ++read_;
    if (piece.count > 0) bytes_ += static_cast<std::size_t>(piece.count);
    // Less than was asked for is the end, where the file is as long as the system said.
    at_end_ = piece.count <= 0 || (bytes_ == size_ && piece.count < static_cast<std::ptrdiff_t>(once));
    ended_ = ended_ || at_end_;
    changed_.notify_all();
  }

  system::File& open_;
  const std::size_t size_;
  const std::span<Piece> ring_;
  std::mutex mutex_;  // of all that follows, and of the ring
  std::condition_variable changed_;
  std::size_t read_ = 0, taken_ = 0, bytes_ = 0;
  bool reading_ = false, at_end_ = false, ended_ = false;
  const Helpers helper_;
};

/// The bytes of an open file. One that grows meanwhile is read on.
FileText read_open(system::File& open, std::size_t size, Ring& ring, const ReadingBounds& bounds,
                   const Stopped& stopped) {
  FileText file;
  file.text.reserve(size);
  system::advise_large_pages(file.text.data(), size);
  Pieces pieces(open, size, made(ring, size));
  file.utf8 = true;
  while (file.text.size() < bounds.largest && !stopped(std::min(size + 1, kPiece))) {
    const Piece& piece = pieces.next();
    if (piece.count < 0) return failed(FileFault::NotRead, open.error());
    if (piece.count == 0) break;
    const bool first = file.text.empty();
    if (first && bounds.only_texts && !looks_like_text(piece.text()))
      return failed(FileFault::NotText);
    file.text += piece.text();
    file.utf8 = file.utf8 && piece.ascii;
  }
  file.utf8 = file.utf8 || (!file.text.starts_with(kUtf8Mark) && is_utf8(file.text, stopped));
  return file;
}

FileText read_file(const std::string& path, Ring& ring, const ReadingBounds& bounds,
                   const Stopped& stopped) {
  system::File open(path);
  if (!open.is_open()) return failed(FileFault::NotOpened, open.error());
  const system::File::Facts facts = open.facts();
  if (!facts.known) return failed(FileFault::NotRead, open.error());
  if (!facts.regular) return failed(FileFault::NotRegular);
  if (facts.size > bounds.largest) return failed(FileFault::TooLarge);
  return read_open(open, static_cast<std::size_t>(facts.size), ring, bounds, stopped);
}

/// The files of one call, taken one after the other by several threads.
class Pool {
 public:
  Pool(const std::vector<std::string>& paths, const ReadingBounds& bounds)
      : paths_(paths), bounds_(bounds), files_(paths.size()) {}

  std::vector<FileText> read(InterruptCheck& interrupt) {
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
    work([this](std::size_t) { return stop_.load(std::memory_order_relaxed); });
    const std::scoped_lock lock(mutex_);
    --busy_;
    ended_.notify_one();
  }

  void work(const Stopped& stopped) noexcept {
    try {
      Ring ring;
      for (std::size_t i = 0; (i = next_++) < paths_.size() && !stopped(kSample);)
        files_[i] = read_file(paths_[i], ring, bounds_, stopped);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      fault_ = std::current_exception();
      stop_ = true;
    }
  }

  /// The others may still read a large file: the interrupt is asked meanwhile.
  void await(InterruptCheck& interrupt) {
    constexpr std::size_t kLook = std::size_t{1} << 16;  // bytes behind which a look is due
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::milliseconds(20), [this] { return busy_ == 0; })) {
      lock.unlock();
      if (interrupt.requested(kLook)) stop_ = true;
      lock.lock();
    }
  }

  const std::vector<std::string>& paths_;
  const ReadingBounds& bounds_;
  std::vector<FileText> files_;
  std::vector<std::thread> helpers_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::size_t busy_ = 0;
  std::exception_ptr fault_;
};

}  // namespace

bool looks_like_text(std::string_view bytes) {
  if (starts_like(bytes, kOtherStarts)) return false;
  if (starts_like(bytes, kMarks)) return true;
  const std::string_view sample = bytes.substr(0, kSample);
  const auto strange = std::count_if(sample.begin(), sample.end(), is_strange);
  return static_cast<std::size_t>(strange) * 20 <= sample.size();
}

std::vector<FileText> read_files(const std::vector<std::string>& paths, const ReadingBounds& bounds,
                                 InterruptCheck& interrupt) {
  return Pool(paths, bounds).read(interrupt);
}

}  // namespace cncsub::bindings
