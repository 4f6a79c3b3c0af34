"""The command `nacre` of a wheel: starts the program in the package, without importing numpy or the module."""
import importlib.util
import os
import sys


def program():
    """The program of the package nacre, or None if the package has none."""
    package = importlib.util.find_spec("nacre")
    path = os.path.join(os.path.dirname(package.origin), "nacre") if package and package.origin else ""
    return path if os.access(path, os.X_OK) else None


def main():
    path = program()
    if path is None:
        sys.exit("nacre: error: the package nacre has no program")
    os.execv(path, [path, *sys.argv[1:]])  # by its own name, beside which it finds its driver
