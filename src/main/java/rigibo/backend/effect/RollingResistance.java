package rigibo.backend.effect;

/** A torque up to c·N against rolling, from the materials' lever c; it stops and never reverses. */
public record RollingResistance() implements Effect {}
