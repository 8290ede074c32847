/** What runs in a process of its own and puts an engine to a problem. */
package rigibo.lab.precision.probe;
