/** The code of the processes that run one scene in one engine, time it and examine it. */
package rigibo.lab.bench.probe;
