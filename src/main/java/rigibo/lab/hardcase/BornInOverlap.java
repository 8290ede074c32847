package rigibo.lab.hardcase;

import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Ten boxes that overlap by a quarter, two discs at one place, a box inside a fixed one. Truth:
 * bodies that begin in overlap part within 2 s, at no more than the push-out speed of 3 m/s,
 * however deep the overlap.
 */
final class BornInOverlap implements Scenes {

    private static final double MOST_SPEED = 3;
    private static final double HORIZON = 2;

    @Override
    public void run(Trial trial) {
        BodyDefinition box = Solid.box(1, 1);
        BodyDefinition disc = Solid.disc(0.5);
        trial.variant("ten boxes in a row");
        WatchedPool row = trial.space().allowingOverlap();
        for (int i = 0; i < 10; i++) {
            row.add(box.at(0.75 * i, 0));
        }
        part(trial, row);
        trial.variant("two discs at one place");
        WatchedPool twins = trial.space().allowingOverlap();
        twins.add(disc.at(0, 0));
        twins.add(disc.at(0, 0));
        part(trial, twins);
        trial.variant("a box inside a fixed one");
        WatchedPool inside = trial.space().allowingOverlap();
        inside.add(Solid.fixed(4, 4));
        inside.add(box.at(0.3, 0.1));
        part(trial, inside);
    }

    private static void part(Trial trial, WatchedPool pool) {
        while (pool.time() < HORIZON) {
            pool.step();
            trial.measure("fastest", pool.fastest(), "m/s", MOST_SPEED);
        }
        double limit = Trial.TOLERATED_OVERLAP;
        trial.measure("overlap after 2 s", pool.overlapNow(), "width", limit);
    }
}
