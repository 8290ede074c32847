/** dyn4j, written in Java and in doubles. */
package rigibo.peers.dyn4j;
