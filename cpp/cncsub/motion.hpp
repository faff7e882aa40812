// Where the tool goes: a block's words change the modal state, move the axes and leave rows in the
// table of moves.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/code.hpp"
#include "cncsub/control.hpp"
#include "cncsub/motion_state.hpp"
#include "cncsub/moves.hpp"
#include "cncsub/probe.hpp"

namespace cncsub {

/// What was set at the machine before the run. Lengths in mm, X of a lathe as a diameter.
struct Setup {
  std::string machine;           // "mill", "lathe-a", "lathe-b"; empty = the control's own
  std::map<char, double> start;  // work coordinates; an axis not named stands at its machine zero
  std::map<std::string, std::map<char, double>> work_offsets;  // "G54", "EXT", "G54.1 P3"
  std::map<int, double> length_offsets, radius_offsets;        // H, D
  struct Tool {
    std::map<char, double> values;
    int tip = 0;
    double radius = 0;
  };
  std::map<int, Tool> tools;                         // of a lathe, by offset number
  std::map<int, std::map<char, double>> reference;   // machine coordinates, 1 = G28
  std::map<char, double> rapid;                      // mm/min
  std::map<char, std::pair<double, double>> limits;  // machine coordinates
  std::map<char, std::pair<double, double>> area;    // of G22, before the program sets it
  double increment = 0.001;                          // the least input increment
};

/// The blocks N(ns) to N(nf) that a cycle follows.
struct Profile {
  std::vector<NcWords> blocks;
  Address behind = kNowhere;  // the block behind the last of them
  bool right_behind = false;  // the first stands right behind the cycle
};

/// Skip signals, a bit for each: 1 to 8, and those of G36 and G37, one for X, Y and Z each.
using SignalMask = std::uint32_t;
constexpr SignalMask kAnySignal = ~SignalMask{0};
constexpr int kArrivalSignal = 9;  // of X
constexpr int kSkipSignals = kArrivalSignal + 3;
constexpr SignalMask signal_bit(int signal) { return SignalMask{1} << signal; }

/// What is said of a skip signal on the way of one block.
struct SkipSignal {
  enum class Comes : std::uint8_t { AtFraction, AtCoordinate, Never } comes = Comes::AtFraction;
  double value = 0;  // of the way, or in work coordinates, mm
  int axis = 0;
};

/// What is told of the signals that a block watches, and those of which nothing is left.
struct SkipsTold {
  std::vector<SkipSignal> told;
  SignalMask open = 0;
};

/// What a block needs from around it.
struct Outside {
  /// The profile that the running block names.
  std::function<std::optional<Fault>(std::int64_t ns, std::int64_t nf, Profile& profile)> profile;
  /// What was told of these signals for the next block that watches them; of the rest the workpiece
  /// decides.
  std::function<SkipsTold(SignalMask)> skips;
  const Workpiece* workpiece = nullptr;  // in machine coordinates
  /// Whether to break off a block that takes very long; or nothing.
  std::function<bool()> interrupted;

  /// Asks that now and then; `work` is what was done since the last time, a move being 1.
  bool over(std::size_t work) {
    worked += work;
    if (worked < kAskWork || !interrupted) return false;
    worked = 0;
    return interrupted();
  }
  static constexpr std::size_t kAskWork = 1 << 14;
  std::size_t worked = 0;
};

struct MotionFacts;   // what never changes during a run
struct OffsetTables;  // zero points and tool offsets
struct BlockWords;    // a block's words by meaning

class Motion {
 public:
  Motion(std::shared_ptr<const Control> control, const Setup& setup);

  struct Outcome {
    bool moved = false;         // an axis really moved
    bool axis_word = false;     // a motion block with an axis word
    Address behind = kNowhere;  // G71 to G73: the run goes on here, behind the profile
    std::int64_t moves = 0;
    SkipMove skip = SkipMove::No;
    // What the block says and the control does not obey beside something else of the block.
    std::uint32_t dropped = 0;        // addresses, as in a mask
    std::uint16_t dropped_codes = 0;  // the places of G codes among the block's

