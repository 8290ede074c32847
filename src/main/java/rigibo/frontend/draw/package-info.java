/**
 * Drawing with OpenGL 3.3 and NanoVG behind {@link rigibo.frontend.scene.Canvas}: bodies and
 * particles in one batch, whose textures and smooth edges a shader computes; text, panels and
 * graphs by NanoVG.
 */
package rigibo.frontend.draw;
