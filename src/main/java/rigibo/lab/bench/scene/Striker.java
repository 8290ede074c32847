package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/**
 * Strikes a body to the right at regular intervals, with a force that lasts one step.
 *
 * @param body number of the body
 * @param impulse of a stroke, N·s
 * @param every steps from one stroke to the next; the first comes after as many
 */
record Striker(int body, double impulse, int every) implements Driver {

    @Override
    public void drive(World world, int made) {
        if (made > 0 && made % every == 0) {
            world.push(body, impulse / Scene.STEP, 0);
        }
    }
}
