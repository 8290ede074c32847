/** Box2D v3 and Rapier, by a library of Rust code that {@code ./rigibo peers} builds. */
package rigibo.peers.rust;
