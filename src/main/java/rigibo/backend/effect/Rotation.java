package rigibo.backend.effect;

/**
 * Bodies turn; left out, they only translate and count as infinitely hard to turn. What was stated
 * of their spin is not kept then: when this is declared later, they begin to turn from rest.
 */
public record Rotation() implements Effect {}
