/** Box2D 2.x itself, in C++ and floats, as libGDX lets Java use it. */
package rigibo.peers.gdx;
