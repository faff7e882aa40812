// The rollback of a block that alarms.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "cncsub/motion/state/state.hpp"

namespace cncsub {

/// The former values of what the running block changed in the offset tables.
class OffsetLog {
 public:
  /// Log an offset that is about to change, and return it.
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

/// The rollback of the state and of the table of moves. Of the offset tables only what changes is
/// kept.
class Undo {
 public:
  /// `before` keeps the state; its memory is used again.
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
