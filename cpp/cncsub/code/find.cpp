// Finds programs by their numbers and names, and blocks by theirs.
#include <algorithm>
#include <bit>
#include <charconv>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/code/search.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

std::int64_t number_in(std::string_view name) {
  if (!name.empty() && (upper(name[0]) == 'O' || name[0] == '%' || name[0] == ':'))
    name.remove_prefix(1);
  if (name.empty() || name.size() > 15) return -1;
  std::int64_t number = 0;
  for (const char c : name) {
    if (!is_digit(c)) return -1;
    number = number * 10 + (c - '0');
  }
  return number;
}

void ProgramIndex::reserve(std::size_t programs) {
  slots_.assign(std::bit_ceil(2 * programs + 1), kNoProgram);
}

namespace {

std::uint64_t hash_of(std::string_view name) {  // FNV-1a of the letters as capitals
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(upper(c))) * 0x100000001b3U;
  return hash;
}

/// Give each program its folder of the control, and take back what was registered before.
void place_in_folders(Code& code) {
  std::unordered_map<std::string, std::uint32_t> known;
  code.folders.assign(1, "");
  for (Program& program : code.programs) {
    program.same_name = kNoProgram;
    program.named_with_folder = false;
    const std::string folder = folder_of(code, program);
    program.folder = 0;
    if (folder.empty()) continue;
    const auto [found, is_new] =
        known.try_emplace(folder, static_cast<std::uint32_t>(code.folders.size()));
    if (is_new) code.folders.push_back(folder);
    program.folder = found->second;
  }
}

bool first_in_file(const Code& code, std::size_t program) {
  return program == 0 || code.programs[program - 1].file != code.programs[program].file;
}

/// Return a test of whether a program has this number.
auto numbered(const Code& code, std::int64_t number) {
  return [&code, number](std::int32_t i) {
    return code.programs[static_cast<std::size_t>(i)].number == number;
  };
}

/// Return a test of whether a program has this name: its own, or that of the file it is the first
/// of.
auto with_name(const Code& code, std::string_view name) {
  return [&code, name](std::int32_t i) {
    const auto at = static_cast<std::size_t>(i);
    const Program& program = code.programs[at];
    return same_letters(code.name_of(program), name) ||
           (first_in_file(code, at) &&
            same_letters(last_of_path(code.files[program.file].name), name));
  };
}

/// Put a program after another one of its name.
void chain(Code& code, std::int32_t program, std::int32_t before) {
  Program& first = code.programs[static_cast<std::size_t>(before)];
  code.programs[static_cast<std::size_t>(program)].same_name = first.same_name;
  first.same_name = program;
}

/// Return the program that takes a name before this one does, where another one has the name. One
/// in another folder of the control has it with its folder: CUS.DIR/SUB.
std::int32_t before_in_folder(Code& code, std::int32_t place, std::int32_t before,
                              bool other_kind) {
  Program& program = code.programs[static_cast<std::size_t>(place)];
  if (before == kNoProgram ||
      program.folder == code.programs[static_cast<std::size_t>(before)].folder)
    return other_kind ? kNoProgram : before;
  program.named_with_folder = true;
  const std::string name = code.name_of(program);
  return code.by_name[code.files[program.file].external].find_or_add(hash_of(name),
                                                                     with_name(code, name), place);
}

/// Let the number and the name of a program lead to it, and of the first one of a file its name.
void register_program(Code& code, std::size_t i) {
  Program& program = code.programs[i];
  const SourceFile& file = code.files[program.file];
  const auto place = static_cast<std::int32_t>(i);
  if (program.number >= 0)
    program.duplicate_of = code.by_number[file.external].find_or_add(
        static_cast<std::uint64_t>(program.number), numbered(code, program.number), place);
  ProgramIndex& names = code.by_name[file.external];
  const std::string name = code.name_of(program);
  const std::int32_t before = names.find_or_add(hash_of(name), with_name(code, name), place);
  const bool other_kind = before != kNoProgram && !code.spelling->called_ending.empty() &&
                          is_main(code, program) &&
                          !is_main(code, code.programs[static_cast<std::size_t>(before)]);
  if (before != kNoProgram && program.inside == kNoProgram) chain(code, place, before);
  if (program.number < 0 && (!other_kind || program.folder != 0))
    program.duplicate_of = before_in_folder(code, place, before, other_kind);
  const std::string_view base = last_of_path(file.name);
  if (first_in_file(code, i) && !base.empty())
    names.find_or_add(hash_of(base), with_name(code, base), place);
}

