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

/// The characters that separate the texts of an input: a file of the memory, one of the external
/// device, a text typed in MDI. `kNameEnd` stands after the name of a file that has one.
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
  std::size_t main = 0;                                  // the program to run, modulo the count
  std::size_t copied_after = 0;                          // steps before the machine is copied
  std::vector<std::pair<std::int64_t, double>> by_hand;  // variables written at that point
};

/// Read the memory alone; the last byte names the control.
Job read_job(const std::uint8_t* data, std::size_t size);
/// Read a whole job.
Job run_job(const std::uint8_t* data, std::size_t size);

/// Read everything except the texts. Bytes that are not needed are left.
Job job_around(const std::uint8_t* data, std::size_t size);

/// Return the library of a job, which is never empty, and the program to run. `general_only` is as
/// for `compile`.
std::shared_ptr<const Code> library_of(const Job& job, std::int32_t& main,
                                       bool general_only = false);

/// Memory in which a broken claim is recorded for another process, unless it is null.
constexpr std::size_t kLongestClaim = 200;
extern char* broken_claim;

/// Stop the fuzzer where a claim about the engine is false.
void claim(bool holds, const char* what);

}  // namespace cncsub::fuzz
