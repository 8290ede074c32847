package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Scene;

/** Makes windows for OpenGL 3.3, hidden at first. */
final class GlWindow {

    private GlWindow() {}

    /**
     * Makes a window of the size of a scene.
     *
     * @return GLFW's handle
     * @throws DisplayException when there is no window or no OpenGL 3.3 to be had
     */
    static long create(String title, Troubles troubles) {
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_STENCIL_BITS, 8);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        long created = glfwCreateWindow(Scene.WIDTH, Scene.HEIGHT, title, 0, 0);
        if (created == 0) {
            throw new DisplayException(
                    "RigiBo needs OpenGL 3.3, found none (" + troubles.last() + ")");
        }
        return created;
    }
}
