package rigibo.backend.saved;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;

/**
 * How each effect is converted to numbers; a new effect needs one line here. An effect that holds a
 * function needs none, since it is not written but passed again by the caller.
 */
final class EffectForms {

    /** Numbers of a jet of a fan, and of a pole of a magnet. */
    private static final int JET = 6;

    private static final int POLE = 5;

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
                    plain(new SurfaceSpeed()),
                    form(
                            AirDrag.class,
                            2,
                            a -> new double[] {a.density(), a.coefficient()},
                            n -> new AirDrag(n[0], n[1])),
                    form(
                            Wind.class,
                            2,
                            w -> new double[] {w.x(), w.y()},
                            n -> new Wind(n[0], n[1])),
                    form(
                            CentralForce.class,
                            4,
                            c -> new double[] {c.x(), c.y(), c.strength(), c.power()},
                            n -> new CentralForce(n[0], n[1], n[2], n[3])),
                    form(
                            Buoyancy.class,
                            3,
                            b -> new double[] {b.level(), b.density(), b.drag()},
                            n -> new Buoyancy(n[0], n[1], n[2])),
                    form(Fan.class, Form.ANY, EffectForms::numbersOf, EffectForms::fanOf),
                    form(Magnet.class, Form.ANY, EffectForms::numbersOf, EffectForms::magnetOf),
                    plain(new ContinuousImpacts()),
                    plain(new Sensors()),
                    plain(new Joints()),
                    form(
                            Sleep.class,
                            2,
                            s -> new double[] {s.seconds(), s.distance()},
                            n -> new Sleep(n[0], n[1])));

    private EffectForms() {}

    /**
     * The form of the effect with a name.
     *
     * @throws IllegalArgumentException when there is none
     */
    @SuppressWarnings("unchecked") // An effect is only converted by the form of its own name.
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

    private static double[] numbersOf(Fan fan) {
        DoubleStream.Builder numbers = DoubleStream.builder();
        for (Fan.Jet jet : fan.jets()) {
            numbers.add(jet.x()).add(jet.y()).add(jet.angle());
            numbers.add(jet.width()).add(jet.reach()).add(jet.force());
        }
        return numbers.build().toArray();
    }

    private static Fan fanOf(double[] n) {
        requireWhole("jets of a fan", n, JET);
        List<Fan.Jet> jets = new ArrayList<>();
        for (int i = 0; i < n.length; i += JET) {
            jets.add(new Fan.Jet(n[i], n[i + 1], n[i + 2], n[i + 3], n[i + 4], n[i + 5]));
        }
        return new Fan(jets);
    }

    private static double[] numbersOf(Magnet magnet) {
        DoubleStream.Builder numbers = DoubleStream.builder();
        for (Magnet.Pole pole : magnet.poles()) {
            numbers.add(pole.x()).add(pole.y()).add(pole.strength());
            numbers.add(pole.reach()).add(pole.category());
        }
        return numbers.build().toArray();
    }

    private static Magnet magnetOf(double[] n) {
        requireWhole("poles of a magnet", n, POLE);
        List<Magnet.Pole> poles = new ArrayList<>();
        for (int i = 0; i < n.length; i += POLE) {
            poles.add(new Magnet.Pole(n[i], n[i + 1], n[i + 2], n[i + 3], (int) n[i + 4]));
        }
        return new Magnet(poles);
    }

    private static void requireWhole(String what, double[] numbers, int each) {
        if (numbers.length % each != 0) {
            throw new IllegalArgumentException(what + " are cut short");
        }
    }

    private static Form<Effect> plain(Effect effect) {
        return new Form<>(effect.getClass().getSimpleName(), 0, e -> new double[0], n -> effect);
    }

    private static <T extends Effect> Form<T> form(
            Class<T> kind, int count, Function<T, double[]> numbers, Function<double[], T> maker) {
        return new Form<>(kind.getSimpleName(), count, numbers, maker);
    }
}
