package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/** Nothing is driven. */
record Undriven() implements Driver {

    @Override
    public void drive(World world, int made) {
        // Nothing is done.
    }
}
