/** What each body costs in very large worlds. */
package rigibo.lab.bench.large;
