package rigibo.lab.ablation;

import rigibo.backend.effect.Effects;

import java.util.Map;

/**
 * The origin of the figures.
 *
 * @param machine that ran it
 * @param date of the run
 * @param options of the command, each after a space
 * @param demos the effects of each demo of the game, by its name, in their order
 */
public record Provenance(String machine, String date, String options, Map<String, Effects> demos) {}
