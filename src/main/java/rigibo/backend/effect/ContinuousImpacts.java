package rigibo.backend.effect;

/** Impacts at their own time within the step; left out, only overlap at the step's end counts. */
public record ContinuousImpacts() implements Effect {}
