package rigibo.lab.plot;

/** A place in a picture, px to the right and down. */
public record Spot(double x, double y) {}
