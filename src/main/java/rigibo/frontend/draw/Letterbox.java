package rigibo.frontend.draw;

import rigibo.frontend.scene.Scene;

/**
 * The place of the logical window in a framebuffer: as large as fits, centred.
 *
 * @param x left edge, framebuffer pixels
 * @param y lower edge, framebuffer pixels
 * @param width framebuffer pixels
 * @param height framebuffer pixels
 */
public record Letterbox(int x, int y, int width, int height) {

    /** The largest box with the proportions of the window that fits into a framebuffer. */
    public static Letterbox of(int framebufferWidth, int framebufferHeight) {
        double scale =
                Math.min(
                        framebufferWidth / (double) Scene.WIDTH,
                        framebufferHeight / (double) Scene.HEIGHT);
        int width = Math.max(1, (int) Math.round(scale * Scene.WIDTH));
        int height = Math.max(1, (int) Math.round(scale * Scene.HEIGHT));
        return new Letterbox(
                (framebufferWidth - width) / 2, (framebufferHeight - height) / 2, width, height);
    }

    /** Converts a framebuffer x to logical px. */
    public double logicalX(double framebufferX) {
        return (framebufferX - x) * Scene.WIDTH / width;
    }

    /**
     * Converts a framebuffer y, counted from the top of a framebuffer of a given height, to logical
     * px.
     */
    public double logicalY(double framebufferY, int framebufferHeight) {
        return (framebufferY - top(framebufferHeight)) * Scene.HEIGHT / height;
    }

    /** Converts a logical x to framebuffer pixels. */
    public double framebufferX(double logicalX) {
        return x + logicalX * width / Scene.WIDTH;
    }

    /**
     * Converts a logical y to framebuffer pixels, counted from the top of a framebuffer of a given
     * height.
     */
    public double framebufferY(double logicalY, int framebufferHeight) {
        return top(framebufferHeight) + logicalY * height / Scene.HEIGHT;
    }

    private int top(int framebufferHeight) {
        return framebufferHeight - y - height;
    }
}
