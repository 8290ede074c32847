/** The gain of several workers: the same steps made by one and by several. */
package rigibo.lab.bench.workers;
