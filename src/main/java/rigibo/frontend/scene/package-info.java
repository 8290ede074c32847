/**
 * The content of a window, and the means to show it. A {@link rigibo.frontend.scene.Scene} receives
 * input and turns of the loop, and draws on a {@link rigibo.frontend.scene.Canvas}; it knows
 * neither a window nor OpenGL, so every scene also runs in a test.
 *
 * <p>To write one: implement {@code Scene}, take a {@code Director} in the constructor for changing
 * to another scene, and add a line to the catalog. Screen coordinates are logical pixels of a 720 ×
 * 800 window, y down; world coordinates are metres, y up, which a {@link
 * rigibo.frontend.scene.Camera} converts to the screen.
 */
package rigibo.frontend.scene;
