package rigibo.backend.effect;

import rigibo.backend.setup.Require;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * Streams of air from places of the world. A stream pushes each dynamic body whose centre of mass
 * is in its reach. The force points along the stream. At the mouth it is {@code force} times the
 * width that the body turns to the stream, and it falls linearly to 0 at the end of the reach. The
 * force acts at the centre of mass; bodies do not shelter each other.
 *
 * <pre>{@code
 * Fan.Jet upwards = new Fan.Jet(0, 0, Math.PI / 2, 1, 4, 800);
 * pool.effects(pool.effects().with(new Fan(upwards)));
 * // Later, between two steps, at half of its strength:
 * pool.effects(pool.effects().with(new Fan(upwards.force(400))));
 * }</pre>
 *
 * @param jets the streams, in an order of the caller's
 */
public record Fan(List<Jet> jets) implements Effect {

    /** Checks that there is no null among the streams. */
    public Fan {
        Require.present("Fan.jets", jets);
        jets.forEach(jet -> Require.present("Fan.jets jet", jet));
        jets = List.copyOf(jets);
    }

    /** A fan of some streams, or of none. */
    public Fan(Jet... jets) {
        this(Arrays.asList(Require.present("Fan.jets", jets)));
    }

    @Override
    public Kind kind() {
        return Kind.FAN;
    }

    @Override
    public double[] numbers() {
        DoubleStream.Builder numbers = DoubleStream.builder();
        for (Jet jet : jets) {
            numbers.add(jet.x()).add(jet.y()).add(jet.angle());
            numbers.add(jet.width()).add(jet.reach()).add(jet.force());
        }
        return numbers.build().toArray();
    }

    /** Makes a fan of its parameters; refuses an incomplete jet. */
    static Fan of(double[] n) {
        if (n.length % Jet.NUMBERS != 0) {
            throw new IllegalArgumentException("jets of a fan are cut short");
        }
        List<Jet> jets = new ArrayList<>();
        for (int i = 0; i < n.length; i += Jet.NUMBERS) {
            jets.add(new Jet(n[i], n[i + 1], n[i + 2], n[i + 3], n[i + 4], n[i + 5]));
        }
        return new Fan(jets);
    }

    /**
     * One stream.
     *
     * @param x world x of the middle of its mouth, m
     * @param y world y of the middle of its mouth, m, up
     * @param angle direction of the stream, rad, counter-clockwise from the right
     * @param width across, m, positive
     * @param reach along, m, positive
     * @param force at the mouth for each metre of a body's width, N/m; a negative one sucks
     */
    public record Jet(double x, double y, double angle, double width, double reach, double force) {

        private static final int NUMBERS = 6;

        /**
         * Checks every number.
         *
         * @throws IllegalArgumentException when one is not finite, or width or reach not positive
         */
        public Jet {
            Require.finite("Fan.Jet.x", x, "m");
            Require.finite("Fan.Jet.y", y, "m");
            Require.finite("Fan.Jet.angle", angle, "rad");
            Require.positive("Fan.Jet.width", width, "m");
            Require.positive("Fan.Jet.reach", reach, "m");
            Require.finite("Fan.Jet.force", force, "N/m");
        }

        /** A copy of another strength, N/m; 0 for a stream that is switched off. */
        public Jet force(double newtonsPerMetre) {
            return new Jet(x, y, angle, width, reach, newtonsPerMetre);
        }
    }
}
