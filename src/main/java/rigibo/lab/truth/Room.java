package rigibo.lab.truth;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.List;

/**
 * A smooth disc in a room, e = 1. Truth: unfolded at the walls its path is straight, so each
 * coordinate is a triangle wave of time: x = w − |((x0 + vt) mod 2w) − w| over the free width w.
 *
 * @param velocityX of the disc at the start, m/s, 0 or more
 * @param velocityY of the disc at the start, m/s, 0 or more
 */
public record Room(double velocityX, double velocityY) {

    private static final double WIDTH = 10;
    private static final double HEIGHT = 8;
    private static final double RADIUS = 0.25;
    private static final double START_X = 4;
    private static final double START_Y = 3;
    private static final Material SMOOTH = new Material(1, 0, 1);

    /** The four walls, 1 m thick. */
    public List<BodyDefinition> walls() {
        BodyDefinition wall = Solid.fixed(12, 1).material(SMOOTH);
        return List.of(
                wall.at(WIDTH / 2, -0.5),
                wall.at(WIDTH / 2, HEIGHT + 0.5),
                wall.at(-0.5, HEIGHT / 2).angle(Math.PI / 2),
                wall.at(WIDTH + 0.5, HEIGHT / 2).angle(Math.PI / 2));
    }

    /** The disc at its start. */
    public BodyDefinition disc() {
        return Solid.disc(RADIUS)
                .at(START_X, START_Y)
                .velocity(velocityX, velocityY)
                .material(SMOOTH);
    }

    /** Bounces per second at both pairs of walls. */
    public double bouncesPerSecond() {
        return velocityX / (WIDTH - 2 * RADIUS) + velocityY / (HEIGHT - 2 * RADIUS);
    }

    /** The distance of a place from that of the disc at a time in s, as a share of the width. */
    public double off(double x, double y, double time) {
        double trueX = RADIUS + wave(START_X - RADIUS + velocityX * time, WIDTH - 2 * RADIUS);
        double trueY = RADIUS + wave(START_Y - RADIUS + velocityY * time, HEIGHT - 2 * RADIUS);
        return Math.hypot(x - trueX, y - trueY) / WIDTH;
    }

    /** Whether the centre of the disc could be there. */
    public boolean holds(double x, double y) {
        return x > 0 && x < WIDTH && y > 0 && y < HEIGHT;
    }

    /** The triangle wave that rises from 0 to the free way and falls again. */
    private static double wave(double unfolded, double free) {
        return free - Math.abs(unfolded % (2 * free) - free);
    }
}
