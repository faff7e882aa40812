#include "cncsub/dialect/sinumerik/code_groups.hpp"

#include <algorithm>
#include <utility>

namespace cncsub::sinumerik {

namespace {

/// List the groups that a path depends on. [NCI, ggroups.json]
std::vector<CodesOfGroup> groups() {
  std::vector<int> systems{5000, 540, 550, 560, 570};
  for (int code = 505; code <= 599; ++code) systems.push_back(code * 10);
  return {{1,
           {0, 10, 20, 30, 9012, kNoCode, kNoCode, kNoCode, kNoCode, 330, 3310, 3320, kNoCode,
            kNoCode, kNoCode, kNoCode, kNoCode}},
          {6, {170, 180, 190}},
          {7, {400, 410, 420}},
          {8, std::move(systems)},
          {10, {600, 640, 6410, 6420, 6430, 6440, 6450}},
          {12, {6010, 6020, 6030}},
          {13, {700, 710, 7000, 7100}},
          {14, {900, 910}},
          {15, {930, 940, 950, 960, 970}},
          {18, {4500, 4510}},
          {29, {9015, 9014}}};
}

}  // namespace

const CodesOfGroup* codes_of_group(int number) {
  static const std::vector<CodesOfGroup> kAll = groups();
  const auto found = std::find_if(kAll.begin(), kAll.end(),
                                  [number](const CodesOfGroup& of) { return of.number == number; });
  return found == kAll.end() ? nullptr : &*found;
}

}  // namespace cncsub::sinumerik
