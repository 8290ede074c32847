/**
 * The sounds of scenes: samples made when the game starts, and OpenAL, which plays them. Times in
 * s, frequencies in Hz, loudness as a share of full scale. The loop never waits for it, and without
 * a device it is silent.
 */
package rigibo.frontend.sound;
