#include "cncsub/analysis/mode_reader.hpp"

namespace cncsub::modes {

namespace {

constexpr std::uint32_t kAxes =
    kEndWords | bit('A') | bit('B') | bit('C') | bit('U') | bit('V') | bit('W');

/// Return whether all words of a block that name axes are the number 0: G52 X0 Y0 shifts nothing.
bool all_zero(const Code& code, const Block& block) {
  const Cell* cell = code.cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) expressions = (cell++)->extra.expressions;
  cell += block.code_cells();
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const std::uint32_t address = left & ~(left - 1);
    if ((address & kAxes) != 0 && ((expressions & address) != 0 || cell->value != 0)) return false;
  }
  return true;
}

}  // namespace

/// Return the values of the modes, with the usual ones of a machine.
std::vector<Meant> ModeReader::meant(bool lathe) {
  return {{Distance, kUsual, Meaning::Absolute},
          {Distance, kOther, Meaning::Incremental},
          {Plane, lathe ? kOther : kUsual, Meaning::PlaneXY},
          {Plane, lathe ? kUsual : kOther, Meaning::PlaneZX},
          {Plane, kSecond, Meaning::PlaneYZ},
          {Units, kUsual, Meaning::Metric},
          {Units, kOther, Meaning::Inch},
          {Radius, kUsual, Meaning::RadiusOff},
          {Radius, kOther, Meaning::RadiusLeft},
          {Radius, kSecond, Meaning::RadiusRight},
          {Cycle, kUsual, Meaning::CycleOff},
          {Length, kUsual, Meaning::LengthOff},
          {Length, kOther, Meaning::LengthPlus},
          {Length, kSecond, Meaning::LengthMinus},
          {Work, kUsual, Meaning::Work1},
          {Work, kOther, Meaning::Work2},
          {Work, kOther, Meaning::Work3},
          {Work, kOther, Meaning::Work4},
          {Work, kOther, Meaning::Work5},
          {Work, kOther, Meaning::Work6},
          {Work, kSecond, Meaning::WorkExtra},
          {Shift, kOther, Meaning::Local},
          {Origin, kOther, Meaning::SetCoordinate},
          {Origin, kUsual, Meaning::ClearCoordinate},
          {Rotation, kUsual, Meaning::RotationOff},
          {Rotation, kOther, Meaning::RotationOn},
          {Scaling, kUsual, Meaning::ScalingOff},
          {Scaling, kOther, Meaning::ScalingOn},
          {Mirror, kUsual, Meaning::MirrorOff},
          {Mirror, kOther, Meaning::MirrorOn},
          {Polar, kUsual, Meaning::PolarOff},
          {Polar, kOther, Meaning::PolarOn},
          {Feed, kUsual, Meaning::PerMinute},
          {Feed, kOther, Meaning::PerRevolution},
          {Feed, kSecond, Meaning::InverseTime},
          {Surface, kUsual, Meaning::SpindleSpeed},
          {Surface, kOther, Meaning::SurfaceSpeed}};
}

/// Return the modes that a code sets, 0 where it sets none.
Modes ModeReader::set_by(Meaning meaning, Group group) const {
  for (const Meant& each : meant_)
    if (each.meaning == meaning) return of(each.mode, each.value);
  if (group == Group::Cycle) return of(Cycle, kOther);
  return group == Group::Motion ? of(Cycle, kUsual) : 0;
}

/// Return the modes that a code of a block sets; `g` is ten times its number.
Modes ModeReader::set_by(int g, const Block& block) const {
  const GCode code = c_.g_codes.find(g);
  if (code.meaning == Meaning::Local && all_zero(c_.code, block)) return of(Shift, kUsual);
  return set_by(code.meaning, code.group);
}

/// Restore the modes that were found. A computed code is written to do this, as `G#3` after
/// `#3=#4003`; M72 does it too.
void ModeReader::restore(Modes& modes, const Block& block, bool sometimes) const {
  if (block.g_count != 0 && (block.flags & Block::kCodeExpression) != 0)
    put(modes, all(kFound), sometimes);
  each_m(c_.code, block, [&](int m) {
    if (c_.code.control->calls.roles.value.of_m(m) == Role::RestoreModes)
      put(modes, kKept, sometimes);
  });
}

bool ModeReader::keeps(const ProgramFlow& flow) const {
  const Roles& roles = c_.code.control->calls.roles.value;
  if (!roles.code_of(Role::KeepModes)) return false;
  bool keeps = false;
  for (Address at = flow.first(); at < flow.last() && !keeps; ++at) {
    const Block& block = c_.code.blocks[at];
    if (block.op == Op::Words)
      each_m(c_.code, block, [&](int m) { keeps |= roles.of_m(m) == Role::KeepModes; });
  }
  return keeps;
}

Modes ModeReader::after(Modes before, Address at) const {
  const Block& block = c_.code.blocks[at];
  Modes modes = before;
  const bool sometimes = block.can_be_skipped() || block.op == Op::IfThen || block.op == Op::Select;
  each_variant(c_.code, block, [&](const Block& each) {
    const bool plain = each.op == Op::Linear || each.op == Op::Arc;
    if (plain && (each.flags & Block::kNoG) == 0)
      put(modes, set_by(Meaning::Line, Group::Motion), sometimes);
    if (plain) return;
    each_g(c_.code, each, [&](int g) { put(modes, set_by(g, each), sometimes); });
    restore(modes, each, sometimes);
    if (each.op == Op::ModalCall) put(modes, of(Macro, kOther), sometimes);
    if (each.op == Op::CancelModal) put(modes, of(Macro, kUsual), sometimes);
  });
  return modes;
}

std::uint32_t ModeReader::set_at(Address at) const {
  const Modes modes = after(0, at);
  std::uint32_t set = 0;
  for (int mode = 0; mode < kModes; ++mode)
    if (value(modes, mode) != 0) set |= 1u << mode;
  return set;
}

bool ModeReader::moves(Address at) const {
  const Block& block = c_.code.blocks[at];
  return is_words(block.op) && (block.mask & kAxes) != 0;
}

bool ModeReader::leads_on(Address at) const {
  const Op op = c_.code.blocks[at].op;
  return !moves(at) && (op == Op::Words || op > Op::Return);
}

std::string ModeReader::name(int mode, Modes which) const {
  if (mode == Cycle) return "a canned cycle";
  if (mode == Macro) return "a modal macro call";
  if (mode == Work) return "another work coordinate system";
  for (const Meant& each : meant_)
    if (each.mode == mode && (each.value & which) != 0)
      if (const GCode code = c_.g_codes.of(each.meaning); code.code >= 0)
        return code_name(code.code);
  return "a mode";
}

}  // namespace cncsub::modes
