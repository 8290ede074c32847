/**
 * Builds the page from the engine's classes by TeaVM, serves it on this machine, and reads its
 * output in browsers. Runs on the JVM only.
 */
package rigibo.web.build;