    void drop(std::uint32_t addresses) { dropped |= addresses; }
  };
  /// Executes the motion words of a block. When it returns a fault nothing has changed.
  std::optional<Fault> execute(const NcWords& words, std::uint32_t step, Moves* moves,
                               Outcome& outcome, Outside& outside);

  /// A block with nothing but G00 or G01 (g 0, 1, or -1 for none), X, Y, Z and F, its values in the
  /// order of the alphabet. Returns false when the state wants the general path; then nothing has
  /// changed.
  bool linear(std::uint32_t mask, const Cell* values, int g, std::uint32_t step, Moves* moves,
              bool& moved);

  /// The same for G02 and G03 (g 2, 3 or -1) with words of a centre. It moves where it is true.
  bool round(std::uint32_t mask, const Cell* values, int g, std::uint32_t step, Moves* moves);

  /// Emits the moves held back for compensation or corners: at M00, M02, M30 and the end of the
  /// run. When it returns a fault nothing has changed.
  std::optional<Fault> finish(std::uint32_t step, Moves* moves);
  /// What M02, M30 and the reset key do.
  void reset();

  /// The axes that addresses (a block's mask) can move, as the columns of the moves are called.
  std::string axes_of(std::uint32_t mask) const;
  /// A workpiece by machine coordinates and true lengths, its zero point where it is now.
  Workpiece placed(Workpiece workpiece) const;
  /// The rows go to another table from now on.
  void forget_table() { s_.row_moves = nullptr; }
  std::int64_t held_pieces() const {
    return static_cast<std::int64_t>(s_.held.corner.size() + s_.held.radius.size());
  }
  std::size_t held_bytes() const {
    return (s_.held.corner.capacity() + s_.held.radius.capacity()) * sizeof(Piece);
  }

  /// Points a fault of the motion at the word of its block, which is written as `block` and begins
  /// at `text` in its file.
  void point_at_word(std::string_view block, std::uint32_t text, Fault& fault) const;

  double time() const { return s_.time; }
  bool in_cycle() const;
  bool compensating() const;
  bool g20() const;
  /// A number without a point at this address, as an argument of a macro.
  double scaled(char address, double value) const;
  /// The least input increment of an address, 0 where it has none.
  double increment(char address) const;

  // System variables. `axis` counts from 0 in the control's order: X Y Z A B C U V W; lathe X Z Y C
  // A B.
  double modal_code(int group) const;
  double modal_word(char address) const;
  double block_end(int axis) const;
  double machine_position(int axis) const;
  double work_position(int axis) const;
  double skip_position(int axis) const;
  double active_length(int axis) const;
  double work_offset(int system, int axis) const;
  void set_work_offset(int system, int axis, double value);
  double extra_offset(int p, int axis) const;
  void set_extra_offset(int p, int axis, double value);
  double offset(VariableKind kind, int number) const;
  void set_offset(VariableKind kind, int number, double value);

  std::vector<std::pair<std::string, double>> position() const;
  std::vector<std::pair<std::string, std::string>> modal() const;

 private:
  using Result = std::optional<Fault>;

  // motion.cpp: a block from its words to its effect.
  void power_on();
  Result run(const NcWords& words, std::uint32_t step, Moves* moves, Outcome& outcome,
             Outside& outside);
  Result read(BlockWords& block) const;
  Result check(const BlockWords& block) const;
  // motion_conflicts.cpp
  Result check_conflicts(const BlockWords& block) const;
  // motion.cpp again
  Result end_waiting(std::uint32_t step, Moves* moves);
  Result set_modes(BlockWords& block);
  Result set_feed(const BlockWords& block);
  Result feed_of(const BlockWords& block, double& feed) const;
  double feed_increment() const;
  Result set_spindle(const BlockWords& block);
  Result one_shot(BlockWords& block);
  void take_motion_code(const BlockWords& block);
  Result motion(BlockWords& block);
  Result straight(BlockWords& block, Meaning meaning);
  Result dwell(BlockWords& block);
  Result need_feed(const BlockWords& block, Meaning meaning) const;
  bool lacks_speed() const;
  // A fault of the motion: `at` is the number of its block.
  Fault fault(Cause cause, const BlockWords& block, std::string detail = {}) const;
  bool tool_waits() const;
  Fault fault_at(char address, Cause cause, const BlockWords& block, std::string detail = {}) const;
  Fault fault_of(int code, Cause cause, const BlockWords& block) const;
  void settle();
  double raw(const BlockWords& block, char address) const;
  double number(const BlockWords& block, char address) const;
  bool corner_address(char name) const;
  Axes target(BlockWords& block, std::uint32_t& named);
  Axes end_point(BlockWords& block, std::uint32_t& named);
  bool goes_with_motion(const BlockWords& block, Meaning once) const;

