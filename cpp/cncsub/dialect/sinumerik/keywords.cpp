#include "cncsub/dialect/sinumerik/keywords.hpp"

#include <array>
#include <cstdint>

#include "cncsub/code/block.hpp"

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

// [NCI groups]
constexpr Word kWords[] = {{"TRANS", 3},   {"ATRANS", 3}, {"ROT", 3},      {"AROT", 3},
                           {"SCALE", 3},   {"ASCALE", 3}, {"MIRROR", 3},   {"AMIRROR", 3},
                           {"CIP", 1},     {"CT", 1},     {"SUPA", 9},     {"DIAMON", 29},
                           {"DIAMOF", 29}, {"BRISK", 21}, {"DRIVE", 21},   {"SOFT", 21},
                           {"FFWOF", 24},  {"FFWON", 24}, {"WALIMON", 28}, {"WALIMOF", 28}};

// Words that change no path: how an axis starts and brakes, how exactly and how fast the path is
// followed, the orientation of a tool that no transformation turns, and what the screen shows. [NCI
// groups; general knowledge of the SINUMERIK 840D]
constexpr std::string_view kNeutral[] = {
    "BRISK",     "BRISKA",    "DRIVE",    "DRIVEA",     "SOFT",       "SOFTA",    "FFWOF",
    "FFWON",     "SBLOF",     "SBLON",    "STOPRE",     "DISPLOF",    "DISPLON",  "WALIMON",
    "WALIMOF",   "CFC",       "CFTCP",    "CFIN",       "CDON",       "CDOF",     "CDOF2",
    "FNORM",     "FLIN",      "FCUB",     "COMPON",     "COMPOF",     "COMPCURV", "COMPCAD",
    "CUT2D",     "NORM",      "FIFOCTRL", "STARTFIFO",  "STOPFIFO",   "TRAFOOF",  "TOROTOF",
    "PAROTOF",   "RTLION",    "RTLIOF",   "DYNNORM",    "DYNPOS",     "DYNROUGH", "DYNSEMIFIN",
    "DYNFINISH", "CPRECON",   "CPRECOF",  "UPATH",      "SPATH",      "ORIWKS",   "ORIMKS",
    "ORIAXES",   "ORIVECT",   "ORIPLANE", "ORIEULER",   "ORIRPY",     "ORIRPY2",  "ORIVIRT1",
    "ORIVIRT2",  "ORIC",      "ORID",     "OSOF",       "OSC",        "OSS",      "ORISON",
    "ORISOF",    "COMPSURF",  "COMPPATH", "DYNPREC",    "FTOCOF",     "OSSE",     "OSD",
    "OST",       "PTPG0",     "CP",       "LFON",       "LFOF",       "FENDNORM", "WAITENC",
    "RELIEVEON", "RELIEVEOF", "SUPD",     "DELAYFSTON", "DELAYFSTOF", "IPTRLOCK", "IPTRUNLOCK",
    "WALCS0",    "WALCS1",    "WALCS2",   "WALCS3",     "WALCS4",     "WALCS5",   "WALCS6",
    "WALCS7",    "WALCS8",    "WALCS9",   "WALCS10",    "AFISON",     "AFISOF",   "ICYCON",
    "ICYCOF"};

// Words with a value, of an axis or a spindle in brackets too. [NCI grammar; general knowledge of
// the SINUMERIK 840D]
constexpr std::string_view kReported[] = {
    "ACC", "ACCLIMA", "JERKLIMA", "VELOLIMA", "VELOLIM", "ADIS", "ADISPOS", "FA",    "FB",    "FD",
    "FDA", "FL",      "FMA",      "LIMS",     "OVR",     "OVRA", "OVRRAP",  "SPOS",  "SPOSA", "SCC",
    "SVC", "FZ",      "DITS",     "DITE",     "CTOL",    "OTOL", "ATOL",    "STOLF", "FGREF", "SF"};

