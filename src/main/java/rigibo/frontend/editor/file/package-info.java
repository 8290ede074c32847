/**
 * Where the editor's levels are: files that are opened and saved, and what was left unsaved. Writes
 * beside a file and moves into its place; never writes into a level of the game itself.
 */
package rigibo.frontend.editor.file;
