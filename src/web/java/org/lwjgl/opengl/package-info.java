/** What the game asks of OpenGL, by WebGL 2. Stands in front of the library of this name. */
package org.lwjgl.opengl;
