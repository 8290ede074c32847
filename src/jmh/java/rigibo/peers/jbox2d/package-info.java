/** JBox2D, a translation of Box2D 2.x into Java, in floats. */
package rigibo.peers.jbox2d;
