/** Systems of linear equations, without knowledge of what they stand for. */
package rigibo.backend.algebra;
