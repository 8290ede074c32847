package org.lwjgl.system;

import java.nio.FloatBuffer;

/** Buffers of floats on the heap, whose memory comes back by itself. */
public final class MemoryUtil {

    private MemoryUtil() {}

    public static FloatBuffer memAllocFloat(int size) {
        return FloatBuffer.allocate(size);
    }

    /** A larger buffer with what was put into one; its position stays. */
    public static FloatBuffer memRealloc(FloatBuffer before, int size) {
        FloatBuffer larger = FloatBuffer.allocate(size);
        before.flip();
        return larger.put(before);
    }

    public static void memFree(FloatBuffer buffer) {}
}
