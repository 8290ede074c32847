/**
 * The headless laboratory, which measures the accuracy and the cost of the physics. It uses the
 * public API of the engine alone.
 */
package rigibo.lab;