/// Register the programs of several folders, each turn by itself: those whose folder nothing tells
/// have their names alone, then come the others as a search finds them.
template <class TurnOf>
void register_by_folders(Code& code, const TurnOf& turn_of, const std::function<bool()>& over) {
  using Key = std::tuple<decltype(turn_of(code.programs[0])), bool, int, std::size_t>;
  std::vector<Key> order;
  for (std::size_t i = 0; i < code.programs.size(); ++i) {
    const Program& of = code.programs[i];
    order.emplace_back(turn_of(of), of.folder != 0, place_in_path(code, of), i);
  }
  std::sort(order.begin(), order.end());
  for (const Key& key : order)
    if (!over()) register_program(code, std::get<3>(key));
}

}  // namespace

void Code::register_programs(const std::function<bool()>& over) {
  for (auto* index : {&by_number, &by_name})
    for (ProgramIndex& table : *index) table.reserve(2 * programs.size() + files.size());
  place_in_folders(*this);
  // Where a main program has the name of another one, a call means the other. A name means a file
  // first, so the parts of files come last: they are found by their labels.
  enum class Turn : std::uint8_t { First, Main, Part };
  const bool two_kinds = !spelling->called_ending.empty();
  const auto turn_of = [&](const Program& of) {
    if (of.inside != kNoProgram) return Turn::Part;
    return two_kinds && is_main(*this, of) ? Turn::Main : Turn::First;
  };
  if (folders.size() > 1) return register_by_folders(*this, turn_of, over);
  bool later = true;
  for (const Turn turn : {Turn::First, Turn::Main, Turn::Part}) {
    if (!std::exchange(later, false)) return;
    for (std::size_t i = 0; i < programs.size() && !over(); ++i) {
      const Turn its = turn_of(programs[i]);
      if (its == turn) register_program(*this, i);
      later = later || its > turn;
    }
  }
}

bool defines_for_all(const Spelling& spelling, const SourceFile& file) {
  const std::string_view ending = spelling.definitions, name = file.name;
  return !ending.empty() && name.size() >= ending.size() &&
         std::equal(ending.begin(), ending.end(), name.end() - std::ssize(ending),
                    [](char a, char b) { return a == upper(b); });
}

std::int32_t Code::main_program() const {
  std::int32_t first = kNoProgram;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const SourceFile& file = files[programs[i].file];
    if (file.external || file.system || defines_for_all(*spelling, file)) continue;
    if (first == kNoProgram) first = static_cast<std::int32_t>(i);
    if (spelling->main_ending.empty()) break;
    if (is_main(*this, programs[i])) return static_cast<std::int32_t>(i);
  }
  return first;
}

std::int32_t Code::find(std::int64_t number, bool external) const {
  return by_number[external].find(static_cast<std::uint64_t>(number), numbered(*this, number));
}

namespace {

/// Return the program of a name with its folder of the control, CUS.DIR/SUB.
std::int32_t find_in_folder(const Code& code, std::string_view path, bool external) {
  const std::string_view name = last_of_path(path);
  const std::string folder = capitals(path.substr(0, path.size() - name.size() - 1));
  std::int32_t at = name.empty() ? kNoProgram : code.find(name, external);
  while (at != kNoProgram) {
    const Program& program = code.programs[static_cast<std::size_t>(at)];
    if (program.folder != 0 && is_same_folder(code.folders[program.folder], folder)) return at;
    at = program.same_name;
  }
  return kNoProgram;
}

}  // namespace

