// What takes a block back that alarms.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "cncsub/motion/state/state.hpp"

namespace cncsub {

/// What the running block changed in the offset tables, as it was before.
class OffsetLog {
 public:
  /// An offset that is about to change.
  double& change(double& place) {
    offsets_.emplace_back(&place, place);
    return place;
  }
  ToolOffsets& change(std::map<int, ToolOffsets>& tools, int number);
  void put_back(OffsetTables& tables);
  void clear();

 private:
  std::vector<std::pair<double*, double>> offsets_;
  std::vector<std::pair<int, std::optional<ToolOffsets>>> tools_;
};

/// The state and the table of moves as they are; of the offset tables only what changes is kept.
class Undo {
 public:
  /// `before`: where the state is kept; the room that it has is used again.
  Undo(MotionState& state, ModalState& before, OffsetLog& log, Moves* moves);
  void put_back();

 private:
  MotionState& state_;
  ModalState& before_;
  OffsetLog& log_;
  Moves* moves_;
  std::size_t rows_;
};

}  // namespace cncsub
