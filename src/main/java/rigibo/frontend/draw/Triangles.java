package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import rigibo.frontend.scene.Layout;

import java.nio.FloatBuffer;

/** Triangles that are collected during a frame and drawn by one call of one program. */
final class Triangles {

    /** Two triangles about the origin. */
    static final int[] SQUARE = {-1, -1, 1, -1, 1, 1, -1, -1, 1, 1, -1, 1};

    private final Gathered gathered;

    /**
     * Triangles whose vertices have attributes of the given numbers of floats, at locations 0, 1, …
     */
    Triangles(int... sizes) {
        gathered = new Gathered(sizes);
    }

    /** Makes room for one more vertex; the caller then puts all of its floats. */
    FloatBuffer vertex() {
        return gathered.next();
    }

    /** Draws the collected triangles, if there are any, and empties the collection. */
    void draw(Program program, Layout layout) {
        if (gathered.isEmpty()) {
            return;
        }
        program.use();
        program.set("window", layout);
        program.set("ratio", (float) layout.ratio());
        glDrawArrays(GL_TRIANGLES, 0, gathered.upload());
        gathered.clear();
    }

    void free() {
        gathered.free();
    }
}
