package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/**
 * The removal of a body from a scene; the bodies on top of it, asleep or not, must respond at once.
 *
 * @param body number of it, or one that no body has
 * @param step made before it goes
 */
public record Loss(int body, int step) {

    /** No removal. */
    public static final Loss NONE = new Loss(-1, 0);

    /**
     * Removes the body if the time has come.
     *
     * @param made steps made so far
     */
    public void befall(World world, int made) {
        if (body >= 0 && made == step) {
            world.remove(body);
        }
    }
}