  // motion_emit.cpp: pieces on their way to the table.
  Axes machine_point() const;
  MoveState move_state() const;
  Piece make_piece(const BlockWords& block, MoveKind kind, const Axes& work_end,
                   std::uint32_t named) const;
  Result move(BlockWords& block, Piece piece);
  Result move(BlockWords& block, MoveKind kind, const Axes& work_end, std::uint32_t named);
  Result move_axis(BlockWords& block, MoveKind kind, int axis, double value);
  Result wait(BlockWords& block, double seconds);
  Result record(const Piece& piece, Moves* moves, const std::array<double, 3>& vector);
  std::array<double, 3> centre_of(const Piece& piece) const;
  double arc_in_plane(const Piece& piece, const Axes& machine) const;
  // motion_travel.cpp
  void set_area(const BlockWords& block);
  bool checks_area() const;
  bool area_is_empty() const;
  Result check_travel(const Piece& piece, const Axes& machine) const;
  Result check_area(const Piece& piece, const Axes& machine) const;
  void arc_reach(const Piece& piece, const Axes& machine, int axis, double& low,
                 double& high) const;
  bool set_plain_feed(double value);
  /// Zero while there is no feed.
  void set_seconds_per_mm() {
    const bool revolutions = s_.modal[at(Group::Feed)].meaning == Meaning::PerRevolution;
    s_.seconds_per_mm =
        s_.feed > 0 ? 60 / (revolutions ? s_.feed * turning(s_.speed) : s_.feed) : 0;
  }
  void new_row_state(Moves& moves);
  void switch_line(int line) {
    s_.line = static_cast<std::uint8_t>(line);
    s_.modal[at(Group::Motion)] = line_codes_[static_cast<std::size_t>(line)];
  }

