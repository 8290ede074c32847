package rigibo.frontend.draw;

import static org.lwjgl.opengl.GL33C.*;

/** A compiled and linked pair of shaders. */
final class Program {

    private final int id;

    /** Builds {@code shaders/VERTEX.vert.glsl} and {@code shaders/FRAGMENT.frag.glsl}. */
    Program(String vertexName, String fragmentName) {
        int vertex = compile(GL_VERTEX_SHADER, "shaders/" + vertexName + ".vert.glsl");
        int fragment = compile(GL_FRAGMENT_SHADER, "shaders/" + fragmentName + ".frag.glsl");
        id = glCreateProgram();
        glAttachShader(id, vertex);
        glAttachShader(id, fragment);
        glLinkProgram(id);
        glDeleteShader(vertex);
        glDeleteShader(fragment);
        if (glGetProgrami(id, GL_LINK_STATUS) == GL_FALSE) {
            throw new IllegalStateException(
                    fragmentName + " does not link: " + glGetProgramInfoLog(id));
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
