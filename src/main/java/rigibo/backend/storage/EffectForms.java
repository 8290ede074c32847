package rigibo.backend.storage;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Thrust;

import java.util.List;
import java.util.function.Function;

/**
 * How each effect is stated by numbers: to add an effect, add a line. One that holds a function
 * needs none, for it is not written but handed in again.
 */
final class EffectForms {

    private static final List<Form<? extends Effect>> FORMS =
            List.of(
                    form(
                            Gravity.class,
                            2,
                            g -> new double[] {g.x(), g.y()},
                            n -> new Gravity(n[0], n[1])),
                    plain(new Contacts()),
                    plain(new Rotation()),
                    plain(new Friction()),
                    plain(new Restitution()),
                    plain(new RollingResistance()),
                    plain(new Drag()),
                    plain(new Thrust()),
                    plain(new ContinuousImpacts()),
                    form(
                            Sleep.class,
                            2,
                            s -> new double[] {s.seconds(), s.distance()},
                            n -> new Sleep(n[0], n[1])));

    private EffectForms() {}

    /**
     * How an effect of this name is stated.
     *
     * @throws IllegalArgumentException when there is none
     */
    @SuppressWarnings("unchecked") // An effect is only stated by the form of its own name.
    static Form<Effect> named(String name) {
        return (Form<Effect>)
                FORMS.stream()
                        .filter(form -> form.name().equals(name))
                        .findFirst()
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                "declares the effect "
                                                        + name
                                                        + ", for which there is no form"));
    }

    private static Form<Effect> plain(Effect effect) {
        return new Form<>(effect.getClass().getSimpleName(), 0, e -> new double[0], n -> effect);
    }

    private static <T extends Effect> Form<T> form(
            Class<T> kind, int count, Function<T, double[]> numbers, Function<double[], T> maker) {
        return new Form<>(kind.getSimpleName(), count, numbers, maker);
    }
}
