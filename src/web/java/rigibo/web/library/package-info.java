/**
 * Parts of Java's library that the game uses and TeaVM's lacks, under the same names: classes, and
 * in {@code Missing} methods of existing classes.
 */
package rigibo.web.library;
