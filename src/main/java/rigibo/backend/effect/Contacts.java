package rigibo.backend.effect;

/** Bodies collide and rest on each other; left out, they pass through each other. */
public record Contacts() implements Effect {}
