package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import rigibo.frontend.scene.Layout;

import java.nio.FloatBuffer;

/**
 * Squares that are collected during a frame, a few floats each, and drawn by one instanced call.
 */
final class Instances {

    private final int corners;
    private final Gathered gathered;

    /**
     * Instances of a strip with a number of corners, with attributes of the given numbers of
     * floats.
     */
    Instances(int corners, int... sizes) {
        this.corners = corners;
        gathered = new Gathered(sizes);
        gathered.onePerInstance();
    }

    /** Makes room for one more instance; the caller then puts all of its floats. */
    FloatBuffer next() {
        return gathered.next();
    }

    /** Draws the collected instances, if there are any, and empties the collection. */
    void draw(Program program, Layout layout) {
        if (gathered.isEmpty()) {
            return;
        }
        program.use();
        program.set("window", layout);
        int count = gathered.upload();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, corners, count);
        gathered.clear();
    }

    void free() {
        gathered.free();
    }
}
