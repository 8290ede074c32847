/**
 * Processes of their own in which the laboratory measures, so that nothing compiled, collected or
 * loaded for one measurement is there in the next.
 */
package rigibo.lab.child;
