/** Box2D 2.x itself, in C++ with floats, through libGDX. */
package rigibo.peers.gdx;
