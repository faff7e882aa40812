// The state of the axes and of everything modal: plain values, so that a copy is a snapshot.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "cncsub/code/block_codes.hpp"
#include "cncsub/control/control.hpp"
#include "cncsub/motion/state/frames.hpp"
#include "cncsub/motion/state/offset_tables.hpp"
#include "cncsub/trace/moves.hpp"

namespace cncsub {

/// Return X, Y and Z of a mask of letters as bits of the axes.
constexpr std::uint32_t straight_axes(std::uint32_t letters) { return letters >> ('X' - 'A') & 7u; }

/// A motion that is not yet in the table. Its end is without tool offsets, in coordinates from
/// ModalValues::origin.
struct Piece {
  MoveKind kind = MoveKind::Rapid;
  std::uint32_t step = 0;
  Axes end{};
  std::uint32_t named = 0;         // axes with a word, bit i = kAxisNames[i]
  std::array<double, 3> centre{};  // of an arc, from the origin too
  Plane plane = Plane::XY;
  double turn = 0;     // of an arc: the angle run through, plus = counter-clockwise
  double seconds = 0;  // of a dwell
  int side = 0;        // radius compensation: -1 left, 1 right, 0 off
  double radius = 0;
  std::array<double, 3> tip{};  // of a lathe: from the nose centre to the imaginary tip
  char corner = 0;  // 'C', 'L' (by the chamfer's length) or 'R' between this piece and the next
  double corner_size = 0;
  double corner_feed = 0;     // of what is put in at the corner; 0: the feed of a side
  bool modal_corner = false;  // the round holds for all moves, not for this one alone
  bool corner_piece = false;  // put in between two blocks
  SkipMove skip = SkipMove::No;
  std::uint32_t at = 0;  // its block, for faults
  Axes offset{};         // from work coordinates to those
  Axes length{};         // from those to the machine's
  MoveState state;
  // A compensated move that waits by its own normal: its programmed path in the plane, and the
  // vector from its end to where the tool ends.
  std::array<double, 2> way{}, beside{};

  bool operator==(const Piece&) const = default;
};

/// Pieces that wait. There are nearly always none, and to copy none over none costs a comparison.
struct Pieces : std::vector<Piece> {
  using std::vector<Piece>::vector;
  Pieces() = default;
  Pieces(const Pieces&) = default;
  Pieces(Pieces&&) = default;
  Pieces& operator=(Pieces&&) = default;
  Pieces& operator=(const Pieces& other) {
    if (!empty() || !other.empty()) std::vector<Piece>::operator=(other);
    return *this;
  }
  ~Pieces() = default;
};

/// A line of which only the angle is known, until the next block tells its end.
struct PendingAngle {
  double angle = 0;  // degrees
  Pieces line;       // one or none
  int idle = 0;      // blocks without a move after it

  bool waiting() const { return !line.empty(); }

  bool operator==(const PendingAngle&) const = default;
};

/// The numbers of the moves that wait. A copy is one of bytes.
struct LookaheadValues {
  Axes corner_from{};     // where the block with a corner starts, from the origin
  Axes radius_from{};     // where the first of the compensated moves starts
  Axes radius_to{};       // where the last compensated move in the plane ended
  std::size_t step = 0;   // where in `radius` a low step waits for the move after it; 0: none
  Axes step_from{};       // where that step starts
  bool moved = false;     // a move in the plane came in this block
  bool starting = false;  // that move is the start-up
  bool engaged = false;   // the tool is off the programmed path
  std::array<double, 2>
      vector{};  // from the programmed point to the tool, in the plane, radius values
  std::array<double, 2> entered{};  // the direction of the compensated move before
  int idle = 0;                     // blocks without a move in the plane, in a row
  bool round_ended = false;         // a block without a move ended the round of all moves
  std::array<double, 2> begun{};    // by own normals: where the first of `radius` starts
  bool begun_known = false;
  bool ended = false;  // by own normals: G40 came, and no move yet that leads to the path

  bool operator==(const LookaheadValues&) const = default;
};

/// Moves that wait because the next one decides where they end.
struct LookaheadQueue : LookaheadValues {
  Pieces corner;  // a block with a chamfer or a corner round
  Pieces radius;  // a compensated move, and after it those that do not move in the plane

