"""python -m nacre: the command `nacre`, that of the package or the one along PATH."""
import os
import shutil
import sys

_program = os.path.join(os.path.dirname(__file__), "nacre")
if not os.access(_program, os.X_OK):
    _program = shutil.which("nacre")
if not _program:
    sys.exit("nacre: error: no program: not in the package nacre, not along PATH")
os.execv(_program, ["nacre", *sys.argv[1:]])
