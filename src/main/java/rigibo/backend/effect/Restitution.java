package rigibo.backend.effect;

/** Impacts rebound by the materials' elasticity; left out, every impact has e = 0. */
public record Restitution() implements Effect {}
