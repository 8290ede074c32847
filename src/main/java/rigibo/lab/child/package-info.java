/**
 * Child processes in which the laboratory measures, so that compiled code, garbage and loaded
 * classes of one measurement do not influence the next.
 */
package rigibo.lab.child;
