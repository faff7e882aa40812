// Loaded before everything else (LD_PRELOAD): the n-th `new` from now on has no memory.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> left{-1};
std::atomic<long> made{0};

void* memory(std::size_t size, std::size_t alignment) {
  ++made;
  if (left.load() >= 0 && left.fetch_sub(1) == 0) throw std::bad_alloc();
  void* got = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (got == nullptr) throw std::bad_alloc();
  return got;
}
}  // namespace

extern "C" {
void fail_after(long n) { left = n; }
long news_so_far() { return made; }
}

// The other forms of `new` and `delete` of the standard library call these.
void* operator new(std::size_t size) { return memory(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t at) {
  return memory(size, static_cast<std::size_t>(at));
}
void operator delete(void* from) noexcept { std::free(from); }
void operator delete(void* from, std::align_val_t /*at*/) noexcept { std::free(from); }