// Calls that change no path: spindles, feeds, channels, tool management, and the marks of editors.
// [general knowledge of the SINUMERIK 840D]
constexpr std::string_view kReportedCalls[] = {
    "FGROUP",   "SETMS",    "WAITP",       "WAITS",     "WAITM",        "WAITMC",    "WAITE",
    "CLEARM",   "SETM",     "GET",         "GETD",      "RELEASE",      "SPCON",     "SPCOF",
    "BLSYNC",   "TMON",     "TMOF",        "GWPSON",    "GWPSOF",       "DISABLE",   "ENABLE",
    "CLRINT",   "STOPREOF", "GROUP_BEGIN", "GROUP_END", "GROUP_ADDEND", "WORKPIECE", "LOCK",
    "UNLOCK",   "CLGON",    "CLGOF",       "NPROT",     "CPROT",        "MSGL",      "DRFOF",
    "ADISPOSA", "AUXFUDEL", "AUXFUDELG",   "AUXFUMSEQ", "AUXFUSYNC",    "CADAPTON",  "CADAPTOF",
    "ESRR",     "ESRS",     "FPR",         "FPRAOF",    "FPRAON",       "IPOBRKA",   "JERKA",
    "RESETMON", "SIRELIN",  "SIRELOUT",    "SIRELTIME", "TML",          "POSM",      "POSMT",
    "CYCLE832", "NEWCONF",  "CHANDATA",    "CANCEL",    "MMC",          "CTABDEL",   "PROTA",
    "PROTS"};

// Words of an axis, which stands in brackets after them. [general knowledge of the SINUMERIK 840D]
constexpr std::string_view kAxisEnds[] = {"FINEA", "COARSEA", "IPOENDA"};

// [general knowledge of the SINUMERIK 840D]
constexpr std::string_view kOffAtZero[] = {"TOFFL",  "TOFFR", "TOFF", "TCARR",
                                           "CUTMOD", "DL",    "DISC"};

// Words of statements, calls and frames, and words that say how an axis goes. [NCI grammar; NCI
// groups; general knowledge of the SINUMERIK 840D]
constexpr std::string_view kNotComputed[] = {
    "AROTS",    "ASPLINE",  "AXIS",     "BLOCK",    "BOOL",     "BSPLINE",     "CALL",
    "CASE",     "CHAR",     "CROTS",    "CSPLINE",  "CUT3DC",   "DEFAULT",     "DEFINE",
    "DELETE",   "DIAM90",   "DO",       "ENDFOR",   "ENDLABEL", "EVERY",       "EXECSTRING",
    "EXTCALL",  "FOR",      "FP",       "FRAME",    "FROM",     "FXS",         "GOTOS",
    "ID",       "IDS",      "INIT",     "INT",      "INVCCW",   "INVCW",       "ISFILE",
    "KONT",     "KONTC",    "KONTT",    "MEAW",     "MPF",      "OF",          "PCALL",
    "POLF",     "POLY",     "POSA",     "POSP",     "PRESETON", "RDISABLE",    "READ",
    "REAL",     "REPEATB",  "ROTS",     "ROUNDUP",  "SAVE",     "SET",         "SETINT",
    "START",    "STRING",   "TO",       "TOFRAME",  "TOROT",    "TRACYL",      "TRAILON",
    "TRAILOF",  "TRANSMIT", "TRAORI",   "WHEN",     "WHENEVER", "WRITE",       "BAUTO",
    "BNAT",     "BTAN",     "EAUTO",    "ENAT",     "ETAN",     "PW",          "SD",
    "PL",       "AC",       "IC",       "DC",       "ACP",      "ACN",         "CTABDEF",
    "CTABEND",  "EGDEF",    "EGON",     "EGONSYN",  "EGOFS",    "EGOFC",       "LEADON",
    "LEADOF",   "COUPDEF",  "COUPON",   "COUPOF",   "TRAANG",   "TRACON",      "TRACOORD",
    "GEOAX",    "PAROT",    "MEAFRAME", "SETPIECE", "GETT",     "REPOS",       "REPOSA",
    "REPOSL",   "REPOSH",   "REPOSHA",  "REPOSQ",   "REPOSQA",  "INITIAL_INI", "CONTPRON",
    "CONTDCON", "EXECTAB",  "EXECUTE",  "CORROF",   "POLFMASK", "POLFMLIN"};

