package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Room;

/** A smooth disc in a room, e = 1, v = (200, 153). Truth: {@link Room}. */
final class Billiard implements Scenes {

    private static final double VX = 200;
    private static final double VY = 153;
    private static final Room ROOM = new Room(VX, VY);

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.space();
        RigidBody disc = disc(pool);
        boolean isExact = trial.preset() == Preset.EXACT;
        double horizon = (isExact ? 1000 : 100) / ROOM.bouncesPerSecond();
        while (pool.time() < horizon) {
            pool.step();
            double off = ROOM.off(disc.x(), disc.y(), pool.time());
            trial.measure("place after 1000 / 100 bounces", off, "of L", 1e-6, 1e-3);
            trial.measure("speed changed", speedChange(disc), "of v", 1e-12, 1e-3);
        }
    }

    /**
     * An hour, 149,000 bounces. Truth: the speed is constant. A bounce rounds three times, by half
     * of 2.2e-16 each; if all errors had one sign, they would add up to 5e-11.
     */
    static void keepSpeedForAnHour(Trial trial) {
        WatchedPool pool = trial.space();
        RigidBody disc = disc(pool);
        Limits limits = Limits.of(1e-3, 5e-11);
        new Hour(trial, pool)
                .run(() -> trial.measure("speed changed", speedChange(disc), "of v", limits));
        double time = Hour.STEPS * Trial.DT;
        double bounces = ROOM.bouncesPerSecond() * time;
        double missing = Math.abs(trial.work().all().impacts() - bounces);
        trial.measure("bounces too many or too few", missing, "bounces", 2, 1e-3 * bounces);
        trial.report("place after an hour", ROOM.off(disc.x(), disc.y(), time), "of L");
    }

    /** Builds the room and the disc in it. */
    private static RigidBody disc(WatchedPool pool) {
        ROOM.walls().forEach(pool::add);
        return pool.add(ROOM.disc());
    }

    private static double speedChange(RigidBody disc) {
        double speed = Math.hypot(disc.velocityX(), disc.velocityY());
        return Math.abs(speed / Math.hypot(VX, VY) - 1);
    }
}
