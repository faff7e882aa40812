// Blocks of plain words: N10 G1 X10.5 Y-3 F200 M8.
#include <bitset>
#include <span>
#include <utility>

#include "cncsub/dialect/sinumerik/block.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"

namespace cncsub::sinumerik {

BlockReader::BlockReader(Builder& to, std::vector<std::string> called_in_iso_mode)
    : open_(to), declarations_(to, open_.line, open_.expression, open_.definitions) {
  open_.called_in_iso_mode = std::move(called_in_iso_mode);
  if (!to.code().general_only) prepare_plain_words();
}

void BlockReader::prepare_plain_words() {
  using Kind = PlainTable::Kind;
  constexpr std::string_view kAxes = "ABCIJKUVWXYZ";
  const Control& control = open_.to.control();
  plain_.set(";", Kind::End);
  plain_.set(kAxes, Kind::Value);
  plain_.set("DFST", Kind::Value);
  for (const char c : kAxes)
    plain_.of_value[static_cast<unsigned char>(c)] = PlainTable::kPoint | PlainTable::kMinus;
  for (const char c : {'F', 'S'})
    plain_.of_value[static_cast<unsigned char>(c)] = PlainTable::kPoint;
  plain_.set("G", Kind::G);
  plain_.set("M", Kind::M);
  plain_.set("N", Kind::N);
  for (std::size_t g = 0; g < plain_.g.size(); ++g)
    plain_.g[g] = control.reading.g_codes.value.has(static_cast<int>(10 * g));
  for (const int code : {kIsoModeOff, kIsoModeOn})
    plain_.g.reset(static_cast<std::size_t>(code / 10));
  plain_.max_digits = kMostDigits;
  plain_.max_n = control.reading.max_sequence_number.value;
}

namespace {

/// What plain words hold beside numbers.
struct PlainLanguage {
  const Roles& roles;

  bool takes_m(int m) const {
    const Role role = roles.of_m(m);
    return role != Role::Return && role != Role::End;
  }
  static bool computed(PlainWords& /*words*/, char /*letter*/, const char*& /*at*/) {
    return false;
  }
};

/// Return whether two codes stand in a block that do not go together: of one group, or each of
/// which says alone what is done with the words.
bool has_two_alike(std::span<const int> codes) {
  if (codes.size() < 2) return false;
  std::bitset<kCodeGroups> groups;
  bool acts = false;
  for (const int code : codes) {
    const int group = group_of(code);
    if (group != 0 && groups.test(static_cast<std::size_t>(group))) return true;
    if (acts_alone(group, 10 * code) && std::exchange(acts, true)) return true;
    groups.set(static_cast<std::size_t>(group));
  }
  return false;
}

}  // namespace

/// Compile a block of plain words.
bool BlockReader::plain(std::string_view text, Block& block) {
  if (static_cast<std::ptrdiff_t>(text.size()) >= kLongestPlain) return false;
  PlainWords words;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  PlainLanguage language{open_.to.control().calls.roles.value};
  if (!PlainWordReader(plain_, language).read(text.data(), text.data() + text.size(), words) ||
      !words.any() || has_two_alike(words.codes()))
    return false;
  declarations_.end_definitions();
  block.n = words.n;
  open_.to.plain_words(block, words.codes(), words.m, words.mask, words.extra, words.values);
  return true;
}

}  // namespace cncsub::sinumerik
