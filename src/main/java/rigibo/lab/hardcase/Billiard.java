package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Room;

/** A smooth disc in a room, e = 1, v = (200, 153). Truth: {@link Room}. */
final class Billiard implements HardCase {

    private static final double VX = 200;
    private static final double VY = 153;
    private static final Room ROOM = new Room(VX, VY);

    @Override
    public String row() {
        return "41";
    }

    @Override
    public String title() {
        return "a disc in a room follows the unfolded line";
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.space());
        RigidBody disc = disc(pool);
        boolean isExact = trial.preset() == Preset.EXACT;
        double horizon = (isExact ? 1000 : 100) / bouncesPerSecond();
        while (pool.time() < horizon) {
            pool.step();
            double off = off(disc, pool.time());
            trial.measure("place after 1000 / 100 bounces", off, "of L", 1e-6, 1e-3);
            trial.measure("speed changed", speedChange(disc), "of v", 1e-12, 1e-3);
        }
    }

    /** Builds the room and the disc in it. */
    static RigidBody disc(WatchedPool pool) {
        ROOM.walls().forEach(pool::add);
        return pool.add(ROOM.disc());
    }

    static double bouncesPerSecond() {
        return ROOM.bouncesPerSecond();
    }

    /** How far the disc is from where it is in truth, as a share of the room's width. */
    static double off(RigidBody disc, double time) {
        return ROOM.off(disc.x(), disc.y(), time);
    }

    static double speedChange(RigidBody disc) {
        double speed = Math.hypot(disc.velocityX(), disc.velocityY());
        return Math.abs(speed / Math.hypot(VX, VY) - 1);
    }
}