// The same, of words that some programs define as names of their own. [general knowledge of the
// SINUMERIK 840D]
constexpr std::string_view kFurther[] = {
    "AXTOCHAN",  "CALCPOSI",   "COMPLETE",   "COUPDEL",  "COUPOFS",    "COUPONC",    "COUPRES",
    "CPROTDEF",  "CTAB",       "CTABEXISTS", "CTABFNO",  "CTABFPOL",   "CTABFSEG",   "CTABID",
    "CTABINV",   "CTABISLOCK", "CTABLOCK",   "CTABMEM",  "CTABMEMTYP", "CTABMPOL",   "CTABMSEG",
    "CTABNO",    "CTABNOMEM",  "CTABPERIOD", "CTABPOL",  "CTABPOLID",  "CTABSEG",    "CTABSEGID",
    "CTABSEV",   "CTABSSV",    "CTABTEP",    "CTABTEV",  "CTABTMAX",   "CTABTMIN",   "CTABTSP",
    "CTABTSV",   "CTABUNLOCK", "CUT2DF",     "CUT3DCC",  "CUT3DCCD",   "CUT3DF",     "CUT3DFF",
    "CUT3DFS",   "CUTCONOF",   "CUTCONON",   "DELDTG",   "DELMLOWNER", "DELTOOLENV", "DIAM90A",
    "DIAMCHAN",  "DIAMCHANA",  "DIAMOFA",    "DIAMONA",  "DISCL",      "DZERO",      "EGDEL",
    "EGONSYNE",  "FAD",        "FCTDEF",     "FOCOF",    "FOCON",      "FPO",        "FTOC",
    "FTOCON",    "FXST",       "FXSW",       "GETTCOR",  "GETTENV",    "GETVARAP",   "GETVARDFT",
    "GETVARLIM", "GETVARPHU",  "GETVARTYP",  "INICF",    "INTERSEC",   "INTTOAX",    "INVFRAME",
    "LEAD",      "LENTOAX",    "LFPOS",      "LFTXT",    "LFWP",       "LIFTFAST",   "ALF",
    "MASLDEF",   "MASLDEL",    "MASLOF",     "MASLOFS",  "MASLON",     "MEAC",       "MEASA",
    "MEAWA",     "MESURE",     "MODAXVAL",   "MOV",      "NPROTDEF",   "OEMIPO1",    "OEMIPO2",
    "OMA1",      "OMA2",       "OMA3",       "OMA4",     "OMA5",       "ORIAXPOS",   "ORICONCCW",
    "ORICONCW",  "ORICONIO",   "ORICONTO",   "ORICURVE", "ORIPATH",    "ORIPATHS",   "ORIRESET",
    "ORIROTA",   "ORIROTC",    "ORIROTR",    "ORIROTT",  "ORIS",       "OS",         "OSB",
    "OSCILL",    "OSCTRL",     "OSNSC",      "OSP1",     "OSP2",       "PDELAYOF",   "PDELAYON",
    "POLFA",     "POLYPATH",   "PON",        "PONS",     "POSRANGE",   "PRIO",       "PTP",
    "PUNCHACC",  "PUTFTOC",    "PUTFTOCF",   "QECLROF",  "QECLRON",    "RMB",        "RME",
    "RMI",       "RMN",        "SETDNO",     "SETMTH",   "SETTA",      "SETTCOR",    "SETTIA",
    "SIRELAY",   "SON",        "SONS",       "SPIF1",    "SPIF2",      "SPLINEPATH", "SPN",
    "SPOF",      "SPP",        "STA",        "SYNFCT",   "TANG",       "TANGDEL",    "TANGOF",
    "TANGON",    "TCOABS",     "TCOFR",      "TCOFRX",   "TCOFRY",     "TCOFRZ",     "THETA",
    "TILT",      "TLIFT",      "TOFFOF",     "TOFFON",   "TOFRAMEX",   "TOFRAMEY",   "TOFRAMEZ",
    "TOROTX",    "TOROTY",     "TOROTZ",     "TOWBCS",   "TOWKCS",     "TOWMCS",     "TOWSTD",
    "TOWTCS",    "TOWWCS",     "WAITC",      "WRTPR",    "RESET",      "CANCELSUB",  "EXTOPEN",
    "EXTCLOSE",  "TCA",        "MVTOOL"};

// E, N, O, P and Q, G and M are no addresses with a value in the mask: others have their places.
// [NCI grammar]
constexpr Spelling::LongAddress kLong[] = {
    {"CR", 'R' - 'A'},  {"RPL", 'E' - 'A'},  {"AR", 'Q' - 'A'},   {"TURN", 'P' - 'A'},
    {"I1", 'I' - 'A'},  {"J1", 'J' - 'A'},   {"K1", 'K' - 'A'},   {"RP", kRadius},
    {"AP", kAngle},     {"CHR", kCommaC},    {"CHF", kCommaD},    {"RND", kCommaR},
    {"ANG", kCommaA},   {"LIMS", 'L' - 'A'}, {"RNDM", 'O' - 'A'}, {"OFFN", 'N' - 'A'},
    {"FRC", 'G' - 'A'}, {"FRCM", 'M' - 'A'}};

/// The words that are not computed, and what they would need.
struct Need {
  std::string_view word, needs;
};
constexpr std::string_view kInterrupts =
    "an interrupt runs when the PLC asks for it, and a run has none: leave the block out";
constexpr std::string_view kSynchronous =
    "a synchronized action runs beside the blocks, in the cycle of the drives: leave it out for a "
    "run without it";
