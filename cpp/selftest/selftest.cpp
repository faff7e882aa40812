// The self-test: runs the rows of a file and says which come out otherwise than on the machine that
// wrote them.
//
//     selftest FILE [EVERY]     EVERY: only each so many-th row, for a machine that is emulated
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "cncsub/system/file.hpp"
#include "run.hpp"
#include "system.hpp"

namespace {

using namespace cncsub::selftest;

constexpr int kMostShown = 20;

/// Return the bytes of a file; print why and return nothing where there is none.
std::optional<std::string> bytes_of(const char* path) {
  cncsub::system::File file(path);
  const auto facts = file.is_open() ? file.facts() : cncsub::system::File::Facts{};
  if (!file.is_open() || !facts.regular) {
    std::fprintf(stderr, "selftest: %s is no file that can be read\n", path);
    return std::nullopt;
  }
  std::string text(static_cast<std::size_t>(facts.size), '\0');
  std::size_t got = 0;
  while (got < text.size()) {
    const std::ptrdiff_t count = file.read(text.data() + got, text.size() - got, got);
    if (count <= 0) break;
    got += static_cast<std::size_t>(count);
  }
  text.resize(got);
  return text;
}

struct Count {
  int rows = 0, passed = 0, failed = 0;
};

void try_row(Row row, Count& count) {
  const std::string name = row.name;
  const std::string wrong = difference(std::move(row));
  if (wrong.empty()) {
    ++count.passed;
  } else if (++count.failed <= kMostShown) {
    std::printf("%s\n  %s\n", name.c_str(), wrong.c_str());
  }
}

int test(const std::string& text, int every) {
  Count count;
  for (const std::string& wrong : system_differences()) {
    ++count.failed;
    std::printf("the system's substitutes: %s\n", wrong.c_str());
  }
  Reader reader(text);
  while (auto row = reader.next())
    if (count.rows++ % every == 0) try_row(std::move(*row), count);
  std::printf("%d passed, %d failed\n", count.passed, count.failed);
  return count.passed > 0 && count.failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2 || count > 3) {
    std::fputs("selftest FILE [EVERY]: FILE is what tools/selftest_rows.py writes\n", stderr);
    return 2;
  }
  try {
    const auto text = bytes_of(arguments[1]);
    const int every = count > 2 ? std::atoi(arguments[2]) : 1;
    return text ? test(*text, every > 0 ? every : 1) : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "selftest: %s\n", error.what());
    return 2;
  }
}
