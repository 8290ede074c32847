package rigibo.backend.effect;

/** Bodies turn; left out, they only translate and count as infinitely hard to turn. */
public record Rotation() implements Effect {}
