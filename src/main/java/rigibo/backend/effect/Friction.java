package rigibo.backend.effect;

/**
 * Coulomb's friction at contacts and impacts, from the materials' μ.
 *
 * <pre>{@code
 * pool.effects(pool.effects().without(Friction.class)); // everything is ice
 * }</pre>
 */
public record Friction() implements Effect {}
