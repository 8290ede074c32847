package rigibo.fuzz.program;

import static rigibo.fuzz.program.Stated.call;
import static rigibo.fuzz.program.Stated.numbers;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldFunction;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Gusts;
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
import rigibo.fuzz.chance.Chance;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;

/** Draws a set of effects; an effect is drawn only if those that it needs are there. */
final class DrawnEffects {

    private final Chance chance;
    private final Temper temper;
    private final List<Stated<Effect>> drawn = new ArrayList<>();

    private DrawnEffects(Chance chance, Temper temper) {
        this.chance = chance;
        this.temper = temper;
    }

    static Stated<Effects> draw(Chance chance, Temper temper) {
        DrawnEffects effects = new DrawnEffects(chance, temper);
        effects.drawAll();
        List<Stated<Effect>> all = effects.drawn;
        // The order must not matter.
        Collections.rotate(all, chance.whole(0, Math.max(1, all.size())));
        return new Stated<>(
                all.stream()
                        .map(Stated::java)
                        .collect(Collectors.joining(", ", "Effects.of(", ")")),
                () -> Effects.of(all.stream().map(Stated::value).toArray(Effect[]::new)));
    }

    private void drawAll() {
        boolean hasRotation = plain(0.8, new Rotation());
        if (plain(0.9, new Contacts())) {
            drawContacts(hasRotation);
        }
        if (chance.happens(0.7)) {
            drawGravity();
        }
        boolean hasDrag = plain(0.3, new Drag());
        boolean hasAir = chance.happens(0.2);
        if (hasAir) {
            two("AirDrag", temper.factor(chance, 1e50), temper.factor(chance, 1e50), AirDrag::new);
        }
        if ((hasDrag || hasAir) && chance.happens(0.5)) {
            drawWind();
        }
        plain(0.4, new Thrust());
        if (chance.happens(0.15)) {
            drawCentralForce();
        }
        if (chance.happens(0.15)) {
            drawFan();
        }
        if (chance.happens(0.15)) {
            drawMagnet();
        }
        if (chance.happens(0.15)) {
            drawn.add(field());
        }
    }

    private void drawContacts(boolean hasRotation) {
        if (plain(0.7, new Friction())) {
            plain(0.3, new SurfaceSpeed());
        }
        plain(0.7, new Restitution());
        plain(0.7, new ContinuousImpacts());
        if (hasRotation) {
            plain(0.3, new RollingResistance());
        }
        if (chance.happens(0.5)) {
            two("Sleep", temper.factor(chance, 1e9), 1e-3 * temper.factor(chance, 1e9), Sleep::new);
        }
        plain(0.2, new Sensors());
        plain(0.2, new Joints());
    }

    private void drawGravity() {
        double y = chance.happens(0.5) ? -9.81 : chance.ofEitherSign(1e-3, 1e3);
        double strong = temper.wildness() > 0 && chance.happens(0.1) ? 1e6 : y;
        double x = chance.happens(0.7) ? 0 : chance.between(-10, 10);
        two("Gravity", x, strong, Gravity::new);
        if (chance.happens(0.2)) {
            double level = temper.placeY(chance);
            double density = temper.factor(chance, 1e50);
            double drag = temper.factor(chance, 1e50);
            drawn.add(
                    new Stated<>(
                            call("new Buoyancy", level, density, drag),
                            () -> new Buoyancy(level, density, drag)));
        }
    }

    private void drawWind() {
        double vx = chance.happens(0.05) ? 1e4 : chance.between(-20, 20);
        double vy = chance.between(-5, 5);
        if (chance.happens(0.5)) {
            two("Wind", vx, vy, Wind::new);
            return;
        }
        Stated<Gusts> gusts = Functions.gusts(chance, temper);
        drawn.add(
                new Stated<>(
                        "new Wind(" + numbers(vx, vy) + ", " + gusts.java() + ")",
                        () -> new Wind(vx, vy, gusts.value())));
    }

    private void drawCentralForce() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double power = chance.oneOf(-2.0, 1.0, 0.0, chance.between(-8, 8));
        double strength = temper.factor(chance, 1e100);
        drawn.add(
                new Stated<>(
                        call("new CentralForce", x, y, strength, power),
                        () -> new CentralForce(x, y, strength, power)));
    }

    private void drawFan() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double angle = chance.between(-4, 4);
        double width = 1e-3 + temper.factor(chance, 1e9);
        double reach = 1e-3 + temper.factor(chance, 1e9);
        double force = temper.factor(chance, 1e50);
        drawn.add(
                new Stated<>(
                        "new Fan(" + call("new Fan.Jet", x, y, angle, width, reach, force) + ")",
                        () -> new Fan(new Fan.Jet(x, y, angle, width, reach, force))));
    }

    private void drawMagnet() {
        double x = temper.placeX(chance);
        double y = temper.placeY(chance);
        double strength = temper.factor(chance, 1e50);
        double reach = 1e-3 + temper.factor(chance, 1e9);
        drawn.add(
                new Stated<>(
                        "new Magnet(" + call("new Magnet.Pole", x, y, strength, reach) + ")",
                        () -> new Magnet(new Magnet.Pole(x, y, strength, reach))));
    }

    private Stated<Effect> field() {
        Stated<FieldFunction> function = Functions.field(chance, temper);
        return new Stated<>(
                "new Field(" + function.java() + ")", () -> new Field(function.value()));
    }

    /** Declares an effect without parameters with a probability. */
    private boolean plain(double probability, Effect effect) {
        boolean isDeclared = chance.happens(probability);
        if (isDeclared) {
            drawn.add(
                    new Stated<>("new " + effect.getClass().getSimpleName() + "()", () -> effect));
        }
        return isDeclared;
    }

    private interface OfTwo {
        Effect make(double first, double second);
    }

    private void two(String name, double first, double second, OfTwo maker) {
        drawn.add(
                new Stated<>(call("new " + name, first, second), () -> maker.make(first, second)));
    }
}
