/**
 * Makes the page from the engine's classes by TeaVM, serves it on this machine, and asks a browser
 * what it shows. Runs on the JVM alone.
 */
package rigibo.web.build;
