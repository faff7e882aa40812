#include "cncsub/motion/state/undo.hpp"

#include "cncsub/motion/state/values.hpp"

namespace cncsub {

ToolOffsets& OffsetLog::change(std::map<int, ToolOffsets>& tools, int number) {
  const auto found = tools.find(number);
  tools_.emplace_back(number, found == tools.end() ? std::nullopt : std::optional(found->second));
  return tools[number];
}

void OffsetLog::put_back(OffsetTables& tables) {
  for (; !offsets_.empty(); offsets_.pop_back()) *offsets_.back().first = offsets_.back().second;
  for (; !tools_.empty(); tools_.pop_back()) {
    const auto& [number, before] = tools_.back();
    if (before)
      tables.tools[number] = *before;
    else
      tables.tools.erase(number);
  }
}

void OffsetLog::clear() {
  offsets_.clear();
  tools_.clear();
}

namespace {

/// Take pieces over. There are nearly always none.
void take_pieces(std::vector<Piece>& to, const std::vector<Piece>& from) {
  if (!to.empty() || !from.empty()) to = from;
}

void take_lookahead(LookaheadQueue& to, const LookaheadQueue& from) {
  static_cast<LookaheadValues&>(to) = from;
  take_pieces(to.corner, from.corner);
  take_pieces(to.radius, from.radius);
}

/// Take over everything modal.
void take_modal(ModalState& to, const ModalState& from) {
  static_cast<ModalValues&>(to) = from;
  to.pending_angle.angle = from.pending_angle.angle;
  to.pending_angle.idle = from.pending_angle.idle;
  take_pieces(to.pending_angle.line, from.pending_angle.line);
  take_lookahead(to.lookahead, from.lookahead);
}

}  // namespace

Undo::Undo(MotionState& state, ModalState& before, OffsetLog& log, Moves* moves)
    : state_(state),
      before_(before),
      log_(log),
      moves_(moves),
      rows_(moves != nullptr ? moves->size() : 0) {
  take_modal(before_, state_);
  log_.clear();
}

void Undo::put_back() {
  take_modal(state_, before_);
  log_.put_back(state_.tables);
  if (moves_ != nullptr) moves_->truncate(rows_);
}

}  // namespace cncsub
