/**
 * Files that the game reads, made by its own writers and then mutated: bytes, encodings, JSON. They
 * are read as the game reads them, without a window. Knows the game's readers and writers.
 */
package rigibo.fuzz.file;
