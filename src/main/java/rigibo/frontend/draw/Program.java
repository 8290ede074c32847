package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

import rigibo.frontend.scene.Layout;

/** A compiled and linked pair of shaders. */
final class Program {

    private final int id;

    /**
     * Builds {@code shaders/VERTEX.vert.glsl} and {@code shaders/FRAGMENT.frag.glsl}.
     *
     * @throws rigibo.frontend.scene.DisplayException naming the file that cannot be used, and why
     */
    Program(String vertexName, String fragmentName) {
        String vertexFile = "shaders/" + vertexName + ".vert.glsl";
        String fragmentFile = "shaders/" + fragmentName + ".frag.glsl";
        int vertex = compile(GL_VERTEX_SHADER, vertexFile);
        int fragment = compile(GL_FRAGMENT_SHADER, fragmentFile);
        id = glCreateProgram();
        glAttachShader(id, vertex);
        glAttachShader(id, fragment);
        glLinkProgram(id);
        glDeleteShader(vertex);
        glDeleteShader(fragment);
        if (glGetProgrami(id, GL_LINK_STATUS) == GL_FALSE) {
            String why = "does not fit " + vertexFile + ": " + glGetProgramInfoLog(id);
            throw Assets.broken(fragmentFile, why);
        }
    }

    void use() {
        glUseProgram(id);
    }

    void set(String uniform, int value) {
        glUniform1i(glGetUniformLocation(id, uniform), value);
    }

    void set(String uniform, float value) {
        glUniform1f(glGetUniformLocation(id, uniform), value);
    }

    /** Sets what a window shows: its left and upper edge, width and height. */
    void set(String uniform, Layout layout) {
        glUniform4f(
                glGetUniformLocation(id, uniform),
                (float) layout.left(),
                (float) layout.top(),
                (float) layout.width(),
                (float) layout.height());
    }

    void free() {
        glDeleteProgram(id);
    }

    private static int compile(int stage, String file) {
        int shader = glCreateShader(stage);
        glShaderSource(shader, Assets.text(file));
        glCompileShader(shader);
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) {
            throw Assets.broken(file, "is no shader: " + glGetShaderInfoLog(shader));
        }
        return shader;
    }
}
