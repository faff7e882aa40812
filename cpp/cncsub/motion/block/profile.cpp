// G70 to G73: the blocks of a profile, carried out as they are written or tried out for its pieces.
#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/cycle/contour.hpp"
#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {
namespace {

bool calls(const Roles& roles, const NcWords& words) {
  const auto is_call = [](Role role) { return role >= Role::Call && role <= Role::CancelModal; };
  const auto g = words.codes->g(), m = words.codes->m();
  return std::any_of(m.begin(), m.end(), [&](int code) { return is_call(roles.of_m(code)); }) ||
         std::any_of(g.begin(), g.end(), [&](int code) { return is_call(roles.of_g(code)); });
}

/// Return whether a block has G70 to G73, which would follow the profile that they stand in.
bool follows_profile(const NcWords& words) {
  const MeaningSet& all = words.codes->all;
  return all.test(at(Meaning::Finish)) || all.test(at(Meaning::RoughTurn)) ||
         all.test(at(Meaning::RoughFace)) || all.test(at(Meaning::RoughPattern));
}

/// Return whether a code may stand inside: G00 to G04, G40 to G42, G96 to G99 and the modes.
/// [TDi 23.1, TA 8]
bool allowed(Meaning meaning) {
  switch (meaning) {
    case Meaning::Rapid:
    case Meaning::Line:
    case Meaning::Cw:
    case Meaning::Ccw:
    case Meaning::Thread:
    case Meaning::Dwell:
    case Meaning::RadiusOff:
    case Meaning::RadiusLeft:
    case Meaning::RadiusRight:
    case Meaning::SurfaceSpeed:
    case Meaning::SpindleSpeed:
    case Meaning::PerMinute:
    case Meaning::PerRevolution:
    case Meaning::Absolute:
    case Meaning::Incremental:
      return true;
    default:
      return false;
  }
}

/// The words by which a block calls, or ends.
constexpr WordName kCallWords{.addresses = bit('M'),
                              .groups = bit(Group::OneShot) | bit(Group::Macro)};

/// Check what may stand in a profile that is cut in levels.
Result check_profile_block(const MotionFacts& facts, const NcWords& words) {
  if (calls(facts.control->calls.roles.value, words))
    return fault_at(kCallWords, Cause::ProfileCall, words.at);
  for (const int g : words.codes->g())
    if (!allowed(facts.codes.find(g).meaning))
      return fault_at({.code = g}, Cause::ProfileCode, words.at);
  return std::nullopt;
}

/// Collect the pieces that the blocks make. The blocks run on a plan of their own that is never
/// committed.
Result capture(MotionContext& m, const std::vector<NcWords>& blocks, std::vector<Piece>& pieces) {
  MotionState state = m.state;
  MotionOutcome outcome;
  MotionContext trial{{m.facts, state, nullptr, &pieces}, outcome, m.inputs};
  end_cycles(m.facts, state);
  const GCode radius_off = m.facts.codes.of(Meaning::RadiusOff);
  for (const NcWords& words : blocks) {
    if (auto wrong = check_profile_block(m.facts, words)) return wrong;
    if (m.inputs.over(1)) return broken_off(words.at);
    outcome = {};
    state.modal[at(Group::Radius)] = radius_off;
    if (auto wrong = run_block(trial, words, 0)) return wrong;
  }
  if (auto wrong = unfinished_move(trial)) return wrong;
  std::erase_if(pieces, [](const Piece& piece) { return piece.kind == MoveKind::Dwell; });
  return std::nullopt;
}

/// Execute G70: the blocks as they are written, with their own F, S and T, then back.
Result finish_contour(MotionContext& m, BlockWords& block, const std::vector<NcWords>& blocks) {
  const Axes start = m.state.work;
  for (const NcWords& words : blocks) {
    if (calls(m.facts.control->calls.roles.value, words))
      return fault_at(kCallWords, Cause::ProfileCall, words.at);
    if (follows_profile(words)) return fault_at({}, Cause::ProfileCode, words.at);
    if (auto wrong = run_block(m, words, block.step, block.cycle)) return wrong;
  }
  const GCode radius = m.state.modal[at(Group::Radius)];
  m.state.modal[at(Group::Radius)] = m.facts.codes.of(Meaning::RadiusOff);
  auto wrong = move(m, block, MoveKind::Rapid, start, kXz);
  if (m.facts.codes.of(Meaning::RadiusOff).code != radius.code && !compensating(m.state))
    m.state.lookahead.engaged = false;
  return wrong;
}

}  // namespace

std::optional<ProfileNumbers> named_profile(const MotionFacts& facts, const NcWords& words) {
  const Meaning once = words.codes->meaning(Group::OneShot);
  if (once < Meaning::Finish || once > Meaning::RoughPattern) return std::nullopt;
  const ProfileNumbers numbers{whole(std::round(words['P'])), whole(std::round(words['Q']))};
  if (numbers.ns == numbers.nf && facts.refuses(Cause::PqSame)) return std::nullopt;
  return numbers;
}

Result contour(MotionContext& m, BlockWords& block, Meaning meaning) {
  const NcWords& w = block.words;
  if (!w.has('P') && !w.has('Q') && meaning != Meaning::Finish)
    return take_first_block(m, block, meaning);
  if (!w.has('P') || !w.has('Q')) return fault(Cause::PqMissing, block);
  if (std::round(w['P']) == std::round(w['Q']) && m.facts.refuses(Cause::PqSame))
    return fault_at('Q', Cause::PqSame, block);
  if (m.inputs.profile == nullptr) return fault_at('P', Cause::PqNotFound, block);
  const Profile& profile = *m.inputs.profile;
  if (profile.fault) return profile.fault;
  const int most = m.facts.control->turning.max_profile_blocks.value;
  if (most > 0 && profile.blocks.size() > static_cast<std::size_t>(most))
    return fault_at('Q', Cause::ProfileTooLong, block);
  if (profile.blocks.empty()) return fault_at('P', Cause::PqNotFound, block);
  if (meaning == Meaning::Finish) return finish_contour(m, block, profile.blocks);
  take_one_block(m, block, meaning);
  if (auto wrong = need_feed(m, block, Meaning::Line)) return wrong;
  std::vector<Piece> pieces;
  if (auto wrong = capture(m, profile.blocks, pieces)) return wrong;
  return rough_contour(m, block, meaning, profile, std::move(pieces));
}

}  // namespace cncsub
