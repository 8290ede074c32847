/**
 * The functions of OpenGL that the game calls, by WebGL 2. Stands in front of the library of this
 * name.
 */
package org.lwjgl.opengl;
