package rigibo.lab.problem;

import rigibo.backend.effect.Gravity;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Room;

import java.util.List;

/**
 * A disc is reflected by the walls of a room a thousand times. Truth: {@link Room}. The phases are
 * different rooms with discs in other directions; none reaches 120 m/s, where some engines no
 * longer follow. An error of the disc is a lead or lag along its path, and the places in the last
 * second give it.
 */
final class Billiards {

    private static final int BOUNCES = 1000;
    private static final double WATCHED = 1;

    private static final List<Room> ROOMS =
            List.of(new Room(50, 38), new Room(41, 47), new Room(59, 23), new Room(31, 53));

    /** Row 41. */
    private static final double EQUAL_BELOW = 1e-6;

    private Billiards() {}

    static Problem problem() {
        return new Problem(
                "R10",
                "a disc in a room, 1000 bounces",
                "distance from the unfolded line / width of the room",
                EQUAL_BELOW,
                List.of(
                        Line.STEP,
                        Line.STEP_DISCRETE,
                        Line.STEP_SPLIT,
                        Line.TOLERANCE,
                        Line.SEARCH),
                Billiards::set);
    }

    private static Trial set(Bench bench) {
        World[] worlds = new World[ROOMS.size()];
        for (int i = 0; i < worlds.length; i++) {
            worlds[i] = bench.world(Earth.effects().without(Gravity.class));
            worlds[i].add(ROOMS.get(i).disc());
            ROOMS.get(i).walls().forEach(worlds[i]::add);
        }
        return () -> bounce(bench, worlds);
    }

    private static Errors bounce(Bench bench, World[] worlds) {
        double[] off = new double[worlds.length];
        for (int i = 0; i < worlds.length; i++) {
            Room room = ROOMS.get(i);
            int steps = bench.stepsIn(BOUNCES / room.bouncesPerSecond());
            int watched = bench.stepsIn(WATCHED);
            for (int step = 1; step <= steps; step++) {
                bench.step(worlds[i]);
                double x = worlds[i].x(0);
                double y = worlds[i].y(0);
                if (!room.holds(x, y)) {
                    return Errors.failed("disc " + i + " left its room");
                }
                if (step > steps - watched) {
                    off[i] += room.off(x, y, step * bench.step()) / watched;
                }
            }
        }
        return Errors.of(Mean.of(off));
    }
}
