#include "cncsub/dialect/linuxcnc/codes.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

namespace cncsub::linuxcnc {

namespace {

struct Group {
  int number;
  std::vector<int> codes;
};

int find(const std::vector<Group>& groups, int code) {
  for (const Group& group : groups)
    if (std::find(group.codes.begin(), group.codes.end(), code) != group.codes.end())
      return group.number;
  return -1;
}

const std::vector<Group>& g_groups() {
  static const std::vector<Group> groups = {
      {0, {40, 53, 63, 100, 280, 281, 300, 301, 520, 530, 920}},
      {1,
       {0,   10,  20,  30,  50,  51,  52,  60,  61,  62,  330, 331, 382, 383, 384, 385, 700, 710,
        711, 712, 720, 721, 722, 730, 740, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890}},
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
  };
  return groups;
}

const std::vector<Group>& m_groups() {
  static const std::vector<Group> groups = {
      {4, {0, 1, 2, 30, 60, 99}},
      {5, {62, 63, 64, 65, 66, 67, 68}},
      {6, {6, 61}},
      {7, {3, 4, 5, 19, 70, 71, 72, 73}},
      {8, {7, 8, 9}},
      {9, {48, 49, 50, 51, 52, 53}},
  };
  return groups;
}

}  // namespace

int group_of_g(int code10) { return find(g_groups(), code10); }

int group_of_m(int code) { return code >= 100 && code <= 199 ? 10 : find(m_groups(), code); }

}  // namespace cncsub::linuxcnc