constexpr std::string_view kFiles = "files are not written while a program runs";
constexpr std::string_view kToolPlaces = "a run has no magazine: write T and M6";
constexpr std::string_view kOscillates = "an axis that oscillates moves beside the path";
constexpr Need kNeeds[] = {
    {"SETINT", kInterrupts},
    {"PRIO", kInterrupts},
    {"LIFTFAST", kInterrupts},
    {"BLSYNC", kInterrupts},
    {"ID", kSynchronous},
    {"IDS", kSynchronous},
    {"WHEN", kSynchronous},
    {"WHENEVER", kSynchronous},
    {"EVERY", kSynchronous},
    {"RESET", kSynchronous},
    {"CANCELSUB", kSynchronous},
    {"FROM", kSynchronous},
    {"DO", kSynchronous},
    {"OS", kOscillates},
    {"OSCILL", kOscillates},
    {"OSP1", kOscillates},
    {"OSP2", kOscillates},
    {"EXECSTRING",
     "the text is a block that is known only when it runs: write the block "
     "itself, or choose among blocks by IF"},
    {"INIT", "a run has one channel"},
    {"START", "a run has one channel"},
    {"EXTOPEN", kFiles},
    {"EXTCLOSE", kFiles},
    {"TCA", kToolPlaces},
    {"MVTOOL", kToolPlaces},
    {"DISC", "an outside corner between an arc and a meeting point: G450 or G451 without it"},
    {"TRAORI", "it needs the kinematics of the machine"},
    {"TRANSMIT", "it needs the data of the transformation"},
    {"TRACYL", "it needs the data of the transformation"},
    {"TOFRAME", "it needs the direction of the tool"},
    {"TOROT", "it needs the direction of the tool"},
    {"BSPLINE", "the path between the points of a spline is not computed"},
    {"ASPLINE", "the path between the points of a spline is not computed"},
    {"CSPLINE", "the path between the points of a spline is not computed"},
    {"POLY", "the path of a polynomial is not computed"},
    {"POSA", "the axis moves on while the next blocks run: write POS where they can wait for it"},
    {"POSP", "the axis comes in parts while the next blocks run: write POS where they can wait"},
    {"KONT", "how the tool goes around the first point is not computed"},
    {"KONTC", "how the tool goes around the first point is not computed"},
    {"KONTT", "how the tool goes around the first point is not computed"}};

}  // namespace

const std::span<const std::string_view> kNeutralWords = kNeutral;
const std::span<const std::string_view> kReportedWords = kReported;
const std::span<const std::string_view> kReportedCallWords = kReportedCalls;
const std::span<const std::string_view> kOffAtZeroWords = kOffAtZero;
const std::span<const std::string_view> kAxisEndWords = kAxisEnds;
const std::span<const std::string_view> kNotComputedWords = kNotComputed;
const std::span<const std::string_view> kFurtherWords = kFurther;

int group_of(int code) {
  static constexpr auto kGroups = [] {
    std::array<std::int8_t, 1000> groups{};
    for (const Codes& of : kCodes)
      for (int each = of.first; each <= of.last; ++each)
        groups[static_cast<std::size_t>(each)] = of.group;
    return groups;
  }();
  return code >= 0 && code < 1000 ? kGroups[static_cast<std::size_t>(code)] : 0;
}

int group_of(std::string_view word) {
  for (const Word& of : kWords)
    if (of.word == word) return of.group;
  return 0;
}

bool is_neutral(std::string_view word) { return is_among(kNeutral, word); }

bool is_reported_call(std::string_view word) { return is_among(kReportedCalls, word); }

bool is_axis_end(std::string_view word) { return is_among(kAxisEnds, word); }

bool is_off_at_zero(std::string_view word) { return is_among(kOffAtZero, word); }

bool is_reported(std::string_view word) { return is_among(kReported, word); }

bool is_not_computed(std::string_view word) {
  return is_among(kNotComputed, word) || is_among(kFurther, word);
}

std::string what_it_needs(std::string_view word) {
  std::string text(word);
  for (const Need& of : kNeeds)
    if (of.word == word) text.append(": ").append(of.needs);
  return text;
}

const std::span<const Spelling::LongAddress> kLongAddresses = kLong;

int place_of(std::string_view address) {
  for (const Spelling::LongAddress& of : kLong)
    if (of.name == address) return of.place;
  return -1;
}

bool is_jump(std::string_view word) {
  static constexpr std::string_view kJumps[] = {"GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS"};
  return is_among(kJumps, word);
}

}  // namespace cncsub::sinumerik
