/** What further workers bring: the same steps by one and by several. */
package rigibo.lab.bench.workers;
