package rigibo.backend.effect;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * A part of physics that is simulated only where it is declared; otherwise it costs nothing.
 *
 * <pre>{@code
 * for (Effect effect : pool.effects().all()) {
 *     System.out.println(effect.title());
 * }
 * }</pre>
 */
public sealed interface Effect
        permits Gravity,
                Contacts,
                Rotation,
                Friction,
                Restitution,
                RollingResistance,
                SurfaceSpeed,
                Drag,
                AirDrag,
                Wind,
                Field,
                CentralForce,
                Buoyancy,
                Fan,
                Magnet,
                Thrust,
                ContinuousImpacts,
                Joints,
                Sleep,
                Sensors {

    /** Whether the effect holds a caller's function, which a snapshot cannot save. */
    default boolean holdsFunction() {
        return false;
    }

    /** Its kind, of which a pool declares one effect at most. */
    Kind kind();

    /** The effects it needs: at least one kind of each list must be declared with it. */
    default List<List<Kind>> needs() {
        return List.of();
    }

    /** The effect's parameters as a snapshot keeps them; a caller's function is not among them. */
    default double[] numbers() {
        return new double[0];
    }

    /**
     * Name of the effect in level files and messages, in kebab-case: {@code rolling-resistance}.
     */
    default String title() {
        return kind().title();
    }

    /** What an effect may do to the energy that a pool counts. */
    enum Energy {
        /** None is taken or given. */
        KEPT,
        /** Some is taken, none is given. */
        TAKEN,
        /** Work is done from outside, or a force has a potential that no pool counts. */
        GIVEN
    }

    /**
     * The kinds of effects. Code that chooses what a kind adds to a step names all of them, so that
     * the compiler tells where a new one is missing. Forces that vary along the path add up in this
     * order.
     */
    enum Kind {
        GRAVITY(Energy.KEPT, 2, n -> new Gravity(n[0], n[1])),
        CONTACTS(Energy.KEPT, 0, n -> new Contacts()),
        ROTATION(Energy.KEPT, 0, n -> new Rotation()),
        FRICTION(Energy.TAKEN, 0, n -> new Friction()),
        RESTITUTION(Energy.KEPT, 0, n -> new Restitution()),
        ROLLING_RESISTANCE(Energy.TAKEN, 0, n -> new RollingResistance()),
        SURFACE_SPEED(Energy.GIVEN, 0, n -> new SurfaceSpeed()),
        AIR_DRAG(Energy.TAKEN, 2, n -> new AirDrag(n[0], n[1])),
        DRAG(Energy.TAKEN, 0, n -> new Drag()),
        CENTRAL_FORCE(Energy.GIVEN, 4, n -> new CentralForce(n[0], n[1], n[2], n[3])),
        BUOYANCY(Energy.GIVEN, 3, n -> new Buoyancy(n[0], n[1], n[2])),
        FAN(Energy.GIVEN, Fan::of),
        MAGNET(Energy.GIVEN, Magnet::of),
        FIELD(Energy.GIVEN),
        THRUST(Energy.GIVEN, 0, n -> new Thrust()),
        JOINTS(Energy.KEPT, 0, n -> new Joints()),
        SENSORS(Energy.KEPT, 0, n -> new Sensors()),
        CONTINUOUS_IMPACTS(Energy.KEPT, 0, n -> new ContinuousImpacts()),
        SLEEP(Energy.TAKEN, 2, n -> new Sleep(n[0], n[1])),
        WIND(Energy.GIVEN, 2, n -> new Wind(n[0], n[1]));

        private static final int ANY = -1;

        private final Energy energy;
        private final int count;
        private final Function<double[], Effect> maker;

        Kind(Energy energy, int count, Function<double[], Effect> maker) {
            this.energy = energy;
            this.count = count;
            this.maker = maker;
        }

        /** For effects that take any number of parameters. */
        Kind(Energy energy, Function<double[], Effect> maker) {
            this(energy, ANY, maker);
        }

        /** For effects that always hold a function, and so cannot be made of numbers. */
        Kind(Energy energy) {
            this(energy, ANY, null);
        }

        /** What it may do to the energy that a pool counts. */
        public Energy energy() {
            return energy;
        }

        /** Name in level files and messages, in kebab-case: {@code rolling-resistance}. */
        public String title() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }

        /** Name of its class: {@code RollingResistance}. */
        public String typeName() {
            return Arrays.stream(name().split("_"))
                    .map(word -> word.charAt(0) + word.substring(1).toLowerCase(Locale.ROOT))
                    .collect(Collectors.joining());
        }

        /** Whether an effect of this kind can be made of numbers alone. */
        public boolean isMadeOfNumbers() {
            return maker != null;
        }

        /** Number of parameters of this kind; −1 where it varies. */
        public int numbers() {
            return count;
        }

        /**
         * Makes the effect of this kind that has these {@link Effect#numbers()}.
         *
         * @throws IllegalArgumentException when no such effect has them
         */
        public Effect of(double... numbers) {
            boolean isCount = count == ANY || count == numbers.length;
            if (!isMadeOfNumbers() || !isCount) {
                throw new IllegalArgumentException(
                        typeName() + " is not made of " + numbers.length + " numbers");
            }
            return maker.apply(numbers);
        }
    }
}
