package rigibo.backend.force;

import rigibo.backend.storage.Bodies;

/** Clears what all varying forces before it add along locked axes. */
final class LockedAxesForce implements ChangingForce {

    private final Bodies bodies;

    LockedAxesForce(Bodies bodies) {
        this.bodies = bodies;
    }

    @Override
    public void add(Instant instant) {
        if (bodies.lockedX[instant.slot]) {
            instant.accelerationX = 0;
        }
        if (bodies.lockedY[instant.slot]) {
            instant.accelerationY = 0;
        }
    }
}
