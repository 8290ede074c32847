package rigibo.backend.effect;

/** Something that is simulated because a scene declares it; what is not declared costs nothing. */
public sealed interface Effect
        permits Gravity,
                Contacts,
                Rotation,
                Friction,
                Restitution,
                RollingResistance,
                SurfaceSpeed,
                Drag,
                Thrust,
                ContinuousImpacts,
                Sleep {

    /** The effect's name in levels and messages, in kebab-case: {@code rolling-resistance}. */
    default String title() {
        return getClass()
                .getSimpleName()
                .replaceAll("(?<!^)([A-Z])", "-$1")
                .toLowerCase(java.util.Locale.ROOT);
    }
}
