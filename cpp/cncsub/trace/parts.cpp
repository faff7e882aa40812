#include "cncsub/trace/parts.hpp"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace cncsub {

namespace {

constexpr std::size_t kRowBytes = 8;  // that working out a row is worth, between two questions

/// Threads that help, as many as the system gives, until this ends.
class Helpers {
 public:
  Helpers(std::size_t count, const std::function<void()>& work) {
    threads_.reserve(count);
    try {
      while (threads_.size() < count) threads_.emplace_back(work);
    } catch (const std::system_error&) {  // those there are do all
      return;
    }
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;
  ~Helpers() {
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  std::vector<std::thread> threads_;
};

}  // namespace

void in_parts(std::size_t rows, InterruptCheck* interrupt,
              const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t pieces = (rows + kPieceRows - 1) / kPieceRows;
  if (pieces == 0) return;
  std::atomic<std::size_t> next = 0;
  const auto one = [&] {  // false where none is left
    const std::size_t piece = next.fetch_add(1, std::memory_order_relaxed);
    if (piece >= pieces) return false;
    work(piece * kPieceRows, std::min(rows, (piece + 1) * kPieceRows));
    return true;
  };
  const std::size_t cores = std::max<std::size_t>(1, std::thread::hardware_concurrency());
  const Helpers helpers(std::min(cores, pieces) - 1, [&] {
    while (one()) {
    }
  });
  while (one())
    if (interrupt != nullptr && interrupt->requested(kPieceRows * kRowBytes)) next = pieces;
}

}  // namespace cncsub
