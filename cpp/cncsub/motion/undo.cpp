#include "cncsub/motion/undo.hpp"

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

/// Takes pieces over, of which there are none nearly always.
void take_pieces(std::vector<Piece>& to, const std::vector<Piece>& from) {
  if (!to.empty() || !from.empty()) to = from;
}

void take_held(Held& to, const Held& from) {
  static_cast<HeldValues&>(to) = from;
  take_pieces(to.corner, from.corner);
  take_pieces(to.radius, from.radius);
}

/// Takes over what a block changes that only moves, `Values` beside what waits.
template <class Values>
void take_moved(ModalState& to, const ModalState& from) {
  static_cast<Values&>(to) = from;
  to.modal[at(Group::Motion)] = from.modal[at(Group::Motion)];
  take_held(to.held, from.held);
}

/// Takes over everything modal.
void take_modal(ModalState& to, const ModalState& from) {
  static_cast<ModalValues&>(to) = from;
  to.angled.angle = from.angled.angle;
  to.angled.idle = from.angled.idle;
  take_pieces(to.angled.line, from.angled.line);
  take_held(to.held, from.held);
}

void take(ModalState& to, const ModalState& from, Changes changes) {
  switch (changes) {
    case Changes::All:
      return take_modal(to, from);
    case Changes::Moves:
      to.modal[at(Group::Radius)] = from.modal[at(Group::Radius)];
      to.d = from.d;
      to.given_radius = from.given_radius;
      return take_moved<MoveValues>(to, from);
    case Changes::Path:
      return take_moved<PathValues>(to, from);
  }
}

}  // namespace

Undo::Undo(MotionState& state, ModalState& before, OffsetLog& log, Moves* moves, Changes changes)
    : state_(state),
      before_(before),
      log_(log),
      moves_(moves),
      rows_(moves != nullptr ? moves->size() : 0),
      changes_(changes) {
  take(before_, state_, changes_);
  log_.clear();
}

void Undo::put_back() {
  take(state_, before_, changes_);
  log_.put_back(state_.tables);
  if (moves_ != nullptr) moves_->truncate(rows_);
}

}  // namespace cncsub
