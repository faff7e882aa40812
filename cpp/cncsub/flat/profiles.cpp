// Cycles that follow the blocks of a profile, which is renumbered.
#include <string>
#include <utility>

#include "cncsub/flat/flat.hpp"

namespace cncsub {

/// Write a cycle and the blocks of the profile that it follows. They stand right after it where it
/// passes over them. A cycle that goes on with the next block, as G70 does, names the blocks of an
/// earlier cycle, or blocks after the end of the program.
bool FlatRun::write_with_profile(std::string& text, FlatOrigins& origins, const Block& block,
                                 const Profile& profile) {
  profile_.clear();
  if (other_) return refuse("a cycle with a profile cannot be written for another control");
  for (const NcWords& words : profile.blocks) {
    const Block& own = machine_.code().blocks[words.at];
    if (!blocks_.write(profile_.emplace_back(), own, program_at(words.at), &words))
      return refuse("the value of " + blocks_.failed() + " cannot be written as a number");
  }
  std::array<std::int64_t, 2> numbers{};
  const bool behind =
      codes_of(machine_, observer_, block).meaning(Group::OneShot) != Meaning::Finish;
  bool is_new = true;
  if (!number_profile(behind, numbers, is_new)) return false;
  if (!write_words(text, origins, block, &numbers)) return false;
  end_line(text, origins);
  if (!is_new) return true;
  Late late{numbers, profile_, {}, coming_.call, coming_.repeat};
  for (const NcWords& words : profile.blocks) late.blocks.push_back(words.at);
  if (behind)
    write_profile(text, origins, late);
  else
    late_.push_back(std::move(late));
  return true;
}

void FlatRun::write_profile(std::string& text, FlatOrigins& origins, const Late& profile) {
  const Coming cycle = coming_;
  coming_.call = profile.call;
  coming_.repeat = profile.repeat;
  for (std::size_t i = 0; i < profile.lines.size(); ++i) {
    const bool first = i == 0, last = i + 1 == profile.lines.size();
    if (first || last) text += "N" + std::to_string(profile.numbers[first ? 0 : 1]) + " ";
    if (!first && !last && profile.lines[i].empty()) continue;
    text += profile.lines[i];
    coming_.at = profile.blocks[i];
    end_line(text, origins);
  }
  coming_ = cycle;
}

bool FlatRun::number_profile(bool behind, std::array<std::int64_t, 2>& numbers, bool& is_new) {
  const Control& control = *machine_.code().control;
  const auto known = profiles_.find(profile_);
  is_new = behind || known == profiles_.end();
  if (!is_new) {
    numbers = known->second;
    return true;
  }
  const bool one = profile_.size() == 1;
  if (one && control.common.refuses.value.has(Cause::PqSame))
    return refuse("the profile is one block, whose number would be P and Q");
  numbers = {last_n_ + 1, last_n_ + (one ? 1 : 2)};
  last_n_ = numbers[1];
  profiles_[profile_] = numbers;
  return last_n_ <= control.reading.max_sequence_number.value ||
         refuse("the program has more profiles than there are sequence numbers");
}

}  // namespace cncsub
