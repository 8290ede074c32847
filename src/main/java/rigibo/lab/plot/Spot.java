package rigibo.lab.plot;

/** A point in a picture, px to the right and down. */
public record Spot(double x, double y) {}
