package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;

/**
 * The billiard for an hour, 149,000 bounces. Truth: its speed stays. A bounce rounds three times,
 * by half of 2.2e-16 each; should all of them go the same way, that is 5e-11.
 */
final class LongBilliard implements HardCase {

    @Override
    public String row() {
        return "59/billiard";
    }

    @Override
    public String title() {
        return "a disc in a room keeps its speed for an hour";
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.space());
        RigidBody disc = Billiard.disc(pool);
        new Hour(trial, pool)
                .run(
                        () ->
                                trial.measure(
                                        "speed changed",
                                        Billiard.speedChange(disc),
                                        "of v",
                                        5e-11,
                                        1e-3));
        double time = Hour.STEPS * Trial.DT;
        double bounces = Billiard.bouncesPerSecond() * time;
        double missing = Math.abs(trial.work().impacts() - bounces);
        trial.measure("bounces too many or too few", missing, "bounces", 2, 1e-3 * bounces);
        trial.report("place after an hour", Billiard.off(disc, time), "of L");
    }
}
