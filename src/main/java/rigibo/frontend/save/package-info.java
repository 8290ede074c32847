/**
 * Settings and progress on disk, where the system keeps such files or in a folder of the player's
 * choice. Nothing of the player's is ever lost silently: a file is replaced as a whole, the one
 * before is kept beside it, what is damaged is set aside, what a newer game wrote is left alone,
 * and what cannot be written now is held in memory and tried again. Knows neither window nor
 * scenes.
 */
package rigibo.frontend.save;
