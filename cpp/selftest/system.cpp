#include "system.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string_view>

#include "cncsub/system/decimal.hpp"
#include "cncsub/system/extended.hpp"
#include "cncsub/system/kept_memory.hpp"
#include "cncsub/system/wide.hpp"

namespace cncsub::selftest {

namespace {

using namespace std::string_view_literals;

using Differences = std::vector<std::string>;

struct Written {
  std::string_view text;
  double value;
  std::size_t length;
  system::Decimal form = system::Decimal::General;
};

constexpr double kRefused = -77;
constexpr Written kNumbers[] = {{"12.5", 12.5, 4},      {"-0.25X", -0.25, 5},
                                {".5", 0.5, 2},         {"5.", 5, 2},
                                {"1e3", 1000, 3},       {"1e", 1, 1},
                                {"1E-2", 0.01, 4},      {"1e3", 1, 1, system::Decimal::Fixed},
                                {"0X10", 0, 1},         {"1,5", 1, 1},
                                {"0.1", 0.1, 3},        {"9007199254740993", 9007199254740992, 16},
                                {"1e400", kRefused, 5}, {"1e-400", kRefused, 6},
                                {"0e-400", 0, 6},       {"", kRefused, 0},
                                {".", kRefused, 0},     {"+1", kRefused, 0},
                                {"-", kRefused, 0}};

void check_reading(Differences& wrong) {
  for (const Written& row : kNumbers)
    for (const auto& read : {system::parse, system::parse_by_stream}) {
      double value = kRefused;
      const system::Parsed got = read(row.text, value, row.form);
      if (value != row.value || got.number != (row.value != kRefused) ||
          (got.number && got.length != row.length))
        wrong.push_back("reads '" + std::string(row.text) + "' as " + std::to_string(value));
    }
}

struct Shortest {
  double value;
  std::string_view text;
};
constexpr Shortest kTexts[] = {
    {0.1, "0.1"},       {100000, "1e+05"},  {12345, "12345"},
    {-2.5, "-2.5"},     {1e22, "1e+22"},    {1e-7, "1e-07"},
    {0, "0"},           {21234, "21234"},   {1.0 / 3, "0.3333333333333333"},
    {123456, "123456"}, {5e-324, "5e-324"}, {0.001, "0.001"}};

/// Check numbers of all sizes: a written number reads as itself, and both ways write it alike.
void check_writing(Differences& wrong) {
  for (const Shortest& row : kTexts)
    for (const auto& write : {system::shortest, system::shortest_by_stream})
      if (const std::string got = write(row.value); got != row.text)
        wrong.push_back("writes " + std::string(row.text) + " as " + got);
  std::mt19937_64 random(2026);
  for (int i = 0; i < 20000; ++i) {
    auto value = std::bit_cast<double>(random());
    if (i % 2 == 0) value = static_cast<double>(static_cast<std::int64_t>(random() >> 34U)) / 1000;
    if (!std::isfinite(value)) continue;
    const std::string text = system::shortest_by_stream(value);
    double again = 0, by_stream = 0;
    system::parse(text, again);
    system::parse_by_stream(text, by_stream, system::Decimal::General);
    if (again != value || by_stream != value || text != system::shortest(value))
      wrong.push_back("writes " + system::shortest(value) + " as " + text);
  }
}

/// Check angles against more exact numbers: each is the same double, except for one in thousands,
/// which is the next one.
void check_angles(Differences& wrong) {
  const auto check = [&](const char* what, const auto& by_pairs, const auto& known) {
    std::mt19937_64 random(2026);
    int apart = 0;
    for (int i = -1000; i < 20000; ++i) {
      const double angle = i < 1000 ? i : static_cast<double>(random() >> 20U) / 1e6 - 1e7;
      const double a = by_pairs(angle), b = known(angle);
      if (a != b) ++apart;
      if (!(std::fabs(a - b) <= 3e-16 * std::fabs(b))) apart += 1000;
    }
    if (apart > 40) wrong.push_back(std::string(what) + " by pairs is another one");
  };
  if (system::kHasExtended) {
    check("sine", system::sine_by_pairs, system::extended_sine);
    check("cosine", system::cosine_by_pairs, system::extended_cosine);
    check("tangent", system::tangent_by_pairs, system::extended_tangent);
    check("degrees", system::degrees_by_pairs, system::extended_degrees);
  }
  if (system::sine_by_pairs(30) != 0.5 || system::cosine_by_pairs(90) == 0 ||
      system::degrees_by_pairs(std::asin(system::sine_by_pairs(5))) != 5)
    wrong.emplace_back("angles are not those of extended numbers");
}

void check_paths(Differences& wrong) {
  const auto check = [&](std::string_view from, std::u16string_view to) {
    if (system::wide<std::u16string>(from) != to)
      wrong.push_back("widens '" + std::string(from) + "' to something else");
  };
  check("C:\\job\\O1.nc", u"C:\\job\\O1.nc");
  check("\xe7\xa8\x8b.nc", u"程.nc");
  check("\xf0\x9f\x94\xa7", u"\U0001F527");
  const char16_t half[] = {0xD83D, 0};
  check("\xed\xa0\xbd", half);
  check("\xff\xc3(", u"\xFFFD\xFFFD(");
}

void check_memory(Differences& wrong) {
  constexpr std::size_t kBytes = 3 * system::kLargePage + 5;
  void* const memory = system::allocate_pages(kBytes);
  if (memory == nullptr || reinterpret_cast<std::uintptr_t>(memory) % system::kLargePage != 0)
    wrong.emplace_back("there are no whole pages");
  if (memory != nullptr) std::memset(memory, 1, kBytes);
  system::free_pages(memory);
  for (const std::size_t bytes : {kBytes, system::kLargePage / 5}) {
    void* const taken = system::take_memory(bytes);
    std::memset(taken, 2, bytes);
    system::give_memory(taken, bytes);
    void* const again = system::take_memory(bytes);
    if (system::kMostKept != 0 && again != taken)
      wrong.emplace_back("memory that was given back is not taken again");
    system::give_memory(again, bytes);
  }
}

}  // namespace

Differences system_differences() {
  Differences wrong;
  check_reading(wrong);
  check_writing(wrong);
  check_angles(wrong);
  check_paths(wrong);
  check_memory(wrong);
  return wrong;
}

}  // namespace cncsub::selftest