  bool operator==(const LookaheadQueue&) const = default;
};

struct CycleData {
  Meaning cycle = Meaning::CycleOff;
  GCode code;
  double r = 0, z = 0;  // as written
  bool r_incremental = false, z_incremental = false, has_r = false, has_z = false;
  double q = 0, k = 0, p = 0;
  double shift_x = 0, shift_y = 0;  // I J of G76 and G87
  bool has_q = false, has_k = false, has_shift = false;
  double clearance = -1;  // D of a lathe
  bool full = false;      // draws back all the way after a peck, J1 of a lathe
  double initial = 0;     // the level from which the cycle mode was entered

  bool operator==(const CycleData&) const = default;
};

/// X Z R J K of the lathe's simple cycles and threads, kept until another motion code.
struct TurnData {
  double x = 0, z = 0, r = 0;
  bool has_x = false, has_z = false;
  double j = 0, k = 0;  // the run-out of a thread
  bool has_j = false, has_k = false;
  int starts = 1;  // of a thread

  bool operator==(const TurnData&) const = default;
};

/// The first blocks of the two-block cycles G71 to G76.
struct MultipleData {
  double depth = 0, escape = 0;     // G71 U R, G72 W R
  double shift_x = 0, shift_z = 0;  // G73 U W
  int passes = 1;                   // G73 R
  bool has_depth = false, has_escape = false;
  double retract = 0;                             // G74 G75 R
  int finish_passes = 1, chamfer = 0, angle = 0;  // G76 P
  double least_cut = 0, allowance = 0;            // G76 Q R

  bool operator==(const MultipleData&) const = default;
};

/// The area of G22: machine coordinates of X, Y and Z.
struct StrokeArea {
  std::array<double, 3> low{}, high{};
  bool known = false;

  bool operator==(const StrokeArea&) const = default;
};

struct Transform {  // rotation, scaling and mirror
  bool rotation = false, scaling = false, mirror = false;
  std::array<double, 3> centre{}, scale_centre{}, scale{1, 1, 1}, mirror_at{};
  double angle = 0;
  Plane plane = Plane::XY;
  bool frame = false;  // the centre is the zero point of rotated coordinates
  std::uint32_t mirrored = 0;

  bool operator==(const Transform&) const = default;
};

/// The frame that lies over the offsets of the work system: that of the program, in the matrix of
/// the work system. Points are turned, scaled and mirrored by a matrix, then shifted.
struct GeneralFrame {
  Matrix matrix = kUnitMatrix;
  Axes shift{};
  bool turned = false;  // the matrix is not that of a shift alone

  double operator()(int row, int column) const {
    return matrix[3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
  }
  bool operator==(const GeneralFrame&) const = default;
};

/// The numbers of the modal state. A copy is one of bytes.
struct ModalValues {
  // The fast path of lines and arcs reads and writes these.
  bool plain = false;  // nothing but G00 to G03 with words for X Y Z F and a centre can happen
  bool incremental = false;
  std::uint8_t motion_code = 0;  // where `plain`: 1 is G01
  std::uint32_t row_state = 0;
  const Moves* row_moves = nullptr;  // the table row_state belongs to; only compared
  double unit = 1;                   // mm in one unit of the program
  double feed_unit = 1;              // mm in one unit of F, where it counts lengths
  double feed = 0;                   // mm/min, mm/rev
  double seconds_per_mm = 0;
  double time = 0;
  Axes work{};              // the programmed point, work coordinates
  Axes tool_at{};           // machine position after the last recorded move; kept where not `plain`
  double lead = 0;          // of threads, where it is kept apart from the feed
  std::uint32_t named = 0;  // axes that moves named
  bool tool_pending = false;  // a tool offset waits for the next move
  bool moved_before = false;  // a move came, or set coordinates: the head of the program is over

  double polar_angle = 0;
  bool polar_known = false;
  CycleData cycle;
  TurnData turn;

  double x_share = 1;                     // squared share of X in a path's length
  std::array<double, 3> rapid_seconds{};  // per unit of the axis

