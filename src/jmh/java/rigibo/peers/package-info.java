/**
 * The engines that ours is compared with, set up as their users would do. This package holds what
 * their adapters share; each engine has a package of its own below. They are compiled with the
 * benchmarks and never shipped. SI units, y up.
 */
package rigibo.peers;
