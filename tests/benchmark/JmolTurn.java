// Milliseconds that Jmol takes for a frame of a turn, as one line of JSON: the least on the clock, and the mean of all its
// threads.
// xvfb-run java -cp /usr/share/java/Jmol.jar JmolTurn.java FILE WIDTH HEIGHT FRAMES

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import javax.swing.JPanel;
import org.jmol.adapter.smarter.SmarterJmolAdapter;
import org.jmol.api.JmolViewer;
import org.jmol.viewer.Viewer;

public class JmolTurn {
    public static void main(String[] arguments) {
        int width = Integer.parseInt(arguments[1]), height = Integer.parseInt(arguments[2]);
        int frames = Integer.parseInt(arguments[3]);
        Viewer viewer = (Viewer) JmolViewer.allocateViewer(
            new JPanel(), new SmarterJmolAdapter(), null, null, null, "", null);
        viewer.setScreenDimension(width, height);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        // The atoms that Nacre draws: no waters, all else in van der Waals radii. Black is background.
        viewer.scriptWait("set zoomLarge false; set antialiasDisplay false; set pdbAddHydrogens false; background black; "
            + "load \"" + arguments[0] + "\" filter \"![HOH]\"; select all; wireframe off; cartoon off; "
            + "spacefill 100%; zoom 100;");
        var threads = (com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        double[] wall = new double[frames];
        long processor = 0;  // of a whole turn: the clock of processor time is coarse
        for (int turn = 0; turn < 3; ++turn) {  // the first two are for the compiler
            processor = 0;
            for (int i = 0; i < frames; ++i) {
                viewer.scriptWait("rotate y " + 360.0 / frames);
                long cpu = threads.getProcessCpuTime(), start = System.nanoTime();
                viewer.renderScreenImage(graphics, width, height);
                wall[i] = (System.nanoTime() - start) / 1e6;
                processor += threads.getProcessCpuTime() - cpu;
            }
        }
        int covered = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) covered += (image.getRGB(x, y) & 0xffffff) != 0 ? 1 : 0;
        Arrays.sort(wall);
        System.out.printf(java.util.Locale.US,
            "{\"atoms\": %d, \"covered_pixels\": %d, \"wall\": %.3f, \"processor\": %.3f}%n", viewer.ms.ac, covered,
            wall[0], processor / 1e6 / frames);
        System.exit(0);
    }
}
