// Fuzzes running: any program on any control, with parameters, rules, options, inputs and setup
// from the input too, in every way there is.
#include "laws.hpp"

namespace cncsub::fuzz {

namespace {

constexpr std::size_t kLongest = 1 << 14;  // bytes of a program

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > kLongest) return -1;
  try_all_ways(run_job(data, size));
  return 0;
}

}  // namespace cncsub::fuzz
