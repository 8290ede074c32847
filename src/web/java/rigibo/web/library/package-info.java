/**
 * What the game calls of Java's library and TeaVM's lacks, under the same names: classes, and in
 * {@code Missing} methods of classes that are there.
 */
package rigibo.web.library;
