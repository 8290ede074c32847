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

/** What has to be declared for a column to be there. */
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
    /** Paths are integrated, which follows from forces and accuracy. */
    PATHS,
    TURNING_PATHS(Rotation.class),
    /** A body has more than one shape. */
    COMPOUNDS,
    /** A shape does not meet everybody. */
    FILTERS,
    /** A body is kept from turning. */
    LOCKS,
    /** A body is driven to a place. */
    DRIVES,
    /** A body is taken out of the simulation for a while. */
    ABSENCES,
    /** A shape is solid on one side alone. */
    ONE_SIDED,
    /** A shape touches nothing and tells who is inside. */
    SENSORS,
    /** A body is kept from moving along an axis. */
    AXES;

    /** What the first body that has it makes columns of, whatever is declared. */
    public static final List<Need> OF_BODIES =
            List.of(COMPOUNDS, FILTERS, LOCKS, DRIVES, ABSENCES, ONE_SIDED, SENSORS, AXES);

    private final List<Class<? extends Effect>> effects;

    @SafeVarargs
    Need(Class<? extends Effect>... effects) {
        this.effects = List.of(effects);
    }

    /** Whether effects alone do not tell. */
    private boolean isAskedFor() {
        return this == PATHS || this == TURNING_PATHS || OF_BODIES.contains(this);
    }

    /** Whether it is met by what is declared, and by what else was asked for. */
    boolean isMet(Effects declared, Set<Need> asked) {
        return (!isAskedFor() || asked.contains(this))
                && effects.stream().allMatch(declared::declares);
    }
}
