package rigibo.backend.effect;

/**
 * A part of physics that is simulated only where it is declared; otherwise it costs nothing.
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
                Fan,
                Magnet,
                Thrust,
                ContinuousImpacts,
                Joints,
                Sleep,
                Sensors {

    /** Whether the effect holds a caller's function, which a snapshot cannot save. */
    default boolean holdsFunction() {
        return false;
    }

    /**
     * Name of the effect in level files and messages, in kebab-case: {@code rolling-resistance}.
     */
    default String title() {
        return getClass()
                .getSimpleName()
                .replaceAll("(?<!^)([A-Z])", "-$1")
                .toLowerCase(java.util.Locale.ROOT);
    }
}
