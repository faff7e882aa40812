// The data of the edges of tools, which variables name by three numbers: $TC_DP3[5,1].
#pragma once

#include <cstdint>

namespace cncsub {

/// A datum of an edge: which one, of which edge and tool. As one number it is an index among the
/// variables of VariableKind::EdgeDatum.
struct EdgeDatum {
  std::int32_t datum = 0, edge = 1, tool = 0;

  static constexpr std::int32_t kData = 36, kEdges = 20,
                                kTools = 40'000;  // more than any control has
  static constexpr std::int32_t kNumbers = kData * kEdges * kTools;

  std::int32_t number() const { return (datum * kTools + tool) * kEdges + edge; }
  static EdgeDatum of(std::int32_t number) {
    return {number / kEdges / kTools, number % kEdges, number / kEdges % kTools};
  }
};

}  // namespace cncsub
