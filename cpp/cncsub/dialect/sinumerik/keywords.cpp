#include "cncsub/dialect/sinumerik/keywords.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace cncsub::sinumerik {

namespace {

struct Codes {
  std::int16_t first, last;  // codes in a row
  std::int8_t group;
};

// [NCI, ggroups.json: the G groups of the manual]
constexpr Codes kCodes[] = {
    {0, 3, 1},      {33, 35, 1},    {331, 332, 1},  {335, 336, 1},  {4, 5, 2},      {7, 7, 2},
    {63, 63, 2},    {74, 75, 2},    {147, 148, 2},  {247, 248, 2},  {347, 348, 2},  {25, 26, 3},
    {58, 59, 3},    {110, 112, 3},  {17, 19, 6},    {40, 42, 7},    {54, 57, 8},    {500, 500, 8},
    {505, 599, 8},  {53, 53, 9},    {153, 153, 9},  {60, 60, 10},   {64, 64, 10},   {641, 645, 10},
    {9, 9, 11},     {601, 603, 12}, {70, 71, 13},   {700, 700, 13}, {710, 710, 13}, {90, 91, 14},
    {93, 97, 15},   {931, 931, 15}, {942, 942, 15}, {952, 952, 15}, {961, 962, 15}, {971, 973, 15},
    {450, 451, 18}, {810, 819, 31}, {820, 829, 32}, {140, 143, 43}, {340, 341, 44}, {290, 291, 47},
    {460, 462, 48}, {62, 62, 57},   {621, 621, 57}};

struct Word {
  std::string_view word;
  std::int8_t group;
};

constexpr Word kWords[] = {
    {"BRISK", 21}, {"DRIVE", 21}, {"SOFT", 21}, {"FFWOF", 24}, {"FFWON", 24}};

// [NCI groups]
constexpr std::string_view kNeutral[] = {"BRISK", "DRIVE",  "FFWOF", "FFWON",   "SOFT",
                                         "SBLOF", "STOPRE", "SBLON", "DISPLOF", "DISPLON"};

// Words of statements, calls and frames, and words that say how an axis goes. [NCI grammar; NCI
// groups]
constexpr std::string_view kNotComputed[] = {
    "ADIS",     "ADISPOS", "AMIRROR",  "AROT",    "AROTS",      "ASCALE",   "ASPLINE",
    "ATRANS",   "AXIS",    "BLOCK",    "BOOL",    "BSPLINE",    "CALL",     "CALLPATH",
    "CASE",     "CDOF",    "CDON",     "CFC",     "CFIN",       "CFTCP",    "CHAR",
    "CHF",      "CHR",     "CIP",      "CLEARM",  "COMPCAD",    "COMPCURV", "COMPOF",
    "COMPON",   "CROTS",   "CSPLINE",  "CT",      "CUT2D",      "CUT3DC",   "DC",
    "DEFAULT",  "DEFINE",  "DELETE",   "DIAM90",  "DIAMOF",     "DIAMON",   "DISC",
    "DO",       "ENDFOR",  "ENDLABEL", "EVERY",   "EXECSTRING", "EXTCALL",  "FGROUP",
    "FIFOCTRL", "FNORM",   "FOR",      "FRAME",   "FROM",       "FXS",      "GET",
    "GOTOS",    "IC",      "ID",       "IDS",     "INIT",       "INT",      "INVCCW",
    "INVCW",    "ISFILE",  "KONT",     "KONTC",   "KONTT",      "LIMS",     "MEAS",
    "MEAW",     "MIRROR",  "MPF",      "MSGL",    "NORM",       "OF",       "OFFN",
    "ORIAXES",  "ORIMKS",  "ORIWKS",   "OVR",     "OVRA",       "PCALL",    "POLF",
    "POLY",     "POS",     "POSA",     "POSP",    "PRESETON",   "RDISABLE", "READ",
    "REAL",     "RELEASE", "REPEATB",  "ROT",     "ROTS",       "ROUNDUP",  "RND",
    "RNDM",     "SAVE",    "SCALE",    "SET",     "SETINT",     "SETM",     "SPCOF",
    "SPCON",    "SPOS",    "SPOSA",    "START",   "STARTFIFO",  "STOPFIFO", "STRING",
    "SUPA",     "SUPD",    "TO",       "TOFRAME", "TOROT",      "TOROTOF",  "TRACYL",
    "TRAFOOF",  "TRAILON", "TRAILOF",  "TRANS",   "TRANSMIT",   "TRAORI",   "TURN",
    "UNLOCK",   "UPATH",   "VELOLIM",  "WAITE",   "WAITM",      "WAITMC",   "WAITP",
    "WAITS",    "WALIMON", "WALIMOF",  "WHEN",    "WHENEVER",   "WRITE"};

}  // namespace

int group_of(int code) {
  for (const Codes& of : kCodes)
    if (code >= of.first && code <= of.last) return of.group;
  return 0;
}

int group_of(std::string_view word) {
  for (const Word& of : kWords)
    if (of.word == word) return of.group;
  return 0;
}

bool is_neutral(std::string_view word) {
  return std::find(std::begin(kNeutral), std::end(kNeutral), word) != std::end(kNeutral);
}

bool is_not_computed(std::string_view word) {
  return std::find(std::begin(kNotComputed), std::end(kNotComputed), word) !=
         std::end(kNotComputed);
}

}  // namespace cncsub::sinumerik
