/** The game's log, which in a page is the browser's console. */
package org.tinylog;
