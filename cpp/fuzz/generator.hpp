// Whole programs, made of words: rows and examples with changed words, and blocks of every kind
// (cycles with any of their words, profiles, corners, compensation, macros, data), with numbers at
// the edges of every type and of sense.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "input.hpp"

namespace cncsub::fuzz {

class Generator {
 public:
  /// Take seeds, which are inputs of `run_job`.
  explicit Generator(std::vector<std::vector<std::uint8_t>> seeds);

  /// Return the program of a number, with its control, setup and options; the same every time.
  Job make(std::uint64_t seed, std::uint64_t number) const;

 private:
  std::vector<std::vector<std::uint8_t>> seeds_;
  std::vector<std::string> lines_;  // of all seeds
};

}  // namespace cncsub::fuzz
