/** Buffers outside the heap, which a browser's programs lack: they are on it. */
package org.lwjgl.system;
