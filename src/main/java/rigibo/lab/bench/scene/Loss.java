package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/**
 * A body that is taken out of a scene: what stood on it, asleep or not, has to answer at once.
 *
 * @param body number of it, or one that no body has
 * @param step made before it goes
 */
public record Loss(int body, int step) {

    /** Nothing is taken out. */
    public static final Loss NONE = new Loss(-1, 0);

    /**
     * Takes the body out when it is time.
     *
     * @param made steps made so far
     */
    public void befall(World world, int made) {
        if (body >= 0 && made == step) {
            world.remove(body);
        }
    }
}
