// The variables of the Haas mills. The keys of the sources stand in sources.def.
#include "controls/facts.hpp"
#include "controls/haas/family.hpp"

namespace cncsub::haas {
namespace {

using enum Evidence;

constexpr const char* kUnsure = "general knowledge of the Haas mill, unsure";
constexpr const char* kHaas = "general knowledge of the Haas mill";
using Kind = VariableKind;
constexpr Access kReadWrite = Access::ReadWrite;
constexpr Access kReadOnly = Access::ReadOnly;
constexpr Access kWriteOnly = Access::WriteOnly;
constexpr const char* kTable = "HNGC p.200 to 208, macro variables";

/// Add the inputs, the outputs, and what the machine counts.
void signals(Control& c) {
  const std::string table = kTable;
  c.variables.insert(
      c.variables.end(),
      {
          // The numbers of older controls: the manual's example of a computed jump reads them.
          {1000, 1063, Kind::InputWord, kReadOnly, 0, "HNGC p.227, #1030", Secondary},
          // Loads, analog inputs, flutes, vibrations and timers: the machine supplies their values.
          {1064, 1068, Kind::InputWord, kReadOnly, 0, table, Manual},
          {1080, 1087, Kind::InputWord, kReadOnly, 0, table, Manual},
          {1090, 1098, Kind::InputWord, kReadOnly, 0, table, Manual},
          {1100, 1139, Kind::Output, kReadWrite, 0, kHaas, Inferred},
          {1264, 1268, Kind::InputWord, kReadOnly, 0, table, Manual},
          {1601, 2000, Kind::InputWord, kReadOnly, 0, table, Manual},
          {3020, 3025, Kind::InputWord, kReadOnly, 0, table, Manual},
          {3027, 3028, Kind::InputWord, kReadOnly, 0, table, Manual},
          {3030, 3030, Kind::InputWord, kReadOnly, 0, table, Manual},
          {3032, 3033, Kind::InputWord, kReadOnly, 0, table, Manual},
          {3196, 3196, Kind::InputWord, kReadOnly, 0, table, Manual},
          {3201, 3600, Kind::InputWord, kReadOnly, 0, table, Manual},
          {3901, 3902, Kind::PartsCount, kReadWrite, 0, table, Manual},
          {5401, 5600, Kind::InputWord, kReadOnly, 0, table, Manual},
          {5601, 5699, Kind::PartsCount, kReadWrite, 0, table, Manual},
          {5701, 5800, Kind::PartsCount, kReadWrite, 0, table, Manual},
          {5801, 5900, Kind::InputWord, kReadOnly, 0, table, Manual},
          {5901, 6000, Kind::PartsCount, kReadWrite, 0, table, Manual},
          {11000, 11255, Kind::Input, kReadOnly, 0, "HNGC p.208, discrete inputs", Manual},
          {12000, 12255, Kind::Output, kReadWrite, 0, "HNGC p.218, discrete outputs", Manual},
          {13000, 13063, Kind::InputWord, kReadOnly, 0, "HNGC p.205, analog inputs", Manual},
      });
}

/// Add the tools, what stops and what is told, and the settings.
void system_variables(Control& c) {
  const std::string table = kTable;
  c.variables.insert(
      c.variables.end(),
      {
          {2001, 2200, Kind::LengthGeometry, kReadWrite, 0, table, Manual},
          {2201, 2400, Kind::LengthWear, kReadWrite, 0, table, Manual},
          {2401, 2600, Kind::RadiusGeometry, kReadWrite, 0, table, Manual},
          {2601, 2800, Kind::RadiusWear, kReadWrite, 0, table, Manual},
          {3000, 3000, Kind::UserAlarm, kWriteOnly, 0, "HNGC p.210, #3000", Manual},
          {3001, 3001, Kind::Milliseconds, kReadWrite, 0, "HNGC p.211, #3001", Manual},
          {3002, 3002, Kind::Hours, kReadWrite, 0, "HNGC p.211, #3002", Manual},
          {3003, 3004, Kind::Control1, kReadWrite, 0, "HNGC p.211, #3003, #3004", Manual},
          {3006, 3006, Kind::Message, kWriteOnly, 0, "HNGC p.212, #3006", Manual},
          {3011, 3011, Kind::Date, kReadOnly, 0, table, Manual},
          {3012, 3012, Kind::Time, kReadOnly, 0, table, Manual},
          {3026, 3026, Kind::ActiveWord, kReadOnly, 'T', table, Manual},
          {7501, 7506, Kind::InputWord, kReadOnly, 0, "HNGC p.216, pallets", Manual},
          {7601, 7606, Kind::InputWord, kReadOnly, 0, "HNGC p.216, pallets", Manual},
          {7701, 7706, Kind::InputWord, kReadOnly, 0, "HNGC p.216, pallets", Manual},
          {7801, 7806, Kind::InputWord, kReadOnly, 0, "HNGC p.216, pallets", Manual},
          // A program writes the number of a group or a tool, and reads what the machine knows.
          {8500, 8500, Kind::OutputWord, kReadWrite, 0, "HNGC p.216, tool management", Manual},
          {8501, 8515, Kind::InputWord, kReadOnly, 0, "HNGC p.216, tool management", Manual},
          {8550, 8550, Kind::OutputWord, kReadWrite, 0, "HNGC p.217, tool management", Manual},
          {8551, 8567, Kind::InputWord, kReadOnly, 0, "HNGC p.217, tool management", Manual},
          {9000, 9031, Kind::InputWord, kReadOnly, 0, table, Manual},
          {30000, 39999, Kind::InputWord, kReadOnly, 0, table, Manual},
          {50001, 50400, Kind::InputWord, kReadOnly, 0, table, Manual},
          {50601, 51000, Kind::InputWord, kReadOnly, 0, table, Manual},
          {51301, 52800, Kind::InputWord, kReadOnly, 0, table, Manual},
      });
}

/// Add the modal codes, positions and work offsets.
void system_positions(Control& c) {
  const std::string table = kTable;
  const char* const offsets = "HNGC p.214, work offsets";
  c.variables.insert(
      c.variables.end(),
      {
          {4001, 4021, Kind::ModalCode, kReadOnly, 0, "HNGC p.212, #4001 to #4021", Manual},
          {5001, 5006, Kind::BlockEnd, kReadOnly, 0, "HNGC p.213, #5001 to #5006", Manual},
          {5021, 5026, Kind::MachinePosition, kReadOnly, 0, "HNGC p.213, #5021", Manual},
          {5041, 5046, Kind::WorkPosition, kReadOnly, 0, "HNGC p.213, #5041", Manual},
          {5061, 5069, Kind::SkipPosition, kReadOnly, 0, "HNGC p.214, #5061 to #5069", Manual},
          {5081, 5086, Kind::ActiveLength, kReadOnly, 0, "HNGC p.214, #5081", Manual},
          // #5201 to #5206, the offset of G52, is no external offset and is not held here.
          {5221, 5326, Kind::WorkOffset, kReadWrite, 0, offsets, Manual, 20},
          {7001, 7386, Kind::ExtraWorkOffset, kReadWrite, 0, offsets, Manual},
          {14001, 15966, Kind::ExtraWorkOffset, kReadWrite, 0, table, Manual},
      });
}

}  // namespace

void add_family_variables(Control& c) {
  const std::string table = kTable;
  c.variables = {
      {0, 0, Kind::Vacant, kReadOnly, 0, table, Manual},
      {1, 33, Kind::Local, kReadWrite, 0, "HNGC p.198, local variables", Manual},
      {700, 749, Kind::Kept, kReadWrite, 0, table, Manual},  // of the control's own programs
  };
  signals(c);
  system_variables(c);
  system_positions(c);
  // The numbers of older Haas controls are other names of these.
  for (const auto& [first, last] : {std::pair{100, 199}, {500, 699}, {800, 999}})
    c.variables.push_back({first, last, Kind::Kept, kReadWrite, 0, "HNGC p.199, legacy ranges",
                           Manual, 10000 + first});
  for (const char address : {'B', 'D', 'F', 'H', 'M', 'S', 'T'}) {
    const std::int32_t number = modal_word_number(address);
    c.variables.push_back({number, number, Kind::ModalWord, kReadOnly, address,
                           "HNGC p.213, #4101 to #4126", Manual});
  }
  for (const char address : {'N', 'O'}) {
    const std::int32_t number = modal_word_number(address);
    c.variables.push_back({number, number, Kind::ModalWord, kReadOnly, address, kUnsure, Inferred});
  }
}

}  // namespace cncsub::haas
