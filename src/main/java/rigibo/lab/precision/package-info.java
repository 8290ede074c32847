/**
 * What accuracy costs in time: the errors and times of every setting of every engine at every
 * reference problem, in tables, figures and a page that opens offline.
 */
package rigibo.lab.precision;
