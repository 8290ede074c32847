/**
 * What accuracy costs in time: every setting of every engine at every reference problem, its error
 * beside its time, in tables, figures and a page that opens offline.
 */
package rigibo.lab.precision;
