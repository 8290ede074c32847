package rigibo.backend.effect;

/**
 * Something that is simulated because a scene declares it; what is not declared costs nothing.
 *
 * <pre>{@code
 * for (Effect effect : pool.effects().all()) {
 *     System.out.println(effect.title());
 * }
 * }</pre>
 */
public sealed interface Effect
        permits Gravity,
                Contacts,
                Rotation,
                Friction,
                Restitution,
                RollingResistance,
                SurfaceSpeed,
                Drag,
                AirDrag,
                Wind,
                Field,
                CentralForce,
                Buoyancy,
                Thrust,
                ContinuousImpacts,
                Joints,
                Sleep,
                Sensors {

    /**
     * Whether the effect holds a function of the caller's, which may change with time and cannot be
     * written down.
     */
    default boolean holdsFunction() {
        return false;
    }

    /** The effect's name in levels and messages, in kebab-case: {@code rolling-resistance}. */
    default String title() {
        return getClass()
                .getSimpleName()
                .replaceAll("(?<!^)([A-Z])", "-$1")
                .toLowerCase(java.util.Locale.ROOT);
    }
}
