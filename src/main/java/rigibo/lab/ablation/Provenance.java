package rigibo.lab.ablation;

import rigibo.backend.effect.Effects;

import java.util.Map;

/**
 * Where and how the figures were measured.
 *
 * @param machine what it ran on
 * @param date when
 * @param options of the command that makes them again, each after a space
 * @param demos what each demo of the game declares, by its name, in their order
 */
public record Provenance(String machine, String date, String options, Map<String, Effects> demos) {}
