/** Systems of linear equations, whatever they stand for. */
package rigibo.backend.algebra;
