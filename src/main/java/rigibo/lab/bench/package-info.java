/**
 * The speed of a step compared with other engines. All engines run the same scenes, each in its own
 * process, and the results are examined by the same measures.
 */
package rigibo.lab.bench;
