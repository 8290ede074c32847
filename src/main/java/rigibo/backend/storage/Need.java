package rigibo.backend.storage;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;

import java.util.List;
import java.util.Set;

/** The condition under which a column exists. */
public enum Need {
    ALWAYS,
    ROTATION(Rotation.class),
    CONTACTS(Contacts.class),
    TURNING_CONTACTS(Contacts.class, Rotation.class),
    SLEEP(Sleep.class),
    TURNING_SLEEP(Sleep.class, Rotation.class),
    FRICTION(Friction.class),
    RESTITUTION(Restitution.class),
    ROLLING_RESISTANCE(RollingResistance.class),
    SURFACE_SPEED(SurfaceSpeed.class),
    DRAG(Drag.class),
    THRUST(Thrust.class),
    TURNING_THRUST(Thrust.class, Rotation.class),
    /** Paths are integrated in substeps; this follows from the forces and the accuracy. */
    PATHS,
    TURNING_PATHS(Rotation.class),
    /** A body has more than one shape. */
    COMPOUNDS,
    /** A shape has a category or a mask of its own. */
    FILTERS,
    /** The rotation of a body is locked. */
    LOCKS,
    /** A body is driven to a target pose. */
    DRIVES,
    /** A body is disabled for a while. */
    ABSENCES,
    /** A shape is solid on one side only. */
    ONE_SIDED,
    /** A shape is a sensor. */
    SENSORS,
    /** A body's motion along an axis is locked. */
    AXES;

    /** Needs that arise with the first such body, whatever effects are declared. */
    public static final List<Need> OF_BODIES =
            List.of(COMPOUNDS, FILTERS, LOCKS, DRIVES, ABSENCES, ONE_SIDED, SENSORS, AXES);

    private final List<Class<? extends Effect>> effects;

    @SafeVarargs
    @SuppressWarnings("varargs") // The list copies the array.
    Need(Class<? extends Effect>... effects) {
        this.effects = List.of(effects);
    }

    /** Whether the declared effects alone do not decide it. */
    private boolean isAskedFor() {
        return this == PATHS || this == TURNING_PATHS || OF_BODIES.contains(this);
    }

    /** Whether the declared effects, and the needs that were asked for, meet it. */
    boolean isMet(Effects declared, Set<Need> asked) {
        return (!isAskedFor() || asked.contains(this))
                && effects.stream().allMatch(declared::declares);
    }
}
