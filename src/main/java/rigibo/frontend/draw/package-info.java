/**
 * Drawing with OpenGL 3.3 and NanoVG behind {@link rigibo.frontend.scene.Canvas}. Bodies and
 * particles are drawn in one batch, with textures and smooth edges from a shader; text, panels and
 * graphs by NanoVG.
 */
package rigibo.frontend.draw;
