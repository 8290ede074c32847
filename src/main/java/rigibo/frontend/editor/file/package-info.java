/**
 * The editor's files: levels that are opened and saved, and drafts left unsaved. A file is written
 * beside the old one and then moved into its place; the game's own levels are never written.
 */
package rigibo.frontend.editor.file;
