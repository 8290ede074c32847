/**
 * The engines that ours is measured against, as a user of theirs would set a scene: what all of
 * their adapters share. Each engine has a package of its own below. They are compiled with the
 * benchmarks and never shipped. SI units, y up.
 */
package rigibo.peers;
