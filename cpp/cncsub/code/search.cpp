#include "cncsub/code/search.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr int kNotSearched = std::numeric_limits<int>::max();

const Program& program_at(const Code& code, std::int32_t program) {
  return code.programs[static_cast<std::size_t>(program)];
}

const SearchPath& search_path(const Code& code) { return code.control->calls.search_path.value; }

/// Return the place of a folder in the search path; kNotSearched where it is in none.
int place_in_path(const Code& code, std::string_view folder, std::string_view added) {
  int place = 0;
  for (const SearchFolder::Entry& entry : search_path(code)) {
    const bool is_added = entry.on_control() == SearchFolder::kAdded;
    const std::string name =
        is_added ? code.spelling->folder_of(added) : std::string(entry.on_control());
    if (!name.empty() && is_same_folder(name, folder)) return place;
    ++place;
  }
  return kNotSearched;
}

/// Return when a program is found, before those with a larger number.
int rank_of(const Code& code, const Program& program, const SearchFrom& from) {
  enum : int { Own, OwnMain, Unknown, UnknownMain, Path };
  constexpr int kLast = kNotSearched - 1;
  static const std::string nothing;
  const std::string& folder = code.folders[program.folder];
  const std::string& own =
      from.main == kNoProgram ? nothing : code.folders[program_at(code, from.main).folder];
  const bool main = is_main(code, program);
  if (folder.empty() ? own.empty() : is_same_folder(folder, own)) return main ? OwnMain : Own;
  if (folder.empty()) return main ? UnknownMain : Unknown;
  const int place = place_in_path(code, folder, from.added);
  if (place != kNotSearched) return main ? kNotSearched : Path + place;
  return own.empty() || from.added_unknown ? kLast : kNotSearched;
}

/// Return when a program is found that a call names with its folder.
int rank_in(const Code& code, const Program& program, std::string_view folder) {
  enum : int { There, ThereMain, Unknown, UnknownMain };
  const std::string& own = code.folders[program.folder];
  const bool main = is_main(code, program);
  if (own.empty()) return main ? UnknownMain : Unknown;
  if (!is_same_folder(own, folder)) return kNotSearched;
  return main ? ThereMain : There;
}

template <class Rank>
std::int32_t first_by(const std::vector<std::int32_t>& programs, const Rank& rank_of) {
  std::pair best{kNotSearched, kNoProgram};
  for (const std::int32_t program : programs)
    if (const int rank = rank_of(program); rank < best.first) best = {rank, program};
  return best.second;
}

}  // namespace

bool is_main(const Code& code, const Program& program) {
  const std::string_view ending = code.spelling->main_ending;
  const SourceFile& file = code.files[program.file];
  if (program.name_length == Program::kOfFile) return ends_in(file.name, ending);
  const std::string_view text = file.text.view();
  const std::size_t end = std::size_t{program.name_at} + program.name_length;
  return ends_in(text.substr(0, std::min(end + ending.size() + 1, text.size())), ending);
}

int place_in_path(const Code& code, const Program& program) {
  const int place = place_in_path(code, code.folders[program.folder], "");
  return place == kNotSearched ? -1 : place;
}

std::string folder_of(const Code& code, const Program& program) {
  if (search_path(code).empty()) return "";
  const SourceFile& file = code.files[program.file];
  const std::string_view name = file.name, base = last_of_path(name);
  const std::string_view before = name.substr(0, name.size() - base.size());
  const std::string_view last =
      last_of_path(before.substr(0, before.size() - (before.empty() ? 0 : 1)));
  for (const SearchFolder::Entry& entry : search_path(code))
    if (!last.empty() && same_letters(entry.on_disk(), last))
      return std::string(entry.on_control());
  const std::string_view told = file.text.view().substr(program.path_at, program.path_length);
  return code.spelling->folder_of(told.empty() ? before : told);
}

bool is_same_folder(std::string_view one, std::string_view other) {
  if (one.size() < other.size()) std::swap(one, other);
  return one.ends_with(other) &&
         (one.size() == other.size() || one[one.size() - other.size() - 1] == '/');
}

std::vector<std::int32_t> programs_named(const Code& code, std::string_view name) {
  std::vector<std::int32_t> programs;
  const std::int32_t first = code.find(name);
  if (first == kNoProgram) return programs;
  for (std::int32_t at = first; at != kNoProgram; at = program_at(code, at).same_name)
    programs.push_back(at);
  std::sort(programs.begin() + 1, programs.end());
  return programs;
}

std::int32_t find_called(const Code& code, std::string_view name, std::string_view path,
                         const SearchFrom& from) {
  const std::int32_t first = code.find(name);
  if (first == kNoProgram || search_path(code).empty()) return first;
  const Program& alone = program_at(code, first);
  if (alone.same_name == kNoProgram && alone.folder == 0) return first;
  const std::vector<std::int32_t> programs = programs_named(code, name);
  const std::string folder = code.spelling->folder_of(path);
  if (folder.empty())
    return first_by(programs, [&](std::int32_t program) {
      return rank_of(code, program_at(code, program), from);
    });
  return first_by(programs, [&](std::int32_t program) {
    return rank_in(code, program_at(code, program), folder);
  });
}

bool means_one(const Code& code, std::string_view name, std::string_view path) {
  const std::int32_t first = code.find(name);
  if (first == kNoProgram || search_path(code).empty() || !code.spelling->folder_of(path).empty())
    return true;
  const Program& alone = program_at(code, first);
  if (alone.same_name != kNoProgram) return false;
  return alone.folder == 0 || (!is_main(code, alone) &&
                               place_in_path(code, code.folders[alone.folder], "") != kNotSearched);
}

SearchFrom known_search(const Code& code, std::int32_t program) {
  SearchFrom from;
  if (code.folders.size() == 1) return from;  // all programs lie in one
  const bool main = program != kNoProgram && is_main(code, program_at(code, program));
  from.main = main ? program : code.main_program();
  from.added_unknown =
      std::any_of(code.statements.begin(), code.statements.end(), [&](const Statement& of) {
        return of.target == Statement::Target::Common && of.index == code.call_path;
      });
  return from;
}

std::string told_elsewhere(const Code& code, std::string_view name) {
  std::string folders;
  if (!search_path(code).empty())
    for (const std::int32_t program : programs_named(code, name))
      folders += (folders.empty() ? "" : ", ") + code.folders[program_at(code, program).folder];
  return folders.empty() ? "" : "; it is in " + folders + ", which is not searched here";
}

}  // namespace cncsub
