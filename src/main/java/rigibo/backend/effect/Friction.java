package rigibo.backend.effect;

/** Coulomb's friction at contacts and impacts, from the materials' μ. */
public record Friction() implements Effect {}
