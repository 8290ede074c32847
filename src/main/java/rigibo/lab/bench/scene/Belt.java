package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/**
 * A kinematic floor, the scene's first body, that slides to the right all the time: a conveyor that
 * every engine can have.
 *
 * @param speed m/s
 */
record Belt(double speed) implements Driver {

    @Override
    public void drive(World world, int made) {
        world.drive(0, speed, 0, 0);
    }
}
