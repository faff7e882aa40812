// Runs the programs of files on a control, and shows an alarm as the command line does:
//   run_files fanuc-0i-f main.nc macro.nc
#include <cncsub/cncsub.hpp>
#include <iostream>
#include <string>
#include <vector>

namespace nc = cncsub::api;

int main(int count, char** words) {
  if (count < 3) {
    std::cerr << "run_files CONTROL FILE...; the controls are:\n";
    for (const nc::Control& control : nc::controls()) std::cerr << "  " << control.name << '\n';
    return 2;
  }
  const auto library =
      nc::Library::load(std::vector<std::string>(words + 2, words + count), words[1]);
  if (!library) return std::cerr << library.error().message << '\n', 2;
  const auto run = library->run();
  if (!run) return std::cerr << run.error().message << '\n', 2;
  std::cout << to_string(run->stop()) << ", after " << run->blocks() << " blocks, " << run->moves()
            << " moves, " << run->length() << " mm\n";
  if (const auto alarm = run->alarm()) {
    std::cout << alarm->message() << "\ncure: " << alarm->cure << '\n';
    return 1;
  }
  return 0;
}