  Axes offset{};  // work to base: zero points, shift, local
  // What pieces count from, base: the zero point of the work coordinates. A path is worked out in
  // the programmed numbers, wherever these lie on the machine. While moves wait, the origin stays
  // the zero point of the first of them.
  Axes origin{};
  Axes length{};  // base to machine: tool length
  Axes shift{}, local{};
  Axes kept_shift{};     // what the shift becomes when it is restored
  bool shifted = false;  // `kept_shift` counts
  Axes tool_shift{};     // lathe tool offset as a shift of the work coordinates
  Axes middle{};         // intermediate point of G28, base
  std::uint32_t middle_known = 0;
  // The angle of the work coordinates to the machine's, in radians about Z, counter-clockwise. What
  // is called base and machine here is rotated back by it, so that it differs from work by an
  // offset.
  double frame_angle = 0;
  bool diameter = false;               // X words count twice
  std::array<double, 2> spline_way{};  // from the end of a spline along its direction there
  bool skip_touched = false;           // the signal of the last skip came
  // The zero point and the rotation in force, where variables of its work system were written
  // since.
  bool zero_is_held = false;
  Axes zero{};
  double zero_turn = 0;    // degrees
  double feed_before = 0;  // the feed of G94 or G95 before G93, where each cut has its own
  // Whether the control has set the last skip, the work system and the shift since a program wrote
  // their variables. Until then what was written counts.
  std::array<bool, 3> set_anew{};
  int length_axis = 2;
  Axes skip{};                          // skip position: work coordinates, tool included
  Axes measured{}, measured_machine{};  // the same point in the frame of its block, and the machine
  std::array<GCode, kGroups> modal{};
  Plane plane = Plane::XY;
  int work_system = 1;                                 // 1 to 6, 0 = extra
  int extra_system = 0;                                // G54.1 P
  double speed = 0, surface_speed = 0, max_speed = 0;  // S of G97, of G96, limit
  bool surface = false;
  bool turns = false;        // the spindle turns
  bool backward = false;     // counter-clockwise
  bool rigid_waits = false;  // M29 came, its tapping cycle did not yet
  bool rigid = false;        // the cycle in force came after M29
  bool data_set = false;     // a G10 came
  int b = 0, h = 0, d = 0, t = 0;
  int tool = 0, tool_offset = 0;
  double given_radius = 0;  // of a radius compensation without an offset number
  bool no_motion = false;   // after G80, where no motion code is in force then
  int cycle_before = -1;    // ten times the code of the cycle that was in force before it
  MultipleData multiple;
  Transform transform;
  GeneralFrame frame;
  // The changes of offsets that no move along their axes has made yet, where increments make them.
  Axes unmoved{};
  std::array<double, 3> pole{};  // from which polar words count, in programmed coordinates
  // The direction of the last move in programmed coordinates, zero: none. Kept where a program has
  // arcs that go on from it.
  std::array<double, 3> heading{};
  std::array<double, 3> axis_feeds{};  // of moves beside the path, mm/min; 0: the axis' own
  double modal_round = 0;              // the corner round of all moves, mm; 0: none
  double corner_feed = 0;     // the feed of all chamfers and corner rounds, mm/min or mm/rev
  double contour_offset = 0;  // what a compensated radius is larger by, mm
  StrokeArea area;

  bool operator==(const ModalValues&) const = default;
};
static_assert(std::is_trivially_copyable_v<ModalValues>);

/// Everything modal.
struct ModalState : ModalValues {
  PendingAngle pending_angle;
  LookaheadQueue lookahead;

  bool operator==(const ModalState&) const = default;
};

/// The whole state of the motion. A copy is a snapshot: it shares the offset tables.
struct MotionState : ModalState {
  OffsetTables tables;
  Shared<Frames> frames;  // what ModalValues::frame is made of

  bool operator==(const MotionState&) const = default;
};

struct MotionFacts;  // what never changes during a run

/// The facts and the state, for code that only reads them.
struct MotionView {
  const MotionFacts& facts;
  const MotionState& state;
};

}  // namespace cncsub
