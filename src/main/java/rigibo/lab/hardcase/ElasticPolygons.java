package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyType;
import rigibo.lab.truth.Room;
import rigibo.lab.truth.Solid;

import java.util.List;
import java.util.SplittableRandom;

/**
 * Smooth polygons, e = 1, in a closed room without gravity. Truth: no impact takes energy, however
 * fast the polygons are and however often they meet in a step; and none leaves.
 */
record ElasticPolygons(List<Double> few, List<Double> all) implements Scenes {

    private static final double HORIZON = 5;
    private static final Limits MOST_ENERGY = new Limits(1e-3, 1e-3, 1e-9, 1e-9);

    /** Walls of a room; its disc is left out. */
    private static final Room ROOM = new Room(0, 0);

    /** Speeds at which a pair meets once or twice in a step. */
    static final ElasticPolygons SLOW =
            new ElasticPolygons(List.of(35.0), List.of(30.0, 50.0, 80.0));

    /** Speeds at which a pair may meet more often in a step than the cap allows. */
    static final ElasticPolygons FAST =
            new ElasticPolygons(List.of(330.0, 900.0), List.of(200.0, 330.0, 600.0, 1000.0));

    @Override
    public void run(Trial trial) {
        int draws = trial.sampling().count(5, 20);
        for (double speed : trial.sampling().of(few, all)) {
            for (int draw = 0; draw < draws; draw++) {
                trial.variant(speed + " m/s, draw " + draw);
                fly(trial, speed, trial.sampling().random(Math.round(10 * speed) + draw));
            }
        }
    }

    private static void fly(Trial trial, double speed, SplittableRandom random) {
        WatchedPool pool = trial.space().withOverlapOfItsOwn();
        ROOM.walls().forEach(pool::add);
        int count = 1 + random.nextInt(4);
        // A single one may be so large that it meets the walls many times in a step.
        double largest = count == 1 ? 3.8 : 0.9;
        for (int i = 0; i < count; i++) {
            double way = 2 * Math.PI * random.nextDouble();
            double radius = 0.4 + (largest - 0.4) * random.nextDouble();
            pool.add(
                    Solid.of(Polygon.regular(3 + random.nextInt(4), radius), 0, 1)
                            .at(count == 1 ? 5 : 1.5 + 2.2 * i, 4)
                            .angle(2 * Math.PI * random.nextDouble())
                            .velocity(speed * Math.cos(way), speed * Math.sin(way))
                            .spin(40 * random.nextDouble() - 20));
        }
        double start = pool.pool().kineticEnergy();
        double most = 0;
        while (pool.time() < HORIZON) {
            pool.step();
            most = Math.max(most, Math.abs(pool.pool().kineticEnergy() / start - 1));
        }
        trial.measure("energy", most, "of start", MOST_ENERGY);
        long out = pool.pool().bodies().stream().filter(ElasticPolygons::isOutside).count();
        trial.measure("out of the room", out, "bodies", 0);
    }

    private static boolean isOutside(RigidBody body) {
        return body.type() == BodyType.DYNAMIC && !ROOM.holds(body.x(), body.y());
    }
}
