/**
 * Files made by the game's writers and then mutated: bytes, encodings, JSON. They are read as the
 * game reads them, without a window. This room knows the game's readers and writers.
 */
package rigibo.fuzz.file;
