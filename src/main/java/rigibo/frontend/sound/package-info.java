/**
 * What scenes are heard by: samples made when the game starts, and OpenAL, which plays them. Times
 * in s, frequencies in Hz, loudness as a share of full scale. The loop never waits for it, and
 * without a device all of it is silent.
 */
package rigibo.frontend.sound;
