// Runs to a breakpoint, then block by block, and tells each change of a variable:
//   single_step fanuc-0i-f main.nc O1 30 100
#include <cncsub/cncsub.hpp>
#include <iostream>
#include <string>

namespace nc = cncsub::api;

namespace {

std::string shown(const std::optional<double>& value) {
  return value ? std::to_string(*value) : "vacant";
}

}  // namespace

int main(int count, char** words) {
  if (count != 6) return std::cerr << "single_step CONTROL FILE PROGRAM N VARIABLE\n", 2;
  const std::int64_t watched = std::stoll(words[5]);
  const auto library = nc::Library::load({words[2]}, words[1]);
  if (!library) return std::cerr << library.error().message << '\n', 2;
  auto machine = library->machine();
  if (!machine) return std::cerr << machine.error().message << '\n', 2;
  const auto there = machine->run_to(words[3], std::stoll(words[4]));
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
