"""What is told of programs and of runs: references checked, blocks listed, one flat program."""
