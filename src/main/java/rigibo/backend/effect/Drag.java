package rigibo.backend.effect;

/** A force per mass of k·v against motion, k from the material; the decay is exactly e^(−kt). */
public record Drag() implements Effect {}
