package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import java.util.function.Consumer;

/**
 * Texture layers of one size, which a shader computes once and drawing only samples: on software
 * OpenGL, computing the noise of every pixel in every frame is too slow.
 */
final class Baked {

    private final int texture = glGenTextures();
    private final int frame = glGenFramebuffers();
    private final int nothing = glGenVertexArrays();
    private final int width;
    private final int height;

    /**
     * Runs a shader over each layer. The uniform {@code layer} is the layer's number, and {@code
     * detailed} says whether everything is to be drawn; {@code others} sets what else there is.
     */
    Baked(
            String shader,
            int width,
            int height,
            int layers,
            Detail detail,
            Consumer<Program> others) {
        this.width = width;
        this.height = height;
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
        glTexImage3D(
                GL_TEXTURE_2D_ARRAY,
                0,
                GL_RGBA8,
                width,
                height,
                layers,
                0,
                GL_RGBA,
                GL_UNSIGNED_BYTE,
                0L);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        Program program = new Program("everywhere", shader);
        program.use();
        program.set("detailed", detail == Detail.FULL ? 1 : 0);
        others.accept(program);
        for (int layer = 0; layer < layers; layer++) {
            program.set("layer", layer);
            run(layer);
        }
        program.free();
    }

    /** Adds mipmaps, for bodies that are small in the window; that costs more than baking. */
    void shrink() {
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
        glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    }

    private void run(int layer) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0, layer);
        glViewport(0, 0, width, height);
        glDisable(GL_BLEND);
        glBindVertexArray(nothing);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindVertexArray(0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    /** Binds the texture, with all its sizes, for shaders to read. */
    void bind() {
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    }

    /** Copies the last layer to the framebuffer, with its lower left corner at a pixel. */
    void copy(int left, int bottom) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, frame);
        glBlitFramebuffer(
                0,
                0,
                width,
                height,
                left,
                bottom,
                left + width,
                bottom + height,
                GL_COLOR_BUFFER_BIT,
                GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    }

    void free() {
        glDeleteFramebuffers(frame);
        glDeleteTextures(texture);
        glDeleteVertexArrays(nothing);
    }
}
