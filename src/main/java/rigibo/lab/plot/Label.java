package rigibo.lab.plot;

/**
 * A label that belongs to a spot.
 *
 * @param words themselves
 * @param size of their letters, px
 * @param color of their letters
 * @param of what they belong to
 * @param gap least distance from there, px
 * @param reach greatest distance from there, px
 */
public record Label(String words, int size, String color, Spot of, double gap, double reach) {}
