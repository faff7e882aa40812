// Makes programs by the million, runs each in every way there is, and holds the runs to the laws:
//
//     fuzz_programs [--seed 1] [--first 0] [--count 100000] [--seconds S] [--show] SEEDS
//
// SEEDS is a folder of `seeds.py`. A program that breaks a law, crashes or takes too long is made
// as short as it can be and printed with its number; `--first N --count 1 --show` prints it whole.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "generator.hpp"
#include "laws.hpp"

namespace cncsub::fuzz {

namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned kInterruptCheck = 20;  // seconds for one program
constexpr int kMostFound = 10;

struct Arguments {
  std::uint64_t seed = 1, first = 0, count = 100'000;
  double seconds = 0;  // 0 = any
  bool show = false;
  std::string seeds;
};

Arguments arguments_of(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string name = values[i];
    const bool last = i + 1 == count;
    if (name == "--show")
      arguments.show = true;
    else if (name == "--seed" && !last)
      arguments.seed = std::strtoull(values[++i], nullptr, 10);
    else if (name == "--first" && !last)
      arguments.first = std::strtoull(values[++i], nullptr, 10);
    else if (name == "--count" && !last)
      arguments.count = std::strtoull(values[++i], nullptr, 10);
    else if (name == "--seconds" && !last)
      arguments.seconds = std::strtod(values[++i], nullptr);
    else
      arguments.seeds = name;
  }
  return arguments;
}

std::vector<std::vector<std::uint8_t>> read_seeds(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  if (!folder.empty())
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::vector<std::uint8_t>> seeds;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

/// Memory shared with the child: the number of the program that it runs, and the broken claim.
struct Shared {
  std::uint64_t number;
  char claim[kLongestClaim];
};

Shared* shared() {
  static Shared* const memory = [] {
    void* place =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) std::abort();
    broken_claim = static_cast<Shared*>(place)->claim;
    return static_cast<Shared*>(place);
  }();
  return memory;
}

/// Do the work in a child; return whether it reached its end.
template <class Work>
bool survives(bool quiet, Work&& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) std::abort();
  if (child == 0) {
    if (quiet && std::freopen("/dev/null", "w", stderr) == nullptr) _exit(2);
    work();
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) != child) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Return whether a job breaks no law, or another one than this.
bool holds(const Job& job, const std::string& claim) {
  shared()->claim[0] = 0;
  const bool well = survives(true, [&] {
    alarm(kInterruptCheck);
    try_all_ways(job);
  });
  return well || claim != shared()->claim;
}

void print(const Job& job) {
  const Setup& setup = job.options.setup;
  std::printf("control %s, machine \"%s\", trace %d, blocks %lld, copied after %zu%s\n",
              job.control->name.c_str(), setup.machine.c_str(), static_cast<int>(job.options.trace),
              static_cast<long long>(job.options.max_blocks), job.copied_after,
              job.by_hand.empty() ? "" : ", with variables written by hand");
  const auto point = [](const std::string& name, const std::map<char, double>& axes) {
    if (axes.empty()) return;
    std::printf("%s:", name.c_str());
    for (const auto& [axis, value] : axes) std::printf(" %c %.17g", axis, value);
    std::printf("\n");
  };
  point("start", setup.start);
  point("rapid", setup.rapid);
  for (const auto& [name, axes] : setup.work_offsets) point(name, axes);
  for (const auto& [number, axes] : setup.reference) point("reference", axes);
  for (const auto& [number, value] : setup.length_offsets)
    std::printf("H%d %.17g\n", number, value);
  for (const auto& [number, value] : setup.radius_offsets)
    std::printf("D%d %.17g\n", number, value);
  for (const auto& [number, tool] : setup.tools) {
    std::printf("tool %d tip %d R %.17g ", number, tool.tip, tool.radius);
    point("values", tool.values);
  }
  for (const auto& [axis, range] : setup.limits)
    std::printf("limits %c %.17g %.17g\n", axis, range.first, range.second);
  for (const auto& [number, value] : job.options.variables)
    std::printf("#%d = %.17g\n", number, value);
  const auto whole = [](std::string_view text) {  // a NUL does not end it
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::putchar('\n');
  };
  for (const SourceFile& file : job.texts.files) {
    std::printf("--- %s%s\n", file.name.c_str(), file.external ? " (external)" : "");
    whole(file.text.view());
  }
  if (job.texts.mdi) {
    std::puts("--- MDI");
    whole(*job.texts.mdi);
  }
}

/// Leave out what is not needed to break the law: blocks, many at a time first, then words.
template <class Put>
void shorten(Job& job, std::string_view of, const std::string& claim, const Put& put) {
  std::string text(of);
  for (const char* ends : {"\n", "\n XYZABCUVWIJKRPQLFSTHDGM"}) {
    for (std::size_t parts = 16; parts > 0; parts /= 2)
      for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        for (std::size_t left = parts; left > 0 && end < text.size(); --left)
          end = std::min(text.find_first_of(ends, end + 1), text.size());
        const std::string whole = text;
        text.erase(at, end - at);
        put(text);
        if (holds(job, claim)) {
          put(text = whole);
          at = end;
        }
      }
  }
}

void shorten(Job& job, const std::string& claim) {
  const auto without = [&](auto& field) {
    const auto kept = field;
    field = {};
    if (holds(job, claim)) field = kept;
  };
  Setup& setup = job.options.setup;
  without(job.by_hand);
  without(job.options.variables);
  without(job.options.inputs);
  without(setup.start);
  without(setup.work_offsets);
  without(setup.reference);
  without(setup.rapid);
  without(setup.limits);
  without(setup.area);
  without(setup.tools);
  without(setup.length_offsets);
  without(setup.radius_offsets);
  for (SourceFile& file : job.texts.files)
    shorten(job, file.text.view(), claim,
            [&](const std::string& text) { file.text = FileText(text); });
  if (job.texts.mdi)
    shorten(job, *job.texts.mdi, claim, [&](const std::string& text) { job.texts.mdi = text; });
}

int run(const Arguments& arguments) {
  const Generator generator(read_seeds(arguments.seeds));
  if (arguments.show) {
    for (std::uint64_t i = 0; i < arguments.count; ++i)
      print(generator.make(arguments.seed, arguments.first + i));
    return EXIT_SUCCESS;
  }
  const auto started = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - started).count(); };
  const std::uint64_t last = arguments.first + arguments.count;
  std::uint64_t& number = shared()->number;
  number = arguments.first;
  int found = 0;
  while (number < last && found < kMostFound) {
    shared()->claim[0] = 0;
    const bool well = survives(false, [&] {
      for (; number < last && (arguments.seconds == 0 || passed() < arguments.seconds); ++number) {
        alarm(kInterruptCheck);
        try_all_ways(generator.make(arguments.seed, number));
      }
    });
    if (well) break;
    ++found;
    std::printf("program %llu of seed %llu breaks a law; shortened:\n",
                static_cast<unsigned long long>(number),
                static_cast<unsigned long long>(arguments.seed));
    Job job = generator.make(arguments.seed, number);
    shorten(job, std::string(shared()->claim));
    print(job);
    survives(false, [&] {
      alarm(kInterruptCheck);
      try_all_ways(job);
    });
    ++number;
  }
  std::printf("%llu programs, %d broke a law, %.0f s\n",
              static_cast<unsigned long long>(number - arguments.first), found, passed());
  return found == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

}  // namespace cncsub::fuzz

int main(int count, char** values) {
  return cncsub::fuzz::run(cncsub::fuzz::arguments_of(count, values));
}
