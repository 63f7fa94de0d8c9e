"""The command line tool: ``python -m predicament``, and the script ``predicament``."""

import sys

from . import _native


def main() -> int:
    """Runs the command of the command line, and returns its exit code."""
    return _native.main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
