package rigibo.lab.plot;

/**
 * A label of a spot.
 *
 * @param words its text
 * @param size of the letters, px
 * @param color of the letters
 * @param of the spot
 * @param gap least distance from the spot, px
 * @param reach greatest distance from the spot, px
 */
public record Label(String words, int size, String color, Spot of, double gap, double reach) {}
