"""The Objective-C++ of the apps, held against declarations of what they use of Apple's frameworks (stubs/): names,
arguments, types, nullability, and whether the oldest system that the apps are built for has it. For Apple's processors
and systems, with the C and C++ headers of this one. Nothing is linked, and nothing runs.

syntax_test.py SOURCE: the source folder."""

import pathlib
import subprocess
import sys
import unittest

SOURCE = pathlib.Path(sys.argv[1])
TARGETS = {"ios": "arm64-apple-ios15", "mac": "arm64-apple-macos12"}
SYSTEM = ["/usr/include/c++/12", "/usr/include/x86_64-linux-gnu/c++/12", "/usr/include/x86_64-linux-gnu",
          "/usr/include"]


def check(target, *arguments, text=None):
    """The compiler's complaints; none if all is well."""
    command = [
        "clang++-14", "-target", target, "-x", "objective-c++", "-std=c++20", "-fobjc-arc", "-fsyntax-only",
        "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Wno-sign-conversion", "-Wno-unused-parameter",
        "-Wnullable-to-nonnull-conversion", "-Wunguarded-availability", "-Wundeclared-selector", "-Werror",
        # What the C library of this system asks for, and its names for what Apple's compiler calls otherwise.
        "-nostdlibinc", "-nostdinc++", *(f for folder in SYSTEM for f in ("-isystem", folder)),
        "-D_GNU_SOURCE", "-D__x86_64__", "-D__builtin_ia32_pause()=((void)0)", "-U__nonnull",
        f"-I{SOURCE / 'tests/apple/stubs'}", f"-I{SOURCE}", *arguments]
    run = subprocess.run(command, input=text, capture_output=True, text=True)
    if (run.returncode == 0) != (run.stderr == ""):
        raise RuntimeError(f"{run.returncode}: {run.stderr}")
    return run.stderr


class Syntax(unittest.TestCase):
    def test_every_source_is_right(self):
        sources = sorted((SOURCE / "app/apple").rglob("*.mm"))
        self.assertEqual({source.parent.name for source in sources}, set(TARGETS))
        for source in sources:
            with self.subTest(source=source.name):
                self.assertEqual(check(TARGETS[source.parent.name], str(source)), "")

    def test_misuse_is_noticed(self):
        """Were the declarations or the flags too lax, the test above would show nothing."""
        head = "#import <UIKit/UIKit.h>\n"
        right = "void f(UIView* v, UILabel* l) { [v addSubview:l]; l.text = nil; }"
        self.assertEqual(check(TARGETS["ios"], "-", text=head + right), "")
        for wrong, complaint in {
            "void f(UIView* v) { [v addSubView:v]; }": "no visible @interface",
            "void f(UIView* v) { v.hiden = YES; }": "not found on object",
            "void f(UIView* v) { [v addSubview:@\"text\"]; }": "cannot initialize a parameter",
            "void f(UIView* v, UIWindow* _Nullable w) { [v addSubview:w]; }": "nullable pointer",
            "void f(CADisplayLink* d) { d.timestamp = 1; }": "readonly property",
            "void f(UIStackView* v) { v.axis = 1; }": "assigning to",
            "void f(id d) { [CADisplayLink displayLinkWithTarget:d selector:@selector(nowhere:)]; }": "undeclared",
            "UIWindow* f(UIView* v) { return v.window.screen; }": "cannot initialize return object",
            "@interface B : NSObject <UIDocumentPickerDelegate>\n@end\n@implementation B\n- (int)isEqual:(id)o "
            "{ return 1; }\n@end": "conflicting return type",
        }.items():
            with self.subTest(wrong=wrong):
                self.assertRegex(check(TARGETS["ios"], "-", text=head + wrong), complaint)

    def test_a_call_that_an_older_system_lacks_is_noticed(self):
        clock = str(SOURCE / "app/apple/ios/frame_clock.mm")
        self.assertRegex(check("arm64-apple-ios14", clock), "only available on iOS 15.0 or newer")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
