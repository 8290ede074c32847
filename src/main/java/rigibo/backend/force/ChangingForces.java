package rigibo.backend.force;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Wind;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;

/** The declared forces that vary along the path, compiled from a set of effects. */
public final class ChangingForces {

    private ChangingForce[] forces;

    /** The varying forces of a declared set; empty if it has none. */
    public ChangingForces(Effects effects) {
        forces =
                effects.all().stream()
                        .sorted(Comparator.comparing(Effect::kind))
                        .map(effect -> force(effect, effects))
                        .flatMap(Optional::stream)
                        .toArray(ChangingForce[]::new);
    }

    /** What an effect adds along the path; empty where that does not vary, or is no force. */
    private static Optional<ChangingForce> force(Effect effect, Effects all) {
        return switch (effect.kind()) {
            case AIR_DRAG -> Optional.of(new AirDragForce((AirDrag) effect, wind(all)));
            case DRAG -> Optional.of(wind(all)).filter(it -> !it.isSteady()).map(GustForce::new);
            case CENTRAL_FORCE -> Optional.of(new CentralPull((CentralForce) effect));
            case BUOYANCY -> Optional.of(new BuoyantForce((Buoyancy) effect, gravity(all)));
            case FAN -> Optional.of(new FanForce((Fan) effect));
            case MAGNET -> Optional.of(new MagnetForce((Magnet) effect));
            case FIELD -> Optional.of(new FieldForce((Field) effect));
            case GRAVITY, THRUST, WIND -> Optional.empty();
            case CONTACTS, FRICTION, RESTITUTION, ROLLING_RESISTANCE, SURFACE_SPEED ->
                    Optional.empty();
            case ROTATION, JOINTS, SENSORS, CONTINUOUS_IMPACTS, SLEEP -> Optional.empty();
        };
    }

    private static Gravity gravity(Effects effects) {
        return effects.find(Gravity.class).orElseThrow();
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
