/**
 * The window and the loop; the only room that knows GLFW. Each scene has its own window, and the
 * present one is destroyed before the next one starts.
 */
package rigibo.frontend.display;
