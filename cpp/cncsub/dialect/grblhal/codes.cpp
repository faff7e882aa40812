#include "cncsub/dialect/grblhal/codes.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace cncsub::grblhal {

namespace {

struct Group {
  int number;
  std::initializer_list<int> codes;

  bool has(int code) const { return std::find(codes.begin(), codes.end(), code) != codes.end(); }
};

// Codes are in tenths.
const Group kGGroups[] = {
    {1, {40, 100, 280, 281, 300, 301, 530, 920, 921, 922, 923}},
    {2, {0, 10, 20, 30, 50, 51, 382, 383, 384, 385, 730, 800, 810, 820, 830, 850, 860, 890}},
    {3, {170, 180, 190}},
    {4, {900, 910}},
    {5, {911}},
    {6, {930, 940}},
    {7, {200, 210}},
    {8, {400}},
    {9, {431, 490}},
    {10, {540, 550, 560, 570, 580, 590, 591, 592, 593}},
    {11, {610}},
    {12, {980, 990}},
    {13, {500, 510}},
    {14, {650, 660, 661, 670}},
};

const Group kMGroups[] = {
    {0, {70, 71, 72, 73}}, {4, {0, 1, 2, 30, 60, 99}}, {6, {6, 61}}, {7, {3, 4, 5}},
    {8, {7, 8, 9}},        {9, {48, 49, 50, 51, 53}},  {14, {98}},
};

template <std::size_t N>
int find(const Group (&groups)[N], int code) {
  const auto* const found = std::find_if(std::begin(groups), std::end(groups),
                                         [code](const Group& of) { return of.has(code); });
  return found == std::end(groups) ? -1 : found->number;
}

}  // namespace

int group_of_g(int code10) { return find(kGGroups, code10); }

int group_of_m(int code) { return find(kMGroups, code); }

bool claims_axes(int code10) {
  const Group own{0, {100, 280, 300, 920, 431}};
  return own.has(code10) || (find(kGGroups, code10) == 2 && code10 != 800);
}

bool has_fractions(int number) {
  const Group of{0, {5, 28, 30, 38, 43, 59, 61, 65, 66, 67, 91, 92}};
  return of.has(number);
}

}  // namespace cncsub::grblhal
