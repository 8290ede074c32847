package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;

/**
 * How large windows are. The first one has a scene's shape and fits the screen; each that follows
 * is as large as the player left the last one. All lengths are those of GLFW's windows, which need
 * not be pixels.
 */
final class WindowSize {

    /** Where a window goes that filled the screen: its title bar is below most systems' panels. */
    private static final int CORNER = 60;

    private int width;
    private int height;
    private boolean isMaximized;

    /**
     * The share of a scene's size, {@link Layout#LEAST_SCALE} to 1, at which its window fits into
     * an area; the least also where not even that fits.
     *
     * @param areaWidth of the area for the window's content
     * @param areaHeight likewise
     * @param unit of these lengths per logical pixel at a scene's full size
     */
    static double scale(double areaWidth, double areaHeight, double unit) {
        double most =
                Math.min(areaWidth / (unit * Scene.WIDTH), areaHeight / (unit * Scene.HEIGHT));
        return Math.max(Layout.LEAST_SCALE, Math.min(1, most));
    }

    /** Sizes a window that was made at a scene's full size and is not shown yet. */
    void open(long window) {
        int[] w = new int[1];
        int[] h = new int[1];
        glfwGetWindowSize(window, w, h);
        limit(window, w[0], h[0]);
        if (width == 0) {
            fit(window, w[0], h[0]);
        }
        glfwSetWindowSize(window, width, height);
        if (isMaximized) {
            glfwMaximizeWindow(window);
        }
    }

    private static void limit(long window, int fullWidth, int fullHeight) {
        glfwSetWindowSizeLimits(
                window,
                (int) Math.ceil(Layout.LEAST_SCALE * fullWidth),
                (int) Math.ceil(Layout.LEAST_SCALE * fullHeight),
                GLFW_DONT_CARE,
                GLFW_DONT_CARE);
    }

    /** Fits the first window into what panels and its own frame leave of the screen. */
    private void fit(long window, int fullWidth, int fullHeight) {
        double scale = 1;
        long monitor = glfwGetPrimaryMonitor();
        if (monitor != 0) {
            int[] areaWidth = new int[1];
            int[] areaHeight = new int[1];
            glfwGetMonitorWorkarea(monitor, null, null, areaWidth, areaHeight);
            int[] left = new int[1];
            int[] top = new int[1];
            int[] right = new int[1];
            int[] bottom = new int[1];
            glfwGetWindowFrameSize(window, left, top, right, bottom);
            scale =
                    scale(
                            areaWidth[0] - left[0] - right[0],
                            areaHeight[0] - top[0] - bottom[0],
                            fullWidth / (double) Scene.WIDTH);
        }
        width = (int) Math.ceil(scale * fullWidth);
        height = (int) Math.ceil(scale * fullHeight);
    }

    /** Remembers how large the player left a window, unless it fills the screen. */
    void keep(long window) {
        if (glfwGetWindowMonitor(window) != 0) {
            return;
        }
        isMaximized = glfwGetWindowAttrib(window, GLFW_MAXIMIZED) == GLFW_TRUE;
        if (!isMaximized && glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_FALSE) {
            int[] w = new int[1];
            int[] h = new int[1];
            glfwGetWindowSize(window, w, h);
            width = w[0];
            height = h[0];
        }
    }

    /** Gives a window that filled the screen its size back. */
    void restore(long window) {
        glfwSetWindowMonitor(window, 0, CORNER, CORNER, width, height, GLFW_DONT_CARE);
    }
}
