"""`python -m cncsub` is the command `cncsub`."""

from cncsub.cli import main

if __name__ == "__main__":
    main()
