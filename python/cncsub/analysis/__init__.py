"""Analysis of programs and runs: references checked, blocks listed, one flat program."""
