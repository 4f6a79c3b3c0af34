"""The command `nacre`: starts the program of the package, or the one along PATH. It imports neither numpy nor the module.

python -m nacre runs it, and a wheel installs it as the script `nacre`.
"""
import importlib.util
import os
import shutil
import sys


def _program():
    package = importlib.util.find_spec("nacre")
    inside = os.path.join(os.path.dirname(package.origin), "nacre") if package and package.origin else ""
    if os.access(inside, os.X_OK):
        return inside  # by its path: it finds its driver next to it
    along = shutil.which("nacre")
    return along if along and not os.path.samefile(along, __file__) else None


if __name__ == "__main__":
    _path = _program()
    if _path is None:
        sys.exit("nacre: error: no program: not in the package nacre, not along PATH")
    os.execv(_path, [_path, *sys.argv[1:]])