  // motion_arc.cpp
  Result arc(BlockWords& block, Meaning meaning);
  Result arc_by_radius(BlockWords& block, Piece& piece) const;
  Result arc_by_centre(BlockWords& block, Piece& piece) const;
  Result check_longer(const BlockWords& block, const Axes& end, bool by_radius) const;
  Result arc_by_points(BlockWords& block, Meaning meaning);
  // motion_polar.cpp: polar coordinates, rotation, scaling and mirror.
  void polar_target(BlockWords& block, Axes& end, std::uint32_t& named);
  Result set_turned(BlockWords& block);
  Result set_rotation(BlockWords& block);
  Result set_scaling(BlockWords& block);
  void set_mirror(BlockWords& block);
  double scale_of(const BlockWords& block, char address) const;
  bool turned() const { return s_.turned.rotation || s_.turned.scaling || s_.turned.mirror; }
  void turn_point(Axes& point, std::uint32_t& named) const;
  Axes turned_back(Axes point) const;
  void turn_vector(double& a, double& b, const struct PlaneAxes& plane) const;
  bool mirrored_plane() const;
  // motion_coordinates.cpp
  Axes zero_offset() const;
  void refresh_offset();
  Result set_coordinate(BlockWords& block);
  Result clear_coordinate(BlockWords& block);
  Result set_local(BlockWords& block);
  Result set_data(BlockWords& block);
  Result set_offset_data(BlockWords& block, int l, double p);
  Result set_tool_data(BlockWords& block);
  Result select_work(BlockWords& block);
  Result machine_move(BlockWords& block);
  Result reference(BlockWords& block, int number);
  Result from_reference(BlockWords& block);
  Result check_reference(BlockWords& block);
  // motion_skip.cpp
  Result skip(BlockWords& block);
  Result skip_feed(const BlockWords& block);
  void hold_skip_feed();
  SignalMask signals_of(const BlockWords& block) const;
  double dwell_part(const BlockWords& block) const;
  std::optional<double> signal_on_way(const BlockWords& block, SignalMask signals, Axes& end) const;
  std::optional<double> part_of(const SkipSignal& told, const Axes& end) const;
  std::optional<double> touch(const Workpiece& workpiece, SignalMask signals,
                              const Axes& end) const;
  Result one_way(BlockWords& block);
  // motion_measure.cpp
  struct MeasuringMove;
  Result measure_tool(BlockWords& block);
  Result check_measuring(const BlockWords& block, MeasuringMove& how) const;
  void take_measure(int axis, double off);
  Axes linear_target(BlockWords& block, std::uint32_t& named);
  // motion_tool.cpp: tool words, lengths and radii.
  Result set_tool(BlockWords& block);
  Result set_length(BlockWords& block);
  Result length_axis(BlockWords& block, int& axis) const;
  Result move_by_length(BlockWords& block, const Axes& before);
  Result set_radius(BlockWords& block);
  double radius_value() const;
  Result set_longer(BlockWords& block) const;
  Axes lengthened(const BlockWords& block, Axes end, std::uint32_t named) const;
  std::array<double, 3> tip_vector() const;
  // motion_corner.cpp: chamfers and corner rounds.
  Result corner_words(BlockWords& block, Piece& piece) const;
  Result right_angle_chamfer(const BlockWords& block, Piece& piece) const;
  Result through_corner(Piece piece, Axes from, Moves* moves);
  // motion_angle.cpp: lines by their angle.
  bool angle_word(const BlockWords& block, double& angle) const;
  Result angled(BlockWords& block, Meaning meaning, double angle);
  Result meet_angles(BlockWords& block, Piece second, double angle);
  Result check_angle(const BlockWords& block, bool waited);
  // motion_radius.cpp: radius compensation.
  Result through_radius(Piece piece, const Axes& from, Moves* moves);
  Result flush_radius(Moves* moves);
  Result count_idle(BlockWords& block);
  // motion_cycles.cpp: canned cycles.
  Result enter_cycle(BlockWords& block);
  void end_cycles();
  Result cycle_words(BlockWords& block, int& repeats);
  Result check_tap(const BlockWords& block) const;
  Result canned_cycle(BlockWords& block);
  Result drill(BlockWords& block);
  int drill_axis(int code) const;
  Result drill_down(BlockWords& block, int axis, double r, double z);
  Result drill_up(BlockWords& block, int axis, double r);
  Result peck(BlockWords& block, int axis, double r, double z);
  Result shift_tool(BlockWords& block, const Axes& hole, bool away);
  Result bore_shifted(BlockWords& block, double r, double z);
  Result drilling_cycle(BlockWords& block);
  Result drill_lathe(BlockWords& block);
  // motion_turning.cpp: G90 G92 G94, G74 to G76.
  Result turning_cycle(BlockWords& block, Meaning meaning);
  Result turn_once(BlockWords& block, Meaning meaning);
  Result tap_cycle(BlockWords& block);
  Result check_groove(const BlockWords& block, bool face, double p, double q) const;
  Result grooving(BlockWords& block, Meaning meaning);
  double cycle_length(const BlockWords& block, char address) const;
  // motion_thread.cpp
  struct RunOut {  // radius values
    double along = 0, across = 0;
  };
  struct ThreadForm {  // of G76, radius values
    double height = 0, first = 0, taper = 0;
  };
  bool cuts_thread(const BlockWords& block) const;
  void set_lead(const BlockWords& block);
  Result need_lead(const BlockWords& block) const;
  RunOut run_out(double tenths) const;
  Result cut_thread(BlockWords& block, const Axes& end, std::uint32_t named, RunOut out, double way,
                    double growth);
  Result thread(BlockWords& block, Meaning meaning);
  void take_run_out(const BlockWords& block);
  Result cut_cycle_thread(BlockWords& block, const Axes& end, double tenths, double level);
  Result set_thread_data(BlockWords& block);
  Result read_thread(const BlockWords& block, const Axes& end, ThreadForm& form);
  Result multiple_thread(BlockWords& block);
  // motion_contour.cpp: G70 to G73.
  Result contour(BlockWords& block, Meaning meaning);
  Result finish_contour(BlockWords& block, const std::vector<NcWords>& blocks);
  Result rough_contour(BlockWords& block, Meaning meaning, const Profile& profile);
  void take_one_block(const BlockWords& block, Meaning meaning);
  Result rough_pattern(BlockWords& block, struct Contour& contour);
  Result capture(const std::vector<NcWords>& blocks, Outside& outside,
                 std::vector<Piece>& pieces) const;
  // motion_system.cpp
  int axis_number(int axis) const;
  double shown(int axis, const Axes& values) const;
  OffsetTables& own_tables();
  double& changed(double& place);
  ToolOffsets& changed_tool(int number);
  void put_back();
  void write(Axes& values, int axis, double value);
  static const std::vector<double>* table_of(const OffsetTables& tables, VariableKind kind);

