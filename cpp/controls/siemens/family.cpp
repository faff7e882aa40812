// The parts that the controls of Siemens share in their own language.
#include "controls/siemens/family.hpp"

#include "cncsub/control/edge_datum.hpp"
#include "controls/facts.hpp"
#include "controls/settings.hpp"

namespace cncsub::siemens {
namespace {

using enum Evidence;

void reading(Control& c) {
  c.reading.max_sequence_number = {99999999, kKnown, Inferred};
  c.reading.g_codes = {
      "0 1 2 3 4 5 7 9 17 18 19 25 26 33 34 35 40 41 42 53 54 55 56 57 58 59 60 62 63 64 70 71 74 "
      "75 90 91 93 94 95 96 97 110 111 112 140 141 142 143 147 148 153 247 248 290 291 331 332 335 "
      "336 340 341 347 348 450 451 460 461 462 500 505 506 507 508 509 510 511 512 513 514 515 516 "
      "517 518 519 520 521 522 523 524 525 526 527 528 529 530 531 532 533 534 535 536 537 538 539 "
      "540 541 542 543 544 545 546 547 548 549 550 551 552 553 554 555 556 557 558 559 560 561 562 "
      "563 564 565 566 567 568 569 570 571 572 573 574 575 576 577 578 579 580 581 582 583 584 585 "
      "586 587 588 589 590 591 592 593 594 595 596 597 598 599 601 602 603 621 641 642 643 644 645 "
      "TRANS ATRANS ROT AROT SCALE ASCALE MIRROR AMIRROR SUPA CIP CT DIAMON DIAMOF POS MEAS "
      "700 710 810 811 812 813 814 815 816 817 818 819 820 821 822 823 824 825 826 827 828 829 931 "
      "942 952 961 962 971 972 973",
      "NCI, ggroups.json: the G groups of the manual", Secondary};
}

void frames_and_tools(Control& c) {
  c.motion.machine_move = {MachineMove::ModalWithTool,
                           "840Dk p.1-7: G53, G153, SUPA; the tool is general knowledge", Inferred};
  c.motion.max_extra_systems = {100, "NCI, ggroups.json: G505 to G599, and G500", Secondary};
  c.motion.extra_system_codes = {500, "NCI, ggroups.json: G505 to G599", Secondary};
  c.motion.tool_edges = {true, "840Dw p.13, MD 20270; the delivered value is general knowledge",
                         Inferred};
  c.motion.max_offset_number = {9999, kKnown, Inferred};
  c.motion.shifts_move_increments = {true, "840Dk p.1-7: SD 42440; NCI, trans2.mpf with its table",
                                     Secondary};
  c.motion.written_offset = {WrittenOffset::WhenProgrammed,
                             "840Dk p.2-58: $P_UIFR is activated by G500, G54 to G599", Manual};
  add_parameter(c, {"24000",
                    0,
                    "1 = shifts that ATRANS adds are the fine shift of the program's frame, which "
                    "TRANS leaves alone: G58 and G59 change either part",
                    "MD840, MD 24000; the delivered value is general knowledge",
                    Secondary,
                    {bit(rule::fine_shift)}});
  c.motion.rotation_words = {"E", "SONE p.309: RPL", Secondary};
}

void paths(Control& c) {
  c.motion.arc_angle_words = {"Q", "5AX p.98: AR", Secondary};
  c.motion.helix = {Helix::AllAxes,
                    "840Dbf p.673: synchronized axes are interpolated with the path", Secondary};
  c.motion.added_turns = {"P", "5AX p.98: TURN", Secondary};
  c.motion.drops_centre_across = {true, "NCI, arc.mpf with its table", Secondary};
  c.motion.poles = {true, "840Df p.118: G110 to G112, RP, AP", Secondary};
  c.motion.chamfer_words = {",C ,D", "840De p.4-72: CHR, CHF", Secondary};
  c.motion.round_words = {",R", "840De p.4-72: RND", Secondary};
  c.motion.corner_idle_blocks = {3, "CNCF, chamfers and roundings: no more than three blocks",
                                 Secondary};
  c.motion.modal_round_words = {"O", "840Df p.193: RNDM", Secondary};
  c.motion.corner_feed_words = {"G", "840Df p.193: FRC", Secondary};
  c.motion.modal_corner_feed_words = {"M", "840Df p.193: FRCM", Secondary};
  c.motion.round_before_chamfer = {true, "808Dm p.89: radius and chamfer in one block", Secondary};
  c.motion.corners_in_rapid = {true, "CNCF, a chamfer that is traversed with G0", Secondary};
  c.motion.corner_reduced = {true, "CNCF, a value that a block has no room for", Secondary};
  add_parameter(c, {"20201#0",
                    0,
                    "the chamfer or the rounding takes its feed from 1 = the block before it, 0 = "
                    "the block after it",
                    "MD840, MD 20201; CNCF, the delivered value",
                    Secondary,
                    {bit(rule::corner_feed_of_next, true, false)}});
  c.motion.contour_offset_words = {"N", "SONE p.251: OFFN", Manual};
  c.motion.angle_words = {",A", "SONE p.220: ANG", Secondary};
  c.motion.angles_on_mills = {true, "SONE p.220: ANG", Secondary};
  c.motion.start_up = {StartUp::TypeA, "general knowledge of the SINUMERIK 840D: NORM", Inferred};
  c.motion.acute_corner = {AcuteCorner::ByCode, "840Df p.364: G450, G451", Secondary};
  c.motion.idle_blocks = {3, "general knowledge of the SINUMERIK 840D: MD 20250", Inferred};
}

void meanings(Control& c) {
  c.motion.g_meanings = {
      "5=not-computed 25=not-computed 26=not-computed 33=thread-by-axis 331=thread-by-axis "
      "332=thread-by-axis 34=thread-growing 35=thread-shrinking 58=frame-shift-by-axis "
      "59=frame-fine-shift-by-axis 60=neutral 63=tapping 70=inch-lengths 71=metric-lengths "
      "74=reference-direct "
      "75=second-reference-direct 96=surface-speed-per-revolution 97=spindle-speed-per-revolution "
      "961=surface-speed-per-minute 971=spindle-speed-per-minute "
      "973=spindle-speed-per-revolution "
      "110=pole-from-tool 111=pole 112=pole-from-pole 153=machine-all 450=corner-arc "
      "451=corner-meet 500=extra-system-100 "
      "TRANS=frame-shift ATRANS=frame-shift-added ROT=frame-rotation AROT=frame-rotation-added "
      "SCALE=frame-scale ASCALE=frame-scale-added MIRROR=frame-mirror AMIRROR=frame-mirror-added "
      "SUPA=machine-all CIP=three-points-by-mode CT=tangent-arc POS=position-axes "
      "MEAS=skip-on-line "
      "DIAMON=diameter DIAMOF=diameter-off "
      "140=neutral 141=neutral 142=neutral 143=neutral 340=neutral 341=neutral 460=neutral "
      "601=neutral 602=neutral 603=neutral 700=inch 710=metric "
      "621=neutral 641=neutral 642=neutral 643=neutral 644=neutral 645=neutral",
      "NCI, ggroups.json", Secondary};
  c.motion.g_meanings.tell("58=frame-shift-by-axis", "SONE p.315: G58", Manual);
  c.motion.g_meanings.tell("59=frame-fine-shift-by-axis", "SONE p.315: G59", Manual);
  c.motion.g_meanings.tell("63=tapping", kKnown, Inferred);
  for (const char* units : {"70=inch-lengths", "71=metric-lengths", "700=inch", "710=metric"})
    c.motion.g_meanings.tell(units, "808Dm p.54: G70, G71, G700, G710", Manual);
  c.motion.g_meanings.tell("MEAS=skip-on-line", "840slj p.5-24: MEAS", Secondary);
  c.motion.g_meanings.tell("CT=tangent-arc", "SONE p.201: CT", Manual);
  c.motion.g_meanings.tell("POS=position-axes", "MD840, MD 32060: positioning axes", Secondary);
  c.motion.g_meanings.tell("96=surface-speed-per-revolution", "SONE p.99: G96", Manual);
  c.motion.g_meanings.tell("97=spindle-speed-per-revolution", "SONE p.99: G97", Manual);
  c.motion.g_meanings.tell("961=surface-speed-per-minute", "SONE p.99: G961", Manual);
  c.motion.g_meanings.tell("971=spindle-speed-per-minute", "SONE p.99: G971", Manual);
  c.motion.g_meanings.tell("973=spindle-speed-per-revolution", "SONE p.99: G973", Manual);
}

void motion(Control& c) {
  meanings(c);
  frames_and_tools(c);
  paths(c);
  c.motion.feed_mode_change = {FeedModeChange::DeletesFeed,
                               "840Dv p.2-4: a change between G93, G94 and G95 deletes F",
                               Secondary};
  c.motion.modal_groups = {
      "motion=1 plane=6 radius=7 work=8 units=13 distance=14 feed=15 corner=18 diameter=29 "
      "surface=30 stroke=31 length=32 return=33 path=34 macro=35 rotation=36 polar=37 scaling=38",
      "NCI, ggroups.json", Secondary};
  c.motion.speed_limit = {SpeedLimit::OwnWord, "SONE p.99: LIMS", Secondary};
  c.motion.unused_words_told = {true, "policy, nobody says", Inferred};
  has(c.common.refuses, {Cause::NoSurfaceSpeed, Cause::FeedOutOfRange},
      "840Dv p.2-9: 10900 and 14800", Secondary);
  has(c.common.refuses, {Cause::NoArcTravel}, "HSA 14040: an arc by its radius", Secondary);
  has(c.common.refuses, {Cause::ValueOutOfRange}, kKnown, Inferred);
  c.motion.machine = {MachineType::Mill,
                      "NCI, ggroups.json: G90 and G91 are modes; MD840, MD 20150: DIAMOF",
                      Secondary};
  c.motion.dwell_words = {"F", "NCI, CHANGELOG.md: F of G4 is its seconds", Secondary};
  c.motion.dwell_turn_words = {"S", "NCI, CHANGELOG.md: S of G4 is turns of the spindle",
                               Secondary};
  c.motion.computed_lengths = {ComputedLengths::Rounded,
                               "840Di p.281: MD 10200, lengths count a thousand increments a mm",
                               Secondary};
  c.motion.arc_tolerance = {10, "HSA 14040: MD 21000; its value is general knowledge", Inferred};
  c.motion.arc_tolerance_share = {1, "HSA 14040: MD 21010; its value is general knowledge",
                                  Inferred};
  c.common.power_on = {Set<PowerOn>{PowerOn::G01}, kKnown, Inferred};
}

void modal_calls(Control& c) {
  c.macros.modal_trigger = {ModalTrigger::AxisWord,
                            "general knowledge of the SINUMERIK 840D: posts write the first "
                            "position again after MCALL",
                            Inferred};
  c.macros.modal_locals = {ModalLocals::Rewritten,
                           "828Dj p.177: the values are handed over once, with MCALL", Inferred};
  c.macros.second_modal_call = {SecondModal::Replaces, kKnown, Inferred};
  c.macros.cancel_alone = {CancelAlone::Ignored, kKnown, Inferred};
}

/// Add R0 to R99, which keep their values, and the numbers of them that machines often have.
void parameters(Control& c) {
  constexpr const char* kNumber = "general knowledge of the SINUMERIK 840D: MD 28050";
  c.variables.push_back({0, 99, VariableKind::Kept, Access::ReadWrite, 0, kKnown, Inferred});
  c.variable_choices = {
      {"r-300", "R0 to R299, by machine datum 28050", "100-299", {}, kNumber, Inferred},
      {"r-1000", "R0 to R999, by machine datum 28050", "100-999", {}, kNumber, Inferred},
      {"r-10000", "R0 to R9999, by machine datum 28050", "100-9999", {}, kNumber, Inferred}};
}

/// Add the machine data of the ISO mode, in which blocks are written as for another maker's
/// control.
void iso_mode(Control& c) {
  const auto add = [&c](const char* name, double value, const char* meaning, const char* source) {
    c.parameters.push_back(read_by(rule::g_codes, {name, value, meaning, source, Secondary}));
  };
  add("10880", 1,
      "which control the ISO mode is like: 1 = a mill (ISO_21), 4 = a mill (ISO_22); those of "
      "lathes, "
      "2 and 5, are not computed",
      "MD840, MD 10880; the delivered value is general knowledge");
  add("18800", 0, "1 = the control has an ISO mode: G291, and programs that ISOCALL calls",
      "MD840, MD 18800; the delivered value is general knowledge");
}

/// Add the system variables that programs write by an index.
void written_variables(Control& c) {
  const auto add_written = [&c](std::int32_t first, std::int32_t count, VariableKind kind,
                                const char* source, char address = 0) {
    c.variables.push_back(
        {first, first + count - 1, kind, Access::ReadWrite, address, source, Inferred});
  };
  constexpr std::int32_t kNames = 1'800'000'000, kEdges = 1'900'000'000;
  add_written(kNames, EdgeDatum::kTools, VariableKind::ToolName,
              "general knowledge of the SINUMERIK 840D: $TC_TP2");
  add_written(kEdges, EdgeDatum::kNumbers, VariableKind::EdgeDatum,
              "general knowledge of the SINUMERIK 840D: $TC_DP1 to $TC_DP35");
  constexpr std::int32_t kOutputs = 1'950'003'001, kMarkers = 1'950'007'001,
                         kParameters = 1'950'007'101;
  add_written(kOutputs, 1024, VariableKind::Output, kKnown);
  add_written(kMarkers, 8, VariableKind::Kept,
              "general knowledge of the SINUMERIK 840D: $AC_MARKER, machine datum 28256", 'M');
  add_written(kParameters, 50, VariableKind::Kept,
              "general knowledge of the SINUMERIK 840D: $AC_PARAM, machine datum 28254", 'P');
}

/// Add the system variables that a run knows, at numbers that no R reaches: the language names
/// them.
void system_variables(Control& c) {
  constexpr const char* kPositions = "NCI, actual_position.mpf";
  const auto add = [&c](std::int32_t first, std::int32_t count, VariableKind kind, char address,
                        const char* source, Evidence evidence) {
    constexpr std::int32_t kFirst = 2'000'000'000;
    c.variables.push_back({kFirst + first, kFirst + first + count - 1, kind, Access::ReadOnly,
                           address, source, evidence});
  };
  add(1001, 1024, VariableKind::Input, 0, kKnown, Inferred);
  add(4901, 40, VariableKind::ModalCode, 0, "NCI, ggroups.json", Secondary);
  add(5001, 9, VariableKind::WorkPosition, 0, kPositions, Secondary);
  add(5021, 9, VariableKind::MachinePosition, 0, kPositions, Secondary);
  add(5041, 9, VariableKind::BlockEnd, 0, kKnown, Inferred);
  add(5061, 1, VariableKind::ActiveWord, 'T', kKnown, Inferred);
  add(5062, 1, VariableKind::ActiveWord, 'F', kKnown, Inferred);
  add(5067, 1, VariableKind::ToolLength, 'T', kKnown, Inferred);  // the tool itself
  c.variables.back().from = -1;
  add(5068, 1, VariableKind::SkipTouched, 0, kKnown, Inferred);
  add(5081, 9, VariableKind::MeasuredPosition, 0, "840slj p.5-24: $AA_MW", Secondary);
  add(5091, 9, VariableKind::MeasuredMachine, 0, "840slj p.5-24: $AA_MM", Secondary);
  add(5063, 1, VariableKind::Date, 0, kKnown, Inferred);
  add(5064, 1, VariableKind::Time, 0, kKnown, Inferred);
  constexpr const char* kFrames = "MD840, framevar.svar: $P_UIFR and kin";
  add(6001, 100, VariableKind::StoredFrame, 0, kFrames, Secondary);
  c.variables.back().access = Access::ReadWrite;
  add(6201, 5, VariableKind::FrameInForce, 0, kFrames, Secondary);
  c.variables.back().access = Access::ReadWrite;
  add(6301, 1, VariableKind::FrameNumber, 0, "SONE p.636: $P_UIFRNUM", Manual);
  add(5065, 1, VariableKind::ActiveWord, 'S', kKnown, Inferred);
  add(5066, 1, VariableKind::ActiveWord, 'D', kKnown, Inferred);
}

}  // namespace

Control family() {
  Control c;
  c.dialect = "sinumerik";
  reading(c);
  motion(c);
  parameters(c);
  iso_mode(c);
  modal_calls(c);
  standard_cycles(c);
  system_variables(c);
  written_variables(c);
  return c;
}

}  // namespace cncsub::siemens
