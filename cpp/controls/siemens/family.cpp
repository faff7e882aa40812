// The parts that the controls of Siemens share in their own language.
#include "controls/siemens/family.hpp"

#include "controls/facts.hpp"

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
      "700 710 810 811 812 813 814 815 816 817 818 819 820 821 822 823 824 825 826 827 828 829 931 "
      "942 952 961 962 971 972 973",
      "NCI, ggroups.json: the G groups of the manual", Secondary};
}

void motion(Control& c) {
  c.motion.g_meanings = {
      "5=not-computed 25=not-computed 26=not-computed 33=not-computed 41=not-computed "
      "42=not-computed 53=not-computed 58=not-computed 59=not-computed 60=neutral "
      "63=tapping 70=inch 71=metric 74=not-computed 93=not-computed "
      "96=not-computed 97=not-computed 450=neutral 451=neutral 601=neutral 602=neutral 603=neutral "
      "621=neutral 641=neutral 642=neutral 643=neutral 644=neutral 645=neutral",
      "NCI, ggroups.json", Secondary};
  c.motion.g_meanings.tell("63=tapping", kKnown, Inferred);
  c.motion.dwell_words = {"F", kKnown, Inferred};
  c.motion.dwell_turn_words = {"S", kKnown, Inferred};
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

/// Add R0 to R99, which keep their values.
void parameters(Control& c) {
  c.variables.push_back({0, 99, VariableKind::Kept, Access::ReadWrite, 0, kKnown, Inferred});
}

}  // namespace

Control family() {
  Control c;
  c.dialect = "sinumerik";
  reading(c);
  motion(c);
  parameters(c);
  modal_calls(c);
  standard_cycles(c);
  return c;
}

}  // namespace cncsub::siemens
