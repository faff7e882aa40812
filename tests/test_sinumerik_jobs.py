"""Programs as they come from posts and machine makers, in our own words: run, made flat, compared.

They hold what public programs of SINUMERIK use most: cycles at modal positions, PROC with values and
SAVE, loops over arrays, frames in loops, repeated parts, radius compensation, diameters, polar
coordinates, threads, zero points, and axes named by variables.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import pytest

import cncsub

CONTROL = "siemens-one"
OFFSETS = {"G54": {"X": 11.125, "Y": -40.25, "Z": 7.5}, "G55": {"X": 1.0}}


@dataclass(frozen=True)
class Job:
    """A program, how many moves it makes, and where in machine coordinates it ends."""

    name: str
    program: str
    moves: int
    end: tuple[float, float, float]
    word: str = ""  # that FANUC has no code for; nothing: its flat program is the same
    setup: dict[str, Any] = field(default_factory=lambda: {"length_offsets": {1: 10.0, 2: 20.0}})
    not_run: int = 0  # blocks that no jump leads to


JOBS = [
    Job(
        "holes by cycles",
        """
        %_N_DRILL_MPF
        G17 G90 G54 G40
        T1 M6 S1200 M3 F200
        G0 X10 Y10 Z50 M8
        MCALL CYCLE81(20,0,2,-12)
        X10 Y10
        X30
        Y30
        MCALL
        G0 Z50
        T2 M6 S800 M3 F150
        MCALL CYCLE83(20,0,2,-30,,-8,,4,0,0,1,1)
        HOLES1(10,10,30,10,15,4)
        HOLES2(50,50,20,0,60,6)
        MCALL
        G0 Z100 M9
        M30
        """,
        235,
        (71.125, -7.571, 127.5),
        word="would not do the same",
    ),
    Job(
        "passes of a subprogram",
        """
        %_N_POCKET_MPF
        DEF REAL DEEP=-9, STEP=3, ZZ
        DEF INT PASSES
        G17 G90 G54
        T1 M6 S3000 M3
        G0 X0 Y0 Z5
        PASSES=TRUNC(ABS(DEEP)/STEP)
        FOR PASSES=1 TO TRUNC(ABS(DEEP)/STEP)
        ZZ=-PASSES*STEP
        ROUND_ONE(ZZ,20,10)
        ENDFOR
        G0 Z50
        M30
        %_N_ROUND_ONE_SPF
        PROC ROUND_ONE(REAL ZTO, REAL LX, REAL LY=5) SAVE
        G1 Z=ZTO F200
        G91 X=LX/2 F800
        Y=LY/2
        X=-LX
        Y=-LY
        X=LX
        Y=LY/2
        G90 X0 Y0
        M17
        """,
        26,
        (11.125, -40.25, 67.5),
        word="would not do the same",
    ),
    Job(
        "a compensated contour",
        """
        %_N_CONTOUR_MPF
        G17 G90 G54
        T1 D1 M6 S2000 M3
        G0 X-30 Y-30 Z5
        G1 Z-5 F300
        G41 X0 Y-10 F600
        Y40
        G2 X10 Y50 CR=10
        G1 X50
        G2 X60 Y40 I0 J-10
        G1 Y0 CHF=3
        X-10
        G40 X-30 Y-30
        G0 Z50
        M30
        """,
        14,
        (-18.875, -70.25, 67.5),
        word="D",
        setup={"length_offsets": {1: 10.0}, "radius_offsets": {1: 3.0}},
    ),
    Job(
        "frames",
        """
        %_N_FRAMES_MPF
        DEF INT I_1
        G17 G90 G54
        T1 M6 S1000 M3 F500
        TRANS X50 Y50
        FOR I_1=0 TO 5
        AROT RPL=60
        G0 X20 Y0 Z2
        G1 X30 Z-3
        G0 Z2
        ENDFOR
        TRANS
        MIRROR X0
        G0 X10 Y0
        G2 X20 Y10 CR=10
        MIRROR
        SCALE X2 Y2
        G0 X5 Y5
        G1 X10
        SCALE
        G0 Z50
        M30
        """,
        23,
        (31.125, -30.25, 67.5),
        word="TRANS",
    ),
    Job(
        "repeated parts",
        """
        %_N_REP_MPF
        N10 G17 G90 G54 F400 S500 M3
        N15 R1=0
        N20 G0 X0 Y0 Z1
        N30 START: G91 G1 X5 Z-1.5
        N40 Y5
        N60 X-5 Y-5
        N70 FINISH: G0 Z1
        N80 G90
        N90 REPEAT START FINISH P=3
        N100 LAB: R1=R1+1
        N110 G0 X=R1*10
        N120 IF R1<3 GOTOB LAB
        N130 CASE(R1) OF 1 GOTOF AA1 3 GOTOF BB1 DEFAULT GOTOF CC1
        N140 AA1: G0 Y1
        N150 BB1: G0 Y2
        N160 CC1: G0 Y3
        N170 M30
        """,
        22,
        (71.125, -35.25, 6.5),
        not_run=1,
    ),
    Job(
        "turning in diameters",
        """
        %_N_TURN_MPF
        G18 G90 G54 G95
        DIAMON
        T1 D1
        S1500 M3
        G0 X62 Z2 R1=60
        WHILE R1>40
        R1=R1-5
        G0 X=R1
        G1 Z-30 F0.25
        G1 X=R1+2
        G0 Z2
        ENDWHILE
        G0 X100 Z100
        DIAMOF
        M30
        """,
        18,
        (61.125, 0.0, 107.5),
        word="DIAMON",
        setup={"tools": {1: {"X": 0.0, "Z": 0.0, "R": 3.0}}},
    ),
    Job(
        "a pitch circle",
        """
        %_N_POLAR_MPF
        G17 G90 G54 S900 M3 F300
        G0 X0 Y0 Z5
        G111 X40 Y30
        G0 RP=25 AP=0
        R1=0
        LOOP
        R1=R1+1
        G1 Z-2
        G0 Z5
        AP=IC(45)
        IF R1>=8 GOTOF DONE
        ENDLOOP
        DONE: G0 Z50
        M30
        """,
        27,
        (76.125, -10.25, 57.5),
        word="G111",
    ),
    Job(
        "threads",
        """
        %_N_THREAD_MPF
        G17 G90 G54
        T3 M6 S400 M3
        G0 X20 Y20 Z5
        CYCLE84(10,0,2,-15,,0.5,5,,1,0,400,400)
        G0 X40
        G331 Z-10 K1.25 S300
        G332 Z5 K1.25
        SPOS=0
        G0 Z50
        M30
        """,
        10,
        (51.125, -20.25, 57.5),
        word="G331",
    ),
    Job(
        "calls with values",
        """
        %_N_NEST_MPF
        EXTERN CORNER(REAL,REAL)
        DEF REAL SIZE[2,2]=SET(10,20,30,40)
        DEF STRING[20] NAME="PART"
        DEF BOOL FINE=TRUE
        G17 G90 G54 F500 S100 M3
        G0 X0 Y0 Z2
        CORNER(SIZE[0,0],SIZE[0,1])
        CORNER(SIZE[1,0],SIZE[1,1]) P=2
        CALL "L20"
        IF FINE AND (STRLEN(NAME)==4)
        MSG("part "<<NAME)
        G0 X=INDEX(NAME,"R")
        ENDIF
        G55 G0 X1 Y1
        G500
        G54 G0 X0 Y0
        M30
        %_N_CORNER_SPF
        PROC CORNER(REAL XX, REAL YY)
        G0 X=XX Y=YY
        G1 Z-1
        L20
        G0 Z2
        RET
        %_N_L20_SPF
        ATRANS X5
        G1 X1 Y1
        TRANS
        M17
        """,
        17,
        (11.125, -40.25, 9.5),
        word="ATRANS",
    ),
    Job(
        "axes by their names",
        """
        %_N_AXES_MPF
        DEF AXIS LENG=X, CROSS=Y
        G17 G90 G54 G94
        S1500 M3
        G0 X0 Y0 Z2
        STROKE(X,Y,40)
        STROKE(CROSS,LENG,-20)
        G0 Z50
        M30
        %_N_STROKE_SPF
        PROC STROKE(AXIS ALONG, AXIS OVER, REAL FAR) SAVE
        DEF INT PASSES
        G91 G1 F300
        FOR PASSES=1 TO 3
        AX[ALONG]=FAR
        AX[OVER]=1
        AX[ALONG]=-FAR AX[OVER]=1
        ENDFOR
        RET
        """,
        20,
        (17.125, -34.25, 57.5),
    ),
]


def library_of(job: Job) -> cncsub.Library:
    lines = (line.strip() for line in job.program.strip().splitlines())
    return cncsub.loads("\n".join(lines) + "\n", control=CONTROL)


def setup_of(job: Job) -> cncsub.Setup:
    return cncsub.Setup(increment=0.001, work_offsets=OFFSETS, **job.setup)


def moves_of(run: cncsub.Run) -> list[tuple[str, float, float, float]]:
    return [(m.kind, round(m.mx, 4), round(m.my, 4), round(m.mz, 4)) for m in run.moves]


every_job = pytest.mark.parametrize("job", JOBS, ids=lambda job: job.name)


@every_job
def test_a_job_runs_to_its_end(job: Job) -> None:
    library = library_of(job)
    run = library.run(setup=setup_of(job))
    run.assert_ends()
    assert len(run.moves) == job.moves
    last = run.moves[-1]
    assert (last.mx, last.my, last.mz) == pytest.approx(job.end, abs=1e-3)
    assert [of.message for of in library.check() if of.severity != "note"] == []
    assert sum(not block.covered for block in run.coverage().blocks) == job.not_run


@every_job
def test_its_flat_program_makes_the_same_moves(job: Job) -> None:
    library, setup = library_of(job), setup_of(job)
    flat = library.flatten(setup=setup)
    flat.verify()
    again = cncsub.loads(flat.text, control=CONTROL).run(setup=setup)
    assert moves_of(again) == moves_of(library.run(setup=setup))


@every_job
def test_flat_for_fanuc_it_is_the_same_or_refused(job: Job) -> None:
    library, setup = library_of(job), setup_of(job)
    if job.word:
        with pytest.raises(ValueError, match=job.word):
            library.flatten(control="fanuc-0i-f", setup=setup)
        return
    flat = library.flatten(control="fanuc-0i-f", setup=setup)
    again = cncsub.loads(flat.text, control="fanuc-0i-f").run(setup=setup)
    assert moves_of(again) == moves_of(library.run(setup=setup))


MACRO = """
O2000
G17 G90 G54 S500 M3
#1=0
WHILE[#1LT6]DO1
G0 X[30*COS[60*#1]] Y[30*SIN[60*#1]]
G1 Z-5. F100
G0 Z2.
#1=#1+1
END1
G65 P2001 A10. B20.
M98 P32002
M30
O2001
G0 X#1 Y#2
IF[#1GT5]GOTO10
G0 Z1.
N10 G91 G1 X1. F50
G90
M99
O2002
G91 G0 X1.
G90
M99
"""


@pytest.mark.parametrize("control", ["siemens-one", "siemens-828d", "siemens-840d-sl"])
def test_a_macro_of_fanuc_is_flat_for_a_sinumerik(control: str) -> None:
    setup = cncsub.Setup(increment=0.001, work_offsets=OFFSETS)
    library = cncsub.loads(MACRO.lstrip(), control="fanuc-0i-f")
    flat = library.flatten(control=control, setup=setup)
    flat.verify()
    again = cncsub.loads(flat.text, control=control).run(setup=setup)
    assert moves_of(again) == moves_of(library.run(setup=setup))
    assert len(again.moves) == 23


def test_one_job_in_two_languages_is_compared() -> None:
    begun = "G17 G90 G54 S500 M3 F100.\nG0 X10. Y10.\nG1 X20.\n"
    one = cncsub.loads(begun + "G2 X30. Y20. CR=10.\nG0 Z5.\nM30\n", control=CONTROL)
    for y, same in ((20, True), (21, False)):
        text = f"O1\n{begun}G2 X30. Y{y}. R10.\nG0 Z5.\nM30\n"
        compared = cncsub.compare(one, cncsub.loads(text, control="fanuc-0i-f"))
        assert compared.same == same
