package org.nacre.viewer;

import android.graphics.Rect;
import android.os.Bundle;
import android.view.View;
import android.view.accessibility.AccessibilityEvent;
import android.view.accessibility.AccessibilityNodeInfo;
import android.view.accessibility.AccessibilityNodeProvider;

/** Controls of the panel as a screen reader's nodes: the panel itself is drawn by native code. */
final class PanelNodes extends AccessibilityNodeProvider {
    private static final String FIELD = "\t", LINE = "\n";
    private static final int ROLE = 0, NAME = 1, VALUE = 2, ENABLED = 3, LEFT = 4;

    private final NacreActivity activity;
    private final View view;
    private String[][] controls = {};
    private int focused = -1;

    PanelNodes(NacreActivity activity, View view) {
        this.activity = activity;
        this.view = view;
        view.setImportantForAccessibility(View.IMPORTANT_FOR_ACCESSIBILITY_YES);
        view.setAccessibilityDelegate(new View.AccessibilityDelegate() {
            @Override
            public AccessibilityNodeProvider getAccessibilityNodeProvider(View host) {
                return PanelNodes.this;
            }
        });
    }

    /** The table anew: a control a line. */
    private void read() {
        String text = activity.app() == 0 ? "" : NacreActivity.controls(activity.app());
        String[] lines = text.isEmpty() ? new String[0] : text.split(LINE);
        controls = new String[lines.length][];
        for (int i = 0; i < lines.length; ++i) controls[i] = lines[i].split(FIELD, -1);
    }

    void changed() {
        view.sendAccessibilityEvent(AccessibilityEvent.TYPE_WINDOW_CONTENT_CHANGED);
    }

    @Override
    public AccessibilityNodeInfo createAccessibilityNodeInfo(int id) {
        if (id == HOST_VIEW_ID) {
            read();
            AccessibilityNodeInfo host = AccessibilityNodeInfo.obtain(view);
            view.onInitializeAccessibilityNodeInfo(host);
            for (int i = 0; i < controls.length; ++i) host.addChild(view, i);
            return host;
        }
        if (id < 0 || id >= controls.length) return null;
        String[] control = controls[id];
        AccessibilityNodeInfo node = AccessibilityNodeInfo.obtain(view, id);
        node.setParent(view);
        node.setPackageName(view.getContext().getPackageName());
        node.setClassName(classOf(control[ROLE]));
        node.setContentDescription(control[VALUE].isEmpty() ? control[NAME] : control[NAME] + ", " + control[VALUE]);
        int[] origin = new int[2];
        view.getLocationOnScreen(origin);
        Rect place = new Rect(Integer.parseInt(control[LEFT]), Integer.parseInt(control[LEFT + 1]),
                Integer.parseInt(control[LEFT + 2]), Integer.parseInt(control[LEFT + 3]));
        place.offset(origin[0], origin[1]);
        node.setBoundsInScreen(place);
        node.setVisibleToUser(true);
        node.setEnabled("1".equals(control[ENABLED]));
        if (control[ROLE].equals("switch") || control[ROLE].equals("choice")) {
            node.setCheckable(true);
            node.setChecked(control[VALUE].equals("on"));
        }
        if (pressable(control[ROLE])) {
            node.setClickable(true);
            node.addAction(AccessibilityNodeInfo.ACTION_CLICK);
        }
        if (control[ROLE].equals("slider")) { // readers offer their volume keys or a swipe for these
            node.addAction(AccessibilityNodeInfo.ACTION_SCROLL_FORWARD);
            node.addAction(AccessibilityNodeInfo.ACTION_SCROLL_BACKWARD);
        }
        node.setAccessibilityFocused(focused == id);
        node.addAction(focused == id ? AccessibilityNodeInfo.ACTION_CLEAR_ACCESSIBILITY_FOCUS
                : AccessibilityNodeInfo.ACTION_ACCESSIBILITY_FOCUS);
        return node;
    }

    private static boolean pressable(String role) {
        return !role.equals("text") && !role.equals("status") && !role.equals("image") && !role.equals("slider");
    }

    /** Readers know what to say of these. */
    private static String classOf(String role) {
        switch (role) {
            case "switch":
                return "android.widget.Switch";
            case "choice":
                return "android.widget.RadioButton";
            case "list":
                return "android.widget.Spinner";
            case "slider":
                return "android.widget.SeekBar";
            case "field":
                return "android.widget.EditText";
            case "image":
                return "android.widget.ImageView";
            case "text":
            case "status":
            case "heading":
                return "android.widget.TextView";
            default:
                return "android.widget.Button";
        }
    }

    @Override
    public boolean performAction(int id, int action, Bundle arguments) {
        if (id < 0 || id >= controls.length) return false;
        switch (action) {
            case AccessibilityNodeInfo.ACTION_CLICK:
                if (activity.app() != 0) NacreActivity.press(activity.app(), controls[id][ROLE], controls[id][NAME]);
                return true;
            case AccessibilityNodeInfo.ACTION_SCROLL_FORWARD:
            case AccessibilityNodeInfo.ACTION_SCROLL_BACKWARD:
                if (activity.app() != 0)
                    NacreActivity.adjust(activity.app(), controls[id][NAME],
                            action == AccessibilityNodeInfo.ACTION_SCROLL_FORWARD);
                return true;
            case AccessibilityNodeInfo.ACTION_ACCESSIBILITY_FOCUS:
                focused = id;
                break;
            case AccessibilityNodeInfo.ACTION_CLEAR_ACCESSIBILITY_FOCUS:
                focused = -1;
                break;
            default:
                return false;
        }
        AccessibilityEvent event = AccessibilityEvent.obtain(focused == id
                ? AccessibilityEvent.TYPE_VIEW_ACCESSIBILITY_FOCUSED
                : AccessibilityEvent.TYPE_VIEW_ACCESSIBILITY_FOCUS_CLEARED);
        event.setSource(view, id);
        event.setPackageName(view.getContext().getPackageName());
        event.setClassName(classOf(controls[id][ROLE]));
        view.getParent().requestSendAccessibilityEvent(view, event);
        return true;
    }
}
