/** What a body costs in worlds of very many. */
package rigibo.lab.bench.large;
