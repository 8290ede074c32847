/**
 * Bodies that touch nothing: they move exactly, a parabola is a parabola at any step, and hit each
 * other and everything else in the order of time.
 */
package rigibo.backend.flight;
