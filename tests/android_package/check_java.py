#!/usr/bin/env python3
"""Compiles the app's Java against declarations of what it uses of Android, and holds it to the native code: every
native method is registered with its signature, every method that native code calls is there. Runs the nodes of screen
readers (PanelNodesTest.java). Says what it weighs.

The declarations follow developer.android.com, API level 36; an SDK is not needed.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "app/android/src/main/java"
MOST_BYTES = 30000  # of the classes, before they are packed

CONTEXT = """public String getPackageName() { return null; } public java.io.File getCacheDir() { return null; }
        public final <T> T getSystemService(Class<T> type) { return null; }"""
STUBS = {
    "android.annotation.TargetApi": "public @interface TargetApi { int value(); }",
    "android.hardware.display.DisplayManager": """public final class DisplayManager {
        public interface DisplayListener { void onDisplayAdded(int id); void onDisplayChanged(int id); void onDisplayRemoved(int id); }
        public android.view.Display getDisplay(int id) { return null; }
        public void registerDisplayListener(DisplayListener l, android.os.Handler h) { }
        public void unregisterDisplayListener(DisplayListener l) { } }""",
    "android.os.Handler": "public class Handler { }",
    "android.view.Display": """public final class Display { public static final int DEFAULT_DISPLAY = 0;
        public static final class Mode { public int getPhysicalWidth() { return 0; } public int getPhysicalHeight() { return 0; }
        public float getRefreshRate() { return 60; } }
        public int getDisplayId() { return 0; } public Mode getMode() { return null; } public Mode[] getSupportedModes() { return null; }
        public float getRefreshRate() { return 60; } }""",
    "android.os.Build": "public class Build { public static final String MANUFACTURER = null, MODEL = null; public static class VERSION { public static final String RELEASE = null; public static final int SDK_INT = Integer.parseInt(\"36\"); } }",
    "android.view.Choreographer": """public final class Choreographer { public interface FrameCallback { void doFrame(long nanoseconds); }
        public static Choreographer getInstance() { return null; } public void postFrameCallback(FrameCallback c) { } }""",
    "android.graphics.Insets": "public final class Insets { public final int left = 0, top = 0, right = 0, bottom = 0; }",
    "android.view.WindowInsets": """public final class WindowInsets { public static final class Type {
        public static int systemBars() { return 1; } public static int displayCutout() { return 2; } public static int systemGestures() { return 4; } }
        public android.graphics.Insets getInsets(int types) { return null; }
        public int getSystemWindowInsetLeft() { return 0; } public int getSystemWindowInsetTop() { return 0; }
        public int getSystemWindowInsetRight() { return 0; } public int getSystemWindowInsetBottom() { return 0; } }""",
    "android.window.OnBackInvokedCallback": "public interface OnBackInvokedCallback { void onBackInvoked(); }",
    "android.window.OnBackInvokedDispatcher": """public interface OnBackInvokedDispatcher { int PRIORITY_DEFAULT = 0;
        void registerOnBackInvokedCallback(int priority, OnBackInvokedCallback c); void unregisterOnBackInvokedCallback(OnBackInvokedCallback c); }""",
    "android.content.ClipData": "public class ClipData { public static ClipData newPlainText(CharSequence label, CharSequence text) { return null; } }",
    "android.content.ClipboardManager": "public class ClipboardManager { public void setPrimaryClip(ClipData clip) { } }",
    "android.content.res.Configuration": "public final class Configuration { public float fontScale = 1; }",
    "android.content.res.Resources": "public class Resources { public Configuration getConfiguration() { return null; } }",
    "android.R": """public final class R { public static final class id { public static final int content = 1; }
        public static final class string { public static final int ok = 1, cancel = 2; } }""",
    "android.content.Context": "public abstract class Context { " + CONTEXT + " }",
    "android.content.ActivityNotFoundException":
        "public class ActivityNotFoundException extends RuntimeException { private static final long serialVersionUID = 1; }",
    "android.content.ContentValues": "public final class ContentValues { }",
    "android.content.ContentProvider": """import android.net.Uri; import android.database.Cursor;
        public abstract class ContentProvider {
        public final Context getContext() { return null; }
        public abstract boolean onCreate(); public abstract String getType(Uri uri);
        public abstract Cursor query(Uri uri, String[] a, String b, String[] c, String d);
        public abstract Uri insert(Uri uri, ContentValues values);
        public abstract int delete(Uri uri, String a, String[] b);
        public abstract int update(Uri uri, ContentValues v, String a, String[] b);
        public android.os.ParcelFileDescriptor openFile(Uri uri, String mode) throws java.io.FileNotFoundException { return null; } }""",
    "android.content.Intent": """public class Intent { public Intent(String action) { }
        public static final String ACTION_OPEN_DOCUMENT = "o", ACTION_SEND = "s", CATEGORY_OPENABLE = "c", EXTRA_STREAM = "e";
        public static final int FLAG_GRANT_READ_URI_PERMISSION = 1;
        public <T extends android.os.Parcelable> T getParcelableExtra(String n) { return null; } public Intent addCategory(String c) { return this; } public Intent setType(String t) { return this; }
        public Intent putExtra(String n, android.os.Parcelable v) { return this; } public Intent addFlags(int f) { return this; }
        public android.net.Uri getData() { return null; }
        public static Intent createChooser(Intent target, CharSequence title) { return target; } }""",
    "android.os.Parcelable": "public interface Parcelable { }",
    "android.os.Bundle": "public final class Bundle { }",
    "android.os.ParcelFileDescriptor": """public class ParcelFileDescriptor { public static final int MODE_READ_ONLY = 1;
        public static ParcelFileDescriptor open(java.io.File f, int mode) throws java.io.FileNotFoundException { return null; } }""",
    "android.net.Uri": """public abstract class Uri implements android.os.Parcelable { public abstract String getLastPathSegment();
        public static final class Builder { public Builder scheme(String s) { return this; } public Builder authority(String s) { return this; }
        public Builder appendPath(String s) { return this; } public Uri build() { return null; } } }""",
    "android.database.Cursor": "public interface Cursor { }",
    "android.database.MatrixCursor": """public class MatrixCursor implements Cursor { public MatrixCursor(String[] c, int n) { }
        public void addRow(Object[] values) { } }""",
    "android.graphics.Rect": "public final class Rect { public Rect(int a, int b, int c, int d) { } public void offset(int x, int y) { } }",
    "android.graphics.Bitmap": """public final class Bitmap { public enum Config { ARGB_8888 } public enum CompressFormat { PNG }
        public static Bitmap createBitmap(int[] colors, int w, int h, Config c) { return null; }
        public boolean compress(CompressFormat f, int q, java.io.OutputStream out) { return true; } }""",
    "android.app.NativeActivity": """import android.content.Intent; import android.os.Bundle;
        public class NativeActivity extends android.content.Context { public static final int RESULT_OK = -1;
        protected void onCreate(Bundle state) { } protected void onDestroy() { } protected void onActivityResult(int a, int b, Intent c) { }
        public void onTrimMemory(int level) { } public boolean isFinishing() { return false; } public boolean isDestroyed() { return false; } public void finish() { }
        protected void onNewIntent(Intent i) { } public void setIntent(Intent i) { }
        public void onConfigurationChanged(android.content.res.Configuration c) { }
        public android.window.OnBackInvokedDispatcher getOnBackInvokedDispatcher() { return null; }
        public android.view.Display getDisplay() { return null; } public android.content.res.Resources getResources() { return null; }
        public android.view.Window getWindow() { return null; } public final void runOnUiThread(Runnable r) { }
        public void startActivityForResult(Intent i, int code) { } public void startActivity(Intent i) { } }""",
    "android.view.Window": "public abstract class Window { public abstract View getDecorView(); public void setSoftInputMode(int m) { } }",
    "android.view.WindowManager": """public interface WindowManager { public static class LayoutParams {
        public static final int SOFT_INPUT_STATE_ALWAYS_VISIBLE = 5; } }""",
    "android.text.Editable": "public interface Editable extends CharSequence { }",
    "android.widget.EditText": """public class EditText extends android.view.View { public EditText(android.content.Context c) { }
        public void setSingleLine() { } public void setText(CharSequence t) { } public void setSelection(int i) { }
        public android.text.Editable getText() { return null; } }""",
    "android.content.DialogInterface": """public interface DialogInterface { interface OnDismissListener { void onDismiss(DialogInterface d); }
        interface OnClickListener { void onClick(DialogInterface d, int which); } }""",
    "android.app.Dialog": """public class Dialog implements android.content.DialogInterface { public void show() { }
        public android.view.Window getWindow() { return null; } }""",
    "android.app.AlertDialog": """import android.content.DialogInterface; public class AlertDialog extends Dialog { public static class Builder {
        public Builder(android.content.Context c) { } public Builder setTitle(CharSequence t) { return this; }
        public Builder setMessage(CharSequence t) { return this; }
        public Builder setOnDismissListener(DialogInterface.OnDismissListener l) { return this; } public AlertDialog show() { return null; }
        public Builder setView(android.view.View v) { return this; } public AlertDialog create() { return null; }
        public Builder setPositiveButton(int t, DialogInterface.OnClickListener l) { return this; }
        public Builder setNegativeButton(int t, DialogInterface.OnClickListener l) { return this; } } }""",
    "android.view.ViewParent": """public interface ViewParent {
        boolean requestSendAccessibilityEvent(View child, android.view.accessibility.AccessibilityEvent event); }""",
    "android.view.View": """import android.view.accessibility.*;
        public class View { public static final int IMPORTANT_FOR_ACCESSIBILITY_YES = 1;
        public static class AccessibilityDelegate { public AccessibilityNodeProvider getAccessibilityNodeProvider(View host) { return null; } }
        public final <T extends View> T findViewById(int id) { return null; } public final boolean requestFocus() { return true; }
        public void setImportantForAccessibility(int mode) { } public void setAccessibilityDelegate(AccessibilityDelegate d) { }
        public interface OnApplyWindowInsetsListener { WindowInsets onApplyWindowInsets(View v, WindowInsets i); }
        public void setOnApplyWindowInsetsListener(OnApplyWindowInsetsListener l) { } public WindowInsets onApplyWindowInsets(WindowInsets i) { return i; }
        public void sendAccessibilityEvent(int type) { } public void onInitializeAccessibilityNodeInfo(AccessibilityNodeInfo i) { }
        public void getLocationOnScreen(int[] at) { } public final ViewParent getParent() { return null; }
        public final android.content.Context getContext() { return null; } }""",
    "android.view.accessibility.AccessibilityNodeProvider": """public abstract class AccessibilityNodeProvider {
        public static final int HOST_VIEW_ID = -1; public AccessibilityNodeInfo createAccessibilityNodeInfo(int id) { return null; }
        public boolean performAction(int id, int action, android.os.Bundle arguments) { return false; } }""",
    "android.view.accessibility.AccessibilityNodeInfo": """import android.view.View; public class AccessibilityNodeInfo {
        public static final int ACTION_CLICK = 16, ACTION_SCROLL_FORWARD = 4096, ACTION_SCROLL_BACKWARD = 8192,
        ACTION_ACCESSIBILITY_FOCUS = 64, ACTION_CLEAR_ACCESSIBILITY_FOCUS = 128;
        public static AccessibilityNodeInfo obtain(View v) { return null; } public static AccessibilityNodeInfo obtain(View v, int id) { return null; }
        public void addChild(View v, int id) { } public void setParent(View v) { } public void setPackageName(CharSequence s) { }
        public void setClassName(CharSequence s) { } public void setContentDescription(CharSequence s) { }
        public void setBoundsInScreen(android.graphics.Rect r) { } public void setVisibleToUser(boolean b) { }
        public void setEnabled(boolean b) { } public void setCheckable(boolean b) { } public void setChecked(boolean b) { }
        public void setClickable(boolean b) { } public void addAction(int a) { } public void setAccessibilityFocused(boolean b) { } }""",
    "android.view.accessibility.AccessibilityEvent": """public final class AccessibilityEvent {
        public static final int TYPE_WINDOW_CONTENT_CHANGED = 2048, TYPE_VIEW_ACCESSIBILITY_FOCUSED = 32768,
        TYPE_VIEW_ACCESSIBILITY_FOCUS_CLEARED = 65536, TYPE_VIEW_HOVER_ENTER = 128, TYPE_VIEW_HOVER_EXIT = 256;
        public static AccessibilityEvent obtain(int type) { return null; } public void setSource(android.view.View v, int id) { }
        public void setPackageName(CharSequence s) { } public void setClassName(CharSequence s) { } }""",
}

# What PanelNodes tells of its nodes, kept.
KEPT = STUBS | {
    "android.content.Context": "public class Context { " + CONTEXT + " }",
    "android.view.View": """import android.view.accessibility.*;
        public class View { public static final int IMPORTANT_FOR_ACCESSIBILITY_YES = 1;
        public final java.util.List<String> events = new java.util.ArrayList<>();
        public static class AccessibilityDelegate { public AccessibilityNodeProvider getAccessibilityNodeProvider(View host) { return null; } }
        public void setImportantForAccessibility(int mode) { } public void setAccessibilityDelegate(AccessibilityDelegate d) { }
        public void sendAccessibilityEvent(int type) { } public void onInitializeAccessibilityNodeInfo(AccessibilityNodeInfo i) { }
        public void getLocationOnScreen(int[] at) { } public final android.content.Context getContext() { return new android.content.Context(); }
        public final ViewParent getParent() { return (child, e) -> events.add(e.type + " " + e.source); } }""",
    "android.view.accessibility.AccessibilityEvent": STUBS["android.view.accessibility.AccessibilityEvent"]
        .replace("obtain(int type) { return null; }", "obtain(int t) { var e = new AccessibilityEvent(); e.type = t; return e; } public int type, source;")
        .replace("setSource(android.view.View v, int id) { }", "setSource(android.view.View v, int id) { source = id; }"),
    "android.view.accessibility.AccessibilityNodeInfo": STUBS["android.view.accessibility.AccessibilityNodeInfo"]
        .replace("return null;", "return new AccessibilityNodeInfo();")
        .replace("addChild(View v, int id) { }", "addChild(View v, int id) { children.add(id); }")
        .replace("setContentDescription(CharSequence s) { }", "setContentDescription(CharSequence s) { description = s.toString(); }")
        .replace("public void setParent", "public final java.util.List<Integer> children = new java.util.ArrayList<>(); public String description; public void setParent"),
}
KEPT = {name: text for name, text in KEPT.items() if re.match(r"android\.(content\.Context|graphics\.Rect|os\.Bundle|view\.(View|ViewParent|accessibility\.\w+))$", name)}
KEPT["org.nacre.viewer.NacreActivity"] = """final class NacreActivity { static String table, pressed;
        long app() { return 1; } static String controls(long app) { return table; }
        static void press(long app, String role, String name) { pressed = role + " " + name; }
        static void adjust(long app, String name, boolean up) { } }"""


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{command[0]}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def write_stubs(folder, stubs=STUBS):
    files = []
    for name, text in stubs.items():
        package, _, simple = name.rpartition(".")
        file = folder / package.replace(".", "/") / (simple + ".java")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"package {package};\n{text}\n")
        files.append(str(file))
    return files


def check_natives(described, native):
    """What javap says of NacreActivity, against platform.cpp."""
    methods = dict(re.findall(r"(\w+)\([^\n]*;\n\s+descriptor: (\S+)", described))
    of_java = set(re.findall(r"native [^\n]*?(\w+)\(", described))
    registered = dict(re.findall(r'native\("(\w+)", "([^"]+)"', native))
    called = dict(re.findall(r'(?:object_, |ask\()"(\w+)", "([^"]+)"', native))
    if of_java != set(registered):
        sys.exit(f"natives of Java {of_java} are not those that are registered {set(registered)}")
    if len(called) < 4:
        sys.exit(f"native code calls {called}: not all was found")
    for name, signature in (registered | called).items():
        if f" {name}(" in CONTEXT:
            continue  # the system's
        if methods.get(name) != signature:
            sys.exit(f"{name} is {methods.get(name)} in Java and {signature} in native code")


def check_nodes(folder):
    run("javac", "--release", "11", "-d", str(folder / "nodes"), *write_stubs(folder / "kept", KEPT),
        str(SOURCES / "org/nacre/viewer/PanelNodes.java"), str(Path(__file__).with_name("PanelNodesTest.java")))
    run("java", "-cp", str(folder / "nodes"), "org.nacre.viewer.PanelNodesTest")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        stubs, classes = folder / "stubs", folder / "classes"
        (folder / "android").mkdir()
        run("javac", "--release", "11", "-d", str(folder / "android"), *write_stubs(stubs))
        run("javac", "--release", "11", "-Xlint:all", "-Werror", "-g:none", "-cp", str(folder / "android"), "-d", str(classes),
            *map(str, SOURCES.rglob("*.java")))
        described = run("javap", "-p", "-s", "-cp", f"{classes}:{folder / 'android'}", "org.nacre.viewer.NacreActivity")
        check_natives(described, (ROOT / "app/android/platform.cpp").read_text())
        check_nodes(folder)
        size = sum(file.stat().st_size for file in classes.rglob("*.class"))
        if not 1000 < size < MOST_BYTES:
            sys.exit(f"the classes have {size} bytes, at most {MOST_BYTES} are thought of")
        print(f"{size} bytes of classes")


main()
