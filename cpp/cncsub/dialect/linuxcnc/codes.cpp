#include "cncsub/dialect/linuxcnc/codes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace cncsub::linuxcnc {

namespace {

/// Codes of one modal group.
struct Group {
  std::int8_t number;
  std::initializer_list<int> codes;
};

/// The group of each code; -1 if it is in none.
template <std::size_t N>
using GroupOf = std::array<std::int8_t, N>;

template <std::size_t N>
constexpr GroupOf<N> groups_of(std::initializer_list<Group> groups) {
  GroupOf<N> of{};
  of.fill(-1);
  for (const Group& group : groups)
    for (const int code : group.codes) of[static_cast<std::size_t>(code)] = group.number;
  return of;
}

template <std::size_t N>
int find(const GroupOf<N>& of, int code) {
  return code >= 0 && static_cast<std::size_t>(code) < N ? of[static_cast<std::size_t>(code)] : -1;
}

// Codes are in tenths. [rs274 2.9; LC overview, modal groups]
constexpr auto kGGroups = groups_of<1000>({
    {0, {40, 53, 63, 100, 280, 281, 300, 301, 520, 530, 920}},
    {1, {0,   10,  20,  30,  50,  51,  52,  330, 331, 382, 383, 384, 385, 700, 710, 711, 712,
         720, 721, 722, 730, 740, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890}},
    {2, {170, 171, 180, 181, 190, 191}},
    {3, {900, 910}},
    {4, {901, 911}},
    {5, {930, 940, 950}},
    {6, {200, 210}},
    {7, {400, 410, 411, 420, 421}},
    {8, {430, 431, 432, 490}},
    {10, {980, 990}},
    {12, {540, 550, 560, 570, 580, 590, 591, 592, 593}},
    {13, {610, 611, 640}},
    {14, {960, 970}},
    {15, {70, 80}},
    {16, {921, 922, 923}},
});

constexpr auto kMGroups = groups_of<100>({
    {4, {0, 1, 2, 30, 60, 99}},
    {5, {62, 63, 64, 65, 66, 67, 68}},
    {6, {6, 61}},
    {7, {3, 4, 5, 19, 70, 71, 72, 73}},
    {8, {7, 8, 9}},
    {9, {48, 49, 50, 51, 52, 53}},
});

}  // namespace

int group_of_g(int code10) { return find(kGGroups, code10); }

int group_of_m(int code) { return code >= 100 && code <= 199 ? 10 : find(kMGroups, code); }

}  // namespace cncsub::linuxcnc
