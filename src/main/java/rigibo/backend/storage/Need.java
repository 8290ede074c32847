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
    TURNING_PATHS(Rotation.class);

    private final List<Class<? extends Effect>> effects;

    @SafeVarargs
    Need(Class<? extends Effect>... effects) {
        this.effects = List.of(effects);
    }

    boolean isMet(Effects declared, boolean pathsAreIntegrated) {
        boolean isOfPaths = this == PATHS || this == TURNING_PATHS;
        return (pathsAreIntegrated || !isOfPaths) && effects.stream().allMatch(declared::declares);
    }
}
