/** The code of the processes that run an engine at a problem. */
package rigibo.lab.precision.probe;
