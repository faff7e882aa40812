#include "cncsub/system/cores.hpp"

#include <algorithm>
#include <thread>

#if __has_include(<sched.h>)
#include <sched.h>
#endif

namespace cncsub::system {

std::size_t cores() {
#if defined(CPU_COUNT) && !defined(__EMSCRIPTEN__)  // which declares it and has none
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    return static_cast<std::size_t>(std::max(1, CPU_COUNT(&allowed)));
#endif
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

}  // namespace cncsub::system
