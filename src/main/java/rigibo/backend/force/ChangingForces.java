package rigibo.backend.force;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Wind;
import rigibo.backend.storage.Bodies;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The declared forces that vary along the path, compiled from a set of effects. */
public final class ChangingForces {

    private ChangingForce[] forces;

    /** The varying forces of a declared set; empty if it has none. */
    public ChangingForces(Effects effects) {
        List<ChangingForce> list = new ArrayList<>();
        effects.find(AirDrag.class)
                .ifPresent(air -> list.add(new AirDragForce(air, wind(effects))));
        if (effects.declares(Drag.class) && !wind(effects).isSteady()) {
            list.add(new GustForce(wind(effects)));
        }
        effects.find(CentralForce.class).ifPresent(central -> list.add(new CentralPull(central)));
        effects.find(Buoyancy.class)
                .ifPresent(
                        water ->
                                list.add(
                                        new BuoyantForce(
                                                water, effects.find(Gravity.class).get())));
        effects.find(Fan.class).ifPresent(fan -> list.add(new FanForce(fan)));
        effects.find(Magnet.class).ifPresent(magnet -> list.add(new MagnetForce(magnet)));
        effects.find(Field.class).ifPresent(field -> list.add(new FieldForce(field)));
        forces = list.toArray(ChangingForce[]::new);
    }

    /** From now on clears what these forces add along the locked axes of bodies. */
    public void holdAxes(Bodies bodies) {
        if (forces.length > 0) {
            forces = Arrays.copyOf(forces, forces.length + 1);
            forces[forces.length - 1] = new LockedAxesForce(bodies);
        }
    }

    private static Wind wind(Effects effects) {
        return effects.find(Wind.class).orElse(new Wind(0, 0));
    }

    /** Whether no force varies along the path. */
    public boolean isEmpty() {
        return forces.length == 0;
    }

    /**
     * Writes the accelerations, m/s² and rad/s², that all these forces give a body at an instant.
     */
    public void evaluate(Instant instant) {
        instant.accelerationX = 0;
        instant.accelerationY = 0;
        instant.angularAcceleration = 0;
        for (int i = 0; i < forces.length; i++) {
            forces[i].add(instant);
        }
    }
}
