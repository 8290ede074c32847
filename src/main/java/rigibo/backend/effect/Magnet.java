package rigibo.backend.effect;

import rigibo.backend.setup.Require;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * Magnets at places of the world. Each pulls the dynamic bodies of a category that are in its
 * reach. Whatever their mass, it accelerates them by {@code strength·(1 − r/reach)}, r being the
 * distance of their centre of mass; at the magnet itself by 0.
 *
 * <pre>{@code
 * int iron = 1 << 1;
 * Magnet.Pole crane = new Magnet.Pole(3, 6, 20, 2, iron);
 * pool.effects(pool.effects().with(new Magnet(crane)));
 * // Later, between two steps, it lets go:
 * pool.effects(pool.effects().with(new Magnet(crane.strength(0))));
 * }</pre>
 *
 * @param poles the magnets, in an order of the caller's
 */
public record Magnet(List<Pole> poles) implements Effect {

    /** Checks that there is no null among the magnets. */
    public Magnet {
        Require.present("Magnet.poles", poles);
        poles.forEach(pole -> Require.present("Magnet.poles pole", pole));
        poles = List.copyOf(poles);
    }

    /** Some magnets, or none. */
    public Magnet(Pole... poles) {
        this(Arrays.asList(Require.present("Magnet.poles", poles)));
    }

    @Override
    public Kind kind() {
        return Kind.MAGNET;
    }

    @Override
    public double[] numbers() {
        DoubleStream.Builder numbers = DoubleStream.builder();
        for (Pole pole : poles) {
            numbers.add(pole.x()).add(pole.y()).add(pole.strength());
            numbers.add(pole.reach()).add(pole.category());
        }
        return numbers.build().toArray();
    }

    /** Makes magnets of their parameters; refuses an incomplete one. */
    static Magnet of(double[] n) {
        if (n.length % Pole.NUMBERS != 0) {
            throw new IllegalArgumentException("poles of a magnet are cut short");
        }
        List<Pole> poles = new ArrayList<>();
        for (int i = 0; i < n.length; i += Pole.NUMBERS) {
            poles.add(new Pole(n[i], n[i + 1], n[i + 2], n[i + 3], (int) n[i + 4]));
        }
        return new Magnet(poles);
    }

    /**
     * One magnet.
     *
     * @param x world x, m
     * @param y world y, m, up
     * @param strength acceleration beside it, m/s²; a negative one repels
     * @param reach m, positive
     * @param category bits of the categories that it acts on, as of a {@code Filter}
     */
    public record Pole(double x, double y, double strength, double reach, int category) {

        private static final int NUMBERS = 5;

        /**
         * Checks every number.
         *
         * @throws IllegalArgumentException when one is not finite, or the reach not positive
         */
        public Pole {
            Require.finite("Magnet.Pole.x", x, "m");
            Require.finite("Magnet.Pole.y", y, "m");
            Require.finite("Magnet.Pole.strength", strength, "m/s²");
            Require.positive("Magnet.Pole.reach", reach, "m");
        }

        /** A magnet that acts on bodies of all categories. */
        public Pole(double x, double y, double strength, double reach) {
            this(x, y, strength, reach, ~0);
        }

        /** A copy of another strength, m/s²; 0 for a magnet that is switched off. */
        public Pole strength(double metresPerSecondSquared) {
            return new Pole(x, y, metresPerSecondSquared, reach, category);
        }
    }
}
