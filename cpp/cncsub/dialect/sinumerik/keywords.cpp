#include "cncsub/dialect/sinumerik/keywords.hpp"

#include <algorithm>
#include <iterator>

#include "cncsub/dialect/sinumerik/line.hpp"

namespace cncsub::sinumerik {

namespace {

// [NCI groups]
constexpr std::string_view kNeutral[] = {"BRISK", "DRIVE",  "FFWOF", "FFWON",   "SOFT",
                                         "SBLOF", "STOPRE", "SBLON", "DISPLOF", "DISPLON"};

// Words of statements, calls and frames, and words that say how an axis goes. [NCI grammar; NCI
// groups]
constexpr std::string_view kNotComputed[] = {
    "ADIS",    "ADISPOS", "AMIRROR",  "AROT",      "AROTS",    "ASCALE",   "ASPLINE",
    "ATRANS",  "AXIS",    "BLOCK",    "BOOL",      "BSPLINE",  "CALL",     "CALLPATH",
    "CASE",    "CDOF",    "CDON",     "CFC",       "CFIN",     "CFTCP",    "CHAR",
    "CHF",     "CHR",     "CIP",      "CLEARM",    "COMPCAD",  "COMPCURV", "COMPOF",
    "COMPON",  "CROTS",   "CSPLINE",  "CT",        "CUT2D",    "CUT3DC",   "CYCLE800",
    "DC",      "DEF",     "DEFAULT",  "DEFINE",    "DELETE",   "DIAM90",   "DIAMOF",
    "DIAMON",  "DISC",    "DO",       "ENDFOR",    "ENDLABEL", "EVERY",    "EXECSTRING",
    "EXTCALL", "EXTERN",  "FGROUP",   "FIFOCTRL",  "FNORM",    "FOR",      "FRAME",
    "FROM",    "FXS",     "GET",      "GOTOS",     "IC",       "ID",       "IDS",
    "INIT",    "INT",     "INVCCW",   "INVCW",     "ISFILE",   "KONT",     "KONTC",
    "KONTT",   "LIMS",    "MCALL",    "MEAS",      "MEAW",     "MIRROR",   "MPF",
    "MSGL",    "NORM",    "OF",       "OFFN",      "ORIAXES",  "ORIMKS",   "ORIWKS",
    "OVR",     "OVRA",    "PCALL",    "POLF",      "POLY",     "POS",      "POSA",
    "POSP",    "PROC",    "PRESETON", "RDISABLE",  "READ",     "REAL",     "RELEASE",
    "REPEATB", "ROT",     "ROTS",     "ROUNDUP",   "RND",      "RNDM",     "SAVE",
    "SCALE",   "SET",     "SETAL",    "SETINT",    "SETM",     "SPCOF",    "SPCON",
    "SPOS",    "SPOSA",   "START",    "STARTFIFO", "STOPFIFO", "STRING",   "SUPA",
    "SUPD",    "TO",      "TOFRAME",  "TOROT",     "TOROTOF",  "TRACYL",   "TRAFOOF",
    "TRAILON", "TRAILOF", "TRANS",    "TRANSMIT",  "TRAORI",   "TURN",     "UNLOCK",
    "UPATH",   "VELOLIM", "WAITE",    "WAITM",     "WAITMC",   "WAITP",    "WAITS",
    "WALIMON", "WALIMOF", "WHEN",     "WHENEVER",  "WRITE"};

}  // namespace

bool is_neutral(std::string_view word) {
  return std::find(std::begin(kNeutral), std::end(kNeutral), word) != std::end(kNeutral);
}

bool is_not_computed(std::string_view word) {
  return std::find(std::begin(kNotComputed), std::end(kNotComputed), word) !=
         std::end(kNotComputed);
}

bool saves_modes(std::string_view line) {
  Line words;
  words.set(line, 0);
  if (words.peek() == 'N' && is_digit(words.ahead(1))) {
    words.pass(1);
    words.take_digits();
  }
  if (capitals(words.name()) != "PROC") return false;
  while (!words.at_end()) {
    const std::string_view name = words.name();
    if (capitals(name) == "SAVE") return true;
    words.pass(name.empty() ? first_character(words.rest()).size() : name.size());
  }
  return false;
}

}  // namespace cncsub::sinumerik
