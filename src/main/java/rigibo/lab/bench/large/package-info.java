/** The cost of a body in very large worlds. */
package rigibo.lab.bench.large;