  friend struct Contour;
  friend struct Pockets;
  friend struct RadiusPath;

  std::array<GCode, 4> line_codes_;
  MotionState s_;
  std::shared_ptr<const MotionFacts> facts_;
  std::shared_ptr<OffsetTables> tables_;  // copied before it is written when it is shared
  // What the running block changed in them, as it was before.
  std::vector<std::pair<double*, double>> old_offsets_;
  std::vector<std::pair<int, std::optional<ToolOffsets>>> old_tools_;
  std::vector<Piece>* captured_ = nullptr;  // pieces go here instead of to the table
};

inline bool Motion::linear(std::uint32_t mask, const Cell* values, int g, std::uint32_t step,
                           Moves* moves, bool& moved) {
  MotionState& s = s_;
  const int line = g >= 0 ? g : s.line;
  if (!s.plain || line > 1) return false;
  const bool has_feed = (mask & bit('F')) != 0;
  if (has_feed ? !(values->value > 0) : (line != 0 && !(s.feed > 0))) return false;
  if (line != s.line) switch_line(line);
  if (has_feed && !set_plain_feed((values++)->value)) return false;

  if (moves != nullptr && s.row_moves != moves) new_row_state(*moves);

  const double x = s.work[0], y = s.work[1], z = s.work[2];
  const double unit = s.unit;
  if ((mask & bit('X')) != 0) s.work[0] = (values++)->value * unit + (s.incremental ? x : 0);
  if ((mask & bit('Y')) != 0) s.work[1] = (values++)->value * unit + (s.incremental ? y : 0);
  if ((mask & bit('Z')) != 0) s.work[2] = values->value * unit + (s.incremental ? z : 0);
  const double dx = s.work[0] - x, dy = s.work[1] - y, dz = s.work[2] - z;
  moved = dx != 0 || dy != 0 || dz != 0;
  if (line == 0)
    s.time +=
        std::max(std::max(std::fabs(dx) * s.rapid_seconds[0], std::fabs(dy) * s.rapid_seconds[1]),
                 std::fabs(dz) * s.rapid_seconds[2]);
  else if (moved)  // what stands takes no time, also where the spindle stands
    s.time += std::sqrt(dx * dx * s.half[0] + dy * dy + dz * dz) * s.seconds_per_mm;
  const std::uint32_t axes = mask & (bit('X') | bit('Y') | bit('Z'));
  if (axes == 0) return true;
  s.moved_before = true;
  if (moves == nullptr) return true;
  moves->mark(axes >> ('X' - 'A'));
  moves->push(step, line != 0 ? MoveKind::Feed : MoveKind::Rapid, s.work, s.row_state);
  return true;
}

}  // namespace cncsub
