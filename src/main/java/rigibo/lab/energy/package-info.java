/**
 * Energy over time, what is lost by design told apart from drift: a ball that bounces lower each
 * time, as it should.
 */
package rigibo.lab.energy;
