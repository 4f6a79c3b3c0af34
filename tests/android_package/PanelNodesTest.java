package org.nacre.viewer;

import android.view.View;
import android.view.accessibility.AccessibilityEvent;
import android.view.accessibility.AccessibilityNodeInfo;
import android.view.accessibility.AccessibilityNodeProvider;

import java.util.List;

/** Runs PanelNodes on declarations that keep what they are told (check_java.py), and an activity whose table is set here. */
final class PanelNodesTest {
    private static final String PICTURE = "image\tthe picture\t\t1\t0\t0\t300\t600\n";

    private static String line(String role, String name, int top) {
        return role + "\t" + name + "\t\t1\t0\t" + top + "\t100\t" + (top + 20) + "\n";
    }

    private static void expect(Object found, Object expected) {
        if (!expected.equals(found)) throw new AssertionError(found + ", expected " + expected);
    }

    private static String nameOf(PanelNodes nodes, int id) {
        AccessibilityNodeInfo node = nodes.createAccessibilityNodeInfo(id);
        return node == null ? "none" : node.description;
    }

    private static List<Integer> children(PanelNodes nodes) {
        return nodes.createAccessibilityNodeInfo(AccessibilityNodeProvider.HOST_VIEW_ID).children;
    }

    public static void main(String[] none) {
        View view = new View();
        PanelNodes nodes = new PanelNodes(new NacreActivity(), view);
        NacreActivity.table = PICTURE + line("button", "Menu", 0) + line("button", "Undo", 20) + line("button", "Menu", 40);
        List<Integer> before = children(nodes);
        expect(before.size(), 4);
        int menu = before.get(1), undo = before.get(2);
        expect(nameOf(nodes, undo), "Undo");

        // A finger that explores: events of the control below it, the picture being below all others.
        nodes.explore(50, 30, true);
        expect(view.events, List.of(AccessibilityEvent.TYPE_VIEW_HOVER_ENTER + " " + undo));
        nodes.explore(51, 31, true);
        expect(view.events.size(), 1);
        nodes.explore(50, 10, true);
        expect(view.events.subList(1, 3), List.of(AccessibilityEvent.TYPE_VIEW_HOVER_ENTER + " " + menu,
                AccessibilityEvent.TYPE_VIEW_HOVER_EXIT + " " + undo));
        nodes.explore(50, 300, true);
        expect(view.events.get(3), AccessibilityEvent.TYPE_VIEW_HOVER_ENTER + " " + before.get(0));
        nodes.explore(50, 300, false);
        expect(view.events.get(5), AccessibilityEvent.TYPE_VIEW_HOVER_EXIT + " " + before.get(0));

        // Rows move, one comes and one goes: each control keeps its number.
        NacreActivity.table = PICTURE + line("choice", "Licorice", 0) + line("button", "Undo", 40) + line("button", "Menu", 60);
        List<Integer> after = children(nodes);
        expect(after.size(), 4);
        expect(after.get(2), undo);
        expect(after.get(3), menu);
        expect(before.contains(after.get(1)), false);
        expect(nameOf(nodes, undo), "Undo");
        expect(nameOf(nodes, before.get(3)), "none");
        nodes.explore(50, 50, true);
        expect(view.events.get(6), AccessibilityEvent.TYPE_VIEW_HOVER_ENTER + " " + undo);
        nodes.performAction(menu, AccessibilityNodeInfo.ACTION_CLICK, null);
        expect(NacreActivity.pressed, "button Menu");
    }
}
