package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;

import java.util.List;

/** E150 a click during the cooldown; E152 a par that a stored solution beats. */
final class SolutionRules {

    private SolutionRules() {}

    static void check(LevelSketch sketch) {
        sketch.limits().ifPresent(limits -> check(sketch, limits.part()));
    }

    private static void check(LevelSketch sketch, Limits limits) {
        for (Located<Solution> solution : sketch.ways()) {
            List<Click> clicks = solution.part().clicks();
            for (int i = 1; i < clicks.size(); i++) {
                requireCooled(sketch.json(), solution, i, limits.cooldown());
            }
            if (clicks.size() < limits.par()) {
                String words = "E152 par is %s, but %s needs only %s";
                int par = limits.par();
                int count = clicks.size();
                sketch.json()
                        .error(
                                "/rules/par",
                                () ->
                                        Fault.of("E152", words, par, solution.pointer(), count)
                                                .naming(par, count));
            }
        }
    }

    private static void requireCooled(
            Document json, Located<Solution> solution, int i, double cooldown) {
        double last = solution.part().clicks().get(i - 1).seconds();
        double next = solution.part().clicks().get(i).seconds();
        if (Steps.of(next) - Steps.of(last) < Steps.of(cooldown)) {
            String pointer = solution.pointer() + "/clicks/" + i + "/t";
            String words = "E150 clicks at %s s, during the cooldown that lasts until %s s";
            json.error(pointer, () -> Fault.of("E150", words, next, last + cooldown));
        }
    }
}
