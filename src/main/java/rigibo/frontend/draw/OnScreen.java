package rigibo.frontend.draw;

import rigibo.frontend.scene.Camera;

import java.nio.FloatBuffer;

/** The place of a body on the screen: converts metres in the body's frame to logical pixels. */
final class OnScreen {

    private double worldX;
    private double worldY;
    private double x;
    private double y;
    private double cos;
    private double sin;
    private double scale;

    /** Takes a body at a pose in the world (m, rad), enlarged by a factor about its centre. */
    void place(Camera camera, double atX, double atY, double angle, double swell) {
        worldX = atX;
        worldY = atY;
        x = camera.screenX(atX);
        y = camera.screenY(atY);
        cos = Math.cos(angle);
        sin = Math.sin(angle);
        scale = swell * camera.scale();
    }

    /** Moves the body on the screen, px. */
    void shift(double dx, double dy) {
        x += dx;
        y += dy;
    }

    /** World x of its centre, m. */
    double worldX() {
        return worldX;
    }

    /** World y of its centre, m. */
    double worldY() {
        return worldY;
    }

    /** Pixels per metre. */
    double scale() {
        return scale;
    }

    /** Component of a direction of the world along the body's x axis. */
    double alongX(double worldX, double worldY) {
        return cos * worldX + sin * worldY;
    }

    /** Component of a direction of the world along the body's y axis. */
    double alongY(double worldX, double worldY) {
        return cos * worldY - sin * worldX;
    }

    /** Begins a vertex at a point of the body's frame, m, with its position on the screen. */
    FloatBuffer vertex(Triangles triangles, double localX, double localY) {
        return triangles
                .vertex()
                .put((float) (x + scale * (cos * localX - sin * localY)))
                .put((float) (y - scale * (sin * localX + cos * localY)));
    }
}
