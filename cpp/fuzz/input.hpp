// What a fuzzer's bytes mean: the files of a memory, a control, and how to run them.
//
// The text stands at the front, so that a seed reads as the program it is; everything else is read
// from the end backwards, so that text can grow without changing what it is run with. Bytes that
// are missing count as 0: a plain program is an input too. `seeds.py` writes the same format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/machine/machine.hpp"

namespace cncsub::fuzz {

/// Separate the texts of an input: a file of the memory, one of the external device, a text typed
/// in MDI. `kNameEnd` stands behind the name of a file that has one.
constexpr char kFile = '\x1c', kExternalFile = '\x1d', kMdi = '\x1e', kNameEnd = '\x1f';

struct Texts {
  std::vector<SourceFile> files;
  std::optional<std::string> mdi;
  bool external_device = false;
};

struct Job {
  Texts texts;
  std::shared_ptr<const Control> control;
  Options options;
  std::size_t main = 0;                                  // of the programs, modulo their count
  std::size_t copied_after = 0;                          // steps before the machine is copied
  std::vector<std::pair<std::int64_t, double>> by_hand;  // variables written at that point
};

/// The memory alone: the last byte names the control.
Job read_job(const std::uint8_t* data, std::size_t size);
/// Everything.
Job run_job(const std::uint8_t* data, std::size_t size);

/// Everything but the texts; what the bytes do not need is left.
Job job_around(const std::uint8_t* data, std::size_t size);

/// The library of a job, and the program to run: never empty. `general_only` as for `compile`.
std::shared_ptr<const Code> library_of(const Job& job, std::int32_t& main,
                                       bool general_only = false);

/// Where a broken claim is noted for another process, unless it is null.
constexpr std::size_t kLongestClaim = 200;
extern char* broken_claim;

/// Stops the fuzzer where a claim about the engine is false.
void claim(bool holds, const char* what);

}  // namespace cncsub::fuzz
