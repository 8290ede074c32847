package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import org.lwjgl.system.MemoryUtil;

import rigibo.frontend.scene.Scene;

import java.nio.FloatBuffer;

/** Triangles that are gathered over a frame and drawn by one call of one program. */
final class Triangles {

    /** Two triangles about the origin. */
    static final int[] SQUARE = {-1, -1, 1, -1, 1, 1, -1, -1, 1, 1, -1, 1};

    private static final int FIRST_CAPACITY = 1 << 16;

    private final int floatsPerVertex;
    private final int array = glGenVertexArrays();
    private final int buffer = glGenBuffers();
    private FloatBuffer vertices = MemoryUtil.memAllocFloat(FIRST_CAPACITY);

    /** Triangles whose vertices have attributes of so many floats each, at locations 0, 1, … */
    Triangles(int... sizes) {
        int sum = 0;
        for (int size : sizes) {
            sum += size;
        }
        floatsPerVertex = sum;
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        long offset = 0;
        for (int i = 0; i < sizes.length; i++) {
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i, sizes[i], GL_FLOAT, false, sum * Float.BYTES, offset);
            offset += (long) sizes[i] * Float.BYTES;
        }
        glBindVertexArray(0);
    }

    /** Makes room for one more vertex; the caller puts all its floats. */
    FloatBuffer vertex() {
        if (vertices.remaining() < floatsPerVertex) {
            vertices = MemoryUtil.memRealloc(vertices, 2 * vertices.capacity());
        }
        return vertices;
    }

    /**
     * Draws what was gathered, if anything, and is empty again.
     *
     * @param ratio framebuffer pixels per logical one, for smooth edges
     * @param seconds for what moves by itself
     */
    void draw(Program program, float ratio, double seconds) {
        if (vertices.position() == 0) {
            return;
        }
        program.use();
        program.set("screen", Scene.WIDTH, Scene.HEIGHT);
        program.set("ratio", ratio);
        program.set("time", (float) (seconds % 1000));
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        int count = vertices.position() / floatsPerVertex;
        vertices.flip();
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, vertices, GL_STREAM_DRAW);
        glDrawArrays(GL_TRIANGLES, 0, count);
        glBindVertexArray(0);
        vertices.clear();
    }

    void free() {
        MemoryUtil.memFree(vertices);
        glDeleteBuffers(buffer);
        glDeleteVertexArrays(array);
    }
}
