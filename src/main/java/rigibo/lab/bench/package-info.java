/**
 * How fast a step is, beside other engines: the same scenes for all of them, each in a process of
 * its own, and what came out looked at by the same eyes.
 */
package rigibo.lab.bench;
