package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import org.lwjgl.system.MemoryUtil;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas.Mood;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.nio.FloatBuffer;

/**
 * All bodies and particles of a frame in one buffer of triangles, drawn by one call. A disc is a
 * square whose shader cuts the circle; a polygon is a fan about its centre, whose corners carry the
 * distance to the outline, so that edges are smooth without multisampling.
 */
final class BodyBatch {

    private static final int FLOATS_PER_VERTEX = 12;
    private static final int PARTICLE = Skin.values().length;

    private final Program program = new Program("body");
    private final int array = glGenVertexArrays();
    private final int buffer = glGenBuffers();
    private FloatBuffer vertices = MemoryUtil.memAllocFloat(1 << 16);
    private Camera camera = Camera.ofPuzzle();
    private double gazeX;
    private double gazeY;
    private float skin;
    private float mood;
    private float radius;
    private float extra0;
    private float extra1;
    private float extra2;
    private float extra3;
    private double x;
    private double y;
    private double cos;
    private double sin;

    BodyBatch() {
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        attribute(0, 2, 0);
        attribute(1, 2, 2);
        attribute(2, 4, 4);
        attribute(3, 4, 8);
        glBindVertexArray(0);
    }

    private static void attribute(int location, int size, int offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(
                location,
                size,
                GL_FLOAT,
                false,
                FLOATS_PER_VERTEX * Float.BYTES,
                (long) offset * Float.BYTES);
    }

    void camera(Camera from) {
        camera = from;
    }

    void gaze(double worldX, double worldY) {
        gazeX = worldX;
        gazeY = worldY;
    }

    void body(Shape shape, double atX, double atY, double angle, Skin of, Mood in) {
        place(atX, atY, angle);
        skin = of.ordinal();
        mood = in.ordinal();
        look();
        switch (shape.kind()) {
            case CIRCLE -> disc((Circle) shape);
            case POLYGON -> fan((Polygon) shape);
        }
    }

    void particle(double atX, double atY, double size, double angle, Color color) {
        place(atX, atY, angle);
        skin = PARTICLE;
        mood = 0;
        extra0 = color.red();
        extra1 = color.green();
        extra2 = color.blue();
        extra3 = color.alpha();
        square(size / 2);
    }

    /** Draws what was gathered, and empties the batch. */
    void flush(double seconds) {
        if (vertices.position() == 0) {
            return;
        }
        int count = vertices.position() / FLOATS_PER_VERTEX;
        vertices.flip();
        program.use();
        program.set("screen", Scene.WIDTH, Scene.HEIGHT);
        program.set("scale", (float) camera.scale());
        program.set("time", (float) (seconds % 1000));
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, vertices, GL_STREAM_DRAW);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glDrawArrays(GL_TRIANGLES, 0, count);
        glBindVertexArray(0);
        vertices.clear();
    }

    void free() {
        MemoryUtil.memFree(vertices);
        glDeleteBuffers(buffer);
        glDeleteVertexArrays(array);
        program.free();
    }

    private void place(double atX, double atY, double angle) {
        x = atX;
        y = atY;
        cos = Math.cos(angle);
        sin = Math.sin(angle);
    }

    /** The direction to what faces look at, in the body's frame. */
    private void look() {
        double dx = gazeX - x;
        double dy = gazeY - y;
        double distance = Math.max(1e-9, Math.sqrt(dx * dx + dy * dy));
        extra0 = (float) ((cos * dx + sin * dy) / distance);
        extra1 = (float) ((cos * dy - sin * dx) / distance);
    }

    private void disc(Circle circle) {
        radius = (float) circle.radius();
        extra2 = radius;
        extra3 = radius;
        // A pixel more than the disc, for its smooth edge.
        square(circle.radius() + 1 / camera.scale());
    }

    private void square(double half) {
        vertex(-half, -half, 0);
        vertex(half, -half, 0);
        vertex(half, half, 0);
        vertex(-half, -half, 0);
        vertex(half, half, 0);
        vertex(-half, half, 0);
    }

    private void fan(Polygon polygon) {
        radius = 0;
        halfExtents(polygon);
        for (int i = 0; i < polygon.corners(); i++) {
            int next = (i + 1) % polygon.corners();
            double inward =
                    polygon.normalX(i) * polygon.cornerX(i)
                            + polygon.normalY(i) * polygon.cornerY(i);
            vertex(0, 0, inward);
            vertex(polygon.cornerX(i), polygon.cornerY(i), 0);
            vertex(polygon.cornerX(next), polygon.cornerY(next), 0);
        }
    }

    private void halfExtents(Polygon polygon) {
        extra2 = 0;
        extra3 = 0;
        for (int i = 0; i < polygon.corners(); i++) {
            extra2 = Math.max(extra2, (float) Math.abs(polygon.cornerX(i)));
            extra3 = Math.max(extra3, (float) Math.abs(polygon.cornerY(i)));
        }
    }

    private void vertex(double localX, double localY, double inside) {
        if (vertices.remaining() < FLOATS_PER_VERTEX) {
            vertices = MemoryUtil.memRealloc(vertices, 2 * vertices.capacity());
        }
        double worldX = x + cos * localX - sin * localY;
        double worldY = y + sin * localX + cos * localY;
        vertices.put((float) camera.screenX(worldX)).put((float) camera.screenY(worldY));
        vertices.put((float) localX).put((float) localY);
        vertices.put(skin).put(mood).put((float) inside).put(radius);
        vertices.put(extra0).put(extra1).put(extra2).put(extra3);
    }
}
