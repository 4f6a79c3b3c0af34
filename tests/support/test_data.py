"""Finds the structures that judges in Python read, as test_data.h does for C++: the folder in NACRE_DATA, else
../shared/data beside the source tree. With the data there, a judge that can't run fails; without them it is skipped."""

import os
import pathlib
import sys

SKIPPED = 77  # what CTest counts as skipped
_SOURCE = pathlib.Path(__file__).resolve().parents[2]
ABSENT = "no test data: neither NACRE_DATA nor ../shared/data beside the source tree holds it"


def folder():
    """The data folder; None without one. A folder that NACRE_DATA names must hold the data."""
    named = os.environ.get("NACRE_DATA")
    path = pathlib.Path(named) if named else _SOURCE.parent / "shared/data"
    if (path / "expected.json").exists():
        return path
    if named:
        sys.exit(f"NACRE_DATA={named} holds no test data")
    return None


def needed_folder():
    """The data folder; ends the judge as skipped without one."""
    path = folder()
    if path is None:
        print(ABSENT)
        sys.exit(SKIPPED)
    return path


def cannot_judge(reason):
    """Ends a judge whose program or module is missing: as skipped without data, as failed with them."""
    print(reason)
    sys.exit(1 if folder() else SKIPPED)
