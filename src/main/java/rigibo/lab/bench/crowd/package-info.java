/** How long a step takes by how many bodies there are, for our engine and others. */
package rigibo.lab.bench.crowd;