std::int32_t Code::find(std::string_view name, bool external) const {
  const std::int32_t found = by_name[external].find(hash_of(name), with_name(*this, name));
  if (found != kNoProgram) return found;
  if (folders.size() > 1 && name.find('/') != std::string_view::npos)
    return find_in_folder(*this, name, external);
  const std::int64_t number = number_in(name);
  return number >= 0 ? find(number, external) : kNoProgram;
}

namespace {

struct Entries {
  const SequenceEntry* first;
  const SequenceEntry* last;
};

/// Return the blocks of one number, in the order of the program.
Entries entries(const Code& code, const Program& program, std::int64_t n) {
  const SequenceEntry* first = code.sequence.data() + program.first_entry;
  const SequenceEntry* last = code.sequence.data() + program.last_entry;
  const auto* const low = std::lower_bound(
      first, last, n, [](const SequenceEntry& e, std::int64_t value) { return e.n < value; });
  const auto* const high = std::upper_bound(
      low, last, n, [](std::int64_t value, const SequenceEntry& e) { return value < e.n; });
  return {low, high};
}

}  // namespace

Address Code::first_of(const Program& program, std::int64_t n) const {
  const Entries found = entries(*this, program, n);
  return found.first == found.last ? kNowhere : found.first->address;
}

Address Code::first_from(const Program& program, std::int64_t n, Address from) const {
  const Entries found = entries(*this, program, n);
  const auto* const next =
      std::lower_bound(found.first, found.last, from,
                       [](const SequenceEntry& e, Address a) { return e.address < a; });
  return next == found.last ? kNowhere : next->address;
}

Address Code::next_of(const Program& program, std::int64_t n, Address behind) const {
  return first_from(program, n, behind + 1);
}

Address Code::last_of(const Program& program, std::int64_t n, Address before) const {
  const Entries found = entries(*this, program, n);
  const auto* const behind =
      std::lower_bound(found.first, found.last, before,
                       [](const SequenceEntry& e, Address a) { return e.address < a; });
  return behind == found.first ? kNowhere : behind[-1].address;
}

Address Code::jump_target(const Program& program, std::int64_t n, Address from) const {
  if (control->calls.jump_search.value == JumpSearch::ForwardThenHead) {
    const Address next = next_of(program, n, from);
    if (next != kNowhere) return next;
  }
  return first_of(program, n);
}

Address Code::return_target(const Program& program, std::int64_t n, Address call) const {
  switch (control->calls.return_search.value) {
    case ReturnSearch::FromHead:
      return first_of(program, n);
    case ReturnSearch::NearestBehindCall: {
      const Address behind = next_of(program, n, call);
      return behind != kNowhere ? behind : last_of(program, n, call + 1);
    }
  }
  return kNowhere;
}

Address Code::named_return_target(const Program& in, std::string_view name, Address call) const {
  if (name.size() > 1 && name[0] == 'N' && is_digit(name[1])) {
    std::int32_t number = -1;
    std::from_chars(name.data() + 1, name.data() + name.size(), number);
    const Address behind = next_of(in, number, call);
    return behind != kNowhere && behind < in.last ? behind : first_of(in, number);
  }
  const auto label = label_places.find(std::string(name));
  if (label == label_places.end()) return kNowhere;
  const Address behind = head_behind(label->second, call);
  if (behind < in.last) return behind;
  const Address first = head_from(label->second, in.first);
  return first < in.last ? first : kNowhere;
}

bool Code::leads_inside(Address from, Address to) const {
  const auto behind =
      std::upper_bound(structures.begin(), structures.end(), to,
                       [](Address at, const StructureMark& of) { return at < of.from; });
  if (behind == structures.begin()) return false;
  const StructureMark& of = *std::prev(behind);
  if (of.first == kNowhere) return false;
  return from <= of.first || (of.last != kNowhere && from > of.last);
}

std::string Code::no_block(std::int64_t n, const Program& program) const {
  return "there is no N" + std::to_string(n) + " in " + name_of(program);
}

}  // namespace cncsub
