/**
 * How the game reads JSON files, all of them alike: settings, progress, levels, drafts, replays.
 * Whatever a file holds becomes a value or problems with their lines, never an exception; time and
 * memory are bounded by {@link rigibo.frontend.document.Bounds}. Knows nothing of what the files
 * are about.
 */
package rigibo.frontend.document;
