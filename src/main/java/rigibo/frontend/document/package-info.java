/**
 * Reads all JSON files of the game in the same way: settings, progress, levels, drafts, replays.
 * Any file gives a value or problems with their lines, never an exception; time and memory are
 * bounded by {@link rigibo.frontend.document.Bounds}. Knows nothing of the meaning of the files.
 */
package rigibo.frontend.document;
