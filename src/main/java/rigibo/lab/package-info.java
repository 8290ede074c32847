/**
 * The headless laboratory: what the physics is worth and what it costs, measured. It sees the
 * engine's public face only.
 */
package rigibo.lab;
