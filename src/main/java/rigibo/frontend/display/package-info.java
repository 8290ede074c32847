/**
 * The window and the loop: the only room that knows GLFW. One window per scene; the present one is
 * destroyed before the next one starts.
 */
package rigibo.frontend.display;
