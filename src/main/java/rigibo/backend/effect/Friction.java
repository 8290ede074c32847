package rigibo.backend.effect;

/**
 * Coulomb friction in contacts and impacts, with μ from the materials. Without this effect all
 * surfaces are smooth.
 *
 * <pre>{@code
 * pool.effects(pool.effects().without(Friction.class)); // everything is ice
 * }</pre>
 */
public record Friction() implements Effect {}
