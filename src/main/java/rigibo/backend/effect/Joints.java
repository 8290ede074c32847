package rigibo.backend.effect;

/** Bodies are joined by hinges, rods, springs and the like; left out, nobody can be. */
public record Joints() implements Effect {}
