package rigibo.frontend.sound;

/**
 * A note of the music.
 *
 * @param start s since the music began
 * @param instrument what plays it
 * @param frequency Hz
 * @param gain a share of what the music may be together, 0 to 1
 */
record Note(double start, Instrument instrument, double frequency, double gain) {}
