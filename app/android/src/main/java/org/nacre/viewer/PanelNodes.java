package org.nacre.viewer;

import android.graphics.Rect;
import android.os.Bundle;
import android.view.View;
import android.view.accessibility.AccessibilityEvent;
import android.view.accessibility.AccessibilityNodeInfo;
import android.view.accessibility.AccessibilityNodeProvider;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;

/** Controls of the panel as nodes for screen readers. Native code draws the panel. */
final class PanelNodes extends AccessibilityNodeProvider {
    private static final String FIELD = "\t", LINE = "\n";
    private static final int ROLE = 0, NAME = 1, VALUE = 2, ENABLED = 3, LEFT = 4, TOP = 5, RIGHT = 6, BOTTOM = 7;
    private static final int NONE = -1;

    private final NacreActivity activity;
    private final View view;
    private final Map<String, Integer> ids = new HashMap<>(); // a control keeps its number when its row moves
    private final Map<Integer, String[]> controls = new LinkedHashMap<>(); // by number
    private int focused = NONE, hovered = NONE;

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

    /** Reads the table of controls, one per line. Their order distinguishes controls of the same name. */
    private void read() {
        String text = activity.app() == 0 ? "" : NacreActivity.controls(activity.app());
        controls.clear();
        if (text.isEmpty()) return;
        Map<String, Integer> met = new HashMap<>();
        for (String line : text.split(LINE)) {
            String[] control = line.split(FIELD, -1);
            String name = control[ROLE] + FIELD + control[NAME];
            String key = name + FIELD + met.merge(name, 1, Integer::sum);
            Integer id = ids.get(key);
            if (id == null) {
                id = ids.size();
                ids.put(key, id);
            }
            controls.put(id, control);
        }
    }

    private static int number(String[] control, int field) {
        return Integer.parseInt(control[field]);
    }

    /** The smallest control at a place: the picture is below all others. */
    private int idAt(float x, float y) {
        int found = NONE;
        long least = Long.MAX_VALUE;
        for (Map.Entry<Integer, String[]> entry : controls.entrySet()) {
            String[] control = entry.getValue();
            int left = number(control, LEFT), top = number(control, TOP);
            int right = number(control, RIGHT), bottom = number(control, BOTTOM);
            long area = (long) (right - left) * (bottom - top);
            if (x < left || x >= right || y < top || y >= bottom || area >= least) continue;
            found = entry.getKey();
            least = area;
        }
        return found;
    }

    /** Handles explore by touch: the reader announces the control under the finger. Pixels of the window. */
    void explore(float x, float y, boolean inside) {
        read();
        int before = hovered;
        hovered = inside ? idAt(x, y) : NONE;
        if (hovered == before) return;
        if (hovered != NONE) send(hovered, AccessibilityEvent.TYPE_VIEW_HOVER_ENTER);
        if (before != NONE) send(before, AccessibilityEvent.TYPE_VIEW_HOVER_EXIT);
    }

    private void send(int id, int type) {
        AccessibilityEvent event = AccessibilityEvent.obtain(type);
        event.setSource(view, id);
        event.setPackageName(view.getContext().getPackageName());
        String[] control = controls.get(id);
        if (control != null) event.setClassName(classOf(control[ROLE]));
        view.getParent().requestSendAccessibilityEvent(view, event);
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
            for (int child : controls.keySet()) host.addChild(view, child);
            return host;
        }
        String[] control = controls.get(id);
        if (control == null) return null;
        AccessibilityNodeInfo node = AccessibilityNodeInfo.obtain(view, id);
        node.setParent(view);
        node.setPackageName(view.getContext().getPackageName());
        node.setClassName(classOf(control[ROLE]));
        node.setContentDescription(control[VALUE].isEmpty() ? control[NAME] : control[NAME] + ", " + control[VALUE]);
        int[] origin = new int[2];
        view.getLocationOnScreen(origin);
        Rect place = new Rect(number(control, LEFT), number(control, TOP), number(control, RIGHT),
                number(control, BOTTOM));
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
        if (control[ROLE].equals("slider")) { // screen readers map volume keys or swipes to these
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

    /** Classes that screen readers know. */
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
        String[] control = controls.get(id);
        if (control == null) return false;
        switch (action) {
            case AccessibilityNodeInfo.ACTION_CLICK:
                if (activity.app() != 0) NacreActivity.press(activity.app(), control[ROLE], control[NAME]);
                return true;
            case AccessibilityNodeInfo.ACTION_SCROLL_FORWARD:
            case AccessibilityNodeInfo.ACTION_SCROLL_BACKWARD:
                if (activity.app() != 0)
                    NacreActivity.adjust(activity.app(), control[NAME],
                            action == AccessibilityNodeInfo.ACTION_SCROLL_FORWARD);
                return true;
            case AccessibilityNodeInfo.ACTION_ACCESSIBILITY_FOCUS:
                focused = id;
                break;
            case AccessibilityNodeInfo.ACTION_CLEAR_ACCESSIBILITY_FOCUS:
                focused = NONE;
                break;
            default:
                return false;
        }
        send(id, focused == id ? AccessibilityEvent.TYPE_VIEW_ACCESSIBILITY_FOCUSED
                : AccessibilityEvent.TYPE_VIEW_ACCESSIBILITY_FOCUS_CLEARED);
        return true;
    }
}
