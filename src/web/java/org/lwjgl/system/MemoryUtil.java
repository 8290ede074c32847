package org.lwjgl.system;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/** Buffers of floats that WebGL reads without a copy; their memory is freed by the browser. */
public final class MemoryUtil {

    private MemoryUtil() {}

    public static FloatBuffer memAllocFloat(int size) {
        return ByteBuffer.allocateDirect(size * Float.BYTES)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
    }

    /** A larger buffer with the content of another one and its position. */
    public static FloatBuffer memRealloc(FloatBuffer before, int size) {
        FloatBuffer larger = memAllocFloat(size);
        before.flip();
        return larger.put(before);
    }

    public static void memFree(FloatBuffer buffer) {}
}
