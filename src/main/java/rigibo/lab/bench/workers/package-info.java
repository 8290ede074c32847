/** What more workers gain: the same steps made by one and by several. */
package rigibo.lab.bench.workers;
