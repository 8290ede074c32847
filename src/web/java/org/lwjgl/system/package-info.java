/** Stands in for buffers outside the heap, which a browser's programs lack: these are on it. */
package org.lwjgl.system;
