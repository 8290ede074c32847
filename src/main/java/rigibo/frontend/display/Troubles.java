package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.GLFW_FORMAT_UNAVAILABLE;
import static org.lwjgl.opengl.GL33C.GL_NO_ERROR;
import static org.lwjgl.opengl.GL33C.glGetError;

import org.lwjgl.glfw.GLFWErrorCallback;

import java.util.ArrayList;
import java.util.List;

/** Errors that GLFW and OpenGL reported, in order of time. */
final class Troubles {

    private final List<String> list = new ArrayList<>();
    private final GLFWErrorCallback listener =
            GLFWErrorCallback.create(
                    (code, words) -> hear(code, GLFWErrorCallback.getDescription(words)));

    private void hear(int code, String words) {
        // A clipboard without text is no trouble.
        if (code != GLFW_FORMAT_UNAVAILABLE) {
            list.add(String.format("GLFW 0x%X: %s", code, words));
        }
    }

    /** Collects GLFW's errors from now on. */
    void listen() {
        listener.set();
    }

    /** Collects the errors of OpenGL since the last call. */
    void askOpenGl(String when) {
        for (int error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
            list.add(String.format("OpenGL 0x%X %s", error, when));
        }
    }

    List<String> all() {
        return List.copyOf(list);
    }

    /** The last complaint, or a general message if there is none. */
    String last() {
        return list.isEmpty() ? "no reason given" : list.get(list.size() - 1);
    }
}
