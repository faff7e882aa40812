// Fills a viewer's buffers with the path of the tool, column by column, and prints where it went:
//   moves fanuc-0i-f part.nc
#include <algorithm>
#include <cncsub/cncsub.hpp>
#include <iostream>
#include <vector>

namespace nc = cncsub::api;

int main(int count, char** words) {
  if (count != 3) return std::cerr << "moves CONTROL FILE\n", 2;
  const auto library = nc::Library::load({words[2]}, words[1]);
  if (!library) return std::cerr << library.error().message << '\n', 2;
  nc::Options options;
  options.setup.work_offsets["G54"] = {{'X', 100.0}, {'Y', 50.0}, {'Z', -200.0}};
  const auto run = library->run(options);
  if (!run) return std::cerr << run.error().message << '\n', 2;

  std::vector<double> x(run->moves()), y(run->moves()), z(run->moves());
  std::vector<std::int32_t> kind(run->moves());
  run->write_moves({.mx = x.data(), .my = y.data(), .mz = z.data(), .kind = kind.data()});

  const auto cuts = std::count_if(kind.begin(), kind.end(), [](std::int32_t of) {
    return of != static_cast<std::int32_t>(nc::Motion::Rapid);
  });
  std::cout << x.size() << " moves, " << cuts << " of them cut\n";
  for (const auto* axis : {&x, &y, &z})
    if (!axis->empty())
      std::cout << *std::min_element(axis->begin(), axis->end()) << " to "
                << *std::max_element(axis->begin(), axis->end()) << '\n';
  return run->alarm() ? 1 : 0;
}
