package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import org.lwjgl.system.MemoryUtil;

import java.nio.FloatBuffer;

/** Records of floats that are collected during a frame and sent to OpenGL at once. */
final class Gathered {

    private static final int FIRST_CAPACITY = 1 << 16;

    private final int[] sizes;
    private final int floatsPerRecord;
    private final int array = glGenVertexArrays();
    private final int buffer = glGenBuffers();
    private FloatBuffer records = MemoryUtil.memAllocFloat(FIRST_CAPACITY);

    /** Records with attributes of the given numbers of floats, at locations 0, 1, … */
    Gathered(int... sizes) {
        this.sizes = sizes.clone();
        int sum = 0;
        for (int size : sizes) {
            sum += size;
        }
        floatsPerRecord = sum;
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

    /** Lets each record count for a whole instance rather than a vertex. */
    void onePerInstance() {
        glBindVertexArray(array);
        for (int i = 0; i < sizes.length; i++) {
            glVertexAttribDivisor(i, 1);
        }
        glBindVertexArray(0);
    }

    /** Makes room for one more record; the caller then puts all of its floats. */
    FloatBuffer next() {
        if (records.remaining() < floatsPerRecord) {
            records = MemoryUtil.memRealloc(records, 2 * records.capacity());
        }
        return records;
    }

    boolean isEmpty() {
        return records.position() == 0;
    }

    /** Sends everything to OpenGL and binds it for drawing; returns the number of records. */
    int upload() {
        int count = records.position() / floatsPerRecord;
        records.flip();
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, records, GL_STREAM_DRAW);
        // Blends premultiplied colours: every shader multiplies its colour by its cover, so that
        // light can also be added.
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        return count;
    }

    /** Empties the collection after drawing. */
    void clear() {
        glBindVertexArray(0);
        records.clear();
    }

    void free() {
        MemoryUtil.memFree(records);
        glDeleteBuffers(buffer);
        glDeleteVertexArrays(array);
    }
}
