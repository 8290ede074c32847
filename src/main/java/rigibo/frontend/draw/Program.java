package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

/** A compiled and linked pair of shaders. */
final class Program {

    private final int id;

    /** Builds {@code shaders/NAME.vert.glsl} and {@code shaders/NAME.frag.glsl}. */
    Program(String name) {
        int vertex = compile(GL_VERTEX_SHADER, "shaders/" + name + ".vert.glsl");
        int fragment = compile(GL_FRAGMENT_SHADER, "shaders/" + name + ".frag.glsl");
        id = glCreateProgram();
        glAttachShader(id, vertex);
        glAttachShader(id, fragment);
        glLinkProgram(id);
        glDeleteShader(vertex);
        glDeleteShader(fragment);
        if (glGetProgrami(id, GL_LINK_STATUS) == GL_FALSE) {
            throw new IllegalStateException(name + " does not link: " + glGetProgramInfoLog(id));
        }
    }

    void use() {
        glUseProgram(id);
    }

    void set(String uniform, float value) {
        glUniform1f(glGetUniformLocation(id, uniform), value);
    }

    void set(String uniform, float x, float y) {
        glUniform2f(glGetUniformLocation(id, uniform), x, y);
    }

    void free() {
        glDeleteProgram(id);
    }

    private static int compile(int stage, String file) {
        int shader = glCreateShader(stage);
        glShaderSource(shader, Assets.text(file));
        glCompileShader(shader);
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) {
            throw new IllegalStateException(file + ": " + glGetShaderInfoLog(shader));
        }
        return shader;
    }
}
