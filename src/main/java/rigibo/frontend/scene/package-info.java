/**
 * What a window shows, and what it shows it with. A {@link rigibo.frontend.scene.Scene} is given
 * input and turns, and draws on a {@link rigibo.frontend.scene.Canvas}; it knows neither a window
 * nor OpenGL, so every scene also runs in a test.
 *
 * <p>To write one: implement {@code Scene}, take a {@code Director} in the constructor for changing
 * to another, and add a line to the catalog. Screen coordinates are logical pixels of a 720 × 800
 * window, y down; world coordinates are metres, y up, brought to the screen by a {@link
 * rigibo.frontend.scene.Camera}.
 */
package rigibo.frontend.scene;
