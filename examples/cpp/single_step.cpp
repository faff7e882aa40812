// Runs to a breakpoint, then block by block, and tells each change of a variable:
//   single_step fanuc-0i-f main.nc O1 30 100
#include <charconv>
#include <cncsub/cncsub.hpp>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>

namespace nc = cncsub::api;

namespace {

std::string shown(const std::optional<double>& value) {
  return value ? std::to_string(*value) : "vacant";
}

/// Return a whole number; nothing where the text is none.
std::optional<std::int64_t> number_of(const std::string& text) {
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

}  // namespace

int main(int count, char** words) {
  const auto n = count == 6 ? number_of(words[4]) : std::nullopt;
  const auto variable = count == 6 ? number_of(words[5]) : std::nullopt;
  if (!n || !variable) return std::cerr << "single_step CONTROL FILE PROGRAM N VARIABLE\n", 2;
  const std::int64_t watched = *variable;
  const auto library = nc::Library::load({words[2]}, words[1]);
  if (!library) return std::cerr << library.error().message << '\n', 2;
  auto machine = library->machine();
  if (!machine) return std::cerr << machine.error().message << '\n', 2;
  const auto there = machine->run_to(words[3], *n);
  if (!there) return std::cerr << there.error().message << '\n', 2;
  std::cout << "before " << machine->next_text() << ", after " << machine->blocks() << " blocks\n";
  for (const nc::Call& call : machine->stack())
    std::cout << "  called by " << call.kind << " in " << call.at.program << '\n';
  auto before = machine->variable(watched);
  if (!before) return std::cerr << before.error().message << '\n', 2;
  while (const auto step = machine->step()) {
    const auto now = machine->variable(watched);
    std::cout << step->at.program << ": " << step->text;
    if (*now != *before) std::cout << "   #" << watched << " = " << shown(*now);
    std::cout << '\n';
    before = now;
  }
  std::cout << to_string(machine->stop()) << '\n';
  return machine->alarm() ? 1 : 0;
}
