package rigibo.backend.law;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;

import java.util.ArrayList;
import java.util.List;

/** Sets of effects drawn from a seed, each of the sixteen kinds where what it needs is there. */
final class RandomEffects {

    private final Draw draw;
    private final List<Effect> drawn = new ArrayList<>();

    private RandomEffects(Draw draw) {
        this.draw = draw;
    }

    static Effects of(Draw draw) {
        RandomEffects effects = new RandomEffects(draw);
        effects.drawAll();
        return Effects.of(effects.drawn.toArray(new Effect[0]));
    }

    private void drawAll() {
        boolean rotation = mayBe(0.85, new Rotation());
        if (mayBe(0.95, new Contacts())) {
            drawContacts(rotation);
        }
        if (mayBe(0.9, new Gravity(draw.between(-0.5, 0.5), -9.81))) {
            mayBe(0.4, new Buoyancy(draw.between(0.3, 3), draw.between(0.3, 3), 2));
        }
        boolean drag = mayBe(0.4, new Drag());
        boolean air = mayBe(0.3, new AirDrag(draw.between(0, 1.3), 1));
        if (drag || air) {
            Wind steady = new Wind(draw.between(-3, 3), 0);
            mayBe(0.4, draw.chance(0.5) ? steady : new Wind(2, 1, StrictMath::sin));
        }
        mayBe(0.5, new Thrust());
        mayBe(0.3, new CentralForce(draw.between(-1, 1), 1, draw.between(-1, 2), 1));
        mayBe(0.1, new Field(at -> at.push(0.1, -0.2 * at.x)));
    }

    private void drawContacts(boolean rotation) {
        if (mayBe(0.85, new Friction())) {
            mayBe(0.3, new SurfaceSpeed());
        }
        mayBe(0.8, new Restitution());
        mayBe(0.8, new ContinuousImpacts());
        if (rotation) {
            mayBe(0.5, new RollingResistance());
        }
        // So soon that most fall asleep again between two edits.
        mayBe(0.8, new Sleep(0.2, 2e-3));
    }

    private boolean mayBe(double probability, Effect effect) {
        boolean isDeclared = draw.chance(probability);
        if (isDeclared) {
            drawn.add(effect);
        }
        return isDeclared;
    }
}
