/** What runs in a process of its own: one engine, one scene, timed and looked at. */
package rigibo.lab.bench.probe;
