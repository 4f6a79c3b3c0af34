"""python -m nacre: the command `nacre`, that of the package or the one along PATH."""
import os
import shutil
import sys


def _main() -> None:
    inside = os.path.join(os.path.dirname(__file__), "nacre")
    program = inside if os.access(inside, os.X_OK) else shutil.which("nacre")
    if program is None:
        sys.exit("nacre: error: no program: not in the package nacre, not along PATH")
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    _main()
