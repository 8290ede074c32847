/**
 * Settings and progress on disk, where the system keeps such files or in a folder of the player's
 * choice. Nothing of the player is ever lost silently: a file is replaced as a whole and its
 * previous version kept beside it, damaged files are set aside, files of a newer game are left
 * alone, and a failed write is kept in memory and repeated. Knows neither window nor scenes.
 */
package rigibo.frontend.save;
