package rigibo.backend.step;

import java.util.function.LongSupplier;
import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;

/** The stages one step consists of. */
public final class StepPlan {

    private final DataStorage data;
    private final Broadphase broadphase;
    private Effects effects;
    private Accuracy accuracy;

    public StepPlan(DataStorage data, Effects effects, Accuracy accuracy) {
        this.data = data;
        broadphase = new Broadphase(data);
        compile(effects, accuracy);
    }

    public void compile(Effects effects, Accuracy accuracy) {
        this.effects = effects;
        this.accuracy = accuracy;
    }

    public void run(double dt, LongSupplier clock) {
        data.counters.clear();
        data.roster.refresh(data.bodies);
        Gravity gravity = effects.find(Gravity.class).orElse(new Gravity(0, 0));
        Bodies b = data.bodies;
        for (int i = 0; i < data.roster.awakeCount; i++) {
            int s = data.roster.awake[i];
            double g = b.type[s] == BodyType.DYNAMIC ? b.gravityScale[s] : 0;
            b.x[s] += dt * (b.velocityX[s] + dt / 2 * g * gravity.x());
            b.y[s] += dt * (b.velocityY[s] + dt / 2 * g * gravity.y());
            b.velocityX[s] += dt * g * gravity.x();
            b.velocityY[s] += dt * g * gravity.y();
            b.angle[s] += dt * b.spin[s];
            b.cos[s] = StrictMath.cos(b.angle[s]);
            b.sin[s] = StrictMath.sin(b.angle[s]);
        }
    }

    public Broadphase broadphase() {
        return broadphase;
    }

    public Effects effects() {
        return effects;
    }

    public Accuracy accuracy() {
        return accuracy;
    }

    public String describe() {
        return "flight";
    }
}
